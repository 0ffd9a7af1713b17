// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/comparison/arrange.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "renderer_worker/comparison/change_list.h"

namespace flair::renderer {
namespace {

constexpr double kCaptionMm = 15;
constexpr double kFootMm = 9;
constexpr double kGapMm = 6;
constexpr double kMarginMm = 12;

// The sheet at a scale with so many columns of panels; none when a plan does not fit its panel.
std::optional<ComparisonSheet> SheetAt(const Comparison& comparison, v1::PaperSize paper, bool portrait, int scale,
                                       int columns) {
  ComparisonSheet made;
  made.paper = EmptySheet(paper, portrait, scale);
  const Box inner = Box{0, 0, made.paper.size_mm.width, made.paper.size_mm.height}.Grown(-kMarginMm);
  const double list_mm = ChangeListHeight(comparison, inner.width());
  made.foot_mm = {inner.x0, inner.y1 - kFootMm, inner.x1, inner.y1};
  made.list_mm = {inner.x0, made.foot_mm.y0 - list_mm, inner.x1, made.foot_mm.y0};
  made.paper.plan_mm = {inner.x0, inner.y0, inner.x1, made.list_mm.y0 - kGapMm / 2};
  const int count = static_cast<int>(comparison.panels.size()), rows = (count + columns - 1) / columns;
  const double width = (inner.width() - (columns - 1) * kGapMm) / columns;
  const double height = (made.paper.plan_mm.height() - (rows - 1) * kGapMm) / rows;
  for (int i = 0; i < count; ++i) {
    Sheet panel = EmptySheet(paper, portrait, scale);
    const double x = inner.x0 + (i % columns) * (width + kGapMm), y = inner.y0 + (i / columns) * (height + kGapMm);
    panel.side_mm = {x, y, x + width, y + kCaptionMm};
    panel.plan_mm = {x, y + kCaptionMm, x + width, y + height};
    const Box needed = PaperNeeded(comparison.panels[i].plan, panel);
    if (needed.width() > panel.plan_mm.width() || needed.height() > panel.plan_mm.height()) return std::nullopt;
    const Point middle = needed.centre(), target = panel.plan_mm.centre();
    panel.origin_mm = {target.x - middle.x, target.y - middle.y};
    made.panels.push_back(panel);
  }
  return made;
}

std::optional<ComparisonSheet> BestAt(const Comparison& comparison, v1::PaperSize paper, int scale) {
  const int count = static_cast<int>(comparison.panels.size());
  // Side by side goes before one above the other, and landscape before portrait.
  for (bool portrait : {false, true}) {
    for (int columns = count; columns >= 1; --columns) {
      if (columns != count && count % columns == 1) continue;  // nobody stands alone
      if (auto sheet = SheetAt(comparison, paper, portrait, scale, columns); sheet.has_value()) return sheet;
    }
  }
  return std::nullopt;
}

}  // namespace

absl::StatusOr<ComparisonSheet> ArrangeComparison(const Comparison& comparison, const v1::RenderOptions& options) {
  const std::string_view paper = EmptySheet(options.paper(), false, 1000).paper;
  if (options.has_scale_denominator()) {
    auto sheet = BestAt(comparison, options.paper(), options.scale_denominator());
    if (sheet.has_value()) return *std::move(sheet);
    return absl::InvalidArgumentError(fmt::format("options.scale_denominator: {} plans do not fit {} at 1:{}",
                                                  comparison.panels.size(), paper, options.scale_denominator()));
  }
  for (const int scale : CommonScales()) {
    if (auto sheet = BestAt(comparison, options.paper(), scale); sheet.has_value()) return *std::move(sheet);
  }
  return absl::InvalidArgumentError(
      fmt::format("beside: {} plans do not fit {} at any scale", comparison.panels.size(), paper));
}

}  // namespace flair::renderer
