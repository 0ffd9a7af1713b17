// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
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
  // So wide a door has two leaves, and slides shut.
  constexpr double kPairM = 1.25;
  const bool swings = door.swing == v1::DOOR_SWING_INWARD || door.swing == v1::DOOR_SWING_OUTWARD, pair = w >= kPairM;
  for (int leaf = 0; swings && leaf < (pair ? 2 : 1); ++leaf) {
    PlanOpening one = door;
    one.width_m = pair ? w / 2 : w;
    one.offset_m += leaf * one.width_m;
    if (pair) one.hinge_at_start = leaf == 0;
    DrawLeaf(canvas, plan, sheet, one);
  }
  if (door.swing == v1::DOOR_SWING_SLIDING) {
    // The leaf slides inside the wall past its hinge end; half open.
    const double from = pair ? 0 : door.hinge_at_start ? -0.5 * w : 0.5 * w;
    Quad(canvas, sheet, frame, from, from + w, 0.36 * t, 0.64 * t);
    canvas.Fill(kWhite, 1, true);
    canvas.Draw({kInk, 0.25});
  }
}

// On the threshold, along the wall, where it fits.
void NameDoor(Canvas& canvas, const Plan& plan, const Sheet& sheet, const PlanOpening& door) {
  constexpr double kLargestMm = 2.4, kLeastMm = 1.5, kAirMm = 1;
  const OpeningFrame frame = FrameOf(plan, sheet, door);
  const TextBlock name{door.name, {.size_mm = std::min(kLargestMm, 0.62 * WallThicknessMm(sheet)), .colour = kInk}};
  if (name.style.size_mm < kLeastMm || Measure(canvas, name).width + kAirMm > door.width_m * sheet.mm_per_m()) return;
  double angle = std::atan2(frame.wall->along.y, frame.wall->along.x);
  constexpr double kRounding = 1e-6;
  if (angle > std::numbers::pi / 2 + kRounding) angle -= std::numbers::pi;
  if (angle < -std::numbers::pi / 2 + kRounding) angle += std::numbers::pi;
  DrawTextAt(canvas, name, sheet.ToSheet(frame.At(door.width_m / 2, frame.thickness_m / 2)), angle);
}

void TraceFloor(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  std::vector<Point> outline;
  for (Point vertex : plan.floor) outline.push_back(sheet.ToSheet(vertex));
  canvas.Polygon(outline);
}

// In [0, 1), the same for the same numbers.
double Chance(int a, int b) {
  uint32_t x = static_cast<uint32_t>(a) * 0x9E3779B9U + static_cast<uint32_t>(b) * 0x85EBCA6BU;
  x = (x ^ (x >> 15)) * 0x2C1B3C6DU;
  return static_cast<double>((x ^ (x >> 13)) >> 8) / 16777216.0;
}

// What a floor is laid of, in a frame whose u runs along the longer side of the room; pieces are never so small that
// the room would have more than a hundred of them in a row.
class Flooring {
 public:
  Flooring(Canvas& canvas, const Plan& plan, const Sheet& sheet)
      : canvas_(canvas),
        sheet_(sheet),
        box_(plan.bounds_m),
        wide_(box_.width() >= box_.height()),
        along_(std::max(box_.width(), box_.height())),
        across_(std::min(box_.width(), box_.height())),
        size_(std::max<double>(plan.floor_look.pattern_size_m, along_ / 100)),
        joint_{LineColourFor(plan.floor_tint), 0.09, 0.26} {}

  void Draw(Pattern pattern) {
    switch (pattern) {
      case Pattern::kWood:
      case Pattern::kPlanks:
        return Courses(size_, 12 * size_, 0.3, [](int course) { return course * 5 % 8 / 8.0; });
      case Pattern::kTiles:
        return Courses(size_, size_, 0, [](int) { return 0.0; });
      case Pattern::kBricks:
        return Courses(size_ / 2, size_, 0.15, [](int course) { return course % 2 / 2.0; });
      case Pattern::kStone:
        return Courses(size_, 1.6 * size_, 0.2, [](int course) { return Chance(course, 7); });
      case Pattern::kHerringbone:
        return Herringbone(size_, 5);
      case Pattern::kCarpet:
        return Pile(std::max(0.11, along_ / 60));
      default:
        return;  // plain: nothing that would compete with the furniture
    }
  }

 private:
  Point At(double u, double v) const {
    return sheet_.ToSheet(wide_ ? Point{box_.x0 + u, box_.y0 + v} : Point{box_.x0 + v, box_.y0 + u});
  }

  void Piece(double u0, double v0, double u1, double v1) {
    const Point corners[] = {At(u0, v0), At(u1, v0), At(u1, v1), At(u0, v1)};
    canvas_.Polygon(corners);
  }

  // Rows across the room, cut into pieces; the cuts of each row are moved by a share of a piece. A share of them is
  // darker.
  template <typename Shift>
  void Courses(double width, double length, double darker, const Shift& shift) {
    const auto each = [&](const auto& visit) {
      for (int course = 0; course * width < across_; ++course) {
        int piece = 0;
        for (double u = (shift(course) - 1) * length; u < along_; u += length, ++piece) visit(course, piece, u);
      }
    };
    each([&](int course, int piece, double u) {
      if (Chance(course, piece) < darker) {
        Piece(std::max(u, 0.0), course * width, std::min(u + length, along_), std::min((course + 1) * width, across_));
      }
    });
    canvas_.Fill(joint_.colour, 0.03);
    for (int course = 1; course * width < across_; ++course)
      canvas_.Line(At(0, course * width), At(along_, course * width));
    each([&](int course, int, double u) {
      if (u > 0) canvas_.Line(At(u, course * width), At(u, std::min((course + 1) * width, across_)));
    });
    canvas_.Draw(joint_);
  }

  // Staves `count` times as long as wide, laid to and fro at 45 degrees: in row k those that lie begin at k + 2 count
  // m.
  void Herringbone(double stave, int count) {
    const double turn = std::sqrt(0.5) * stave;
    const auto at = [&](int x, int y) { return At((x - y) * turn, (x + y) * turn); };
    const int rows = static_cast<int>((along_ + across_) / (2 * turn)) + 2 * count;
    const auto each = [&](bool lying) {
      for (int k = -rows; k < rows; ++k) {
        for (int m = -rows / count; m <= rows / count; ++m) {
          const int start = k + (2 * m - (lying ? 0 : 2)) * count + (lying ? 0 : 1), end = start + count;
          const Point corners[] = {lying ? at(start, k) : at(k, start), lying ? at(end, k) : at(k, end),
                                   lying ? at(end, k + 1) : at(k + 1, end),
                                   lying ? at(start, k + 1) : at(k + 1, start)};
          const Box box = BoundsOf(std::vector<Point>(std::begin(corners), std::end(corners)));
          if (box.Overlaps(sheet_.plan_mm)) canvas_.Polygon(corners);
        }
      }
    };
    each(true);
    canvas_.Fill(joint_.colour, 0.025, true);
    canvas_.Draw(joint_);
    each(false);
    canvas_.Draw(joint_);
  }

  // Short strokes this way and that.
  void Pile(double spacing) {
    for (int i = 0; i * spacing < along_; ++i) {
      for (int k = 0; k * spacing < across_; ++k) {
        const double u = (i + Chance(i, k)) * spacing, v = (k + Chance(k, i + 500)) * spacing,
                     turn = 6.3 * Chance(i, ~k);
        canvas_.Line(At(u, v), At(u + 0.2 * spacing * std::cos(turn), v + 0.2 * spacing * std::sin(turn)));
      }
    }
    canvas_.Draw({joint_.colour, 0.14, 0.3});
  }

  Canvas& canvas_;
  const Sheet& sheet_;
  Box box_;
  bool wide_;
  double along_, across_;
  double size_;
  Stroke joint_;
};

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
    if (opening.door && !opening.name.empty()) NameDoor(canvas, plan, sheet, opening);
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

void DrawFloor(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  TraceFloor(canvas, plan, sheet);
  canvas.Fill(plan.floor_tint);
  TraceFloor(canvas, plan, sheet);
  canvas.Clip();
  Flooring(canvas, plan, sheet).Draw(plan.floor_look.pattern);
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
      canvas.Fill(zone.tint, 0.045, true);
      if (plan.zones.size() > 1) {
        canvas.Draw({LineColourFor(zone.tint), 0.15, 0.5, Dash::kDashed});
      } else {
        canvas.Discard();
      }
    }
  }
  canvas.Unclip();
}

}  // namespace flair::renderer
