// SPDX-License-Identifier: GPL-3.0-or-later
// The colours of materials, a function for each family of them.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "renderer_worker/scene/mesh.h"
#include "renderer_worker/tracing/sampling.h"
#include "renderer_worker/tracing/world.h"

namespace flair::renderer {
namespace {

// A number in [0, 1) for a cell of the plane.
float CellValue(int x, int y, uint32_t salt) {
  return static_cast<float>(
             Mix(static_cast<uint32_t>(x) * 0x8da6b343U + static_cast<uint32_t>(y) * 0xd8163841U + salt) >> 8) *
         0x1p-24F;
}

// Largest whole number not above `value`, for coordinates of a room.
int FloorOf(float value) { return static_cast<int>(std::floor(std::clamp(value, -1e8F, 1e8F))); }

float Smooth(float t) { return t * t * (3 - 2 * t); }

// 0 below `low`, 1 above `high`, smooth between.
float Step(float low, float high, float value) { return Smooth(std::clamp((value - low) / (high - low), 0.0F, 1.0F)); }

Vec3 Lerp(Vec3 a, Vec3 b, float share) { return a * (1 - share) + b * share; }

// Smooth noise in [0, 1] with features of size 1.
float Noise(float x, float y, uint32_t salt) {
  const int i = FloorOf(x), k = FloorOf(y);
  const float u = Smooth(x - static_cast<float>(i)), v = Smooth(y - static_cast<float>(k));
  const float low = CellValue(i, k, salt) * (1 - u) + CellValue(i + 1, k, salt) * u;
  const float high = CellValue(i, k + 1, salt) * (1 - u) + CellValue(i + 1, k + 1, salt) * u;
  return low * (1 - v) + high * v;
}

// How much is left of features of `size` when seen through a filter of width `filter`.
float Kept(float size, float filter) { return std::clamp(2 * size / std::max(filter, 1e-6F) - 1, 0.0F, 1.0F); }

// Noise of several sizes about 0, in [-1, 1], features of `size` and halves of it; what the filter swallows is left
// out.
float FractalNoise(Vec2 p, float size, int octaves, float filter, uint32_t salt) {
  float sum = 0, weight = 0.5F;
  for (int i = 0; i < octaves; ++i, size *= 0.5F, weight *= 0.5F) {
    const float kept = Kept(size, filter);
    if (kept <= 0) break;
    sum += kept * weight * (2 * Noise(p.x / size, p.y / size, salt + static_cast<uint32_t>(i) * 977U) - 1);
  }
  return sum;
}

// The share of a filter `filter` wide that lies in a line `line` wide, at `distance` from the line's middle.
float LineCover(float distance, float line, float filter) {
  const float half = std::max(filter, 1e-6F) / 2;
  const float low = std::max(-line / 2, distance - half), high = std::min(line / 2, distance + half);
  return std::clamp((high - low) / (2 * half), 0.0F, 1.0F);
}

// Stone: flags and rubble where `pattern_size_m` is that of stones, clouded and veined surfaces where it is metres.

// Clouds, and veins where two folds of noise meet.
Vec3 Veined(const Material& m, Vec2 uv, float filter, float contrast) {
  const float size = std::max(m.pattern_size_m, 0.05F);
  const Vec2 warped{uv.x + 0.3F * size * FractalNoise(uv, size * 0.5F, 3, filter, 71),
                    uv.y + 0.3F * size * FractalNoise(uv, size * 0.5F, 3, filter, 73)};
  const float clouds = FractalNoise(warped, size * 0.3F, 6, filter, 79);
  const float fold = std::abs(FractalNoise(warped, size * 0.45F, 4, filter, 83));
  const float vein = 1 - Step(0.0F, 0.035F, fold);
  const float share = std::clamp(0.35F + 0.9F * clouds + contrast * vein, 0.0F, 1.0F);
  return Lerp(m.colour, m.second_colour, share);
}

Vec3 StoneColour(const Material& m, Vec2 uv, float filter) {
  const float size = m.pattern_size_m;
  if (size >= 1 || size < 0.08F) return Veined(m, uv, filter, size >= 1 ? 0.0F : 0.5F);
  // Stones are the cells round scattered points; the joint is where the two nearest are equally far.
  const float x = uv.x / size, y = uv.y / size;
  const int i = FloorOf(x), k = FloorOf(y);
  float nearest = 1e9F, second = 1e9F;
  int stone_i = 0, stone_k = 0;
  for (int a = i - 1; a <= i + 1; ++a) {
    for (int b = k - 1; b <= k + 1; ++b) {
      const float px = static_cast<float>(a) + 0.15F + 0.7F * CellValue(a, b, 101);
      const float py = static_cast<float>(b) + 0.15F + 0.7F * CellValue(a, b, 103);
      const float distance = std::sqrt((px - x) * (px - x) + (py - y) * (py - y));
      if (distance < nearest) {
        second = nearest, nearest = distance, stone_i = a, stone_k = b;
      } else {
        second = std::min(second, distance);
      }
    }
  }
  const float edge = (second - nearest) * size / 2;
  const float tone = 0.8F + 0.4F * CellValue(stone_i, stone_k, 107);
  const float grain = FractalNoise(uv, size * 0.5F, 6, filter, static_cast<uint32_t>(stone_i * 31 + stone_k) + 109U);
  const Vec3 stone = m.colour * (tone + 0.35F * grain);
  const float rounded = 1 - 0.25F * (1 - Step(0.0F, 0.04F, edge));
  return Lerp(stone * rounded, m.second_colour * 0.7F, LineCover(edge, 0.016F, filter));
}

// Carpet and cloth: `colour` and `second_colour` are those of the threads.

// Tufts, and the soft patches that feet leave in the pile.
Vec3 CarpetColour(const Material& m, Vec2 uv, float filter) {
  const float tuft = std::clamp(m.pattern_size_m, 0.004F, 0.03F);
  const float tufts = FractalNoise(uv, tuft, 2, filter, 131);
  const float pile = FractalNoise(uv, 0.5F, 3, filter, 137);
  return Lerp(m.colour, m.second_colour, std::clamp(0.3F + 0.9F * tufts + 0.25F * pile, 0.0F, 1.0F));
}

// Threads over and under, a little uneven.
Vec3 FabricColour(const Material& m, Vec2 uv, float filter) {
  const float thread = std::clamp(m.pattern_size_m, 0.002F, 0.02F);
  const float kept = Kept(thread, filter);
  const float slub =
      FractalNoise({uv.x, uv.y * 6}, 0.06F, 2, filter, 149) + FractalNoise({uv.x * 6, uv.y}, 0.06F, 2, filter, 151);
  float weave = 0.5F;
  if (kept > 0) {
    const int i = FloorOf(uv.x / thread), k = FloorOf(uv.y / thread);
    const float x = uv.x / thread - static_cast<float>(i) - 0.5F, y = uv.y / thread - static_cast<float>(k) - 0.5F;
    const float bulge = ((i + k) & 1) == 0 ? 1 - 4 * x * x : 1 - 4 * y * y;
    weave = 0.5F + kept * (0.75F - bulge);
  }
  return Lerp(m.colour, m.second_colour, std::clamp(weave * 0.6F + 0.2F * slub, 0.0F, 1.0F));
}

// What is laid piece by piece: `colour` is that of the pieces, `second_colour` that of the joints.

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

// Wallpaper: a damask of leaves in ogee rows, `colour` the ground, `second_colour` the figure, `pattern_size_m` the
// repeat.

// Below 0 inside a figure about (0, 0) that is one unit wide and 1.5 high: a palmette of lobes on a stem.
float Figure(float x, float y) {
  const float side = std::abs(x);
  const float radius = std::sqrt(side * side + y * y * 0.5F), angle = std::atan2(y * 0.7F, side);
  const float lobes = 0.30F + 0.055F * std::cos(9 * angle) + 0.05F * std::sin(angle);
  const float heart = std::sqrt(side * side * 1.4F + (y + 0.06F) * (y + 0.06F)) - 0.11F;
  const float rim = std::abs(heart) - 0.022F;
  return std::max(radius - lobes, -rim);
}

// Distance to the ogee lines that frame the figures.
float Ogee(float x, float y) {
  const float wave = 0.25F + 0.21F * std::cos(2 * std::numbers::pi_v<float> * y);
  const float at = x - std::floor(x);
  return std::min(std::abs(at - wave), std::abs(at - (1 - wave)));
}

Vec3 WallpaperColour(const Material& m, Vec2 uv, float filter) {
  const float repeat = std::max(m.pattern_size_m, 0.02F);
  const float x = uv.x / repeat, y = uv.y / (1.5F * repeat);
  // Every second row stands between the others.
  const int row = FloorOf(2 * y);
  const float shift = (row & 1) == 0 ? 0.0F : 0.5F;
  const float cx = x + shift - std::floor(x + shift) - 0.5F, cy = (2 * y - static_cast<float>(row) - 0.5F) * 1.1F;
  const float soft = std::max(0.012F, filter / repeat);
  const float figure = 1 - Step(-soft, soft, Figure(cx, cy));
  const float frame = 1 - Step(0.012F, 0.012F + soft, Ogee(x + 0.25F, y + 0.125F));
  const float kept = Kept(repeat * 0.15F, filter);
  const float share = 0.25F + kept * (0.75F * std::max(figure, 0.6F * frame) - 0.25F);
  const float paper = 1 + 0.03F * FractalNoise(uv, 0.01F, 2, filter, 167);
  return Lerp(m.colour, m.second_colour, share) * paper;
}

// Wood: `colour` is that of the wood, `second_colour` that of its grain and joints.

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

Vec3 Clamped(Vec3 c) { return {std::clamp(c.x, 0.0F, 1.0F), std::clamp(c.y, 0.0F, 1.0F), std::clamp(c.z, 0.0F, 1.0F)}; }

// Coordinates that a room has; meshes of others may hold anything.
float InRoom(float value) { return value > -1e4F && value < 1e4F ? value : 0.0F; }

Vec3 PlainColour(const Material& material, Vec2, float) { return material.colour; }

// In the order of the enum.
constexpr Vec3 (*kColours[])(const Material&, Vec2, float) = {
    PlainColour,  WoodColour,  PlanksColour, HerringboneColour, TilesColour,
    BricksColour, StoneColour, CarpetColour, FabricColour,      WallpaperColour};

}  // namespace

Vec3 PatternColour(const Material& material, Vec2 uv_m, float filter_m) {
  return Clamped(kColours[static_cast<int>(material.pattern)](material, {InRoom(uv_m.x), InRoom(uv_m.y)}, filter_m));
}

Vec3 MeanPatternColour(const Material& material) {
  if (material.pattern == Pattern::kPlain) return PatternColour(material, {}, 1);
  constexpr int kPerSide = 12;
  Vec3 sum;
  for (int i = 0; i < kPerSide; ++i) {
    for (int k = 0; k < kPerSide; ++k) {
      sum = sum + PatternColour(material, {static_cast<float>(i) * 0.317F, static_cast<float>(k) * 0.271F}, 0.01F);
    }
  }
  return sum * (1.0F / (kPerSide * kPerSide));
}

}  // namespace flair::renderer
