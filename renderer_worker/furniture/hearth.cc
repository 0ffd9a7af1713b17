// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "renderer_worker/furniture/piece.h"

// Fire and water, carts and small things, and the box that everything else is shown as.
namespace flair::renderer {
namespace {

void Fire(Piece& p, Vec3 at, float size, float intensity_cd) {
  const Material bark = BaseMaterialOf("bark").look;
  for (int i = 0; i < 3; ++i) {
    p.make.In(Frame::TurnedZ(at + Vec3{0, 0, 0.16F * size * static_cast<float>(i == 2)},
                             i == 2 ? 0.3F : 1.2F * static_cast<float>(i) - 0.6F),
              [&] {
                p.make.Bar(bark, {-0.6F * size, 0, 0.12F * size}, {0.6F * size, 0, 0.12F * size}, 0.11F * size, 9);
              });
  }
  p.Flame(at + Vec3{0, 0, 0.2F * size}, 1.0F * size, intensity_cd);
  for (const float x : {-0.34F, 0.34F})
    p.make.Lathe(
        stuff::FlameStuff(), at + Vec3{x * size, 0.06F * size, 0.2F * size},
        std::array<Vec2, 4>{{{0, 0}, {0.14F * size, 0.16F * size}, {0.08F * size, 0.4F * size}, {0, 0.66F * size}}}, 8);
}

void MakeCauldron(Piece& p) {
  const float leg = 0.18F * p.h, body = 0.62F * p.h, pot_top = 0.86F * p.h;
  static const Material kBrew = [] {
    Material m = PlainMaterial("brew", 0x5E8A3A, 0.25F);
    m.emission = {0.02F, 0.05F, 0.01F};
    return m;
  }();
  p.make.Lathe(p.is.hard, {},
               std::array<Vec2, 11>{{{0, leg},
                                     {0.24F, leg + 0.02F * p.h},
                                     {0.4F, leg + 0.14F * p.h},
                                     {0.47F, leg + 0.3F * p.h},
                                     {0.45F, leg + 0.48F * p.h},
                                     {0.37F, body + 0.12F * p.h},
                                     {0.4F, pot_top},
                                     {0.45F, pot_top},
                                     {0.45F, pot_top + 0.03F * p.h},
                                     {0.37F, pot_top + 0.03F * p.h},
                                     {0.34F, 0.76F * p.h}}},
               30, {p.w, p.d});
  p.make.Lathe(kBrew, {0, 0, 0.78F * p.h}, std::array<Vec2, 2>{{{0.365F, 0}, {0.365F, 0.03F * p.h}}}, 28, {p.w, p.d});
  for (int i = 0; i < 6; ++i)
    p.make.Ellipsoid(kBrew,
                     {0.24F * p.w * (p.Chance(i) - 0.5F) * 2, 0.24F * p.d * (p.Chance(9 + i) - 0.5F) * 2, 0.81F * p.h},
                     {0.04F * p.w, 0.04F * p.d, 0.025F * p.h}, 10, 6);
  for (int i = 0; i < 3; ++i) {
    const float turn = kPiFloat / 2 + 2 * kPiFloat / 3 * static_cast<float>(i);
    p.make.Bar(p.is.hard, {0.36F * p.w * std::cos(turn), 0.36F * p.d * std::sin(turn), 0},
               {0.28F * p.w * std::cos(turn), 0.28F * p.d * std::sin(turn), 0.3F * p.h}, 0.03F * p.smaller(),
               0.045F * p.smaller(), 8);
  }
  std::vector<Vec3> bail;
  for (const Vec2& point : ArcPoints({0, 0.84F * p.h}, 0.49F * p.w, 0.15F * p.h, 0, kPiFloat, 12))
    bail.push_back({point.x, 0, point.y});
  p.make.Tube(p.is.hard, bail, std::array{0.014F * p.smaller()}, 6);
  Fire(p, {0, 0, 0}, 0.16F * p.smaller(), 25);
  p.Shine({0, 0, 0.98F * p.h}, 2, 0.05F * p.smaller(), {0.6F, 1, 0.35F});
}

void MakeFireplace(Piece& p) {
  if (p.Says("stove") || p.Says("burner") || p.Says("fire pit")) {
    const float leg = 0.14F * p.h, body = std::min(p.h, leg + 0.7F * p.h), r = 0.5F * p.smaller();
    p.LegsAt(p.is.metal, 0.4F * p.w, 0.36F * p.d, leg + 0.01F, 0.04F * p.smaller(), 0.6F);
    p.make.Box(p.is.metal, {-0.47F * p.w, -0.47F * p.d, leg}, {0.47F * p.w, 0.46F * p.d, body - 0.03F * p.h}, 0.01F);
    p.make.Box(p.is.metal, {-p.w / 2, -p.d / 2, body - 0.04F * p.h}, {p.w / 2, p.d / 2, body}, 0.008F);
    p.make.Box(stuff::Embers(), {-0.3F * p.w, 0.45F * p.d, leg + 0.14F * p.h},
               {0.3F * p.w, 0.47F * p.d, leg + 0.46F * p.h}, 0.002F);
    p.make.Bar(p.is.metal, {0, -0.1F * p.d, body}, {0, -0.1F * p.d, p.h}, 0.24F * r, 16);
    p.Shine({0, 0.6F * p.d, leg + 0.3F * p.h}, 40, 0.1F * r, {1, 0.6F, 0.28F});
    return;
  }
  const float jamb = 0.2F * p.w, lintel = 0.72F * p.h, mantel = std::min(0.07F, 0.08F * p.h),
              back = -p.d / 2 + 0.12F * p.d;
  static const Material kSoot = PlainMaterial("soot", 0x2A2623, 0.95F);
  for (const float side : {-1.0F, 1.0F})
    p.make.Box(p.is.hard, {side * 0.48F * p.w, -p.d / 2, 0}, {side * (p.w / 2 - jamb), 0.4F * p.d, lintel}, 0.01F);
  p.make.Box(p.is.hard, {-0.48F * p.w, -p.d / 2, lintel - 0.004F}, {0.48F * p.w, 0.4F * p.d, p.h - mantel}, 0.01F);
  p.make.Box(p.is.hard, {-p.w / 2, -p.d / 2, p.h - mantel}, {p.w / 2, p.d / 2, p.h}, 0.012F);
  p.make.Box(kSoot, {-p.w / 2 + 0.9F * jamb, -p.d / 2, 0}, {p.w / 2 - 0.9F * jamb, back, lintel}, 0);
  p.make.Box(p.is.hard, {-0.5F * p.w, -p.d / 2, 0}, {0.5F * p.w, p.d / 2, 0.04F * p.h}, 0.008F);
  const float size = std::min({0.4F * (p.w - 2 * jamb), 0.5F * p.d, 0.4F * lintel});
  for (const float x : {-0.5F, 0.5F})
    p.make.Bar(p.is.metal, {x * size, -0.3F * p.d, 0.09F * p.h}, {x * size, 0.25F * p.d, 0.09F * p.h}, 0.03F * size, 6);
  Fire(p, {0, -0.06F * p.d, 0.1F * p.h}, size, 60);
}

void MakeLogStack(Piece& p) {
  const float post = std::min(0.02F, 0.05F * p.smaller()), r = std::min({0.07F, 0.16F * p.h, 0.16F * p.w});
  for (const float side : {-1.0F, 1.0F}) {
    for (const float y : {-0.3F, 0.3F}) {
      p.make.Box(p.is.metal, {side * p.w / 2, y * p.d - post, 0}, {side * (p.w / 2 - post), y * p.d + post, p.h},
                 0.003F);
    }
  }
  for (const float y : {-0.3F, 0.3F}) {
    p.make.Box(p.is.metal, {-p.w / 2, y * p.d - post, 0}, {p.w / 2, y * p.d + post, post}, 0.003F);
  }
  // Logs in rows, each in the hollow between two of the row below; their cut ends are pale.
  const Material cut = BaseMaterialOf("pine").look;
  const float pitch = 2.04F * r, rise = 0.87F * pitch;
  const int rows = std::clamp(static_cast<int>((p.h - 2 * r - post) / rise) + 1, 1, 9);
  const int columns = std::clamp(static_cast<int>((p.w - 2 * post) / pitch), 1, 12);
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < columns - row % 2; ++i) {
      const float x = pitch * (static_cast<float>(i) - 0.5F * static_cast<float>(columns - 1 - row % 2));
      const float z = post + r + rise * static_cast<float>(row), half = p.d * (0.44F + 0.06F * p.Chance(20 * row + i));
      p.make.Bar(p.is.hard, {x, -0.98F * half, z}, {x, 0.98F * half, z}, r, 9);
      p.make.Bar(cut, {x, -half, z}, {x, half, z}, 0.86F * r, 9);
    }
  }
}

void MakeAquarium(Piece& p) {
  const float stand = p.h > 0.8F ? 0.52F * p.h : 0.05F * p.h, glass = std::min(0.008F, 0.03F * p.smaller()),
              level = p.h - 0.1F * (p.h - stand);
  p.make.Box(p.is.hard, {-p.w / 2, -p.d / 2, 0}, {p.w / 2, p.d / 2, stand}, 0.006F);
  if (p.h > 0.8F)
    for (const float side : {-1.0F, 1.0F})
      p.Panel(p.is.hard, {side < 0 ? -0.48F * p.w : 0.005F, 0.06F * p.h},
              {side < 0 ? -0.005F : 0.48F * p.w, 0.95F * stand}, p.d / 2 - 0.01F, 0.008F);
  static const Material kSand = PlainMaterial("sand", 0xD9C49A, 1);
  const float x = p.w / 2 - 2 * glass, y = p.d / 2 - 2 * glass;
  p.make.Box(kSand, {-x, -y, stand}, {x, y, stand + 0.1F * (p.h - stand)}, 0.003F);
  for (int i = 0; i < 9; ++i) {
    const Vec3 at{x * 1.7F * (p.Chance(i) - 0.5F), y * 1.5F * (p.Chance(20 + i) - 0.5F), stand + 0.08F * (p.h - stand)};
    if (i < 6)
      p.make.Lathe(stuff::Leaf(i), at,
                   std::array<Vec2, 4>{{{0.03F * p.smaller(), 0},
                                        {0.08F * p.smaller(), 0.25F * (p.h - stand)},
                                        {0.04F * p.smaller(), 0.45F * (p.h - stand)},
                                        {0, 0.6F * (p.h - stand)}}},
                   7, {1, 0.4F});
    p.make.Ellipsoid(i % 2 == 0 ? stuff::FlameStuff() : stuff::Book(3),
                     {-at.x, -at.y * 0.8F, stand + (0.3F + 0.45F * p.Chance(40 + i)) * (p.h - stand)},
                     {0.05F * p.smaller(), 0.012F * p.smaller(), 0.025F * p.smaller()}, 9, 5);
  }
  Material water = stuff::Water();
  water.name = "clear water";
  water.opacity = 0.3F;
  p.make.Box(water, {-0.995F * x, -0.99F * y, stand + 0.08F * (p.h - stand)}, {0.995F * x, 0.99F * y, level}, 0);
  for (const float side : {-1.0F, 1.0F}) {
    p.make.Box(stuff::Glass(), {side * (x + glass), -y, stand}, {side * (x + 2 * glass), y, p.h - glass}, 0);
    p.make.Box(stuff::Glass(), {-x - glass, side * (y + glass), stand},
               {x + glass, side * (y + 2 * glass), p.h - glass}, 0);
    p.make.Box(stuff::Black(), {-p.w / 2, side * p.d / 2, p.h - 3 * glass},
               {p.w / 2, side * (p.d / 2 - 3 * glass), p.h}, 0.002F);
    p.make.Box(stuff::Black(), {side * p.w / 2, -p.d / 2, p.h - 3 * glass},
               {side * (p.w / 2 - 3 * glass), p.d / 2, p.h}, 0.002F);
  }
}

void MakeCart(Piece& p) {
  const float wheel = std::min(0.04F, 0.1F * p.h), r = std::min(0.012F, 0.05F * p.smaller());
  for (const float sx : {-1.0F, 1.0F}) {
    for (const float sy : {-1.0F, 1.0F}) {
      const float x = sx * (p.w / 2 - 2 * r), y = sy * (p.d / 2 - 2 * r);
      p.make.Bar(p.is.metal, {x, y, 1.6F * wheel}, {x, y, p.h - r}, r, 8);
      p.make.In({{x, y, wheel}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}}, [&] {
        p.make.Cylinder(stuff::Rubber(), {0, 0, -0.4F * wheel}, wheel, 0.8F * wheel, 0.003F, 14);
      });
    }
    p.make.Bar(p.is.metal, {sx * (p.w / 2 - 2 * r), -p.d / 2 + 2 * r, p.h - r},
               {sx * (p.w / 2 - 2 * r), p.d / 2 - 2 * r, p.h - r}, r, 8);
  }
  const int levels = p.h > 0.85F ? 3 : 2;
  for (int i = 0; i < levels; ++i) {
    const float z = 2 * wheel +
                    (p.h - 0.14F * p.h - 2 * wheel) * static_cast<float>(i) / static_cast<float>(levels - 1),
                rim = 0.05F * p.h;
    p.make.Box(p.is.hard, {-p.w / 2 + r, -p.d / 2 + r, z}, {p.w / 2 - r, p.d / 2 - r, z + 0.02F * p.h}, 0.004F);
    for (const float side : {-1.0F, 1.0F})
      p.make.Bar(p.is.metal, {-p.w / 2 + 2 * r, side * (p.d / 2 - 2 * r), z + rim},
                 {p.w / 2 - 2 * r, side * (p.d / 2 - 2 * r), z + rim}, 0.6F * r, 6);
    for (int k = 0; k < 4; ++k) {  // bottles and boxes
      const float x = p.w * (-0.33F + 0.22F * static_cast<float>(k)),
                  tall = 0.24F * p.h * (0.6F + 0.4F * p.Chance(8 * i + k)), wide = 0.07F * p.w;
      p.make.Lathe(
          stuff::Book(k + 2 * i), {x, p.d * (0.3F * p.Chance(60 + 8 * i + k) - 0.15F), z + 0.02F * p.h},
          std::array<Vec2, 4>{{{wide, 0}, {wide, 0.6F * tall}, {0.35F * wide, 0.75F * tall}, {0.35F * wide, tall}}},
          12);
    }
  }
}

void MakeOrganizer(Piece& p) {            // pots of pens, trays of small things, what stands on desks
  if (p.h > 1.1F * std::max(p.w, p.d)) {  // a pot with what is put upright into it
    const float pot = 0.55F * p.h;
    p.make.Lathe(
        p.is.hard, {},
        std::array<Vec2, 5>{{{0.44F, 0}, {0.5F, 0.04F * pot}, {0.48F, pot}, {0.42F, pot}, {0.42F, 0.2F * pot}}}, 22,
        {p.w, p.d});
    for (int i = 0; i < 4; ++i) {
      const float turn = 1.7F * static_cast<float>(i) + p.Chance(i), x = 0.2F * p.w * std::cos(turn),
                  y = 0.2F * p.d * std::sin(turn);
      p.make.Bar(i == 0 ? p.is.metal : stuff::Book(i), {0.3F * x, 0.3F * y, 0.2F * pot},
                 {x, y, p.h * (i == 0 ? 1 : 0.75F + 0.2F * p.Chance(9 + i))}, std::min(0.008F, 0.06F * p.smaller()), 6);
    }
    return;
  }
  const float wall = std::min(0.006F, 0.06F * p.smaller()), low = 0.55F * p.h;
  p.make.Box(p.is.hard, {-p.w / 2, -p.d / 2, 0}, {p.w / 2, p.d / 2, 0.12F * low}, 0.002F);
  for (const float side : {-1.0F, 1.0F}) {
    p.make.Box(p.is.hard, {side * p.w / 2, -p.d / 2, 0}, {side * (p.w / 2 - wall), p.d / 2, low}, 0.002F);
    p.make.Box(p.is.hard, {-p.w / 2, side * p.d / 2, 0},
               {p.w / 2, side * (p.d / 2 - wall), side < 0 ? low : 0.7F * low}, 0.002F);
  }
  if (p.w > 1.5F * p.d) p.make.Box(p.is.hard, {-wall / 2, -p.d / 2, 0}, {wall / 2, p.d / 2, low}, 0.002F);
  for (int i = 0; i < 6; ++i) {
    const float x = p.w * (0.7F * p.Chance(i) - 0.35F), y = p.d * (0.6F * p.Chance(10 + i) - 0.3F),
                lean = 0.08F * p.w * (p.Chance(20 + i) - 0.5F);
    p.make.Bar(stuff::Book(i), {x, y, 0.1F * low}, {x + lean, y, p.h * (0.8F + 0.2F * p.Chance(30 + i))},
               std::min(0.005F, 0.05F * p.smaller()), 6);
  }
}

// Nothing is known of it but its size: a plain block.
void MakeBox(Piece& p) {
  p.make.Box(p.is.hard, {-p.w / 2, -p.d / 2, 0}, {p.w / 2, p.d / 2, p.h}, std::min(0.008F, 0.04F * p.smaller()));
}

}  // namespace

std::span<const PieceMaker> HearthMakers() {
  static constexpr PieceMaker kMakers[] = {{"cauldron", MakeCauldron},
                                           {"fireplace", MakeFireplace},
                                           {"log_stack", MakeLogStack},
                                           {"aquarium", MakeAquarium},
                                           {"cart", MakeCart},
                                           {"organizer", MakeOrganizer},
                                           {"box", MakeBox}};
  return kMakers;
}

}  // namespace flair::renderer
