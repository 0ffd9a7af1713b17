// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <string>

#include "renderer_worker/drawing/layers.h"

namespace flair::renderer {
namespace {

void TraceFloor(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  std::vector<Point> outline;
  for (Point vertex : plan.floor) outline.push_back(sheet.ToSheet(vertex));
  canvas.Polygon(outline);
}

bool Mentions(std::string text, std::initializer_list<const char*> words) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::any_of(words.begin(), words.end(),
                     [&text](const char* word) { return text.find(word) != std::string::npos; });
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
  if (Mentions(plan.floor_material, {"carpet", "rubber", "vinyl", "linoleum", "concrete", "resin", "earth"})) {
    // Plain: nothing that would compete with the furniture.
  } else if (Mentions(plan.floor_material, {"tile", "stone", "marble", "terracotta", "slate", "flag", "mosaic"}) ||
             (plan.floor_material.empty() && Mentions(plan.room_type, {"kitchen", "bath", "laundry", "shower"}))) {
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

}  // namespace flair::renderer
