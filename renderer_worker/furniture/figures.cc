// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "renderer_worker/furniture/piece.h"

// Figures and toys.
namespace flair::renderer {
namespace {
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
    const float turn = 2 * kPiFloat * (static_cast<float>(i) + 0.5F) / poles;
    const Vec3 foot{0.49F * p.w * std::cos(turn), 0.49F * p.d * std::sin(turn), 0};
    p.make.Bar(p.is.hard, foot, {-0.08F * foot.x, -0.08F * foot.y, p.h}, 0.012F * std::min(1.0F, p.smaller()), 8);
  }
  // Cloth all around but for the entrance at the front.
  p.make.Sheet(
      p.is.soft, 30, 5,
      [&](float u, float v) {
        const float open = 0.42F * (1 - v), turn = kPiFloat / 2 + open + (2 * kPiFloat - 2 * open) * u;
        const float flat = 1 / std::cos(std::fmod(turn + 2 * kPiFloat, 2 * kPiFloat / poles) - kPiFloat / poles) *
                           std::cos(kPiFloat / poles);
        const float r = 0.5F * (1 - 0.9F * v) * flat;
        return Vec3{r * p.w * std::cos(turn), r * p.d * std::sin(turn), 0.02F * p.h + 0.86F * p.h * v};
      },
      0.008F);
  p.make.Cushion(p.is.pale, {-0.26F * p.w, -0.26F * p.d, 0}, {0.26F * p.w, 0.2F * p.d, 0.06F * p.h}, 0.04F);
}

}  // namespace

std::span<const PieceMaker> FigureMakers() {
  static constexpr PieceMaker kMakers[] = {
      {"orb", MakeOrb}, {"statue", MakeStatue}, {"toy", MakeToy}, {"tent", MakeTent}};
  return kMakers;
}

}  // namespace flair::renderer
