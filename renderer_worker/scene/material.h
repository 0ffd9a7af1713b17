// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "renderer_worker/scene/vector.h"

namespace flair::renderer {

// A procedural variation of a material's colour over its surface, by texture coordinates in metres.
enum class Pattern { kPlain, kWood, kPlanks, kHerringbone, kTiles, kBricks, kStone, kCarpet, kFabric, kWallpaper };

// How a surface reflects light: the metallic-roughness model of glTF 2.0, plus a pattern. Colours are linear RGB.
struct Material {
  std::string name;  // such as "oak", unique within a mesh
  Vec3 colour{0.8F, 0.8F, 0.8F};
  float roughness = 0.7F;  // (0, 1]
  float metallic = 0;      // [0, 1]
  float opacity = 1;       // (0, 1]; below 1: glass
  Vec3 emission;           // radiance, for lamp shades and flames; 1 is as bright as a white wall in daylight
  Pattern pattern = Pattern::kPlain;
  Vec3 second_colour;  // of joints, figures or threads
  float pattern_size_m = 0.2F;
  friend bool operator==(const Material&, const Material&) = default;
};

}  // namespace flair::renderer
