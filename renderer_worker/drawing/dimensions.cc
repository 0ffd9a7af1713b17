// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "renderer_worker/drawing/layers.h"
#include "renderer_worker/drawing/text.h"

namespace flair::renderer {
namespace {

constexpr double kRowMm = 8;       // between two dimension lines
constexpr int kMostRows = 6;       // of dimension lines beside each other
constexpr size_t kMostWalls = 60;  // of a room whose lines can still be told apart

// Whether an earlier parallel wall of the same length already carries it, as in rectangles.
bool ToldByAnother(const Plan& plan, size_t wall) {
  const auto rank = [&plan](size_t i) {
    const Point out = plan.walls[i].outward;  // south first, then west
    return out.y < -0.7 ? 0 : out.x < -0.7 ? 1 : 2;
  };
  for (size_t i = 0; i < plan.walls.size(); ++i) {
    if (i == wall || std::abs(Cross(plan.walls[i].along, plan.walls[wall].along)) > 1e-6) continue;
    if (std::abs(plan.walls[i].length_m - plan.walls[wall].length_m) > 5e-3) continue;
    if (rank(i) < rank(wall) || (rank(i) == rank(wall) && i < wall)) return true;
  }
  return false;
}

std::vector<double> OpeningEnds(const Plan& plan, int wall) {
  std::vector<double> ends;
  for (const PlanOpening& opening : plan.openings) {
    if (opening.wall != wall) continue;
    ends.push_back(opening.offset_m);
    ends.push_back(opening.offset_m + opening.width_m);
  }
  if (ends.empty()) return ends;
  ends.push_back(0);
  ends.push_back(plan.walls[wall].length_m);
  for (double& end : ends) end = std::clamp(end, 0.0, plan.walls[wall].length_m);
  std::ranges::sort(ends);
  ends.erase(std::unique(ends.begin(), ends.end(), [](double a, double b) { return b - a < 5e-3; }), ends.end());
  return ends;
}

// Whether a strip outside the wall is free of the room itself (it is not in a narrow notch).
bool StripIsOutside(const Plan& plan, const PlanWall& wall, double reach_m) {
  for (double share : {0.02, 0.25, 0.5, 0.75, 0.98}) {
    for (double step : {0.35, 0.7, 1.0}) {
      if (PolygonContains(plan.floor, wall.start + (wall.end - wall.start) * share + wall.outward * (reach_m * step)))
        return false;
    }
  }
  return true;
}

// From a wall of a notch outwards to where the room ends on that side: lines in the notch would cross each other and
// the walls of its corner. 0 for walls there, and where something of the room is between.
double BeyondNotchM(const Plan& plan, const PlanWall& wall) {
  const Box b = plan.bounds_m;
  const Point corner{wall.outward.x > 0 ? b.x1 : b.x0, wall.outward.y > 0 ? b.y1 : b.y0};
  const bool upright = std::abs(wall.outward.x * wall.outward.y) < 1e-6;
  const double reach_m = upright ? Dot(corner - wall.start, wall.outward) : 0;
  return reach_m > 1e-3 && StripIsOutside(plan, wall, reach_m) ? reach_m : 0;
}

DimensionString MakeString(const Sheet& sheet, const PlanWall& wall, const std::vector<double>& ends_m,
                           double reach_mm) {
  const Point outward{wall.outward.x, -wall.outward.y};
  DimensionString string{{wall.along.x, -wall.along.y}, outward, {}, {}, reach_mm};
  for (double end : ends_m)
    string.ticks_mm.push_back(sheet.ToSheet(wall.start + wall.along * end) + outward * reach_mm);
  for (size_t i = 1; i < ends_m.size(); ++i) string.texts.push_back(fmt::format("{:.2f}", ends_m[i] - ends_m[i - 1]));
  return string;
}

// What the line with its text covers.
Box Extent(const DimensionString& string) {
  Box box;
  for (Point tick : {string.ticks_mm.front(), string.ticks_mm.back()}) {
    box.Include(tick + string.outward * 3.9);
    box.Include(tick - string.outward * 3.9);
  }
  return box;
}

// Adds the string unless it would cross one that is there already.
bool AddString(DimensionString string, std::vector<DimensionString>& strings) {
  const Box extent = Extent(string);
  for (const DimensionString& other : strings) {
    if (Extent(other).Overlaps(extent)) return false;
  }
  strings.push_back(std::move(string));
  return true;
}

// The extent of a room that no single wall tells: below and on the left of everything else.
void AddOverall(const Plan& plan, const Sheet& sheet, std::vector<DimensionString>& strings) {
  const Box b = plan.bounds_m;
  const PlanWall sides[] = {{{b.x0, b.y0}, {b.x1, b.y0}, {1, 0}, {0, -1}, b.width()},
                            {{b.x0, b.y1}, {b.x0, b.y0}, {0, -1}, {-1, 0}, b.height()}};
  for (const PlanWall& side : sides) {
    const bool told = std::ranges::any_of(plan.walls, [&side](const PlanWall& wall) {
      return std::abs(Cross(wall.along, side.along)) < 1e-6 && std::abs(wall.length_m - side.length_m) < 5e-3;
    });
    if (told) continue;
    double reach = WallThicknessMm(sheet) + 7;
    for (size_t i = 0; i < plan.walls.size(); ++i) {
      if (Dot(plan.walls[i].outward, side.outward) > 0.9)
        reach = std::max(reach, WallThicknessMm(sheet) + OutwardReachMm(plan, sheet, static_cast<int>(i)) + 7);
    }
    for (int row = 0; row < kMostRows && !AddString(MakeString(sheet, side, {0, side.length_m}, reach), strings); ++row)
      reach += kRowMm;
  }
}

constexpr double kLeastM = 0.35, kMostM = 2.5;
constexpr double kLeastPieceM2 = 0.4;  // smaller ones are moved aside rather than walked round
constexpr double kSameFloorM = 0.7;
constexpr size_t kMost = 8;
constexpr size_t kMostPieces = 300;  // of a room in which single distances still say something
constexpr double kLeastMm = 10;
const Rgb kClearanceInk = Hex(0x2F6675);

bool IsSolid(const PlanObject& object) { return object.kind == v1::OBJECT_KIND_FLOOR && !object.walk_over; }

// Distance along the ray to the segment; infinite when it is missed or starts behind.
double HitM(Point from, Point direction, Point a, Point b) {
  const Point edge = b - a;
  const double across = Cross(direction, edge);
  if (std::abs(across) < 1e-12) return std::numeric_limits<double>::infinity();
  const double along = Cross(a - from, edge) / across, share = Cross(a - from, direction) / across;
  return along > 1e-6 && share >= 0 && share <= 1 ? along : std::numeric_limits<double>::infinity();
}

double HitOutlineM(Point from, Point direction, const std::vector<Point>& outline) {
  double nearest = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < outline.size(); ++i)
    nearest = std::min(nearest, HitM(from, direction, outline[i], outline[(i + 1) % outline.size()]));
  return nearest;
}

Clearance Ahead(const Plan& plan, const PlanObject& object) {
  const std::vector<Point> corners = object.Corners();
  const Point from = (corners[2] + corners[3]) * 0.5,
              direction{-std::sin(object.theta_rad), std::cos(object.theta_rad)};
  if (!PolygonContains(plan.floor, from + direction * 1e-4)) return {};
  double length = HitOutlineM(from, direction, plan.floor);
  for (const PlanObject& other : plan.objects) {
    if (&other == &object || !IsSolid(other)) continue;
    const std::vector<Point> outline = other.Corners();
    if (PolygonContains(outline, from + direction * 1e-4)) return {};
    length = std::min(length, HitOutlineM(from, direction, outline));
  }
  return {from, from + direction * length, length};
}

bool SameFloor(const Clearance& a, const Clearance& b) {
  const Point ua = (a.to_m - a.from_m) * (1 / a.length_m), ub = (b.to_m - b.from_m) * (1 / b.length_m);
  if (std::abs(Dot(ua, ub)) < 0.9) {
    // Crossing ones would write over each other.
    const double hit = HitM(a.from_m, ua, b.from_m, b.to_m);
    return hit <= a.length_m;
  }
  const Point between = (b.from_m + b.to_m) * 0.5 - (a.from_m + a.to_m) * 0.5;
  return std::abs(Cross(ua, between)) < kSameFloorM && std::abs(Dot(ua, between)) < (a.length_m + b.length_m) / 2;
}

TextBlock NumberOf(const Clearance& clearance) {
  return {fmt::format("{:.2f}", clearance.length_m), {.size_mm = 2.8, .colour = kClearanceInk}};
}

const Rgb kDimensionInk = Hex(0x4A4641);

// Texts read from below or from the right, whatever way the wall runs.
double ReadingAngle(Point direction) {
  double angle = std::atan2(-direction.y, direction.x);
  if (angle > std::numbers::pi / 2 + 1e-6) angle -= std::numbers::pi;
  if (angle <= -std::numbers::pi / 2 + 1e-6) angle += std::numbers::pi;
  return angle;
}

void DrawString(Canvas& canvas, const DimensionString& string) {
  const Point overshoot = string.direction * 1.4;
  canvas.Line(string.ticks_mm.front() - overshoot, string.ticks_mm.back() + overshoot);
  canvas.Draw({kDimensionInk, 0.13});
  const Point slash = (string.direction + string.outward) * 0.85;
  for (Point tick : string.ticks_mm) {
    canvas.Line(tick - string.outward * 3.2, tick + string.outward * 1.6);
    canvas.Draw({kDimensionInk, 0.11, 0.8});
    canvas.Line(tick - slash, tick + slash);
    canvas.Draw({kDimensionInk, 0.35});
  }
  const double angle = ReadingAngle(string.direction);
  // "Above" the line as read, so that stacked lines and texts never touch.
  const Point above{-std::sin(angle), -std::cos(angle)};
  const TextStyle style{.size_mm = 3.3, .colour = kDimensionInk};
  for (size_t i = 0; i + 1 < string.ticks_mm.size(); ++i) {
    Point middle = (string.ticks_mm[i] + string.ticks_mm[i + 1]) * 0.5;
    const double length = PieceMm(string, i);
    TextBlock block{string.texts[i], style};
    double width = Measure(canvas, block).width;
    double height_mm = 2.15;
    if (length < kLeastPieceMm && i == 0) {
      middle = string.ticks_mm.front() - string.direction * (width / 2 + 1.6);
    } else if (length < kLeastPieceMm && i + 1 == string.texts.size()) {
      middle = string.ticks_mm.back() + string.direction * (width / 2 + 1.6);
    } else if (width > length - 1) {
      block.style.size_mm *= 0.8;
      if (0.8 * width > length - 0.4) height_mm += 2.9;  // over its neighbours
    }
    DrawTextAt(canvas, block, middle + above * height_mm, angle);
  }
}

}  // namespace

std::vector<DimensionString> LayOutDimensions(const Plan& plan, const Sheet& sheet) {
  std::vector<DimensionString> strings;
  if (!plan.layers.dimensions || plan.walls.size() > kMostWalls) return strings;
  std::vector<double> reaches(plan.walls.size(), 0);
  for (const bool openings : {true, false}) {
    for (size_t i = 0; i < plan.walls.size(); ++i) {
      const PlanWall& wall = plan.walls[i];
      const double beyond = BeyondNotchM(plan, wall) * sheet.mm_per_m();
      const double first = WallThicknessMm(sheet) + OutwardReachMm(plan, sheet, static_cast<int>(i)) + 7 + beyond;
      const double reach = std::max(reaches[i], first);
      if (!StripIsOutside(plan, wall, (first + kRowMm) / sheet.mm_per_m())) continue;
      const std::vector<double> ends = OpeningEnds(plan, static_cast<int>(i));
      if (openings && ends.size() > 2) {
        if (AddString(MakeString(sheet, wall, ends, reach), strings)) reaches[i] = reach + kRowMm;
      } else if (!openings && !ToldByAnother(plan, i)) {
        AddString(MakeString(sheet, wall, {0, wall.length_m}, reach), strings);
      }
    }
  }
  AddOverall(plan, sheet, strings);
  return strings;
}

std::vector<Clearance> FindClearances(const Plan& plan) {
  std::vector<Clearance> found;
  if (!plan.layers.dimensions || plan.objects.size() > kMostPieces) return found;
  std::vector<const PlanObject*> pieces;
  for (const PlanObject& object : plan.objects) {
    if (IsSolid(object) && object.width_m * object.depth_m >= kLeastPieceM2) pieces.push_back(&object);
  }
  std::ranges::stable_sort(pieces, [](const PlanObject* a, const PlanObject* b) {
    return a->width_m * a->depth_m > b->width_m * b->depth_m;
  });
  for (const PlanObject* piece : pieces) {
    const Clearance clearance = Ahead(plan, *piece);
    if (!(clearance.length_m >= kLeastM && clearance.length_m <= kMostM)) continue;
    if (std::ranges::any_of(found, [&](const Clearance& other) { return SameFloor(clearance, other); })) continue;
    found.push_back(clearance);
    if (found.size() == kMost) break;
  }
  return found;
}

std::vector<Clearance> ShownClearances(const Plan& plan, const Sheet& sheet) {
  std::vector<Clearance> clearances = FindClearances(plan);
  std::erase_if(clearances, [&](const Clearance& c) { return c.length_m * sheet.mm_per_m() < kLeastMm; });
  return clearances;
}

Box ClearanceTextBox(const Canvas& canvas, const Sheet& sheet, const Clearance& clearance) {
  const Size size = Measure(canvas, NumberOf(clearance));
  const Point middle = (sheet.ToSheet(clearance.from_m) + sheet.ToSheet(clearance.to_m)) * 0.5;
  return BoxAround(middle, {size.width + 1.2, size.height * 0.8});
}

void DrawClearances(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  for (const Clearance& clearance : ShownClearances(plan, sheet)) {
    const Point from = sheet.ToSheet(clearance.from_m), to = sheet.ToSheet(clearance.to_m);
    const Point along = (to - from) * (1 / std::hypot(to.x - from.x, to.y - from.y)), across{-along.y, along.x};
    canvas.Line(from, to);
    canvas.Draw({kClearanceInk, 0.13});
    for (const auto& [tip, back] : {std::pair{from, along}, {to, along * -1}}) {
      const Point head[] = {tip, tip + back * 1.9 + across * 0.45, tip + back * 1.9 - across * 0.45};
      canvas.Polygon(head);
      canvas.Fill(kClearanceInk);
    }
    const Box box = ClearanceTextBox(canvas, sheet, clearance);
    canvas.Rectangle(box, 1);
    canvas.Fill(kWhite, 0.85);
    DrawTextAt(canvas, NumberOf(clearance), box.centre());
  }
}

void DrawDimensions(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  for (const DimensionString& string : LayOutDimensions(plan, sheet)) DrawString(canvas, string);
  DrawClearances(canvas, plan, sheet);
}

}  // namespace flair::renderer
