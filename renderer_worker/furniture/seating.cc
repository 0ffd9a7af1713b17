// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "renderer_worker/furniture/classes.h"
#include "renderer_worker/furniture/piece.h"

// Sofas and what is upholstered.
namespace flair::renderer {
namespace {

struct SofaShape {
  float arm, back, seat, base;  // widths of arm and back, heights of seat and plinth
  float arm_height;
};

SofaShape ShapeOf(const Piece& p) {
  const float seat = RestHeightOf("sofa", p.h);
  return {.arm = std::min(0.2F, 0.16F * p.w),
          .back = std::min(0.24F, 0.27F * p.d),
          .seat = seat,
          .base = std::min(0.12F, 0.3F * seat),
          .arm_height = std::min(p.h, seat + 0.45F * (p.h - seat))};
}

// Frame with arms and back on short legs; cushions come on top.
void Carcass(Piece& p, const SofaShape& s, bool rolled) {
  const float x = p.w / 2, y = p.d / 2, soft = std::min(0.05F, 0.3F * s.arm);
  p.LegsAt(p.is.hard, x - std::min(0.07F, 0.1F * p.w), y - std::min(0.07F, 0.1F * p.d), s.base + 0.01F,
           std::min(0.028F, 0.04F * p.smaller()), 0.6F);
  const float deck = std::max(s.base + 0.02F, s.seat - std::min(0.16F, 0.4F * s.seat));
  p.make.Cushion(p.is.soft, {-x + 0.6F * s.arm, -y + 0.5F * s.back, s.base}, {x - 0.6F * s.arm, y - 0.03F * p.d, deck},
                 soft);
  p.make.Cushion(p.is.soft, {-x + 0.02F * p.w, -y, s.base}, {x - 0.02F * p.w, -y + s.back, p.h}, soft, 0.01F);
  for (const float side : {-1.0F, 1.0F}) {
    const float inner = side * (x - s.arm), outer = side * x,
                top = rolled ? s.arm_height - 0.45F * s.arm : s.arm_height;
    p.make.Cushion(p.is.soft, {inner, -y, s.base}, {outer, y, top}, soft);
    if (!rolled) continue;
    p.make.In({{side * (x - 0.5F * s.arm), -y, s.arm_height - 0.55F * s.arm}, {-1, 0, 0}, {0, 0, 1}, {0, 1, 0}}, [&] {
      p.make.Cylinder(p.is.soft, {}, 0.55F * s.arm, p.d, 0.02F, 18);
      p.make.Cylinder(p.is.accent, {0, 0, 0.985F * p.d}, 0.3F * s.arm, 0.02F * p.d, 0.004F, 14);
    });
  }
}

// Cushions side by side: on the seat and against the back.
void SeatCushions(Piece& p, const SofaShape& s, int count) {
  const float left = -p.w / 2 + s.arm, pitch = (p.w - 2 * s.arm) / static_cast<float>(count),
              gap = std::min(0.006F, 0.02F * pitch);
  const float deck = std::max(s.base + 0.02F, s.seat - std::min(0.16F, 0.4F * s.seat)),
              round = std::min(0.045F, 0.2F * pitch);
  const float thick = std::min(0.2F, 0.6F * s.back + 0.06F * p.d);
  for (int i = 0; i < count; ++i) {
    const float from = left + pitch * static_cast<float>(i) + gap, to = from + pitch - 2 * gap;
    p.make.Cushion(p.is.soft, {from, -p.d / 2 + s.back, deck}, {to, p.d / 2, s.seat}, round, 0.012F);
    p.make.In(Frame::TurnedX({0, -p.d / 2 + 0.9F * s.back, s.seat - 0.02F * p.h}, 0.13F), [&] {
      p.make.Cushion(p.is.soft, {from, 0, 0}, {to, thick, 0.98F * (p.h - s.seat)}, round, 0.035F);
    });
  }
}

void ScatterCushion(Piece& p, Vec3 at, float size, float lean, float turn, const Material& material) {
  p.make.In(Frame::TurnedZ(at, turn), [&] {
    p.make.In(Frame::TurnedX({}, lean), [&] {
      p.make.Pillow(material, {-size / 2, 0, 0}, {size / 2, 0.36F * size, size});
    });
  });
}

void MakeSofa(Piece& p) {
  const SofaShape s = ShapeOf(p);
  Carcass(p, s, p.Says("chesterfield") || p.Says("victorian") || p.Says("classic") || p.Says("rolled"));
  const int count = std::clamp(static_cast<int>(std::lround((p.w - 2 * s.arm) / 0.68F)), 1, 6);
  SeatCushions(p, s, count);
  if (p.w < 1) return;
  const float size = std::min(0.42F, 0.8F * (p.h - s.seat)), front = -p.d / 2 + s.back + 0.12F * p.d;
  ScatterCushion(p, {-p.w / 2 + s.arm + 0.62F * size, front, s.seat}, size, 0.3F, 0.25F, p.is.accent);
  ScatterCushion(p, {p.w / 2 - s.arm - 0.62F * size, front, s.seat}, 0.92F * size, 0.3F, -0.3F, p.is.pale);
}

void MakeArmchair(Piece& p) {
  SofaShape s = ShapeOf(p);
  s.arm = std::min(0.16F, 0.2F * p.w);
  const bool winged = p.Says("chesterfield") || p.Says("wingback") || p.Says("wing") || p.Says("victorian") ||
                      p.Says("gothic") || p.h > 1.05F;
  Carcass(p, s, winged);
  SeatCushions(p, s, 1);
  if (!winged) return;
  for (const float side : {-1.0F, 1.0F}) {  // the wings
    p.make.Cushion(p.is.soft, {side * (p.w / 2 - 0.6F * s.arm), -p.d / 2 + 0.5F * s.back, s.arm_height - 0.05F * p.h},
                   {side * p.w / 2, -p.d / 2 + 0.42F * p.d, 0.97F * p.h}, 0.3F * s.arm, 0.01F);
  }
}

void MakeDaybed(Piece& p) {
  const float seat = RestHeightOf("daybed", p.h), leg = 0.4F * seat, head = std::min(0.35F, 0.3F * std::max(p.w, p.d));
  const bool along_x = p.w >= p.d;
  p.LegsAt(p.is.hard, p.w / 2 - 0.05F * p.w, p.d / 2 - 0.05F * p.d, leg + 0.01F, std::min(0.03F, 0.05F * p.smaller()),
           0.55F);
  p.make.Box(p.is.hard, {-p.w / 2, -p.d / 2, leg}, {p.w / 2, p.d / 2, leg + 0.25F * seat}, 0.012F);
  p.make.Cushion(p.is.soft, {-0.49F * p.w, -0.49F * p.d, 0.62F * seat}, {0.49F * p.w, 0.49F * p.d, seat}, 0.05F,
                 0.015F);
  // A raised end to lean on, a back along half the length, a bolster.
  if (along_x) {
    p.make.Cushion(p.is.soft, {-p.w / 2, -p.d / 2, leg}, {-p.w / 2 + 0.5F * head, p.d / 2, p.h}, 0.06F, 0.02F);
    p.make.Cushion(p.is.soft, {-p.w / 2, -p.d / 2, leg},
                   {0.35F * p.w, -p.d / 2 + 0.18F * p.d, seat + 0.7F * (p.h - seat)}, 0.05F, 0.015F);
  } else {
    p.make.Cushion(p.is.soft, {-p.w / 2, -p.d / 2, leg}, {p.w / 2, -p.d / 2 + 0.5F * head, p.h}, 0.06F, 0.02F);
  }
  const float bolster = std::min(0.09F, 0.3F * (p.h - seat) + 0.02F);
  const float length = 0.8F * (along_x ? p.d : p.w);
  const Vec3 at = along_x ? Vec3{-p.w / 2 + 0.5F * head + bolster, 0, seat + 0.85F * bolster}
                          : Vec3{0, -p.d / 2 + 0.5F * head + bolster, seat + 0.85F * bolster};
  const Vec3 half = along_x ? Vec3{0, length / 2, 0} : Vec3{length / 2, 0, 0};
  p.make.Bar(p.is.accent, at - half, at + half, bolster, 16);
}

void MakePouf(Piece& p) {
  if (p.w > 1.3F * p.d || p.d > 1.3F * p.w || p.Says("storage") || p.Says("rectangular")) {
    p.LegsAt(p.is.hard, 0.44F * p.w, 0.44F * p.d, 0.2F * p.h, std::min(0.025F, 0.06F * p.smaller()));
    p.make.Cushion(p.is.soft, {-p.w / 2, -p.d / 2, 0.16F * p.h}, {p.w / 2, p.d / 2, 0.72F * p.h}, 0.03F);
    p.make.Cushion(p.is.soft, {-p.w / 2, -p.d / 2, 0.7F * p.h}, {p.w / 2, p.d / 2, p.h}, 0.05F, 0.02F);
    return;
  }
  const std::vector<Vec2> side = ArcPoints({0.36F, 0.5F}, 0.14F, 0.5F, -kPiFloat / 2, kPiFloat / 2, 10);
  std::vector<Vec2> profile;
  for (const Vec2& point : side) profile.push_back({point.x, point.y * p.h});
  p.make.Lathe(p.is.soft, {}, profile, 28, {p.w, p.d});
  for (int i = 0; i < 12; ++i) {  // seams
    const float turn = kPiFloat / 6 * static_cast<float>(i);
    std::vector<Vec3> seam;
    for (const Vec2& point : profile)
      seam.push_back({1.003F * p.w * point.x * std::cos(turn), 1.003F * p.d * point.x * std::sin(turn), point.y});
    p.make.Tube(p.is.accent, seam, std::array{0.006F * std::min(1.0F, p.smaller() / 0.4F)}, 4);
  }
  p.make.Ellipsoid(p.is.accent, {0, 0, 0.985F * p.h}, {0.06F * p.w, 0.06F * p.d, 0.03F * p.h}, 12, 4);
}

void MakeBeanBag(Piece& p) {
  // Sagging at the floor, sat in towards the front, gathered to a tuft at the top of its back.
  constexpr int kRound = 28, kUp = 12;
  p.make.Sheet(
      p.is.soft, kRound, kUp,
      [&](float u, float v) {
        const float turn = 2 * kPiFloat * u, swell = std::sin(kPiFloat * std::min(1.0F, 0.2F + 0.8F * v));
        const float r = 0.5F * (v > 0.97F ? 0.06F : std::pow(swell, 0.6F) * (1 - 0.12F * v));
        const float wrinkle = 1 + 0.025F * std::sin(7 * turn) * v;
        const float front = 0.5F + 0.5F * std::sin(turn), sat = 0.3F * front * std::sin(kPiFloat * v) * v;
        return Vec3{r * wrinkle * p.w * std::cos(turn), (r * wrinkle * std::sin(turn) - 0.16F * v * v) * p.d,
                    (v - sat) * 0.94F * p.h};
      },
      0.02F * p.smaller());
  p.make.Ellipsoid(p.is.accent, {0, -0.16F * p.d, 0.95F * p.h}, {0.05F * p.w, 0.05F * p.d, 0.05F * p.h}, 12, 6);
}

}  // namespace

std::span<const PieceMaker> SeatingMakers() {
  static constexpr PieceMaker kMakers[] = {{"sofa", MakeSofa},
                                           {"armchair", MakeArmchair},
                                           {"daybed", MakeDaybed},
                                           {"pouf", MakePouf},
                                           {"bean_bag", MakeBeanBag}};
  return kMakers;
}

}  // namespace flair::renderer
