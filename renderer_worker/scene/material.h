// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "renderer_worker/scene/vector.h"

namespace flair::renderer {

// A procedural variation of a material's colour over its surface, by texture coordinates in metres.
enum class Pattern { kPlain, kWood, kPlanks, kHerringbone, kTiles, kBricks, kStone, kCarpet, kFabric, kWallpaper };

// A picture on a surface as its asset brought it: never decoded by us, only handed on.
struct SurfaceImage {
  std::string mime_type;  // "image/png" or "image/jpeg"
  std::string bytes;      // of the file
};

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
  // Multiplies `colour`; null nearly always. Texture coordinates are then in parts of it, v downwards.
  std::shared_ptr<const SurfaceImage> image;
  friend bool operator==(const Material&, const Material&) = default;
};

}  // namespace flair::renderer
