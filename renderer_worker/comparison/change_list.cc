// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/comparison/change_list.h"

#include <fmt/format.h>

#include <algorithm>

#include "renderer_worker/comparison/names.h"
#include "renderer_worker/drawing/panel.h"
#include "renderer_worker/drawing/text.h"

namespace flair::renderer {
namespace {

constexpr double kLeastColumnMm = 88;
constexpr double kRowMm = 5.4;
constexpr double kAboveMm = 3;
constexpr int kMostRows = 12;

int ColumnCount(double width_mm) { return std::max(1, static_cast<int>(width_mm / kLeastColumnMm)); }

int RowCount(const Comparison& comparison, double width_mm) {
  const int columns = ColumnCount(width_mm);
  return std::min(kMostRows, (comparison.change_count + columns - 1) / columns);
}

std::string WordsOf(const PlanChange& change) {
  if (change.kind == ChangeKind::kAdded) return change.words.empty() ? "added" : "added, " + change.words;
  if (change.kind == ChangeKind::kRemoved) return change.words.empty() ? "removed" : "removed, " + change.words;
  return change.words;
}

void DrawRow(Canvas& canvas, const PlanChange& change, Point left_mm, double width_mm) {
  DrawChangeNumber(canvas, change, left_mm + Point{3, kRowMm / 2});
  const TextBlock name{change.name, {.size_mm = 3.1, .colour = kPanelInk, .bold = true}};
  const double name_width = std::min(Measure(canvas, name).width, 0.5 * width_mm);
  const double y = left_mm.y + 0.75;
  DrawText(canvas, {name.text, name.style, name_width + 0.5}, {left_mm.x + 7, y});
  DrawText(canvas, {WordsOf(change), {.size_mm = 3.1, .colour = kPanelSoft}, width_mm - name_width - 11},
           {left_mm.x + 9 + name_width, y});
}

}  // namespace

double ChangeListHeight(const Comparison& comparison, double width_mm) {
  return comparison.change_count == 0 ? 0 : kAboveMm + kRowMm * RowCount(comparison, width_mm);
}

void DrawChangeList(Canvas& canvas, const Comparison& comparison, const Box& box) {
  if (comparison.change_count == 0) return;
  const int columns = ColumnCount(box.width()), rows = RowCount(comparison, box.width());
  const double width = box.width() / columns;
  Rule(canvas, box.x0, box.x1, box.y0 + 0.6);
  int place = 0;
  for (const ComparisonPanel& panel : comparison.panels) {
    for (const PlanChange& change : panel.changes) {
      const Point at{box.x0 + (place / rows) * width, box.y0 + kAboveMm / 2 + 0.8 + (place % rows) * kRowMm};
      if (place + 1 == columns * rows && comparison.change_count > columns * rows) {
        DrawText(canvas,
                 {fmt::format("and {} more", comparison.change_count - place), {.size_mm = 3.1, .colour = kPanelSoft}},
                 at + Point{7, 0.75});
        return;
      }
      DrawRow(canvas, change, at, width);
      ++place;
    }
  }
}

}  // namespace flair::renderer
