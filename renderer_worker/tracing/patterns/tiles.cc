// SPDX-License-Identifier: GPL-3.0-or-later
// What is laid piece by piece: `colour` is that of the pieces, `second_colour` that of the joints.
#include "renderer_worker/tracing/patterns/noise.h"
#include "renderer_worker/tracing/patterns/pattern.h"

namespace flair::renderer {
namespace {

struct Piece {
  int column, row;
  float edge;  // distance to the nearest joint, metres
};

Piece PieceAt(Vec2 uv, float width, float height, float shift_per_row) {
  const int row = FloorOf(uv.y / height);
  const float shifted = uv.x + shift_per_row * width * static_cast<float>(row & 1);
  const int column = FloorOf(shifted / width);
  const float u = shifted - static_cast<float>(column) * width, v = uv.y - static_cast<float>(row) * height;
  return {column, row, std::min({u, width - u, v, height - v})};
}

// The share of the filter that joints cover: of those about it, or, when it is wider than pieces, of all.
float JointCover(float edge, float joint, float filter, float width, float height) {
  const float of_all = std::min(1.0F, joint / width + joint / height);
  const float wide = Step(0.4F, 1.2F, filter / std::min(width, height));
  return LineCover(edge, joint, filter) * (1 - wide) + of_all * wide;
}

}  // namespace

// Square tiles with clouds of their own.
Vec3 TilesColour(const Material& m, Vec2 uv, float filter) {
  const float size = std::max(m.pattern_size_m, 0.01F);
  const Piece tile = PieceAt(uv, size, size, 0);
  const float tone = 0.95F + 0.1F * CellValue(tile.column, tile.row, 41);
  const float cloud = FractalNoise({uv.x + 5 * static_cast<float>(tile.row), uv.y}, size * 0.4F, 4, filter,
                                   static_cast<uint32_t>(tile.column) * 31U + 3U);
  return Lerp(m.colour * (tone + 0.09F * cloud), m.second_colour, JointCover(tile.edge, 0.008F, filter, size, size));
}

// Running bond; a course is a third of the brick's length.
Vec3 BricksColour(const Material& m, Vec2 uv, float filter) {
  const float length = std::max(m.pattern_size_m, 0.02F), height = length / 3;
  const Piece brick = PieceAt(uv, length, height, 0.5F);
  const float tone = 0.78F + 0.44F * CellValue(brick.column, brick.row, 43);
  const float grain = FractalNoise(uv, 0.05F, 4, filter, static_cast<uint32_t>(brick.row) * 13U + 7U);
  const Vec3 clay = m.colour * (tone + 0.25F * grain);
  return Lerp(clay, m.second_colour, JointCover(brick.edge, 0.014F, filter, length, height));
}

}  // namespace flair::renderer
