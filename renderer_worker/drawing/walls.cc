// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer_worker/drawing/layers.h"

namespace flair::renderer {
namespace {

const Rgb kCut = Hex(0x37332F);  // what the section cuts
const Rgb kInk = Hex(0x3A3632);

// The outer face: every edge moved out by the thickness, neighbours met (long spikes cut short).
std::vector<Point> OuterFace(const Plan& plan, double thickness_m) {
  std::vector<Point> outer;
  const size_t count = plan.walls.size();
  for (size_t i = 0; i < count; ++i) {
    const PlanWall& before = plan.walls[(i + count - 1) % count];
    const PlanWall& after = plan.walls[i];
    const Point sum = before.outward + after.outward;
    const double factor = 2 / std::max(Dot(sum, sum), 0.5);
    outer.push_back(after.start + sum * (thickness_m * factor));
  }
  return outer;
}

struct OpeningFrame {
  const PlanWall* wall;
  Point start_m, end_m;
  double thickness_m;
  Point At(double along_m, double outward_m) const {
    return start_m + wall->along * along_m + wall->outward * outward_m;
  }
};

OpeningFrame FrameOf(const Plan& plan, const Sheet& sheet, const PlanOpening& opening) {
  const PlanWall& wall = plan.walls[opening.wall];
  return {&wall, wall.start + wall.along * opening.offset_m,
          wall.start + wall.along * (opening.offset_m + opening.width_m), WallThicknessMm(sheet) / sheet.mm_per_m()};
}

void Quad(Canvas& canvas, const Sheet& sheet, const OpeningFrame& frame, double u0, double u1, double v0, double v1) {
  const Point corners[] = {sheet.ToSheet(frame.At(u0, v0)), sheet.ToSheet(frame.At(u1, v0)),
                           sheet.ToSheet(frame.At(u1, v1)), sheet.ToSheet(frame.At(u0, v1))};
  canvas.Polygon(corners);
}

void DrawWindow(Canvas& canvas, const Plan& plan, const Sheet& sheet, const PlanOpening& window) {
  const OpeningFrame frame = FrameOf(plan, sheet, window);
  const double t = frame.thickness_m, w = window.width_m;
  Quad(canvas, sheet, frame, 0, w, 0, t);
  canvas.Fill(kWhite, 1, true);
  canvas.Draw({kInk, 0.30});
  Quad(canvas, sheet, frame, 0, w, 0.36 * t, 0.64 * t);
  canvas.Fill(Hex(0xDDE9ED), 1, true);
  canvas.Draw({kInk, 0.18});
  if (w > 1.3) {
    canvas.Line(sheet.ToSheet(frame.At(w / 2, 0.36 * t)), sheet.ToSheet(frame.At(w / 2, 0.64 * t)));
    canvas.Draw({kInk, 0.3});
  }
  // The sill, outside.
  const double lip = 0.35 * t;
  Quad(canvas, sheet, frame, -0.04, w + 0.04, t, t + lip);
  canvas.Fill(kWhite, 1, true);
  canvas.Draw({kInk, 0.16});
}

void DrawLeaf(Canvas& canvas, const Plan& plan, const Sheet& sheet, const PlanOpening& door) {
  const DoorLeafGeometry leaf = LeafOf(plan, door);
  const Point hinge = sheet.ToSheet(leaf.hinge_m), open = sheet.ToSheet(leaf.open_end_m),
              closed = sheet.ToSheet(leaf.closed_end_m);
  const double radius = std::hypot(open.x - hinge.x, open.y - hinge.y);
  const double from = std::atan2(open.y - hinge.y, open.x - hinge.x),
               to = std::atan2(closed.y - hinge.y, closed.x - hinge.x);
  double turn = std::remainder(to - from, 2 * std::numbers::pi);
  canvas.Arc(hinge, radius, turn > 0 ? from : from + turn, turn > 0 ? from + turn : from);
  canvas.Draw({kInk, 0.16, 0.85});
  const Point along{(open.x - hinge.x) / radius, (open.y - hinge.y) / radius};
  const double thick = std::clamp(0.04 * sheet.mm_per_m(), 0.6, 1.8);
  const Point side = Point{-along.y, along.x} * (turn > 0 ? thick : -thick);
  const Point corners[] = {hinge, open, open + side, hinge + side};
  canvas.Polygon(corners);
  canvas.Fill(kWhite, 1, true);
  canvas.Draw({kInk, 0.3});
}

void DrawDoor(Canvas& canvas, const Plan& plan, const Sheet& sheet, const PlanOpening& door) {
  const OpeningFrame frame = FrameOf(plan, sheet, door);
  const double t = frame.thickness_m, w = door.width_m;
  Quad(canvas, sheet, frame, 0, w, -0.004, t + 0.004);
  canvas.Fill(plan.floor_tint);
  for (double v : {0.0, t}) {
    canvas.Line(sheet.ToSheet(frame.At(0, v)), sheet.ToSheet(frame.At(w, v)));
    canvas.Draw({kInk, 0.14, 0.7, door.swing == v1::DOOR_SWING_NONE ? Dash::kDashed : Dash::kSolid});
  }
  for (double u : {0.0, w}) canvas.Line(sheet.ToSheet(frame.At(u, 0)), sheet.ToSheet(frame.At(u, t)));
  canvas.Draw({kInk, 0.35});
  if (door.swing == v1::DOOR_SWING_INWARD || door.swing == v1::DOOR_SWING_OUTWARD) DrawLeaf(canvas, plan, sheet, door);
  if (door.swing == v1::DOOR_SWING_SLIDING) {
    // The leaf slides inside the wall past its hinge end; half open.
    const double from = door.hinge_at_start ? -0.5 * w : 0.5 * w;
    Quad(canvas, sheet, frame, from, from + w, 0.36 * t, 0.64 * t);
    canvas.Fill(kWhite, 1, true);
    canvas.Draw({kInk, 0.25});
  }
}

}  // namespace

DoorLeafGeometry LeafOf(const Plan& plan, const PlanOpening& door) {
  const PlanWall& wall = plan.walls[door.wall];
  const Point start = wall.start + wall.along * door.offset_m, end = start + wall.along * door.width_m;
  const Point hinge = door.hinge_at_start ? start : end, strike = door.hinge_at_start ? end : start;
  const Point closed = (strike - hinge) * (1 / door.width_m);
  const Point swing = door.swing == v1::DOOR_SWING_OUTWARD ? wall.outward : wall.outward * -1;
  const Point open = closed * std::cos(door.swing_angle_rad) + swing * std::sin(door.swing_angle_rad);
  return {hinge, hinge + open * door.width_m, strike};
}

void DrawWalls(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  const double thickness_m = WallThicknessMm(sheet) / sheet.mm_per_m();
  std::vector<Point> outer, inner;
  for (Point point : OuterFace(plan, thickness_m)) outer.push_back(sheet.ToSheet(point));
  for (Point point : plan.floor) inner.push_back(sheet.ToSheet(point));
  canvas.Polygon(outer);
  canvas.Polygon(inner);
  canvas.FillEvenOdd(Mix(kCut, plan.wall_tint, 0.18));
  canvas.Polygon(outer);
  canvas.Draw({kCut, 0.45});
  canvas.Polygon(inner);
  canvas.Draw({kCut, 0.45});
}

void DrawOpenings(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  for (const PlanOpening& opening : plan.openings) {
    opening.door ? DrawDoor(canvas, plan, sheet, opening) : DrawWindow(canvas, plan, sheet, opening);
  }
}

void DrawSocketSign(Canvas& canvas, Point at_mm, Point inward) {
  constexpr double kRadiusMm = 1.3;
  const Point along{-inward.y, inward.x}, centre = at_mm + inward * (kRadiusMm + 0.9);
  const double angle = std::atan2(inward.y, inward.x);
  canvas.Line(at_mm, centre - inward * kRadiusMm);
  canvas.Draw({kInk, 0.22});
  canvas.Arc(centre, kRadiusMm, angle + std::numbers::pi / 2, angle + 1.5 * std::numbers::pi);
  canvas.Close();
  canvas.Fill(kWhite, 0.9, true);
  canvas.Draw({kInk, 0.22});
  canvas.Line(centre - along * kRadiusMm, centre + along * kRadiusMm);
  canvas.Draw({kInk, 0.35});
}

void DrawSockets(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  for (const PlanSocket& socket : plan.sockets) {
    const PlanWall& wall = plan.walls[socket.wall];
    DrawSocketSign(canvas, sheet.ToSheet(wall.start + wall.along * socket.offset_m), {-wall.outward.x, wall.outward.y});
  }
}

}  // namespace flair::renderer
