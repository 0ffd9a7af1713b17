// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "absl/strings/ascii.h"
#include "renderer_worker/drawing/layers.h"
#include "renderer_worker/furniture/classes.h"

namespace flair::renderer {
namespace {

void TraceFloor(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  std::vector<Point> outline;
  for (Point vertex : plan.floor) outline.push_back(sheet.ToSheet(vertex));
  canvas.Polygon(outline);
}

bool Mentions(const std::string& text, const google::protobuf::RepeatedPtrField<std::string>& words) {
  const std::string lower = absl::AsciiStrToLower(text);
  return std::any_of(words.begin(), words.end(),
                     [&lower](const std::string& word) { return lower.find(word) != std::string::npos; });
}

// Boards along the longer side of the room, their joints staggered.
void DrawBoards(Canvas& canvas, const Plan& plan, const Sheet& sheet, const Stroke& stroke) {
  const Box b = plan.bounds_m;
  const bool wide = b.width() >= b.height();
  const double across = wide ? b.height() : b.width(), along = wide ? b.width() : b.height();
  const double board = std::max(0.16, across / 120);
  const auto at = [&](double u, double v) {
    return sheet.ToSheet(wide ? Point{b.x0 + u, b.y0 + v} : Point{b.x0 + v, b.y0 + u});
  };
  for (int row = 0; row * board < across; ++row) {
    const double v = row * board;
    if (row > 0) canvas.Line(at(0, v), at(along, v));
    const double first = 1.9 * ((row * 5) % 8) / 8.0;
    for (double u = first; u < along; u += std::max(1.9, along / 60)) {
      if (u > 0) canvas.Line(at(u, v), at(u, std::min(v + board, across)));
    }
  }
  canvas.Draw(stroke);
}

void DrawTiles(Canvas& canvas, const Plan& plan, const Sheet& sheet, const Stroke& stroke, double tile_m) {
  const Box b = plan.bounds_m;
  const double tile = std::max({tile_m, b.width() / 60, b.height() / 60});
  for (double x = b.x0 + tile; x < b.x1; x += tile) canvas.Line(sheet.ToSheet({x, b.y0}), sheet.ToSheet({x, b.y1}));
  for (double y = b.y0 + tile; y < b.y1; y += tile) canvas.Line(sheet.ToSheet({b.x0, y}), sheet.ToSheet({b.x1, y}));
  canvas.Draw(stroke);
}

}  // namespace

void DrawFloor(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  TraceFloor(canvas, plan, sheet);
  canvas.Fill(plan.floor_tint);
  TraceFloor(canvas, plan, sheet);
  canvas.Clip();
  const Stroke joint{LineColourFor(plan.floor_tint), 0.09, 0.20};
  if (Mentions(plan.floor_material, Furniture().plain_floor())) {
    // Plain: nothing that would compete with the furniture.
  } else if (Mentions(plan.floor_material, Furniture().tiled_floor()) ||
             (plan.floor_material.empty() && Mentions(plan.room_type, Furniture().wet_room()))) {
    DrawTiles(canvas, plan, sheet, joint, 0.45);
  } else {
    DrawBoards(canvas, plan, sheet, joint);
  }
  canvas.Unclip();
}

void DrawZones(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  TraceFloor(canvas, plan, sheet);
  canvas.Clip();
  for (const PlanZone& zone : plan.zones) {
    for (const std::vector<Point>& part : zone.parts) {
      std::vector<Point> outline;
      for (Point vertex : part) outline.push_back(sheet.ToSheet(vertex));
      canvas.Polygon(outline);
      canvas.Fill(zone.tint, 0.20, true);
      if (plan.zones.size() > 1) {
        canvas.Draw({LineColourFor(zone.tint), 0.15, 0.55, Dash::kDashed});
      } else {
        canvas.Discard();
      }
    }
  }
  canvas.Unclip();
}

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

// What hangs above shows as a dashed outline only.
void DrawOverhead(Canvas& canvas, const PlanObject& object, const Sheet& sheet) {
  if (object.shown_as->symbol_overhead()) {
    PlanObject overhead = object;
    overhead.ink.line = Hex(0x5A5148);
    DrawObject(canvas, overhead, sheet);
    return;
  }
  canvas.EnterFrame(sheet.ToSheet(object.centre_m), sheet.mm_per_m(), object.theta_rad, true);
  TraceOutline(canvas, object, 0);
  canvas.Draw({Hex(0x5A5148), 0.2, 0.9, Dash::kDashed});
  canvas.LeaveFrame();
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
    if (object.kind == v1::OBJECT_KIND_WALL && !object.walk_over && OnPaper(object, sheet))
      DrawObject(canvas, AsBar(object, sheet), sheet);
  }
  for (const PlanObject& object : plan.objects) {
    if (object.kind == v1::OBJECT_KIND_CEILING && !object.walk_over && OnPaper(object, sheet))
      DrawOverhead(canvas, object, sheet);
  }
}

}  // namespace flair::renderer
