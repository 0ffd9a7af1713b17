// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "renderer_worker/scene/mesh.h"

namespace flair::renderer::gltf {

// What a pattern does to a material's colour at one point: (1 - mix) colour + mix second_colour, times shade.
struct Tone {
  float mix = 0;    // [0, 1]
  float shade = 1;  // [kDarkestShade, kLightestShade]
};

inline constexpr float kDarkestShade = 0.78F;
inline constexpr float kLightestShade = 1.12F;

// What is drawn for a material: its pattern, but stone that is laid in stones apart from stone in one piece.
enum class Figure {
  kPlain,
  kWood,
  kPlanks,
  kHerringbone,
  kTiles,
  kBricks,
  kStone,
  kCarpet,
  kFabric,
  kWallpaper,
  kStones
};
inline constexpr int kFigureCount = 11;

// Stone of a size below a metre is laid, as flags or rubble.
Figure FigureOf(const Material& material);

// The rectangle after which a pattern repeats, in units of pattern_size_m: a board's or stave's width, a tile's side, a
// brick's length, a stone or cloud, a tuft, a thread, a repeat of wallpaper. (0, 0) for kPlain.
Vec2 PeriodOf(Figure figure);

// The tone at (u, v), units of pattern_size_m, within the period. Grain and boards run along u.
Tone ToneAt(Figure figure, float u, float v);

// One period of a material's pattern as a PNG that tiles, row 0 at v = 0. Its pixels are numbers of tones, which depend
// on the pattern alone and are computed once per process; the palette gives them the material's colours. Empty for
// kPlain. Thread-safe, the same bytes for the same material.
std::string PatternPng(const Material& material);

}  // namespace flair::renderer::gltf
