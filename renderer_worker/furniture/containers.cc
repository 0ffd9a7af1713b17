// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "renderer_worker/furniture/piece.h"

// What things are put into or hung on.
namespace flair::renderer {
namespace {
void MakeTrunk(Piece& p) {
  const float body = 0.62F * p.h, strap = std::min(0.04F, 0.06F * p.w), y = p.d / 2 - 0.015F * p.d;
  p.make.Box(p.is.hard, {-0.49F * p.w, -y, 0}, {0.49F * p.w, y, body}, 0.008F);
  // Straps round body and lid, the outer ones a little in from the ends, which they would cover.
  const std::array<float, 4> straps{-0.47F * p.w, -0.16F * p.w - strap / 2, 0.16F * p.w - strap / 2,
                                    0.47F * p.w - strap};
  // A vaulted lid: an arc from front to back, drawn out along x.
  const bool flat = p.Says("crate") || p.Says("box");
  std::vector<Vec2> vault =
      flat ? RoundedOutline({-y, 0}, {y, 0.37F * p.h}, 0.02F) : ArcPoints({0, 0}, y, 0.37F * p.h, 0, kPiFloat, 14);
  p.make.In({{-0.49F * p.w, 0, body + 0.008F * p.h}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}}, [&] {
    p.make.Slab(p.is.hard, vault, 0, 0.98F * p.w, 0.006F);
    std::vector<Vec2> band = vault;
    for (Vec2& point : band) point = {point.x * 1.03F, point.y * 1.03F};
    for (const float x : straps) p.make.Slab(p.is.metal, band, x + 0.49F * p.w, x + 0.49F * p.w + strap, 0.002F);
  });
  for (const float x : straps) p.make.Box(p.is.metal, {x, -p.d / 2, 0.0F}, {x + strap, p.d / 2, body}, 0.003F);
  p.make.Box(p.is.metal, {-0.06F * p.w, y, body - 0.1F * p.h}, {0.06F * p.w, p.d / 2, body + 0.09F * p.h}, 0.004F);
}

void MakeBarrel(Piece& p) {
  std::vector<Vec2> profile;
  for (int i = 0; i <= 10; ++i) {
    const float t = static_cast<float>(i) / 10;
    profile.push_back({0.4F + 0.1F * std::sin(kPiFloat * t), p.h * t});
  }
  profile.push_back({0.36F, p.h});
  profile.push_back({0.36F, 0.965F * p.h});
  p.make.Lathe(p.is.hard, {}, profile, 24, {p.w, p.d});
  for (const float t : {0.08F, 0.28F, 0.72F, 0.92F}) {
    const float low = t - 0.025F, high = t + 0.025F;
    const auto r = [](float at) { return 0.4F + 0.1F * std::sin(kPiFloat * at); };
    p.make.Ring(p.is.metal, {},
                std::array<Vec2, 4>{{{r(low) - 0.02F, low * p.h},
                                     {r(low) + 0.008F, low * p.h},
                                     {r(high) + 0.008F, high * p.h},
                                     {r(high) - 0.02F, high * p.h}}},
                24, {p.w, p.d});
  }
}

void MakeBasket(Piece& p) {
  const bool bin = p.Says("bin") || p.Says("trash") || p.Says("bucket");
  const Vec2 stretch{p.w, p.d};
  p.make.Lathe(p.is.hard, {},
               std::array<Vec2, 7>{{{0.38F, 0},
                                    {0.42F, 0.04F * p.h},
                                    {0.49F, 0.93F * p.h},
                                    {0.49F, 0.97F * p.h},
                                    {0.455F, 0.97F * p.h},
                                    {0.4F, 0.12F * p.h},
                                    {0, 0.12F * p.h}}},
               26, stretch);
  if (bin) {
    p.make.Ring(p.is.metal, {},
                std::array<Vec2, 4>{{{0.45F, 0.95F * p.h}, {0.5F, 0.95F * p.h}, {0.5F, p.h}, {0.45F, p.h}}}, 26,
                stretch);
    return;
  }
  for (int i = 0; i < 9; ++i) {  // rows of the weave
    const float t = (static_cast<float>(i) + 0.5F) / 9.5F, r = 0.42F + 0.075F * t;
    p.make.Ring(
        p.is.hard, {0, 0, t * p.h},
        std::array<Vec2, 4>{{{r - 0.01F, -0.03F * p.h}, {r + 0.008F, 0}, {r - 0.01F, 0.03F * p.h}, {r - 0.02F, 0}}}, 22,
        stretch);
  }
  p.make.Ellipsoid(p.is.pale, {0, 0, 0.78F * p.h}, {0.4F * p.w, 0.4F * p.d, 0.18F * p.h}, 16, 8);
  for (const float side : {-1.0F, 1.0F}) {
    std::vector<Vec3> handle;
    for (int i = 0; i <= 8; ++i) {
      const float turn = kPiFloat * static_cast<float>(i) / 8;
      handle.push_back({side * 0.475F * p.w, 0.14F * p.d * std::cos(turn), 0.9F * p.h + 0.1F * p.h * std::sin(turn)});
    }
    p.make.Tube(p.is.hard, handle, std::array{0.02F * p.smaller()}, 6);
  }
}

void MakeCoatStand(Piece& p) {
  const float r = std::min(0.022F, 0.06F * p.smaller()), foot = 0.5F * p.smaller();
  p.make.Bar(p.is.hard, {0, 0, 0.03F * p.h}, {0, 0, 0.97F * p.h}, 1.2F * r, 0.9F * r, 12);
  p.make.Ellipsoid(p.is.hard, {0, 0, 0.98F * p.h}, {1.5F * r, 1.5F * r, 0.02F * p.h}, 12, 6);
  for (int i = 0; i < 4; ++i) {
    const float turn = kPiFloat / 4 + kPiFloat / 2 * static_cast<float>(i), x = std::cos(turn), y = std::sin(turn);
    p.make.Tube(p.is.hard,
                std::array<Vec3, 3>{{{0, 0, 0.14F * p.h},
                                     {0.6F * foot * x, 0.6F * foot * y, 0.05F * p.h},
                                     {foot * x * 1.35F, foot * y * 1.35F, 0}}},
                std::array{r}, 8);
    for (const float z : {0.72F, 0.9F}) {
      const float up = turn + (z > 0.8F ? kPiFloat / 4 : 0), cx = std::cos(up), cy = std::sin(up);
      p.make.Tube(p.is.hard,
                  std::array<Vec3, 3>{{{0, 0, z * p.h},
                                       {0.5F * foot * cx, 0.5F * foot * cy, z * p.h},
                                       {0.8F * foot * cx, 0.8F * foot * cy, (z + 0.06F) * p.h}}},
                  std::array{0.8F * r}, 8);
    }
  }
  // A coat and a hat, so that it is seen for what it is.
  p.make.Sheet(
      p.is.soft, 14, 6,
      [&](float u, float v) {
        const float turn = 2 * kPiFloat * u, wide = foot * (0.14F + 0.34F * v) * (1 + 0.1F * std::sin(5 * turn));
        return Vec3{0.4F * foot + wide * std::cos(turn), 0.4F * foot + 0.8F * wide * std::sin(turn),
                    p.h * (0.74F - 0.42F * v)};
      },
      0.008F);
  p.make.Lathe(p.is.accent, {-0.6F * foot, -0.45F * foot, 0.93F * p.h},
               std::array<Vec2, 5>{{{0.36F * foot, 0},
                                    {0.2F * foot, 0.012F * p.h},
                                    {0.18F * foot, 0.05F * p.h},
                                    {0.1F * foot, 0.065F * p.h},
                                    {0, 0.066F * p.h}}},
               16);
}

void MakeGarmentRack(Piece& p) {
  const float r = std::min(0.014F, 0.06F * p.smaller()), rail = 0.97F * p.h;
  const bool towels = p.Says("towel") || p.Says("drying") || p.h < 1.2F;
  for (const float side : {-1.0F, 1.0F}) {
    const float x = side * (p.w / 2 - 2 * r);
    p.make.Bar(p.is.metal, {x, 0, r}, {x, 0, p.h - r}, r, 10);
    p.make.Bar(p.is.metal, {x, -p.d / 2, r}, {x, p.d / 2, r}, r, 10);
  }
  p.make.Bar(p.is.metal, {-p.w / 2, 0, rail - r}, {p.w / 2, 0, rail - r}, r, 10);
  p.make.Bar(p.is.metal, {-p.w / 2 + 2 * r, 0, 0.16F * p.h}, {p.w / 2 - 2 * r, 0, 0.16F * p.h}, 0.8F * r, 10);
  const int count = towels ? 2 : std::clamp(static_cast<int>(p.w / 0.1F), 3, 14);
  const float pitch = (p.w - 8 * r) / static_cast<float>(count);
  for (int i = 0; i < count; ++i) {
    const float x = -p.w / 2 + 4 * r + pitch * (static_cast<float>(i) + 0.5F);
    const float length = towels ? 0.5F : 0.42F + 0.2F * p.Chance(i), thick = towels ? 0.42F * pitch : 0.34F * pitch;
    const Material& cloth = i % 3 == 0 ? p.is.soft : i % 3 == 1 ? p.is.accent : p.is.pale;
    const float half = towels ? 3 * r : 0.46F * p.d;
    if (!towels) {  // shoulders that slope, on a hanger
      p.make.Taper(cloth, {x, 0, rail * (1 - length)}, {thick, half}, {x, 0, 0.9F * rail}, {0.7F * thick, 0.8F * half});
      p.make.Taper(cloth, {x, 0, 0.9F * rail}, {0.7F * thick, 0.8F * half}, {x, 0, 0.955F * rail},
                   {0.3F * thick, 0.16F * half});
      p.make.Bar(p.is.metal, {x, 0, 0.95F * rail}, {x, 0, rail}, 0.3F * r, 6);
    } else {
      p.make.Cushion(cloth, {x - thick, -half, rail * (1 - length)}, {x + thick, half, rail + 1.2F * r}, 0.8F * half);
    }
  }
}

void MakeRack(Piece& p) {  // hooks or rails on a wall
  const float board = std::min(0.02F, 0.3F * p.d);
  p.make.Box(p.is.hard, {-p.w / 2, -p.d / 2, 0.55F * p.h}, {p.w / 2, -p.d / 2 + board, p.h}, 0.005F);
  const int count = std::clamp(static_cast<int>(p.w / 0.16F), 2, 10);
  for (int i = 0; i < count; ++i) {
    const float x = p.w * ((static_cast<float>(i) + 0.5F) / static_cast<float>(count) - 0.5F),
                r = std::min(0.008F, 0.08F * p.d);
    p.make.Tube(p.is.metal,
                std::array<Vec3, 4>{{{x, -p.d / 2 + board, 0.75F * p.h},
                                     {x, 0.2F * p.d, 0.72F * p.h},
                                     {x, 0.45F * p.d, 0.8F * p.h},
                                     {x, 0.5F * p.d - r, 0.92F * p.h}}},
                std::array{r}, 8);
    if (i % 2 != 0) continue;
    const float wide = std::min(0.06F, 0.4F * p.w / static_cast<float>(count));
    p.make.Sheet(
        i % 4 == 0 ? p.is.soft : p.is.accent, 8, 4,
        [&](float u, float v) {
          const float a = 2 * u - 1;
          return Vec3{x + wide * a * (0.3F + 0.7F * v), 0.22F * p.d * (1 - a * a) + 0.02F * p.d * std::sin(9 * a),
                      p.h * 0.74F * (1 - v)};
        },
        0.006F);
  }
}

void MakeLadder(Piece& p) {
  const float rail = std::min(0.025F, 0.08F * p.w), lean = 0.5F * p.d - rail;
  for (const float side : {-1.0F, 1.0F}) {
    const float x = side * (p.w / 2 - rail);
    p.make.Taper(p.is.hard, {x * 1.0F, lean, 0}, {rail, rail}, {0.86F * x, -lean, p.h}, {rail, rail});
  }
  const int rungs = std::clamp(static_cast<int>(p.h / 0.3F), 2, 14);
  for (int i = 1; i < rungs; ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(rungs), y = lean * (1 - 2 * t),
                x = (p.w / 2 - rail) * (1 - 0.14F * t);
    p.make.Box(p.is.hard, {-x, y - 0.7F * rail, t * p.h - 0.4F * rail}, {x, y + 0.7F * rail, t * p.h + 0.4F * rail},
               0.004F);
  }
  p.make.Cushion(p.is.soft, {-0.3F * p.w, lean * 0.2F - 2 * rail, 0.2F * p.h},
                 {0.3F * p.w, lean * 0.2F + 3 * rail, 0.42F * p.h}, rail);
}

void MakeFoldingScreen(Piece& p) {
  const int panels = std::clamp(static_cast<int>(std::lround(p.w / 0.5F)), 2, 6);
  const float pitch = p.w / static_cast<float>(panels), thick = std::min(0.03F, 0.3F * p.d), rise = p.d - thick,
              rail = std::min(0.05F, 0.12F * pitch);
  const float length = std::sqrt(pitch * pitch + rise * rise), turn = std::atan2(rise, pitch);
  for (int i = 0; i < panels; ++i) {
    const bool up = i % 2 == 0;
    const Vec3 from{-p.w / 2 + pitch * static_cast<float>(i), up ? -rise / 2 : rise / 2, 0};
    p.make.In(Frame::TurnedZ(from, up ? turn : -turn), [&] {
      const float half = thick / 2, low = 0.03F * p.h;
      for (const float x : {0.01F * length, 0.99F * length - rail})
        p.make.Box(p.is.hard, {x, -half, 0}, {x + rail, half, p.h}, 0.004F);
      for (const float z : {low, 0.62F * p.h, p.h - rail})
        p.make.Box(p.is.hard, {rail, -half, z}, {length - rail, half, z + rail}, 0.004F);
      p.make.Box(p.is.pale, {rail, -0.3F * half, low}, {length - rail, 0.3F * half, p.h - 0.5F * rail}, 0);
    });
  }
}

}  // namespace

std::span<const PieceMaker> ContainerMakers() {
  static constexpr PieceMaker kMakers[] = {{"trunk", MakeTrunk},
                                           {"barrel", MakeBarrel},
                                           {"basket", MakeBasket},
                                           {"coat_stand", MakeCoatStand},
                                           {"garment_rack", MakeGarmentRack},
                                           {"rack", MakeRack},
                                           {"ladder", MakeLadder},
                                           {"folding_screen", MakeFoldingScreen}};
  return kMakers;
}

}  // namespace flair::renderer
