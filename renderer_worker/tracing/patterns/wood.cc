// SPDX-License-Identifier: GPL-3.0-or-later
// Wood: `colour` is that of the wood, `second_colour` that of its grain and joints.
#include "renderer_worker/tracing/patterns/noise.h"
#include "renderer_worker/tracing/patterns/pattern.h"

namespace flair::renderer {
namespace {

// Grain along u: pores stretched twenty times, under them the broad bands of the years.
Vec3 Grain(const Material& m, Vec2 p, float filter, uint32_t board) {
  const float shift = 17 * CellValue(static_cast<int>(board), 3, 91);
  const Vec2 stretched{p.x / 14 + shift, p.y + shift};
  const float warp = 0.02F * FractalNoise({p.x / 5, p.y}, 0.12F, 2, filter, board + 7);
  const float bands = FractalNoise({stretched.x, stretched.y + warp}, 0.035F, 3, filter, board);
  const float pores = FractalNoise(stretched, 0.006F, 2, filter, board + 31);
  const float dark = std::clamp(0.16F + 0.42F * bands + 0.28F * pores, 0.0F, 0.75F);
  return Lerp(m.colour, m.second_colour, dark);
}

Vec3 Board(const Material& m, Vec2 along, float filter, uint32_t board) {
  const float tone = CellValue(static_cast<int>(board), 1, 17), warmth = CellValue(static_cast<int>(board), 2, 23);
  const Vec3 wood = Grain(m, along, filter, board);
  const float light = 0.86F + 0.28F * tone;
  return {wood.x * light * (0.98F + 0.04F * warmth), wood.y * light, wood.z * light * (1.03F - 0.06F * warmth)};
}

}  // namespace

Vec3 WoodColour(const Material& m, Vec2 uv, float filter) { return Grain(m, uv, filter, 5); }

// Boards along u, `pattern_size_m` wide, of random lengths, with fine joints.
Vec3 PlanksColour(const Material& m, Vec2 uv, float filter) {
  const float width = std::max(m.pattern_size_m, 0.01F), length = width * 11;
  const int row = FloorOf(uv.y / width);
  const float across = uv.y - static_cast<float>(row) * width;
  const float shifted = uv.x + length * CellValue(row, 0, 5) * 3;
  const int cell = FloorOf(shifted / length);
  // Each cell of a row holds the joint between two boards.
  const float joint = (static_cast<float>(cell) + 0.2F + 0.6F * CellValue(cell, row, 11)) * length;
  const int board = shifted < joint ? cell - 1 : cell;
  const Vec3 wood =
      Board(m, {shifted, across}, filter, Mix(static_cast<uint32_t>(board) * 7919U + static_cast<uint32_t>(row)));
  const float edge = std::min(across, width - across);
  const float gap = std::max(LineCover(edge, 0.005F, filter), LineCover(std::abs(shifted - joint), 0.004F, filter));
  return Lerp(wood, m.second_colour * 0.35F, 0.8F * gap);
}

// Staves five times as long as wide, each row turned a right angle to the next.
Vec3 HerringboneColour(const Material& m, Vec2 uv, float filter) {
  const float width = std::max(m.pattern_size_m, 0.01F);
  constexpr int kLong = 5;
  // Turned by 45 degrees, so that the zigzag runs along u.
  const float x = (uv.x + uv.y) * 0.70710678F / width, y = (uv.y - uv.x) * 0.70710678F / width;
  const int i = FloorOf(x), k = FloorOf(y);
  const int phase = ((i - k) % (2 * kLong) + 2 * kLong) % (2 * kLong);
  const bool lying = phase < kLong;
  // Cells back to the stave's first one.
  const int back = lying ? phase : 2 * kLong - 1 - phase;
  const int first_i = lying ? i - back : i, first_k = lying ? k : k - back;
  const float along = lying ? x - static_cast<float>(first_i) : y - static_cast<float>(first_k);
  const float across = lying ? y - static_cast<float>(k) : x - static_cast<float>(i);
  const uint32_t stave =
      Mix(static_cast<uint32_t>(first_i) * 7919U + static_cast<uint32_t>(first_k) * 2U + (lying ? 1U : 0U));
  const Vec3 wood =
      Board(m, {along * width + 3 * CellValue(static_cast<int>(stave), 0, 3), across * width}, filter, stave);
  const float edge = std::min({across, 1 - across, along, kLong - along}) * width;
  return Lerp(wood, m.second_colour * 0.4F, 0.7F * LineCover(edge, 0.003F, filter));
}

}  // namespace flair::renderer
