// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "renderer_worker/furniture/piece.h"

// What shines.
namespace flair::renderer {
namespace {

// A shining ball, and its light.
void Bulb(Piece& p, Vec3 at, float radius, float intensity_cd) {
  p.make.Ellipsoid(stuff::Bulb(), at, {radius, radius, radius}, 12, 6);
  p.Shine(at, intensity_cd, radius);
}

void ShadeWithBulb(Piece& p, Vec3 base, float bottom, float top, float height, float intensity_cd) {
  Material shade = stuff::Shade();
  if (p.is.styled) {  // light shines through in the shade's own colour
    shade.name = "shining " + p.is.soft.name;
    shade.colour = Blend(p.is.soft.colour, stuff::Shade().colour, 0.5F);
    shade.emission = Blend(stuff::Shade().emission * p.is.soft.colour, stuff::Shade().emission, 0.55F);
  }
  p.Shade(base, bottom, top, height, shade);
  Bulb(p, base + Vec3{0, 0, 0.45F * height}, std::min(0.035F, 0.3F * std::min(top, height)), intensity_cd);
  // A diffuser closes it: from above nobody wants to look at wires.
  shade.name += " cover";
  shade.emission = shade.emission * 0.8F;
  p.make.Cylinder(shade, base + Vec3{0, 0, 0.95F * height}, 0.99F * top, 0.02F * height, 0, 28);
}

void MakeFloorLamp(Piece& p) {
  const float r = 0.5F * p.smaller(), pole = std::min(0.013F, 0.06F * r * 2),
              shade = std::min({0.3F, 0.22F * p.h, 1.6F * r});
  if (p.Says("arc") && std::max(p.w, p.d) > 0.5F) {
    const bool along_x = p.w >= p.d;
    const float reach = 0.5F * std::max(p.w, p.d), foot = std::min(0.16F, 0.5F * r + 0.05F),
                bell = std::min(0.2F, 0.5F * reach);
    p.make.In(along_x ? Frame{} : Frame{{}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}, [&] {
      p.make.Cylinder(p.is.hard, {-reach + foot, 0, 0}, foot, 0.03F, 0.006F, 28);
      std::vector<Vec3> arc{{-reach + foot, 0, 0.02F}};
      const float half = 0.5F * (2 * reach - foot - bell), drop = 0.3F * bell + 0.02F;
      for (const Vec2& point : ArcPoints({reach - bell - half, 0.55F * p.h}, half, 0.44F * p.h, kPiFloat, 0.06F, 14))
        arc.push_back({point.x, 0, point.y});
      p.make.Tube(p.is.hard, arc, std::array{pole}, 8);
      const Vec3 end = arc.back() - Vec3{0, 0, drop};
      p.make.Ring(p.is.hard, end - Vec3{0, 0, bell},
                  std::array<Vec2, 6>{{{0.95F * bell, 0},
                                       {bell, 0},
                                       {0.75F * bell, 0.6F * bell},
                                       {0.2F * bell, bell + drop},
                                       {0.16F * bell, bell + drop},
                                       {0.7F * bell, 0.6F * bell}}},
                  24);
      Bulb(p, end - Vec3{0, 0, 0.5F * bell}, 0.25F * bell, 70);
    });
    return;
  }
  if (p.Says("tripod")) {
    for (int i = 0; i < 3; ++i) {
      const float turn = kPiFloat / 2 + 2 * kPiFloat / 3 * static_cast<float>(i);
      p.make.Bar(p.is.hard, {0.9F * r * std::cos(turn), 0.9F * r * std::sin(turn), 0},
                 {0.06F * r * std::cos(turn), 0.06F * r * std::sin(turn), p.h - 0.8F * shade}, 1.1F * pole, 1.4F * pole,
                 8);
    }
  } else {
    p.make.Lathe(p.is.hard, {},
                 std::array<Vec2, 5>{{{0.62F * r, 0},
                                      {0.64F * r, 0.008F * p.h},
                                      {0.5F * r, 0.016F * p.h},
                                      {0.12F * r, 0.03F * p.h},
                                      {pole, 0.05F * p.h}}},
                 28);
    p.make.Bar(p.is.hard, {0, 0, 0.04F * p.h}, {0, 0, p.h - 0.5F * shade}, pole, 10);
  }
  p.make.Bar(p.is.metal, {0, 0, p.h - shade}, {0, 0, p.h - 0.06F * shade}, 0.8F * pole, 8);
  ShadeWithBulb(p, {0, 0, p.h - shade}, r, 0.72F * r, shade, 70);
}

void MakeTableLamp(Piece& p) {
  const float r = 0.5F * p.smaller(), shade = 0.48F * p.h;
  if (p.Says("lantern") || p.Says("oil")) {
    p.make.Slab(p.is.metal, RoundedOutline({-r, -r}, {r, r}, 0.2F * r), 0, 0.08F * p.h, 0.004F);
    p.make.Taper(p.is.metal, {0, 0, 0.7F * p.h}, {r, r}, {0, 0, 0.88F * p.h}, {0.3F * r, 0.3F * r});
    for (const float x : {-0.85F, 0.85F}) {
      for (const float y : {-0.85F, 0.85F})
        p.make.Bar(p.is.metal, {x * r, y * r, 0.06F * p.h}, {x * r, y * r, 0.72F * p.h}, 0.06F * r, 6);
    }
    p.make.Box(stuff::Glass(), {-0.8F * r, -0.8F * r, 0.08F * p.h}, {0.8F * r, 0.8F * r, 0.7F * p.h}, 0);
    p.make.Cylinder(stuff::Ivory(), {0, 0, 0.08F * p.h}, 0.35F * r, 0.24F * p.h, 0.003F, 14);
    p.Flame({0, 0, 0.33F * p.h}, 0.2F * p.h, 12);
    p.make.In({{0, 0, 0.88F * p.h}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}}, [&] {
      p.make.Hoop(p.is.metal, {0, 0.05F * p.h, 0}, 0.06F * p.h, 0.02F * p.h, 16);
    });
    return;
  }
  if (p.Says("desk") || p.Says("task") || p.Says("adjustable") || p.Says("work") || p.Says("reading") ||
      p.Says("industrial")) {
    // Jointed arm: up to the back, then over to the front.
    const float foot = std::min(0.36F * p.smaller(), 0.09F), y = 0.5F * p.d,
                thick = std::min(0.008F, 0.08F * p.smaller());
    const float bell = std::min(0.3F * p.smaller(), 0.09F);
    const Vec3 knee{0, -y + thick, 0.62F * p.h}, end{0, y - bell, 0.92F * p.h};
    p.make.Cylinder(p.is.hard, {0, -0.1F * p.d, 0}, std::max(foot, 0.3F * p.w), 0.04F * p.h, 0.006F, 26);
    p.make.Bar(p.is.hard, {0, -0.1F * p.d, 0.03F * p.h}, knee, thick, 8);
    p.make.Ellipsoid(p.is.metal, knee, {1.8F * thick, 1.8F * thick, 1.8F * thick}, 10, 6);
    p.make.Bar(p.is.hard, knee, end, thick, 8);
    p.make.In(Frame::TurnedX(end, 0.35F), [&] {
      p.make.Ring(p.is.hard, {0, 0, -0.16F * p.h},
                  std::array<Vec2, 6>{{{0.95F * bell, 0},
                                       {bell, 0},
                                       {0.7F * bell, 0.1F * p.h},
                                       {0.3F * bell, 0.2F * p.h},
                                       {0.26F * bell, 0.2F * p.h},
                                       {0.64F * bell, 0.1F * p.h}}},
                  22);
      p.make.Cylinder(p.is.hard, {0, 0, 0.02F * p.h}, 0.3F * bell, 0.05F * p.h, 0.003F, 14);
    });
    Bulb(p, end + Vec3{0, 0.03F * p.d, -0.1F * p.h}, 0.4F * bell, 30);
    return;
  }
  const float z = p.h - shade;
  p.make.Lathe(p.is.hard, {},
               std::array<Vec2, 8>{{{0.44F * r, 0},
                                    {0.46F * r, 0.03F * p.h},
                                    {0.2F * r, 0.07F * p.h},
                                    {0.42F * r, 0.2F * p.h},
                                    {0.48F * r, 0.3F * p.h},
                                    {0.36F * r, 0.42F * p.h},
                                    {0.12F * r, 0.5F * p.h},
                                    {0.08F * r, 0.56F * p.h}}},
               26);
  p.make.Bar(p.is.metal, {0, 0, 0.5F * p.h}, {0, 0, p.h - 0.04F * p.h}, 0.06F * r, 8);
  ShadeWithBulb(p, {0, 0, z}, r, 0.66F * r, shade, 40);
}

void MakeWallLamp(Piece& p) {
  const float r = std::min(0.42F * p.w, 0.5F * p.d), y = p.d / 2 - r;
  p.make.In({{0, -p.d / 2, 0.34F * p.h}, {-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
            [&] { p.make.Slab(p.is.metal, EllipseOutline({}, 0.3F * p.w, 0.24F * p.h, 24), 0, 0.1F * p.d, 0.006F); });
  p.make.Tube(p.is.metal,
              std::array<Vec3, 4>{{{0, -p.d / 2, 0.3F * p.h},
                                   {0, 0.5F * (y - p.d / 2), 0.12F * p.h},
                                   {0, y, 0.08F * p.h},
                                   {0, y, 0.42F * p.h}}},
              std::array{std::min(0.012F, 0.1F * r)}, 8);
  if (p.Says("torch") || p.Says("candle")) {
    p.make.Lathe(
        p.is.hard, {0, y, 0.02F * p.h},
        std::array<Vec2, 4>{{{0.25F * r, 0}, {0.4F * r, 0.4F * p.h}, {0.7F * r, 0.5F * p.h}, {0.6F * r, 0.56F * p.h}}},
        14);
    p.Flame({0, y, 0.55F * p.h}, 0.45F * p.h, 18);
    return;
  }
  ShadeWithBulb(p, {0, y, 0.42F * p.h}, r, 0.7F * r, 0.58F * p.h, 25);
}

void MakePendant(Piece& p) {
  const float r = 0.5F * p.smaller(), shade = std::min(0.7F * p.h, 1.2F * r), rod = std::min(0.006F, 0.1F * r);
  if (p.h < 0.16F || p.Says("flush") || p.Says("recessed") || (p.h < 0.4F * p.smaller())) {  // close to the ceiling
    p.make.Lathe(p.is.styled ? p.is.hard : stuff::White(), {0, 0, 0.72F * p.h},
                 std::array<Vec2, 3>{{{0.46F, 0}, {0.5F, 0.1F * p.h}, {0.5F, 0.28F * p.h}}}, 30, {p.w, p.d});
    p.make.Lathe(stuff::Shade(), {},
                 std::array<Vec2, 6>{{{0, 0},
                                      {0.2F, 0.04F * p.h},
                                      {0.36F, 0.2F * p.h},
                                      {0.44F, 0.45F * p.h},
                                      {0.46F, 0.74F * p.h},
                                      {0.4F, 0.76F * p.h}}},
                 28, {p.w, p.d});
    p.Shine({0, 0, 0.4F * p.h}, 90, 0.3F * r);
    return;
  }
  p.make.Lathe(p.is.metal, {0, 0, p.h - 0.05F * p.h},
               std::array<Vec2, 3>{{{0.2F * r, 0}, {0.36F * r, 0.03F * p.h}, {0.36F * r, 0.05F * p.h}}}, 20);
  p.make.Bar(stuff::Black(), {0, 0, 0.9F * shade}, {0, 0, p.h - 0.04F * p.h}, rod, 6);
  if (p.Says("globe") || p.Says("glass") || p.Says("lantern")) {
    p.make.Ellipsoid(stuff::Shade(), {0, 0, shade / 2}, {r, r, shade / 2}, 24, 14);
    p.Shine({0, 0, shade / 2}, 90, 0.8F * r);
    return;
  }
  const std::array<Vec2, 8> bell{{{0.96F * r, 0},
                                  {r, 0},
                                  {0.93F * r, 0.3F * shade},
                                  {0.6F * r, 0.72F * shade},
                                  {0.2F * r, shade},
                                  {0.16F * r, 0.98F * shade},
                                  {0.56F * r, 0.7F * shade},
                                  {0.89F * r, 0.3F * shade}}};
  p.make.Ring(p.is.hard, {}, bell, 28);
  p.make.Cylinder(p.is.metal, {0, 0, 0.94F * shade}, 0.2F * r, 0.1F * shade, 0.003F, 14);
  Bulb(p, {0, 0, 0.28F * shade}, std::min(0.05F, 0.4F * r), 90);
}

void MakeChandelier(Piece& p) {
  const float r = 0.5F * p.smaller(), thick = std::min(0.012F, 0.04F * r);
  const int arms = r > 0.45F ? 8 : 6;
  p.make.Lathe(p.is.metal, {0, 0, 0.94F * p.h},
               std::array<Vec2, 3>{{{0.06F * r, 0}, {0.2F * r, 0.04F * p.h}, {0.2F * r, 0.06F * p.h}}}, 20);
  p.make.Bar(p.is.metal, {0, 0, 0.5F * p.h}, {0, 0, 0.97F * p.h}, thick, 8);
  p.make.Lathe(p.is.metal, {},
               std::array<Vec2, 9>{{{0, 0},
                                    {0.06F * r, 0.03F * p.h},
                                    {0.03F * r, 0.06F * p.h},
                                    {0.14F * r, 0.14F * p.h},
                                    {0.12F * r, 0.22F * p.h},
                                    {0.05F * r, 0.28F * p.h},
                                    {0.09F * r, 0.36F * p.h},
                                    {0.04F * r, 0.46F * p.h},
                                    {0.03F * r, 0.55F * p.h}}},
               18);
  for (int i = 0; i < arms; ++i) {
    const float turn = 2 * kPiFloat * static_cast<float>(i) / static_cast<float>(arms), c = std::cos(turn),
                s = std::sin(turn);
    const auto at = [&](float out, float z) { return Vec3{c * out * r, s * out * r, z * p.h}; };
    p.make.Tube(p.is.metal,
                std::array<Vec3, 6>{{at(0.05F, 0.22F), at(0.3F, 0.13F), at(0.55F, 0.12F), at(0.78F, 0.18F),
                                     at(0.86F, 0.27F), at(0.86F, 0.32F)}},
                std::array{thick}, 7);
    p.make.Lathe(p.is.metal, at(0.86F, 0.31F),
                 std::array<Vec2, 3>{{{0.03F * r, 0}, {0.13F * r, 0.025F * p.h}, {0.14F * r, 0.035F * p.h}}}, 12);
    p.make.Cylinder(stuff::Ivory(), at(0.86F, 0.34F), 0.045F * r, 0.16F * p.h, 0.002F, 10);
    p.make.Lathe(
        stuff::Bulb(), at(0.86F, 0.5F),
        std::array<Vec2, 4>{{{0.02F * r, 0}, {0.05F * r, 0.03F * p.h}, {0.03F * r, 0.07F * p.h}, {0, 0.11F * p.h}}}, 8);
    if (i % 2 == 0) p.Shine(at(0.86F, 0.54F), 240.0F / static_cast<float>(arms), 0.05F * r);
    p.make.Tube(p.is.metal, std::array<Vec3, 4>{{at(0.03F, 0.55F), at(0.4F, 0.36F), at(0.7F, 0.3F), at(0.86F, 0.33F)}},
                std::array{0.4F * thick}, 5);
  }
}

}  // namespace

std::span<const PieceMaker> LampMakers() {
  static constexpr PieceMaker kMakers[] = {{"floor_lamp", MakeFloorLamp},
                                           {"table_lamp", MakeTableLamp},
                                           {"wall_lamp", MakeWallLamp},
                                           {"pendant", MakePendant},
                                           {"chandelier", MakeChandelier}};
  return kMakers;
}

}  // namespace flair::renderer
