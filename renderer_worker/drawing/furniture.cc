// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "renderer_worker/drawing/layers.h"

namespace flair::renderer {
namespace {

void TraceOutline(Canvas& canvas, const PlanObject& object, double grown_m) {
  const double w = object.width_m / 2 + grown_m, d = object.depth_m / 2 + grown_m;
  if (object.shown_as->outline() == FurnitureClass::ELLIPSE) {
    canvas.Ellipse({0, 0}, w, d);
  } else {
    const double radius = object.shown_as->outline() == FurnitureClass::ROUNDED ? 0.18 * std::min(w, d) : 0.01;
    canvas.Rectangle({-w, -d, w, d}, radius + std::max(0.0, grown_m));
  }
}

// A soft shadow to the lower right, longer for taller pieces: layers of growing outlines, vector on every surface.
void DrawShadow(Canvas& canvas, const PlanObject& object, const Sheet& sheet) {
  const double height = std::clamp(object.top_m, 0.1, 2.2);
  const double offset_mm = std::min(0.5 + 0.035 * height * sheet.mm_per_m(), 2.2);
  const Point origin = sheet.ToSheet(object.centre_m) + Point{0.8 * offset_mm, offset_mm};
  canvas.EnterFrame(origin, sheet.mm_per_m(), object.theta_rad, true);
  const double blur_m = 0.45 * offset_mm / sheet.mm_per_m();
  for (double share : {1.0, 0.5, 0.0, -0.5}) {
    TraceOutline(canvas, object, share * blur_m);
    canvas.Fill(Hex(0x2B2621), 0.055);
  }
  canvas.LeaveFrame();
}

void DrawObject(Canvas& canvas, const PlanObject& object, const Sheet& sheet) {
  canvas.EnterFrame(sheet.ToSheet(object.centre_m), sheet.mm_per_m(), object.theta_rad, true);
  // Whatever its proportions, a piece covers its footprint and no more (half a millimetre for its outline).
  canvas.Rectangle(BoxAround({0, 0}, {object.width_m, object.depth_m}).Grown(0.5 / sheet.mm_per_m()));
  canvas.Clip();
  DrawSymbol(canvas, object.ink, object.width_m, object.depth_m, object.shown_as->symbol()).IgnoreError();
  canvas.Unclip();
  canvas.LeaveFrame();
}

// Wall pieces are bars of at least 1 mm on paper, grown into the room so that the wall stays clean.
PlanObject AsBar(PlanObject object, const Sheet& sheet) {
  const double least = 1.1 / sheet.mm_per_m();
  if (object.depth_m < least) {
    const double grow = (least - object.depth_m) / 2;
    object.centre_m = object.centre_m + Point{-std::sin(object.theta_rad), std::cos(object.theta_rad)} * grow;
    object.depth_m = least;
  }
  return object;
}

// Whether it shows as an outline: what is deep and above the plane that plans are cut at, and what has a piece that
// stands on the floor below the middle of its front.
bool IsAbove(const Plan& plan, const PlanObject& object) {
  constexpr double kCut_m = 1.2, kDeep_m = 0.15;
  if (object.low_m >= kCut_m && object.depth_m > kDeep_m) return true;
  const Point front =
      object.centre_m + Point{-std::sin(object.theta_rad), std::cos(object.theta_rad)} * (object.depth_m / 2);
  return std::any_of(plan.objects.begin(), plan.objects.end(), [&](const PlanObject& below) {
    return below.kind == v1::OBJECT_KIND_FLOOR && !below.walk_over && below.top_m < object.top_m &&
           PolygonContains(below.Corners(), front);
  });
}

void DrawAbove(Canvas& canvas, const PlanObject& object, const Sheet& sheet) {
  canvas.EnterFrame(sheet.ToSheet(object.centre_m), sheet.mm_per_m(), object.theta_rad, true);
  TraceOutline(canvas, object, 0);
  canvas.Draw({Hex(0x5A5148), 0.2, 0.9, Dash::kDashed});
  canvas.LeaveFrame();
}

// What hangs above shows as a dashed outline only.
void DrawOverhead(Canvas& canvas, const PlanObject& object, const Sheet& sheet) {
  if (object.shown_as->symbol_overhead()) {
    PlanObject overhead = object;
    overhead.ink.line = Hex(0x5A5148);
    DrawObject(canvas, overhead, sheet);
    return;
  }
  DrawAbove(canvas, object, sheet);
}

// Whether any of it can be seen; what lies kilometres away would overflow the surface's coordinates.
bool OnPaper(const PlanObject& object, const Sheet& sheet) {
  const Point centre = sheet.ToSheet(object.centre_m);
  const double reach = std::hypot(object.width_m, object.depth_m) / 2 * sheet.mm_per_m();
  return BoxAround(centre, {2 * reach, 2 * reach}).Overlaps(sheet.plan_mm.Grown(10));
}

}  // namespace

void DrawRugs(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  for (const PlanObject& object : plan.objects) {
    if (object.walk_over && OnPaper(object, sheet)) DrawObject(canvas, object, sheet);
  }
}

void DrawFurniture(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  for (const PlanObject& object : plan.objects) {
    if (object.walk_over || object.kind == v1::OBJECT_KIND_WALL || object.kind == v1::OBJECT_KIND_CEILING) continue;
    if (!OnPaper(object, sheet)) continue;
    if (object.kind == v1::OBJECT_KIND_FLOOR && object.shown_as->outline() != FurnitureClass::OPEN)
      DrawShadow(canvas, object, sheet);
    DrawObject(canvas, object, sheet);
  }
}

void DrawMounted(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  for (const PlanObject& object : plan.objects) {
    if (object.kind != v1::OBJECT_KIND_WALL || object.walk_over || !OnPaper(object, sheet)) continue;
    IsAbove(plan, object) ? DrawAbove(canvas, object, sheet) : DrawObject(canvas, AsBar(object, sheet), sheet);
  }
  for (const PlanObject& object : plan.objects) {
    if (object.kind == v1::OBJECT_KIND_CEILING && !object.walk_over && OnPaper(object, sheet))
      DrawOverhead(canvas, object, sheet);
  }
}

}  // namespace flair::renderer
