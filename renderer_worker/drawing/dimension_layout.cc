// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/drawing/dimension_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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
  std::sort(ends.begin(), ends.end());
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
    const bool told = std::any_of(plan.walls.begin(), plan.walls.end(), [&side](const PlanWall& wall) {
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

}  // namespace

std::vector<DimensionString> LayOutDimensions(const Plan& plan, const Sheet& sheet) {
  std::vector<DimensionString> strings;
  if (!plan.layers.dimensions || plan.walls.size() > kMostWalls) return strings;
  std::vector<double> reaches(plan.walls.size(), 0);
  for (const bool openings : {true, false}) {
    for (size_t i = 0; i < plan.walls.size(); ++i) {
      const PlanWall& wall = plan.walls[i];
      const double first = WallThicknessMm(sheet) + OutwardReachMm(plan, sheet, static_cast<int>(i)) + 7;
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

}  // namespace flair::renderer
