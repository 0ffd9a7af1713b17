// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "renderer_worker/drawing/layers.h"
#include "renderer_worker/drawing/panel.h"
#include "renderer_worker/drawing/text.h"

namespace flair::renderer {
namespace {

struct Row {
  enum Kind { kZone, kKey } kind;
  int index;
};

std::vector<Row> RowsOf(const Plan& plan) {
  std::vector<Row> rows;
  int zone = -2;
  for (size_t i = 0; i < plan.keys.size(); ++i) {
    if (plan.keys[i].zone != zone) rows.push_back({Row::kZone, zone = plan.keys[i].zone});
    rows.push_back({Row::kKey, static_cast<int>(i)});
  }
  return rows;
}

const char* Carrier(const PlanKey& key) {
  return key.kind == v1::OBJECT_KIND_WALL ? "on wall" : key.kind == v1::OBJECT_KIND_CEILING ? "ceiling" : "";
}

void DrawKeyRow(Canvas& canvas, const Plan& plan, const PlanKey& key, int number, const Box& row, double size) {
  const auto object = std::find_if(plan.objects.begin(), plan.objects.end(),
                                   [number](const PlanObject& o) { return o.key == number - 1; });
  const Ink ink = object != plan.objects.end() ? object->ink : Ink{Hex(0xE5E0D8), kPanelSoft};
  const double middle = (row.y0 + row.y1) / 2;
  DrawBadge(canvas, number, {row.x0 + 2.9, middle}, Mix(ink.fill, kWhite, 0.25), ink.line,
            std::min(1.0, 0.9 * row.height() / BadgeSize(1).height));
  // Where columns are narrow, names are worth more than sizes.
  const TextBlock dims{row.width() < 55 ? "" : fmt::format("{:.2f} × {:.2f}", key.width_m, key.depth_m),
                       {.size_mm = 0.86 * size, .colour = kPanelSoft}};
  const Size dims_size = Measure(canvas, dims);
  DrawText(canvas, dims, {row.x1 - dims_size.width, middle - dims_size.height / 2});
  std::string name = key.name;
  if (key.count > 1) name += fmt::format("  ×{}", key.count);
  if (*Carrier(key) != 0) name += fmt::format("  ({})", Carrier(key));
  const TextBlock text{name, {.size_mm = size, .colour = kPanelInk}, row.width() - dims_size.width - 9};
  DrawText(canvas, text, {row.x0 + 7, middle - Measure(canvas, text).height / 2});
}

void DrawZoneRow(Canvas& canvas, const Plan& plan, int zone, const Box& row, double size) {
  const double y = row.y1 - 0.85 * size;
  if (zone >= 0) {
    canvas.Rectangle({row.x0 + 1.2, y - 1.7, row.x0 + 4.6, y + 1.7}, 0.5);
    canvas.Fill(Mix(kWhite, plan.zones[zone].tint, 0.55), 1, true);
    canvas.Draw({LineColourFor(plan.zones[zone].tint), 0.18});
  }
  const TextBlock text{Capital(zone < 0 ? "whole room" : plan.zones[zone].name),
                       {.size_mm = size, .colour = kPanelInk, .bold = true},
                       row.width() - 8};
  DrawText(canvas, text, {row.x0 + (zone < 0 ? 1.2 : 7), y - Measure(canvas, text).height / 2});
}

constexpr double kPitchMm = 5.5, kLeastPitchMm = 3.7;

}  // namespace

double LeastKeyHeight(const Plan& plan) { return 5.2 + kLeastPitchMm * static_cast<double>(RowsOf(plan).size() + 2); }

// The key in as many columns as the box is wide; shrinks, then ends with "and N more".
void DrawKey(Canvas& canvas, const Plan& plan, const Box& box) {
  const std::vector<Row> rows = RowsOf(plan);
  const double y0 = Heading(canvas, "KEY", box.x0, box.y0);
  const TextBlock unit{"width × depth, m", {.size_mm = 2.6, .colour = kPanelSoft}};
  DrawText(canvas, unit, {box.x1 - Measure(canvas, unit).width, box.y0 + 0.2});
  int columns = std::max(1, static_cast<int>(box.width() / 68));
  double pitch = kPitchMm;
  const auto fits = [&] {
    // Headings take more than a row.
    return rows.size() + 2 * columns <= static_cast<size_t>(std::max(0.0, (box.y1 - y0) / pitch)) * columns;
  };
  while (!fits() && pitch > kLeastPitchMm) pitch -= 0.25;
  if (!fits() && !rows.empty()) {
    columns *= 2;
    for (pitch = 4.6; !fits() && pitch > kLeastPitchMm;) pitch -= 0.25;
  }
  const double size = std::min(3.4, 0.68 * pitch);
  const double width = (box.width() - 5.0 * (columns - 1)) / columns;
  int column = 0;
  double y = y0;
  // Columns of about equal length.
  const double even = y0 + pitch * (static_cast<double>(rows.size()) / columns + 3);
  const double bottom = columns > 1 ? std::min(box.y1, even) : box.y1;
  for (size_t i = 0; i < rows.size(); ++i) {
    const bool heading = rows[i].kind == Row::kZone;
    const double need = heading ? 2 * pitch : pitch;
    if (y + need > (column + 1 < columns ? bottom : box.y1) + 0.01) {
      if (++column >= columns) {
        const size_t left =
            std::count_if(rows.begin() + i, rows.end(), [](const Row& row) { return row.kind == Row::kKey; });
        DrawText(canvas, {fmt::format("… and {} more", left), {.size_mm = 2.8, .colour = kPanelSoft}},
                 {box.x0, box.y1 - 0.5});
        return;
      }
      y = y0;
    }
    const double x = box.x0 + column * (width + 5);
    const double height = heading && y > y0 ? pitch + 1.2 : pitch;
    const Box row{x, y, x + width, y + height};
    heading ? DrawZoneRow(canvas, plan, rows[i].index, row, size)
            : DrawKeyRow(canvas, plan, plan.keys[rows[i].index], rows[i].index + 1, row, size);
    y += height;
  }
}

}  // namespace flair::renderer
