// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "renderer_worker/furniture/piece.h"

// What stands about.
namespace flair::renderer {
namespace {
void MakeVase(Piece& p) {
  const bool flowers = p.Says("flower") || p.Says("bouquet") || (p.Says("vase") && p.h > 0.24F);
  const bool bowl = p.Says("bowl") || p.h < 0.6F * p.smaller(),
             pot = p.Says("jar") || p.Says("pot") || p.Says("potion") || p.Says("bottle");
  if (bowl) {
    p.make.Lathe(p.is.hard, {},
                 std::array<Vec2, 9>{{{0.2F, 0},
                                      {0.22F, 0.06F * p.h},
                                      {0.36F, 0.3F * p.h},
                                      {0.46F, 0.66F * p.h},
                                      {0.5F, 0.98F * p.h},
                                      {0.47F, p.h},
                                      {0.42F, 0.7F * p.h},
                                      {0.3F, 0.4F * p.h},
                                      {0, 0.28F * p.h}}},
                 28, {p.w, p.d});
    if (p.Says("fruit")) {
      for (int i = 0; i < 5; ++i)
        p.make.Ellipsoid(stuff::Book(i % 2 == 0 ? 3 : 0),
                         {0.2F * p.w * std::cos(1.3F * static_cast<float>(i)),
                          0.2F * p.d * std::sin(1.3F * static_cast<float>(i)), 0.7F * p.h},
                         {0.13F * p.w, 0.13F * p.w, 0.26F * p.h}, 12, 8);
    }
    return;
  }
  const float h = flowers ? 0.55F * p.h : p.h, wide = flowers ? 0.62F : 1.0F;
  const Vec2 size{wide * p.w, wide * p.d};
  if (pot) {
    p.make.Lathe(p.is.hard, {},
                 std::array<Vec2, 8>{{{0.4F, 0},
                                      {0.48F, 0.08F * h},
                                      {0.5F, 0.4F * h},
                                      {0.44F, 0.62F * h},
                                      {0.22F, 0.74F * h},
                                      {0.2F, 0.84F * h},
                                      {0.24F, 0.86F * h},
                                      {0.24F, 0.9F * h}}},
                 24, size);
    p.make.Lathe(stuff::Cork(), {0, 0, 0.89F * h}, std::array<Vec2, 2>{{{0.2F, 0}, {0.22F, 0.11F * h}}}, 16, size);
    return;
  }
  p.make.Lathe(p.is.hard, {},
               std::array<Vec2, 11>{{{0.24F, 0},
                                     {0.27F, 0.02F * h},
                                     {0.4F, 0.2F * h},
                                     {0.5F, 0.42F * h},
                                     {0.44F, 0.62F * h},
                                     {0.26F, 0.82F * h},
                                     {0.22F, 0.9F * h},
                                     {0.32F, h},
                                     {0.28F, h},
                                     {0.18F, 0.9F * h},
                                     {0, 0.86F * h}}},
               28, size);
  if (!flowers) return;
  for (int i = 0; i < 11; ++i) {
    const float turn = 2.39996F * static_cast<float>(i), out = 0.46F * std::sqrt((static_cast<float>(i) + 0.5F) / 11),
                z = p.h * (0.9F - 0.5F * out + 0.06F * p.Chance(i));
    const Vec3 tip{out * p.w * std::cos(turn), out * p.d * std::sin(turn), z};
    const float size_of = 0.11F * p.smaller();
    p.make.Bar(stuff::Leaf(2), {0, 0, 0.9F * h}, tip, 0.012F * p.smaller(), 5);
    p.make.Ellipsoid(stuff::Book(i % 3 == 0 ? 4 : i % 3 == 1 ? 0 : 3), tip, {size_of, size_of, 0.75F * size_of}, 9, 6);
    if (i % 2 == 0)
      p.make.Ellipsoid(stuff::Leaf(i), tip * 0.8F + Vec3{0, 0, 0.1F * p.h},
                       {0.9F * size_of, 0.5F * size_of, 0.3F * size_of}, 7, 4);
  }
}

void MakeTray(Piece& p) {
  const float wall = std::min(0.012F, 0.08F * p.smaller()), deck = std::min(0.25F * p.h, 0.02F),
              rim = std::min(p.h, std::max(0.05F, 0.3F * p.h));
  p.make.Slab(p.is.hard, RoundedOutline({-p.w / 2, -p.d / 2}, {p.w / 2, p.d / 2}, 0.04F), 0, deck, 0.003F);
  for (const float side : {-1.0F, 1.0F}) {
    p.make.Box(p.is.hard, {side * p.w / 2, -0.46F * p.d, 0}, {side * (p.w / 2 - wall), 0.46F * p.d, rim}, 0.004F);
    p.make.Box(p.is.hard, {-0.46F * p.w, side * p.d / 2, 0}, {0.46F * p.w, side * (p.d / 2 - wall), rim}, 0.004F);
  }
  const float cup = std::min(0.13F * p.smaller(), 0.05F),
              high = p.h > 1.2F * rim ? p.h - deck : std::min(p.h - deck, 0.05F);
  for (const Vec2 at : {Vec2{-0.2F * p.w, 0.12F * p.d}, Vec2{0.18F * p.w, -0.14F * p.d}}) {
    p.make.Lathe(stuff::White(), {at.x, at.y, deck},
                 std::array<Vec2, 6>{{{0.6F * cup, 0},
                                      {0.9F * cup, 0.3F * high},
                                      {cup, high},
                                      {0.9F * cup, high},
                                      {0.8F * cup, 0.3F * high},
                                      {0, 0.2F * high}}},
                 18);
  }
}

void MakeBooks(Piece& p) {
  const bool open = p.h < 0.03F, stack = p.Says("stack") || p.Says("pile"),
             upright = p.h > 0.9F * p.w && !stack && p.w > 0.1F;
  if (open) return p.Book({-p.w / 2, -p.d / 2, 0}, {p.w / 2, p.d / 2, p.h}, 0);
  if (upright || (!stack && p.w > 1.3F * std::max(p.d, p.h))) {
    const int count = std::clamp(static_cast<int>(p.w / 0.035F), 2, 14);
    float x = -p.w / 2;
    for (int i = 0; i < count; ++i) {
      const float thick = p.w / static_cast<float>(count),
                  tall = p.h * (i == count / 2 ? 1 : 0.72F + 0.28F * p.Chance(i));
      p.Book({x, -p.d / 2, 0}, {x + 0.96F * thick, p.d * (0.2F + 0.3F * p.Chance(30 + i)), tall}, i);
      x += thick;
    }
    return;
  }
  const int count = std::clamp(static_cast<int>(p.h / 0.035F), 1, 8);
  for (int i = 0; i < count; ++i) {
    const float thick = p.h / static_cast<float>(count), turn = i == 0 ? 0 : 0.3F * (p.Chance(i) - 0.5F),
                size = i == 0 ? 1 : 0.78F + 0.14F * p.Chance(20 + i);
    p.make.In(Frame::TurnedZ({0, 0, thick * static_cast<float>(i)}, turn), [&] {
      const float x = p.w / 2 * size, y = p.d / 2 * size, cover = 0.14F * thick;
      p.make.Box(stuff::Book(static_cast<int>(7 * p.Chance(40 + i))), {-x, -y, 0}, {x, y, cover}, 0.001F);
      p.make.Box(stuff::Book(static_cast<int>(7 * p.Chance(40 + i))), {-x, -y, 0.96F * thick - cover},
                 {x, y, 0.96F * thick}, 0.001F);
      p.make.Box(stuff::Book(static_cast<int>(7 * p.Chance(40 + i))), {-x, -y, 0}, {-x + cover, y, 0.96F * thick},
                 0.001F);
      p.make.Box(stuff::Paper(), {-x + cover, -0.95F * y, cover}, {0.96F * x, 0.95F * y, 0.96F * thick - cover}, 0);
    });
  }
}

void MakeCandles(Piece& p) {
  const bool branched = p.Says("candelabra") || p.Says("candelabrum") || (p.h > 0.3F && p.h > 1.4F * p.w);
  const float r = 0.5F * p.smaller();
  const auto candle = [&](Vec3 at, float radius, float high) {
    p.make.Cylinder(stuff::Ivory(), at, radius, high, 0.15F * radius, 14);
    p.Flame(at + Vec3{0, 0, high}, std::min(0.035F, 0.3F * high) * 1.4F, 4);
  };
  if (!branched) {
    const float plate = 0.06F * p.h;
    p.make.Lathe(p.is.metal, {},
                 std::array<Vec2, 4>{{{0.46F, 0}, {0.5F, plate}, {0.46F, plate}, {0.44F, 0.5F * plate}}}, 24,
                 {p.w, p.d});
    const float flame = 0.16F * p.h;
    candle({-0.34F * r, -0.2F * r, 0.5F * plate}, 0.34F * r, p.h - flame);
    candle({0.42F * r, -0.1F * r, 0.5F * plate}, 0.28F * r, 0.64F * (p.h - flame));
    candle({0.0F, 0.5F * r, 0.5F * plate}, 0.26F * r, 0.45F * (p.h - flame));
    return;
  }
  p.make.Lathe(p.is.metal, {},
               std::array<Vec2, 6>{{{0.8F * r, 0},
                                    {0.78F * r, 0.03F * p.h},
                                    {0.2F * r, 0.08F * p.h},
                                    {0.12F * r, 0.3F * p.h},
                                    {0.2F * r, 0.36F * p.h},
                                    {0.1F * r, 0.62F * p.h}}},
               18);
  for (int i = 0; i < 3; ++i) {
    const float x = (static_cast<float>(i) - 1) * (0.5F * p.w - 0.16F * r), z = (i == 1 ? 0.64F : 0.56F) * p.h;
    if (i != 1)
      p.make.Tube(p.is.metal,
                  std::array<Vec3, 4>{{{0, 0, 0.5F * p.h}, {0.5F * x, 0, 0.42F * p.h}, {x, 0, 0.46F * p.h}, {x, 0, z}}},
                  std::array{0.06F * r}, 7);
    p.make.Lathe(p.is.metal, {x, 0, z - 0.02F * p.h}, std::array<Vec2, 2>{{{0.1F * r, 0}, {0.16F * r, 0.03F * p.h}}},
                 12);
    candle({x, 0, z}, 0.08F * r, 0.24F * p.h);
  }
}

// Long blades that bend outwards from one root.
void Fronds(Piece& p, Vec3 root, float reach_x, float reach_y, float rise, int count, float width,
            const Material& material) {
  for (int i = 0; i < count; ++i) {
    const float turn = 2.39996F * static_cast<float>(i) + 0.5F * p.Chance(i), out = 0.55F + 0.45F * p.Chance(50 + i);
    const float high = rise * (0.7F + 0.3F * p.Chance(90 + i)) * (1.15F - 0.4F * out);
    const float c = std::cos(turn), s = std::sin(turn);
    p.make.Sheet(
        i % 3 == 0 ? stuff::Leaf(1) : material, 2, 6,
        [&](float u, float v) {
          const float across = (2 * u - 1) * width * std::sin(kPiFloat * std::min(0.98F, 0.14F + 0.86F * v));
          const float along = out * v * (0.35F + 0.65F * v), up = high * (1.7F * v - 0.75F * v * v);
          return root + Vec3{c * along * reach_x - s * across, s * along * reach_y + c * across,
                             up + 0.25F * std::abs(across)};
        },
        0.003F * std::min(1.0F, p.smaller() / 0.3F));
  }
}

void MakePlant(Piece& p) {
  const bool hanging = p.Says("hanging") || p.Says("ceiling");
  const float r = 0.5F * p.smaller(), pot = std::min(0.34F * p.h, 1.5F * r), rim = std::min(0.62F * r, 0.55F * pot);
  const Material& clay = p.Says("woven") || p.Says("basket") ? BaseMaterialOf("rattan").look : p.is.hard;
  const Material& leaf = stuff::Leaf(0);
  if (hanging) {
    const float base = 0.3F * p.h;
    p.Pot({0, 0, base}, 0.8F * rim + 0.1F * r, 0.8F * pot, clay);
    for (int i = 0; i < 3; ++i) {
      const float turn = 2 * kPiFloat / 3 * static_cast<float>(i);
      p.make.Bar(p.is.soft, {rim * std::cos(turn), rim * std::sin(turn), base + 0.7F * pot}, {0, 0, p.h}, 0.004F, 5);
    }
    p.Foliage({0, 0, base + 0.8F * pot}, {r, r, 0.2F * p.h}, 30, 0.5F * r, leaf);
    for (int i = 0; i < 9; ++i) {  // trailing shoots
      const float turn = 2.39996F * static_cast<float>(i), c = std::cos(turn) * r * 0.9F, s = std::sin(turn) * r * 0.9F,
                  low = base * p.Chance(i);
      p.make.Tube(
          leaf, std::array<Vec3, 3>{{{0.5F * c, 0.5F * s, base + 0.8F * pot}, {c, s, base + 0.5F * pot}, {c, s, low}}},
          std::array{0.004F}, 4);
      for (int k = 0; k < 4; ++k)
        p.make.Ellipsoid(
            stuff::Leaf(k),
            {c * (1 + 0.06F * p.Chance(k + 9 * i)), s, low + 0.24F * static_cast<float>(k) * (base + 0.4F * pot - low)},
            {0.1F * r, 0.1F * r, 0.06F * r}, 6, 4);
    }
    return;
  }
  p.Pot({}, rim, pot, clay);
  const float top = 0.85F * pot, rise = p.h - top;
  if (p.Says("cactus")) {
    for (const Vec3 c : {Vec3{0, 0, 0.5F}, Vec3{-0.5F, 0, 0.55F}, Vec3{0.5F, 0, 0.45F}}) {
      const float wide = c.x == 0 ? 0.34F * r : 0.17F * r;
      p.make.Ellipsoid(stuff::Leaf(2), {c.x * r, 0, top + c.z * rise}, {wide, wide, (c.x == 0 ? 0.5F : 0.28F) * rise},
                       14, 10);
      if (c.x != 0)
        p.make.Bar(stuff::Leaf(2), {0, 0, top + 0.35F * rise}, {c.x * r, 0, top + 0.4F * rise}, 0.8F * wide, 10);
    }
  } else if (p.h > 1.1F * p.smaller() &&
             (p.Says("tree") || p.Says("olive") || p.Says("fig") || p.Says("ficus") || p.h > 1.5F)) {
    const float crown = top + 0.62F * rise;
    p.make.Tube(BaseMaterialOf("bark").look,
                std::array<Vec3, 4>{{{0, 0, top - 0.05F * pot},
                                     {0.05F * r, 0, top + 0.2F * rise},
                                     {-0.04F * r, 0.03F * r, top + 0.4F * rise},
                                     {0, 0, crown}}},
                std::array{0.07F * r, 0.05F * r, 0.045F * r, 0.02F * r}, 8);
    p.Foliage({0, 0, crown}, {r, r, 0.38F * rise}, 90, std::min(0.2F, 0.42F * r), leaf);
    p.Foliage({0.1F * r, -0.1F * r, crown - 0.06F * rise}, {0.6F * r, 0.6F * r, 0.25F * rise}, 40,
              std::min(0.18F, 0.4F * r), stuff::Leaf(2));
  } else if (p.Says("palm") || p.Says("fern") || p.Says("snake") || p.Says("grass") || p.Chance(3) < 0.35F) {
    const bool upright = p.Says("snake") || p.Says("grass");
    Fronds(p, {0, 0, top}, (upright ? 0.85F : 1.0F) * r, (upright ? 0.85F : 1.0F) * r, rise * (upright ? 1.0F : 0.95F),
           upright ? 18 : 30, std::min(0.05F, 0.14F * r), leaf);
  } else {
    p.Foliage({0, 0, top + 0.36F * rise}, {r, r, 0.6F * rise}, 64, std::min(0.26F, 0.62F * r), leaf);
    p.make.Tube(stuff::Leaf(2), std::array<Vec3, 2>{{{0, 0, top - 0.04F * pot}, {0, 0, top + 0.6F * rise}}},
                std::array{0.06F * r}, 6);
  }
}

}  // namespace

std::span<const PieceMaker> DecorMakers() {
  static constexpr PieceMaker kMakers[] = {
      {"vase", MakeVase}, {"tray", MakeTray}, {"books", MakeBooks}, {"candles", MakeCandles}, {"plant", MakePlant}};
  return kMakers;
}

}  // namespace flair::renderer
