// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "renderer_worker/furniture/classes.h"
#include "renderer_worker/furniture/piece.h"

// Tables and desks.
namespace flair::renderer {
namespace {

float TopThickness(const Piece& p) { return std::min({0.032F, 0.12F * p.h, 0.2F * p.smaller()}); }
float LegHalf(const Piece& p, float usual) { return std::min(usual, 0.05F * p.smaller()); }
bool Round(const Piece& p) { return p.Says("round") || p.Says("oval") || p.Says("circular"); }

void RectangularTop(Piece& p, float thick) {
  const Vec2 low{-p.w / 2, -p.d / 2}, high{p.w / 2, p.d / 2};
  p.make.Slab(p.is.hard, RoundedOutline(low, high, 0.02F), p.h - thick, p.h, 0.005F);
}

// A table top on four legs with an apron.
void FourLegs(Piece& p, float leg, bool apron) {
  const float thick = TopThickness(p), rail = std::min(0.09F, 0.16F * p.h), x = p.w / 2 - 1.8F * leg,
              y = p.d / 2 - 1.8F * leg;
  RectangularTop(p, thick);
  const bool metal = p.Says("metal legs") || p.Says("steel legs") || p.Says("hairpin") || p.Says("metal frame") ||
                     p.Says("industrial");
  const Material& legs = metal ? p.is.metal : p.is.hard;
  p.LegsAt(legs, x, y, p.h - thick, metal ? 0.7F * leg : leg, metal ? 1 : 0.62F);
  if (!apron) return;
  const float in = 0.55F * leg;
  for (const float side : {-1.0F, 1.0F}) {
    p.make.Box(legs, {-x, side * y - in, p.h - thick - rail}, {x, side * y + in, p.h - thick}, 0.003F);
    p.make.Box(legs, {side * x - in, -y, p.h - thick - rail}, {side * x + in, y, p.h - thick}, 0.003F);
  }
}

// A round or oval top on a turned pedestal with a spreading foot.
void Pedestal(Piece& p) {
  const float thick = TopThickness(p), r = std::min(0.06F, 0.09F * p.smaller()),
              foot = std::min(0.34F, 0.33F * p.smaller());
  p.make.Slab(p.is.hard, EllipseOutline({}, p.w / 2, p.d / 2, 40), p.h - thick, p.h, 0.007F);
  p.make.Slab(p.is.hard, EllipseOutline({}, 0.36F * p.w, 0.36F * p.d, 32), p.h - 1.9F * thick, p.h - thick, 0.003F);
  p.make.Lathe(p.is.hard, {},
               std::array<Vec2, 10>{{{foot, 0},
                                     {foot, 0.02F * p.h},
                                     {0.8F * foot, 0.05F * p.h},
                                     {0.5F * foot, 0.08F * p.h},
                                     {r, 0.16F * p.h},
                                     {0.8F * r, 0.3F * p.h},
                                     {1.25F * r, 0.5F * p.h},
                                     {0.75F * r, 0.72F * p.h},
                                     {r, 0.86F * p.h},
                                     {2.4F * r, p.h - 1.8F * thick}}},
               24);
}

// Drawers side by side in [left, right], below `top`.
void Drawers(Piece& p, float left, float right, float bottom, float top, int count, int rows) {
  const float wide = (right - left) / static_cast<float>(count), high = (top - bottom) / static_cast<float>(rows);
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < count; ++i) {
      const float x = left + wide * static_cast<float>(i), z = bottom + high * static_cast<float>(row),
                  gap = std::min(0.004F, 0.03F * high);
      p.Panel(p.is.hard, {x + gap, z + gap}, {x + wide - gap, z + high - gap}, p.d / 2 - 0.03F, 0.016F);
      p.Knob({x + wide / 2, p.d / 2 - 0.015F, z + high / 2}, std::min(0.011F, 0.12F * high));
    }
  }
}

void MakeRoundTable(Piece& p) { Pedestal(p); }

void MakeCoffeeTable(Piece& p) {
  const float leg = LegHalf(p, 0.024F), thick = TopThickness(p);
  if (Round(p)) {
    p.make.Slab(p.is.hard, EllipseOutline({}, p.w / 2, p.d / 2, 36), p.h - thick, p.h, 0.006F);
    for (int i = 0; i < 4; ++i) {
      const float turn = kPiFloat / 4 + kPiFloat / 2 * static_cast<float>(i), x = std::cos(turn), y = std::sin(turn);
      p.make.Bar(p.is.hard, {0.42F * p.w * x, 0.42F * p.d * y, 0}, {0.34F * p.w * x, 0.34F * p.d * y, p.h - thick},
                 0.5F * leg, leg, 10);
    }
    p.make.Slab(p.is.hard, EllipseOutline({}, 0.33F * p.w, 0.33F * p.d, 30), 0.32F * p.h, 0.32F * p.h + 0.6F * thick,
                0.004F);
  } else {
    FourLegs(p, leg, false);
    p.make.Box(p.is.hard, {-0.46F * p.w, -0.43F * p.d, 0.3F * p.h},
               {0.46F * p.w, 0.43F * p.d, 0.3F * p.h + 0.6F * thick}, 0.004F);
  }
  if (p.smaller() < 0.35F) return;
  const float size = std::min(0.26F, 0.3F * p.smaller());  // books below, nothing above: others may stand there
  p.Book({-0.24F * p.w, -size / 2, 0.3F * p.h + 0.55F * thick},
         {-0.24F * p.w + size, size / 2, 0.3F * p.h + 0.55F * thick + 0.03F}, 3);
}

void MakeTable(Piece& p) { Round(p) ? MakeRoundTable(p) : FourLegs(p, LegHalf(p, 0.036F), true); }

void MakeSideTable(Piece& p) {
  if (Round(p) || p.Says("pedestal") || (std::abs(p.w - p.d) < 0.02F * p.w && !p.Says("drawer") && p.Chance(7) < 0.5F))
    return Pedestal(p);
  const float leg = LegHalf(p, 0.02F), thick = TopThickness(p);
  FourLegs(p, leg, true);
  p.make.Box(p.is.hard, {-p.w / 2 + 1.5F * leg, -p.d / 2 + 1.5F * leg, 0.25F * p.h},
             {p.w / 2 - 1.5F * leg, p.d / 2 - 1.5F * leg, 0.25F * p.h + 0.7F * thick}, 0.003F);
}

void MakeNightstand(Piece& p) {
  const float thick = TopThickness(p), foot = std::min(0.12F, 0.22F * p.h), leg = LegHalf(p, 0.02F), open = 0.42F * p.h;
  RectangularTop(p, thick);
  p.LegsAt(p.is.hard, p.w / 2 - 2 * leg, p.d / 2 - 2.4F * leg, foot + 0.01F, leg, 0.6F, 0.6F * leg);
  const float side = std::min(0.02F, 0.06F * p.w), x = p.w / 2 - 0.02F * p.w, y = p.d / 2 - 0.03F;
  for (const float s : {-1.0F, 1.0F})
    p.make.Box(p.is.hard, {s * x, -p.d / 2 + 0.01F * p.d, foot}, {s * (x - side), y, p.h - thick}, 0.003F);
  p.make.Box(p.is.hard, {-x, -p.d / 2 + 0.01F * p.d, foot}, {x, y, foot + side}, 0.003F);
  p.make.Box(p.is.hard, {-x, -p.d / 2 + 0.01F * p.d, foot}, {x, -p.d / 2 + 0.01F * p.d + side, p.h - thick}, 0.003F);
  p.make.Box(p.is.hard, {-x, -p.d / 2 + 0.01F * p.d, open + 0.12F * p.h}, {x, y, p.h - thick}, 0.003F);
  Drawers(p, -x + side, x - side, open + 0.12F * p.h, p.h - 1.2F * thick, 1, 1);
  if (p.w < 0.25F) return;
  p.Book({-0.25F * p.w, -0.2F * p.d, foot + side}, {0.2F * p.w, 0.2F * p.d, foot + side + 0.035F}, 1);
  p.Book({-0.2F * p.w, -0.2F * p.d, foot + side + 0.036F}, {0.18F * p.w, 0.16F * p.d, foot + side + 0.06F}, 5);
}

void MakeDesk(Piece& p) {
  const float thick = TopThickness(p), leg = LegHalf(p, 0.024F), unit = std::min(0.42F, 0.34F * p.w),
              apron = std::min(0.12F, 0.18F * p.h);
  RectangularTop(p, thick);
  const Material& legs = p.Says("metal") || p.Says("industrial") ? p.is.metal : p.is.hard;
  p.LegsAt(legs, p.w / 2 - 2 * leg, p.d / 2 - 2 * leg, p.h - thick, leg, 0.65F);
  const float y = p.d / 2 - 0.03F;
  p.make.Box(p.is.hard, {-p.w / 2 + 2 * leg, -p.d / 2 + leg, p.h - thick - apron}, {p.w / 2 - 2 * leg, y, p.h - thick},
             0.004F);
  // Drawers under the right end of someone who sits at its front and looks over it: at -x.
  if (p.w > 0.9F && !p.Says("writing") && !p.Says("simple")) {
    p.make.Box(p.is.hard, {-p.w / 2 + 0.02F * p.w, -p.d / 2 + leg, 0.14F * p.h}, {-p.w / 2 + unit, y, p.h - thick},
               0.004F);
    Drawers(p, -p.w / 2 + 0.02F * p.w, -p.w / 2 + unit, 0.14F * p.h, p.h - 1.3F * thick, 1, 3);
    Drawers(p, -p.w / 2 + unit, p.w / 2 - 2.5F * leg, p.h - thick - apron, p.h - 1.3F * thick, 1, 1);
  } else {
    Drawers(p, -p.w / 2 + 2.5F * leg, p.w / 2 - 2.5F * leg, p.h - thick - apron, p.h - 1.3F * thick, p.w > 0.7F ? 2 : 1,
            1);
  }
}

void MakeVanity(Piece& p) {
  const float top = RestHeightOf("vanity", p.h), back = -p.d / 2;
  Piece desk{.w = p.w, .d = p.d, .h = top, .is = p.is, .words = p.words, .seed = p.seed, .make = {}, .lights = {}};
  const float thick = TopThickness(desk), leg = LegHalf(desk, 0.022F), apron = 0.2F * top;
  p.make.Slab(p.is.hard, RoundedOutline({-p.w / 2, -p.d / 2}, {p.w / 2, p.d / 2}, 0.04F), top - thick, top, 0.006F);
  p.LegsAt(p.is.hard, p.w / 2 - 2.2F * leg, p.d / 2 - 2.2F * leg, top - thick, leg, 0.5F);
  p.make.Box(p.is.hard, {-p.w / 2 + 2 * leg, back + leg, top - thick - apron},
             {p.w / 2 - 2 * leg, p.d / 2 - 0.03F, top - thick}, 0.004F);
  Drawers(p, -p.w / 2 + 2 * leg, p.w / 2 - 2 * leg, top - thick - apron, top - 1.2F * thick, 3, 1);
  if (top == p.h) return;
  const float rx = std::min(0.36F * p.w, 0.4F), rz = (p.h - top) / 2;
  p.make.In({{0, back + 0.02F, top + rz}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}}, [&] {
    p.make.Slab(p.is.hard, EllipseOutline({}, rx, rz, 36), -0.015F, 0.02F, 0.006F);
    p.make.Slab(stuff::Mirror(), EllipseOutline({}, 0.9F * rx, 0.9F * rz, 36), -0.019F, 0, 0.002F);
  });
}

void MakeWorkbench(Piece& p) {
  const float leg = LegHalf(p, 0.045F), thick = std::min(0.07F, 0.12F * p.h);
  p.make.Slab(p.is.hard, RoundedOutline({-p.w / 2, -p.d / 2}, {p.w / 2, p.d / 2}, 0.015F), p.h - thick, p.h, 0.008F);
  p.LegsAt(p.is.hard, p.w / 2 - 2 * leg, p.d / 2 - 2 * leg, p.h - thick, leg, 1);
  p.make.Box(p.is.hard, {-p.w / 2 + leg, -p.d / 2 + leg, 0.2F * p.h},
             {p.w / 2 - leg, p.d / 2 - leg, 0.2F * p.h + 0.5F * thick}, 0.004F);
  p.make.Box(p.is.hard, {-p.w / 2 + 2 * leg, -p.d / 2 + leg, p.h - 2.6F * thick},
             {p.w / 2 - 2 * leg, p.d / 2 - 0.03F, p.h - thick}, 0.004F);
  Drawers(p, -p.w / 2 + 3 * leg, p.w / 2 - 3 * leg, p.h - 2.6F * thick, p.h - 1.1F * thick,
          std::clamp(static_cast<int>(p.w / 0.5F), 1, 5), 1);
  for (int i = 0; i < std::clamp(static_cast<int>(p.w / 0.45F), 1, 5); ++i) {  // boxes below
    const float x = -0.4F * p.w + 0.22F * p.w * static_cast<float>(i) + 0.02F * p.w;
    p.make.Box(stuff::Book(i + 3), {x, -0.3F * p.d, 0.2F * p.h + 0.5F * thick},
               {x + 0.16F * p.w, 0.25F * p.d, (0.34F + 0.1F * p.Chance(i)) * p.h}, 0.006F);
  }
}

void MakePoolTable(Piece& p) {
  const float rim = std::min(0.1F, 0.08F * p.smaller()), thick = 0.22F * p.h,
              leg = std::min(0.08F, 0.08F * p.smaller());
  p.LegsAt(p.is.hard, p.w / 2 - 2 * leg, p.d / 2 - 2 * leg, p.h - thick, leg, 0.6F);
  p.make.Box(p.is.hard, {-0.47F * p.w, -0.47F * p.d, p.h - thick}, {0.47F * p.w, 0.47F * p.d, p.h - 0.06F * p.h},
             0.01F);
  Material felt = p.is.soft;
  p.make.Box(felt, {-p.w / 2 + 0.6F * rim, -p.d / 2 + 0.6F * rim, p.h - 0.08F * p.h},
             {p.w / 2 - 0.6F * rim, p.d / 2 - 0.6F * rim, p.h - 0.04F * p.h}, 0);
  for (const float side : {-1.0F, 1.0F}) {
    p.make.Box(p.is.hard, {-p.w / 2, side * p.d / 2, p.h - 0.4F * thick}, {p.w / 2, side * (p.d / 2 - rim), p.h},
               0.012F);
    p.make.Box(p.is.hard, {side * p.w / 2, -p.d / 2, p.h - 0.4F * thick}, {side * (p.w / 2 - rim), p.d / 2, p.h},
               0.012F);
  }
  const float r = std::min(0.03F, 0.03F * p.smaller());
  const bool along_x = p.w > p.d;
  for (const float a : {-1.0F, 1.0F}) {
    for (const float b : {-1.0F, 0.0F, 1.0F}) {
      const float x = along_x ? b * (p.w / 2 - rim) : a * (p.w / 2 - rim),
                  y = along_x ? a * (p.d / 2 - rim) : b * (p.d / 2 - rim);
      p.make.Cylinder(stuff::Black(), {x, y, p.h - 0.03F * p.h}, 1.9F * r, 0.032F * p.h, 0.001F, 14);
    }
  }
  for (int i = 0; i < 10; ++i) {
    int row = i < 1 ? 0 : i < 3 ? 1 : i < 6 ? 2 : 3;
    const float along = 0.22F * std::max(p.w, p.d) + 1.8F * r * static_cast<float>(row);
    const float across = 2.1F * r * (static_cast<float>(i - row * (row + 1) / 2) - 0.5F * static_cast<float>(row));
    p.make.Ellipsoid(stuff::Book(i), {along_x ? along : across, along_x ? across : along, p.h - 0.04F * p.h + r},
                     {r, r, r}, 10, 6);
  }
}

}  // namespace

std::span<const PieceMaker> TableMakers() {
  static constexpr PieceMaker kMakers[] = {
      {"table", MakeTable},          {"round_table", MakeRoundTable}, {"coffee_table", MakeCoffeeTable},
      {"side_table", MakeSideTable}, {"nightstand", MakeNightstand},  {"desk", MakeDesk},
      {"vanity", MakeVanity},        {"workbench", MakeWorkbench},    {"pool_table", MakePoolTable}};
  return kMakers;
}

}  // namespace flair::renderer
