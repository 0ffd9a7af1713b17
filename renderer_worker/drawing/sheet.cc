// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/drawing/sheet.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "renderer_worker/drawing/layers.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {
namespace {

// Those of architects' triangular rules: the steps between them leave no more than a quarter of the paper empty.
constexpr int kScales[] = {10, 20, 25, 30, 40, 50, 75, 100, 125, 200, 250, 300, 400, 500, 1000};
constexpr int kLargestScale = 5, kSmallestScale = 1000;
constexpr double kEndRoomMm = 10;  // text beyond the end of a dimension line
constexpr double kTextRoomMm = 5;  // text beyond the outermost dimension line

// The sheet at this scale, whichever way up it fits; none when it does not.
std::optional<Sheet> SheetAt(const Plan& plan, v1::PaperSize paper, int scale) {
  for (bool portrait : {false, true}) {
    Sheet sheet = EmptySheet(paper, portrait, scale);
    const Box needed = PaperNeeded(plan, sheet);
    if (needed.width() > sheet.plan_mm.width() || needed.height() > sheet.plan_mm.height()) continue;
    const Point middle = needed.centre(), target = sheet.plan_mm.centre();
    sheet.origin_mm = {target.x - middle.x, target.y - middle.y};
    return sheet;
  }
  return std::nullopt;
}

}  // namespace

Sheet EmptySheet(v1::PaperSize paper, bool portrait, int scale) {
  Sheet sheet;
  sheet.portrait = portrait;
  sheet.scale = scale;
  if (paper == v1::PAPER_SIZE_A4) {
    constexpr double kMargin = 9;
    sheet.paper = "A4";
    sheet.size_mm = portrait ? Size{210, 297} : Size{297, 210};
    sheet.plan_mm = portrait ? Box{kMargin, kMargin, 210 - kMargin, 200} : Box{kMargin, kMargin, 204, 210 - kMargin};
    sheet.side_mm =
        portrait ? Box{kMargin, 203, 210 - kMargin, 297 - kMargin} : Box{208, kMargin, 297 - kMargin, 210 - kMargin};
    return sheet;
  }
  constexpr double kMargin = 12;
  sheet.size_mm = portrait ? Size{297, 420} : Size{420, 297};
  sheet.plan_mm = portrait ? Box{kMargin, kMargin, 297 - kMargin, 292} : Box{kMargin, kMargin, 300, 297 - kMargin};
  sheet.side_mm =
      portrait ? Box{kMargin, 297, 297 - kMargin, 420 - kMargin} : Box{306, kMargin, 420 - kMargin, 297 - kMargin};
  return sheet;
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
    if (PieceMm(string, 0) < kLeastPieceMm) needed.Include(string.ticks_mm.front() - string.direction * kEndRoomMm);
    if (PieceMm(string, string.texts.size() - 1) < kLeastPieceMm)
      needed.Include(string.ticks_mm.back() + string.direction * kEndRoomMm);
  }
  return needed;
}

std::span<const int> CommonScales() { return kScales; }

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

absl::StatusOr<Sheet> ChooseSheet(const Plan& plan, const v1::RenderOptions& options) {
  const std::string_view paper = EmptySheet(options.paper(), false, kSmallestScale).paper;
  if (!v1::PaperSize_IsValid(options.paper()))
    return InvalidArgument("options.paper: {} is not a paper size", static_cast<int>(options.paper()));
  if (options.has_scale_denominator()) {
    const int given = options.scale_denominator();
    if (given < kLargestScale || given > kSmallestScale) {
      return InvalidArgument("options.scale_denominator: {}; must be in [{}, {}]", given, kLargestScale,
                             kSmallestScale);
    }
    if (std::optional<Sheet> sheet = SheetAt(plan, options.paper(), given); sheet.has_value()) return *sheet;
  }
  for (int scale : kScales) {
    if (options.has_scale_denominator() && scale <= options.scale_denominator()) continue;
    const std::optional<Sheet> sheet = SheetAt(plan, options.paper(), scale);
    if (!sheet.has_value()) continue;
    if (!options.has_scale_denominator()) return *sheet;
    return InvalidArgument("options.scale_denominator: the room does not fit {} at 1:{}; it does at 1:{}", paper,
                           options.scale_denominator(), scale);
  }
  return InvalidArgument("room.floor: {:.0f} m x {:.0f} m do not fit {} even at 1:{}", plan.bounds_m.width(),
                         plan.bounds_m.height(), paper, kSmallestScale);
}

}  // namespace flair::renderer
