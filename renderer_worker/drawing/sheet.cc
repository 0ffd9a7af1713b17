// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/drawing/sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace flair::renderer {
namespace {

constexpr int kScales[] = {5, 10, 20, 25, 40, 50, 75, 100, 200, 500, 1000, 2000};
constexpr double kRowMm = 8;       // between two dimension lines
constexpr double kTextRoomMm = 5;  // text beyond the outermost line

Sheet EmptySheet(bool portrait, int scale) {
  Sheet sheet;
  sheet.portrait = portrait;
  sheet.scale = scale;
  constexpr double kMargin = 12;
  if (portrait) {
    sheet.size_mm = {297, 420};
    sheet.plan_mm = {kMargin, kMargin, 297 - kMargin, 292};
    sheet.side_mm = {kMargin, 297, 297 - kMargin, 420 - kMargin};
  } else {
    sheet.size_mm = {420, 297};
    sheet.plan_mm = {kMargin, kMargin, 300, 297 - kMargin};
    sheet.side_mm = {306, kMargin, 420 - kMargin, 297 - kMargin};
  }
  return sheet;
}

// How far doors of a wall swing out of the room, millimetres.
double OutwardReachMm(const Plan& plan, const Sheet& sheet, int wall) {
  double reach = 0;
  for (const PlanOpening& opening : plan.openings) {
    if (opening.wall != wall || !opening.door || opening.swing != v1::DOOR_SWING_OUTWARD) continue;
    reach = std::max(
        reach, opening.width_m * std::min(1.0, std::sin(std::min(opening.swing_angle_rad, 1.5708))) * sheet.mm_per_m());
  }
  return reach;
}

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

Box PaperNeeded(const Plan& plan, const Sheet& sheet) {
  Box needed;
  const double wall_mm = WallThicknessMm(sheet);
  for (size_t i = 0; i < plan.walls.size(); ++i) {
    const Point outward{plan.walls[i].outward.x, -plan.walls[i].outward.y};
    const double reach = std::max(wall_mm + 2, OutwardReachMm(plan, sheet, static_cast<int>(i)) + 1);
    for (Point end : {plan.walls[i].start, plan.walls[i].end}) {
      needed.Include(sheet.ToSheet(end));
      needed.Include(sheet.ToSheet(end) + outward * reach);
    }
  }
  for (const DimensionString& string : LayOutDimensions(plan, sheet)) {
    for (Point tick : string.ticks_mm) needed.Include(tick + string.outward * kTextRoomMm);
  }
  return needed;
}

}  // namespace

std::vector<DimensionString> LayOutDimensions(const Plan& plan, const Sheet& sheet) {
  std::vector<DimensionString> strings;
  if (plan.walls.size() > 60) return strings;
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
  return strings;
}

Sheet ChooseSheet(const Plan& plan) {
  Sheet sheet;
  for (int scale : kScales) {
    for (bool portrait : {false, true}) {
      sheet = EmptySheet(portrait, scale);
      const Box needed = PaperNeeded(plan, sheet);
      if (needed.width() > sheet.plan_mm.width() || needed.height() > sheet.plan_mm.height()) continue;
      const Point middle = needed.centre(), target = sheet.plan_mm.centre();
      sheet.origin_mm = {target.x - middle.x, target.y - middle.y};
      return sheet;
    }
  }
  sheet = EmptySheet(false, kScales[std::size(kScales) - 1]);
  sheet.origin_mm = sheet.plan_mm.centre();
  return sheet;
}

}  // namespace flair::renderer
