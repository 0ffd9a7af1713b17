// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "renderer_worker/furniture/piece.h"

// What one makes things with.
namespace flair::renderer {
namespace {
void MakeEasel(Piece& p) {
  const float r = std::min(0.02F, 0.04F * p.w), tilt = std::atan2(0.5F * p.d, p.h);
  for (const float side : {-1.0F, 1.0F}) {
    p.make.Taper(p.is.hard, {side * (p.w / 2 - r), p.d / 2 - r, 0}, {r, 0.7F * r},
                 {side * 0.07F * p.w, -0.12F * p.d, 0.97F * p.h}, {r, 0.7F * r});
  }
  p.make.Taper(p.is.hard, {0, -p.d / 2 + r, 0}, {r, r}, {0, -0.16F * p.d, 0.9F * p.h}, {r, r});
  p.make.In(Frame::TurnedX({0, 0.34F * p.d, 0.28F * p.h}, tilt), [&] {
    p.make.Box(p.is.hard, {-0.46F * p.w, -r, -0.025F * p.h}, {0.46F * p.w, 0.12F * p.d, 0}, 0.004F);
    p.make.Box(p.is.hard, {-0.8F * r, -2 * r, -0.1F * p.h}, {0.8F * r, -r, 0.7F * p.h}, 0.003F);
    const float half = std::min(0.42F * p.w, 0.34F * p.h), high = 0.5F * p.h;
    p.make.Box(stuff::Paper(), {-half, -0.6F * r, 0}, {half, 0.6F * r, high}, 0.004F);
    // A painting begun: a few broad strokes.
    const std::array<Vec3, 3> hues{p.is.colour, LinearHex(0x6B93A8), LinearHex(0xD0A35A)};
    for (int i = 0; i < 3; ++i) {
      const float x = half * (-0.5F + 0.5F * static_cast<float>(i)), z = high * (0.35F + 0.2F * p.Chance(i));
      Material paint = PlainMaterial("paint " + std::to_string(i), 0x808080, 0.6F);
      paint.colour = paint.second_colour = hues[static_cast<size_t>(i)];
      p.make.In({{x, 0.6F * r, z}, {-1, 0, 0}, {0, 0, 1}, {0, 1, 0}}, [&] {
        p.make.Slab(paint, EllipseOutline({}, 0.42F * half, (0.2F + 0.1F * p.Chance(9 + i)) * high, 14), -0.001F,
                    0.002F + 0.0006F * static_cast<float>(i), 0);
      });
    }
    p.make.Box(p.is.hard, {-3 * r, -r, high}, {3 * r, r, high + 1.4F * r}, 0.003F);
  });
}

void MakeSewingMachine(Piece& p) {
  const float base = 0.16F * p.h;
  p.make.Cushion(p.is.hard, {-p.w / 2, -p.d / 2, 0}, {p.w / 2, p.d / 2, base}, 0.3F * base);
  p.make.Cushion(p.is.hard, {0.16F * p.w, -0.4F * p.d, 0.8F * base}, {0.48F * p.w, 0.4F * p.d, 0.96F * p.h},
                 0.06F * p.w);
  p.make.Cushion(p.is.hard, {-0.46F * p.w, -0.34F * p.d, 0.66F * p.h}, {0.3F * p.w, 0.34F * p.d, 0.96F * p.h},
                 0.06F * p.w);
  p.make.Cushion(p.is.hard, {-0.46F * p.w, -0.3F * p.d, 0.48F * p.h}, {-0.24F * p.w, 0.3F * p.d, 0.8F * p.h},
                 0.04F * p.w);
  p.make.Bar(p.is.metal, {-0.35F * p.w, 0, base}, {-0.35F * p.w, 0, 0.5F * p.h}, 0.012F * p.w, 6);
  p.make.Box(p.is.metal, {-0.42F * p.w, -0.2F * p.d, base - 0.002F}, {-0.26F * p.w, 0.25F * p.d, base + 0.006F},
             0.001F);
  p.make.In({{0.47F * p.w, 0, 0.72F * p.h}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}},
            [&] { p.make.Cylinder(stuff::Black(), {}, 0.17F * p.h, 0.03F * p.w, 0.004F, 20); });
  for (const float x : {0.05F, 0.14F}) {
    p.make.Bar(p.is.metal, {x * p.w, -0.1F * p.d, 0.94F * p.h}, {x * p.w, -0.1F * p.d, p.h}, 0.006F * p.w, 6);
    p.make.Cylinder(p.is.soft, {x * p.w, -0.1F * p.d, 0.95F * p.h}, 0.03F * p.w, 0.04F * p.h, 0.002F, 12);
  }
  p.make.In({{0.3F * p.w, 0.39F * p.d, 0.56F * p.h}, {-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
            [&] { p.make.Cylinder(stuff::Black(), {}, 0.09F * p.h, 0.04F * p.d, 0.003F, 16); });
}

void MakeMannequin(Piece& p) {
  const float hip = 0.48F * p.h, r = std::min(0.02F, 0.06F * p.smaller());
  for (int i = 0; i < 3; ++i) {
    const float turn = kPiFloat / 2 + 2 * kPiFloat / 3 * static_cast<float>(i);
    p.make.Tube(
        p.is.hard,
        std::array<Vec3, 3>{{{0, 0, 0.12F * p.h},
                             {0.24F * p.smaller() * std::cos(turn), 0.24F * p.smaller() * std::sin(turn), 0.04F * p.h},
                             {0.44F * p.smaller() * std::cos(turn), 0.44F * p.smaller() * std::sin(turn), 0}}},
        std::array{0.8F * r}, 8);
  }
  p.make.Bar(p.is.hard, {0, 0, 0.08F * p.h}, {0, 0, hip}, r, 10);
  // A torso: hips, waist, bust, shoulders, neck.
  p.make.Lathe(p.is.soft, {},
               std::array<Vec2, 9>{{{0.34F, hip},
                                    {0.44F, hip + 0.05F * p.h},
                                    {0.42F, hip + 0.12F * p.h},
                                    {0.3F, hip + 0.21F * p.h},
                                    {0.42F, hip + 0.32F * p.h},
                                    {0.47F, hip + 0.38F * p.h},
                                    {0.4F, hip + 0.44F * p.h},
                                    {0.13F, hip + 0.47F * p.h},
                                    {0.11F, 0.97F * p.h}}},
               28, {std::min(p.w, 0.42F), std::min(p.d, 0.28F)});
  for (const float side : {-1.0F, 1.0F})
    p.make.Ellipsoid(p.is.soft, {side * 0.42F * std::min(p.w, 0.42F), 0, hip + 0.41F * p.h},
                     {0.1F * std::min(p.w, 0.42F), 0.2F * std::min(p.d, 0.28F), 0.05F * p.h}, 12, 8);
  p.make.Ellipsoid(p.is.hard, {0, 0, 0.98F * p.h}, {0.03F, 0.03F, 0.02F * p.h}, 10, 6);
  // A tape about its neck.
  p.make.Hoop(p.is.metal, {0, 0, hip + 0.455F * p.h}, 0.2F * std::min(p.d, 0.28F), 0.02F, 18);
}

void MakeIroningBoard(Piece& p) {
  const bool along_x = p.w >= p.d;
  const float length = along_x ? p.w : p.d, width = along_x ? p.d : p.w, r = std::min(0.014F, 0.06F * width);
  p.make.In(along_x ? Frame{} : Frame{{}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}, [&] {
    std::vector<Vec2> outline{{-0.5F * length, -0.46F * width},
                              {0.18F * length, -0.5F * width},
                              {0.36F * length, -0.4F * width},
                              {0.46F * length, -0.22F * width},
                              {0.5F * length, 0}};
    for (size_t i = 4; i-- > 0;) outline.push_back({outline[i].x, -outline[i].y});
    p.make.Slab(p.is.soft, outline, 0.955F * p.h, p.h, 0.01F);
    std::vector<Vec2> tray = outline;
    for (Vec2& point : tray) point = {0.97F * point.x, 0.9F * point.y};
    p.make.Slab(p.is.metal, tray, 0.94F * p.h, 0.957F * p.h, 0.002F);
    for (const float side : {-1.0F, 1.0F}) {
      p.make.Bar(p.is.metal, {-side * 0.4F * length, side * 0.12F * width, r},
                 {side * 0.26F * length, side * 0.12F * width, 0.94F * p.h}, r, 8);
      p.make.Bar(p.is.metal, {side * 0.4F * length, -0.42F * width, r}, {side * 0.4F * length, 0.42F * width, r}, r, 8);
    }
    p.make.Box(p.is.metal, {-0.49F * length, -0.2F * width, 0.99F * p.h}, {-0.38F * length, 0.2F * width, p.h + 0.002F},
               0.002F);
  });
}

void MakeLoom(Piece& p) {
  const float post = std::min(0.05F, 0.06F * p.smaller());
  for (const float sx : {-1.0F, 1.0F}) {
    const float x = sx * (p.w / 2 - post);
    for (const float y : {-0.44F, 0.0F, 0.44F})
      p.make.Box(p.is.hard, {x - post, y * p.d - post, 0}, {x + post, y * p.d + post, (y == 0 ? 1 : 0.66F) * p.h},
                 0.006F);
    for (const float z : {0.1F, 0.6F})
      p.make.Box(p.is.hard, {x - 0.7F * post, -p.d / 2, z * p.h}, {x + 0.7F * post, p.d / 2, z * p.h + 1.6F * post},
                 0.006F);
  }
  for (const float y : {-0.44F, 0.44F})
    p.make.Bar(p.is.hard, {-p.w / 2, y * p.d, 0.6F * p.h}, {p.w / 2, y * p.d, 0.6F * p.h}, 1.3F * post, 14);
  p.make.Box(p.is.hard, {-p.w / 2, -post, p.h - 2 * post}, {p.w / 2, post, p.h}, 0.006F);
  for (const float z : {0.5F, 0.78F})
    p.make.Box(p.is.hard, {-p.w / 2 + 2 * post, -0.05F * p.d, z * p.h},
               {p.w / 2 - 2 * post, -0.02F * p.d, z * p.h + post}, 0.004F);
  const float z = 0.6F * p.h + 1.3F * post;
  const int threads = std::clamp(static_cast<int>(p.w / 0.045F), 6, 36);
  for (int i = 0; i < threads; ++i) {
    const float x = (p.w - 5 * post) * ((static_cast<float>(i) + 0.5F) / static_cast<float>(threads) - 0.5F);
    p.make.Bar(p.is.pale, {x, -0.44F * p.d, z}, {x, 0.44F * p.d, z}, 0.003F, 4);
    p.make.Bar(p.is.pale, {x, -0.03F * p.d, 0.52F * p.h}, {x, -0.03F * p.d, 0.78F * p.h}, 0.002F, 4);
  }
  for (int i = 0; i < 3; ++i) {  // what is woven already
    const float from = 0.16F + 0.09F * static_cast<float>(i);
    p.make.Box(i == 1 ? p.is.accent : p.is.soft, {-p.w / 2 + 2.5F * post, from * p.d, z - 0.006F},
               {p.w / 2 - 2.5F * post, (from + 0.09F) * p.d, z + 0.006F}, 0.002F);
  }
  p.make.Box(p.is.hard, {-0.3F * p.w, 0.36F * p.d, 0.26F * p.h}, {0.3F * p.w, 0.5F * p.d, 0.3F * p.h}, 0.006F);
}

void MakeSpinningWheel(Piece& p) {
  const float r = std::min(0.38F * p.h, 0.32F * p.d), leg = std::min(0.018F, 0.06F * p.smaller());
  const Vec3 hub{0, -0.12F * p.d, p.h - r};
  p.make.In({hub, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}}, [&] {
    p.make.Ring(
        p.is.hard, {},
        std::array<Vec2, 4>{{{0.86F * r, -0.08F * p.w}, {r, -0.08F * p.w}, {r, 0.08F * p.w}, {0.86F * r, 0.08F * p.w}}},
        32);
    p.make.Cylinder(p.is.hard, {0, 0, -0.16F * p.w}, 0.12F * r, 0.32F * p.w, 0.006F, 14);
    for (int i = 0; i < 10; ++i) {
      const float turn = kPiFloat / 5 * static_cast<float>(i);
      p.make.Bar(p.is.hard, {}, {0.9F * r * std::cos(turn), 0.9F * r * std::sin(turn), 0}, 0.7F * leg, 6);
    }
  });
  const float bench = 0.36F * p.h;
  p.make.Box(p.is.hard, {-0.3F * p.w, -0.4F * p.d, bench}, {0.3F * p.w, 0.5F * p.d, bench + 0.06F * p.h}, 0.01F);
  for (const float side : {-1.0F, 1.0F}) {
    p.make.Bar(p.is.hard, {side * 0.44F * p.w, -0.44F * p.d, 0}, {side * 0.2F * p.w, -0.3F * p.d, bench}, 1.2F * leg,
               8);
    p.make.Bar(p.is.hard, {side * 0.26F * p.w, hub.y, bench}, {side * 0.26F * p.w, hub.y, hub.z + 0.04F * p.h},
               1.1F * leg, 8);
  }
  p.make.Bar(p.is.hard, {0, 0.46F * p.d, 0}, {0, 0.34F * p.d, bench}, 1.2F * leg, 8);
  p.make.Bar(p.is.hard, {0, 0.38F * p.d, bench}, {0, 0.38F * p.d, 0.74F * p.h}, leg, 8);
  p.make.Bar(p.is.hard, {-0.5F * p.w, 0.38F * p.d, 0.66F * p.h}, {0.5F * p.w, 0.38F * p.d, 0.66F * p.h}, leg, 8);
  p.make.Ellipsoid(p.is.pale, {0, 0.38F * p.d, 0.78F * p.h}, {0.2F * p.w, 0.08F * p.d, 0.1F * p.h}, 14, 8);
}

void MakeTelescope(Piece& p) {
  const Vec3 top{0, 0, 0.66F * p.h};
  const float r = std::min(0.1F, 0.16F * p.smaller());
  for (int i = 0; i < 3; ++i) {
    const float turn = -kPiFloat / 2 + 2 * kPiFloat / 3 * static_cast<float>(i);
    p.make.Taper(p.is.hard, {0.48F * p.w * std::cos(turn), 0.48F * p.d * std::sin(turn), 0}, {0.25F * r, 0.25F * r},
                 {0.06F * p.w * std::cos(turn), 0.06F * p.d * std::sin(turn), top.z}, {0.4F * r, 0.4F * r});
  }
  const Vec3 along = Normalized({0, 0.62F * p.d, 0.55F * p.h});
  const float half = 0.5F * std::min(p.d / along.y, 0.66F * p.h / along.z);
  p.make.Ellipsoid(p.is.metal, top, {0.6F * r, 0.6F * r, 0.8F * r}, 12, 8);
  const Vec3 middle = top + Vec3{0, 0, 1.2F * r};
  p.make.Tube(p.is.metal,
              std::array<Vec3, 4>{{middle - along * (0.9F * half), middle - along * (0.5F * half),
                                   middle - along * (0.48F * half), middle + along * half}},
              std::array{0.4F * r, 0.4F * r, 0.75F * r, r}, 20);
  p.make.Tube(p.is.hard, std::array<Vec3, 2>{{middle + along * (0.8F * half), middle + along * (1.02F * half)}},
              std::array{1.12F * r}, 20);
}

void MakeGlobe(Piece& p) {
  const float r = std::min(0.42F * p.smaller(), 0.36F * p.h), z = p.h - 1.12F * r;
  static const Material kSea = PlainMaterial("sea", 0x4A7C9B, 0.4F), kLand = PlainMaterial("land", 0xB59A5B, 0.6F);
  p.make.Ellipsoid(kSea, {0, 0, z}, {r, r, r}, 26, 14);
  for (int i = 0; i < 7; ++i) {  // continents: caps a little larger than the sphere
    const float up = 1.6F * p.Chance(i) - 0.8F, turn = 2 * kPiFloat * p.Chance(20 + i), flat = std::sqrt(1 - up * up);
    const Vec3 out{flat * std::cos(turn), flat * std::sin(turn), up}, side = Normalized(Cross({0, 0.1F, 1}, out));
    const float cap = 0.35F + 0.3F * p.Chance(40 + i);
    p.make.In({{0, 0, z}, side, Cross(out, side), out}, [&] {
      std::vector<Vec2> profile = ArcPoints({}, 1.012F * r, 1.012F * r, kPiFloat / 2 - cap, kPiFloat / 2, 4);
      profile.back().x = 0;
      p.make.Lathe(kLand, {}, profile, 9, {1, 0.6F + 0.6F * p.Chance(60 + i)});
    });
  }
  p.make.In(Frame::TurnedY({0, 0, z}, 0.41F), [&] {
    p.make.In({{}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}}, [&] { p.make.Hoop(p.is.metal, {}, 1.07F * r, 0.05F * r, 36); });
    p.make.Bar(p.is.metal, {0, 0, -1.08F * r}, {0, 0, 1.08F * r}, 0.03F * r, 6);
  });
  p.make.Lathe(p.is.hard, {},
               std::array<Vec2, 7>{{{0.9F * r, 0},
                                    {0.88F * r, 0.02F * p.h},
                                    {0.3F * r, 0.05F * p.h},
                                    {0.14F * r, 0.14F * p.h},
                                    {0.2F * r, 0.4F * (z - r)},
                                    {0.12F * r, 0.9F * (z - 1.1F * r)},
                                    {0.2F * r, z - 1.05F * r}}},
               20);
  if (p.h > 0.7F) {
    p.make.In({{0, 0, z}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, [&] {
      p.make.Ring(p.is.hard, {},
                  std::array<Vec2, 4>{
                      {{1.1F * r, -0.03F * r}, {1.19F * r, -0.03F * r}, {1.19F * r, 0.03F * r}, {1.1F * r, 0.03F * r}}},
                  36);
    });
  }
}

}  // namespace

std::span<const PieceMaker> CraftMakers() {
  static constexpr PieceMaker kMakers[] = {{"easel", MakeEasel},         {"sewing_machine", MakeSewingMachine},
                                           {"mannequin", MakeMannequin}, {"ironing_board", MakeIroningBoard},
                                           {"loom", MakeLoom},           {"spinning_wheel", MakeSpinningWheel},
                                           {"telescope", MakeTelescope}, {"globe", MakeGlobe}};
  return kMakers;
}

}  // namespace flair::renderer
