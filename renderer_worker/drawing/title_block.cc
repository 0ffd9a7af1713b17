// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "renderer_worker/drawing/layers.h"
#include "renderer_worker/drawing/panel.h"
#include "renderer_worker/drawing/text.h"

namespace flair::renderer {
namespace {

void DrawNorthArrow(Canvas& canvas, Point centre) {
  const double r = 6.2;
  canvas.Ellipse(centre, r, r);
  canvas.Draw({kPanelInk, 0.22});
  const Point east[] = {
      {centre.x, centre.y - r + 0.6}, {centre.x + 2.4, centre.y + 0.72 * r}, {centre.x, centre.y + 0.38 * r}};
  const Point west[] = {
      {centre.x, centre.y - r + 0.6}, {centre.x - 2.4, centre.y + 0.72 * r}, {centre.x, centre.y + 0.38 * r}};
  canvas.Polygon(east);
  canvas.Fill(kPanelInk, 1, true);
  canvas.Draw({kPanelInk, 0.2});
  canvas.Polygon(west);
  canvas.Fill(Hex(0xFFFFFF), 1, true);
  canvas.Draw({kPanelInk, 0.2});
  DrawTextAt(canvas, {"N", {.size_mm = 3.4, .colour = kPanelInk, .bold = true}}, {centre.x, centre.y - r - 2.4});
}

// Four alternating fields of a round length, about 55 mm of paper in all.
void DrawScaleBar(Canvas& canvas, const Sheet& sheet, Point left) {
  double field_m = 0.1;
  for (double step : {0.1, 0.25, 0.5, 1.0, 2.5, 5.0, 10.0, 25.0}) {
    if (4 * step * sheet.mm_per_m() <= 62) field_m = step;
  }
  const double field = field_m * sheet.mm_per_m();
  for (int i = 0; i < 4; ++i) {
    canvas.Rectangle({left.x + i * field, left.y, left.x + (i + 1) * field, left.y + 1.6});
    canvas.Fill(i % 2 == 0 ? kPanelInk : Hex(0xFFFFFF), 1, true);
    canvas.Draw({kPanelInk, 0.2});
  }
  for (int i = 0; i <= 4; i += 2) {
    const std::string text = fmt::format("{:g}{}", i * field_m, i == 4 ? " m" : "");
    DrawTextAt(canvas, {text, {.size_mm = 2.6, .colour = kPanelInk}}, {left.x + i * field, left.y + 3.9});
  }
}

// A small heading and what it is about, in a cell of the block.
void DrawCell(Canvas& canvas, const Box& cell, const std::string& heading, const std::string& text) {
  canvas.Rectangle(cell);
  canvas.Draw({kPanelSoft, 0.18});
  DrawText(canvas, {heading, {.size_mm = 2.0, .colour = kPanelSoft, .tracking = 0.12}, cell.width() - 3},
           {cell.x0 + 1.6, cell.y0 + 1.0});
  DrawText(canvas, {text, {.size_mm = 3.2, .colour = kPanelInk}, cell.width() - 3}, {cell.x0 + 1.6, cell.y0 + 3.7});
}

std::string NameOfDrawing(const PlanLayers& layers) {
  if (layers.constraints && layers.circulation) return "Constraints, circulation";
  if (layers.constraints) return "Plan of constraints";
  if (layers.circulation) return "Plan of circulation";
  return layers.floor_pieces || layers.tertiary ? "Furniture plan" : "Room plan";
}

}  // namespace

double DrawTitle(Canvas& canvas, const Plan& plan, const Box& box) {
  TextBlock title{
      Capital(plan.title), {.size_mm = 7.4, .colour = kPanelInk, .serif = true, .condense = 0.94}, box.width(), 3};
  // Rather smaller than on two lines, rather smaller still than on three.
  const double line = Measure(canvas, {"A", title.style}).height;
  for (const auto& [size_mm, lines] : {std::pair{7.4, 1}, {6.2, 1}, {6.6, 2}, {5.2, 3}}) {
    title.style.size_mm = size_mm;
    if (Measure(canvas, title).height < (lines + 0.5) * line * size_mm / 7.4) break;
  }
  DrawText(canvas, title, {box.x0, box.y0});
  double y = box.y0 + Measure(canvas, title).height + 1.4;
  std::string facts =
      fmt::format("{:.2f} × {:.2f} m   ·   {:.1f} m²", plan.bounds_m.width(), plan.bounds_m.height(), plan.area_m2);
  if (plan.height_m > 0) facts += fmt::format("   ·   {:.2f} m high", plan.height_m);
  DrawText(canvas, {facts, {.size_mm = 3.3, .colour = kPanelSoft}, box.width()}, {box.x0, y});
  return y + 6.5;
}

void DrawTitleBlock(Canvas& canvas, const Plan& plan, const Sheet& sheet, const Box& box) {
  constexpr double kCellMm = 9.4;
  const double cells = box.y1 - kCellMm, north = box.x1 - 22;
  canvas.Rectangle({box.x0, box.y0, north, cells});
  canvas.Draw({kPanelSoft, 0.18});
  canvas.Rectangle({north, box.y0, box.x1, cells});
  canvas.Draw({kPanelSoft, 0.18});
  const TextBlock scale{fmt::format("1:{}", sheet.scale), {.size_mm = 5.6, .colour = kPanelInk, .serif = true}};
  DrawText(canvas, scale, {box.x0 + 1.8, box.y0 + 2.2});
  DrawText(canvas, {fmt::format("at {}", sheet.paper), {.size_mm = 2.7, .colour = kPanelSoft}},
           {box.x0 + Measure(canvas, scale).width + 4, box.y0 + 4.8});
  DrawScaleBar(canvas, sheet, {box.x0 + 3.5, box.y0 + 13});
  DrawNorthArrow(canvas, {(north + box.x1) / 2, (box.y0 + cells) / 2 + 2.2});
  const double first = box.x0 + 0.56 * box.width(), second = box.x0 + 0.76 * box.width();
  DrawCell(canvas, {box.x0, cells, first, box.y1}, "DRAWING", NameOfDrawing(plan.layers));
  DrawCell(canvas, {first, cells, second, box.y1}, "UNIT", "metre");
  DrawCell(canvas, {second, cells, box.x1, box.y1}, "PIECES", fmt::format("{}", plan.objects.size()));
  canvas.Rectangle(box);
  canvas.Draw({kPanelInk, 0.35});
}

}  // namespace flair::renderer
