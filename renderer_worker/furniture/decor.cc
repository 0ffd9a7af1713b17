// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "renderer_worker/furniture/families.h"

// What stands about.
namespace flair::renderer {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

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
          const float across = (2 * u - 1) * width * std::sin(kPi * std::min(0.98F, 0.14F + 0.86F * v));
          const float along = out * v * (0.35F + 0.65F * v), up = high * (1.7F * v - 0.75F * v * v);
          return root + Vec3{c * along * reach_x - s * across, s * along * reach_y + c * across,
                             up + 0.25F * std::abs(across)};
        },
        0.003F * std::min(1.0F, p.smaller() / 0.3F));
  }
}

}  // namespace

void MakePlant(Piece& p) {
  const bool hanging = p.Says("hanging") || p.Says("ceiling");
  const float r = 0.5F * p.smaller(), pot = std::min(0.34F * p.h, 1.5F * r), rim = std::min(0.62F * r, 0.55F * pot);
  const Material& clay = p.Says("woven") || p.Says("basket") ? BaseMaterialOf("rattan").look : p.is.hard;
  const Material& leaf = stuff::Leaf(0);
  if (hanging) {
    const float base = 0.3F * p.h;
    p.Pot({0, 0, base}, 0.8F * rim + 0.1F * r, 0.8F * pot, clay);
    for (int i = 0; i < 3; ++i) {
      const float turn = 2 * kPi / 3 * static_cast<float>(i);
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
    Fronds(p, {0, 0, top}, (upright ? 0.5F : 1.0F) * r, (upright ? 0.5F : 1.0F) * r, rise * (upright ? 1.0F : 0.95F),
           upright ? 18 : 30, std::min(0.05F, 0.14F * r), leaf);
  } else {
    p.Foliage({0, 0, top + 0.36F * rise}, {r, r, 0.6F * rise}, 64, std::min(0.26F, 0.62F * r), leaf);
    p.make.Tube(stuff::Leaf(2), std::array<Vec3, 2>{{{0, 0, top - 0.04F * pot}, {0, 0, top + 0.6F * rise}}},
                std::array{0.06F * r}, 6);
  }
}

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
  const bool open = p.h < 0.03F, upright = p.h > 0.9F * p.w && !p.Says("stack") && p.w > 0.1F;
  if (open) return p.Book({-p.w / 2, -p.d / 2, 0}, {p.w / 2, p.d / 2, p.h}, 0);
  if (upright || p.w > 1.3F * std::max(p.d, p.h)) {
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

void MakeOrb(Piece& p) {
  const float stand = p.Says("ball") && !p.Says("crystal") ? 0 : 0.16F * p.h,
              r = std::min(0.5F * p.smaller(), 0.5F * (p.h - stand));
  const bool crystal = p.Says("crystal") || p.Says("glass") || p.Says("orb");
  p.make.Ellipsoid(crystal ? stuff::Glass() : p.is.hard, {0, 0, p.h - r}, {r, r, r}, 28, 16);
  if (crystal) p.make.Ellipsoid(p.is.soft, {0, 0, p.h - r}, {0.55F * r, 0.55F * r, 0.5F * r}, 18, 10);
  if (stand > 0)
    p.make.Lathe(p.is.metal, {},
                 std::array<Vec2, 5>{{{0.8F * r, 0},
                                      {0.78F * r, 0.25F * stand},
                                      {0.4F * r, 0.6F * stand},
                                      {0.62F * r, 1.3F * stand},
                                      {0.5F * r, 1.4F * stand}}},
                 22);
}

void MakeStatue(Piece& p) {
  const float base = 0.12F * p.h, r = 0.5F * p.smaller();
  p.make.Box(p.is.hard, {-p.w / 2, -p.d / 2, 0}, {p.w / 2, p.d / 2, 0.6F * base}, 0.006F);
  p.make.Box(p.is.hard, {-0.42F * p.w, -0.42F * p.d, 0.59F * base}, {0.42F * p.w, 0.42F * p.d, base}, 0.006F);
  const float rise = p.h - base;
  if (p.Says("obelisk") || p.Says("column") || p.Says("pillar")) {
    p.make.Lathe(p.is.hard, {0, 0, base},
                 std::array<Vec2, 6>{{{0.8F * r, 0},
                                      {0.76F * r, 0.06F * rise},
                                      {0.62F * r, 0.1F * rise},
                                      {0.56F * r, 0.88F * rise},
                                      {0.74F * r, 0.94F * rise},
                                      {0.8F * r, rise}}},
                 20);
    return;
  }
  if (p.Says("bust") || rise < 1.6F * r) {
    p.make.Lathe(
        p.is.hard, {0, 0, base},
        std::array<Vec2, 5>{
            {{0.34F, 0}, {0.2F, 0.14F * rise}, {0.42F, 0.34F * rise}, {0.36F, 0.48F * rise}, {0.13F, 0.54F * rise}}},
        22, {p.w, 0.8F * p.d});
    p.make.Bar(p.is.hard, {0, 0, base + 0.5F * rise}, {0, 0, base + 0.68F * rise}, 0.24F * r, 14);
    p.make.Ellipsoid(p.is.hard, {0, 0.04F * p.d, base + 0.8F * rise}, {0.36F * r, 0.42F * r, 0.2F * rise}, 20, 14);
    p.make.Ellipsoid(p.is.hard, {0, 0.36F * r + 0.04F * p.d, base + 0.78F * rise}, {0.07F * r, 0.1F * r, 0.05F * rise},
                     8, 6);
    return;
  }
  // A standing figure: robe, shoulders, arms, head.
  p.make.Lathe(p.is.hard, {0, 0, base},
               std::array<Vec2, 7>{{{0.36F, 0},
                                    {0.3F, 0.2F * rise},
                                    {0.26F, 0.45F * rise},
                                    {0.24F, 0.58F * rise},
                                    {0.34F, 0.74F * rise},
                                    {0.28F, 0.8F * rise},
                                    {0.08F, 0.84F * rise}}},
               22, {p.w, 0.8F * p.d});
  p.make.Ellipsoid(p.is.hard, {0, 0, base + 0.92F * rise}, {0.2F * r, 0.22F * r, 0.08F * rise}, 16, 10);
  for (const float side : {-1.0F, 1.0F}) {
    p.make.Tube(p.is.hard,
                std::array<Vec3, 3>{{{side * 0.3F * p.w, 0, base + 0.76F * rise},
                                     {side * 0.42F * p.w, 0.06F * p.d, base + 0.58F * rise},
                                     {side * 0.2F * p.w, 0.32F * p.d, base + 0.54F * rise}}},
                std::array{0.13F * r, 0.11F * r, 0.08F * r}, 10);
  }
}

void MakeToy(Piece& p) {  // a rocking horse when there is room, else a bear
  if (p.Says("horse") || p.d > 0.6F || p.w > 0.6F) {
    const bool lengthwise = p.d >= p.w;
    const float length = lengthwise ? p.d : p.w, width = lengthwise ? p.w : p.d;
    p.make.In(lengthwise ? Frame{} : Frame{{}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}, [&] {
      for (const float side : {-1.0F, 1.0F}) {
        std::vector<Vec3> runner;
        for (int i = 0; i <= 10; ++i) {
          const float t = -1 + static_cast<float>(i) / 5;
          runner.push_back({side * 0.44F * width, 0.5F * length * t, 0.03F * p.h + 0.12F * p.h * t * t});
        }
        p.make.Tube(BaseMaterialOf("oak").look, runner, std::array{0.06F * width}, 8);
        for (const float y : {-0.24F, 0.22F})
          p.make.Bar(p.is.hard, {side * 0.42F * width, y * length, 0.06F * p.h},
                     {side * 0.2F * width, 0.8F * y * length, 0.5F * p.h}, 0.06F * width, 0.09F * width, 8);
      }
      p.make.Ellipsoid(p.is.hard, {0, 0, 0.52F * p.h}, {0.3F * width, 0.3F * length, 0.13F * p.h}, 18, 10);
      p.make.Bar(p.is.hard, {0, 0.2F * length, 0.55F * p.h}, {0, 0.3F * length, 0.86F * p.h}, 0.2F * width,
                 0.14F * width, 12);
      p.make.Ellipsoid(p.is.hard, {0, 0.37F * length, 0.88F * p.h}, {0.15F * width, 0.13F * length, 0.08F * p.h}, 14,
                       8);
      p.make.Cushion(p.is.soft, {-0.28F * width, -0.14F * length, 0.6F * p.h},
                     {0.28F * width, 0.1F * length, 0.68F * p.h}, 0.03F * p.h, 0.01F);
      p.make.Bar(p.is.accent, {0, 0.2F * length, 0.68F * p.h}, {0, 0.28F * length, 0.96F * p.h}, 0.07F * width,
                 0.04F * width, 6);
      p.make.Tube(
          p.is.accent,
          std::array<Vec3, 3>{
              {{0, -0.28F * length, 0.56F * p.h}, {0, -0.4F * length, 0.5F * p.h}, {0, -0.42F * length, 0.3F * p.h}}},
          std::array{0.06F * width}, 6);
    });
    return;
  }
  const Material& fur = p.is.soft;
  p.make.Ellipsoid(fur, {0, -0.05F * p.d, 0.32F * p.h}, {0.34F * p.w, 0.36F * p.d, 0.3F * p.h}, 16, 10);
  p.make.Ellipsoid(fur, {0, 0, 0.74F * p.h}, {0.27F * p.w, 0.28F * p.d, 0.22F * p.h}, 16, 10);
  p.make.Ellipsoid(p.is.pale, {0, 0.26F * p.d, 0.69F * p.h}, {0.12F * p.w, 0.1F * p.d, 0.08F * p.h}, 10, 6);
  for (const float side : {-1.0F, 1.0F}) {
    p.make.Ellipsoid(fur, {side * 0.2F * p.w, 0, 0.93F * p.h}, {0.1F * p.w, 0.06F * p.d, 0.07F * p.h}, 10, 6);
    p.make.Ellipsoid(fur, {side * 0.38F * p.w, 0.06F * p.d, 0.4F * p.h}, {0.12F * p.w, 0.16F * p.d, 0.14F * p.h}, 10,
                     6);
    p.make.Ellipsoid(fur, {side * 0.26F * p.w, 0.34F * p.d, 0.12F * p.h}, {0.14F * p.w, 0.16F * p.d, 0.12F * p.h}, 10,
                     6);
    p.make.Ellipsoid(stuff::Black(), {side * 0.1F * p.w, 0.25F * p.d, 0.79F * p.h},
                     {0.03F * p.w, 0.03F * p.d, 0.03F * p.h}, 8, 4);
  }
}

void MakeTent(Piece& p) {
  const int poles = 6;
  for (int i = 0; i < poles; ++i) {
    const float turn = 2 * kPi * (static_cast<float>(i) + 0.5F) / poles;
    const Vec3 foot{0.49F * p.w * std::cos(turn), 0.49F * p.d * std::sin(turn), 0};
    p.make.Bar(p.is.hard, foot, {-0.08F * foot.x, -0.08F * foot.y, p.h}, 0.012F * std::min(1.0F, p.smaller()), 8);
  }
  // Cloth all around but for the entrance at the front.
  p.make.Sheet(
      p.is.soft, 30, 5,
      [&](float u, float v) {
        const float open = 0.42F * (1 - v), turn = kPi / 2 + open + (2 * kPi - 2 * open) * u;
        const float flat =
            1 / std::cos(std::fmod(turn + 2 * kPi, 2 * kPi / poles) - kPi / poles) * std::cos(kPi / poles);
        const float r = 0.5F * (1 - 0.9F * v) * flat;
        return Vec3{r * p.w * std::cos(turn), r * p.d * std::sin(turn), 0.02F * p.h + 0.86F * p.h * v};
      },
      0.008F);
  p.make.Cushion(p.is.pale, {-0.26F * p.w, -0.26F * p.d, 0}, {0.26F * p.w, 0.2F * p.d, 0.06F * p.h}, 0.04F);
}

}  // namespace flair::renderer
