// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "renderer_worker/drawing/layers.h"
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
  canvas.Fill(kWhite, 1, true);
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
    canvas.Fill(i % 2 == 0 ? kPanelInk : kWhite, 1, true);
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

double DrawPalette(Canvas& canvas, const Plan& plan, double x, double y, double width) {
  const size_t count = std::min<size_t>(plan.palette.size(), 6);
  const double pitch = width / static_cast<double>(std::max<size_t>(count, 5));
  for (size_t i = 0; i < count; ++i) {
    const Box swatch{x + i * pitch, y, x + (i + 1) * pitch - 1.6, y + 7};
    canvas.Rectangle(swatch, 0.8);
    canvas.Fill(plan.palette[i].second, 1, true);
    canvas.Draw({Hex(0x8A8379), 0.12});
    TextBlock name{plan.palette[i].first, {.size_mm = 2.4, .colour = kPanelSoft}, pitch - 1.0, 2};
    DrawText(canvas, name, {swatch.x0, swatch.y1 + 0.7});
  }
  return y + 15;
}

std::string UnplacedText(const Plan& plan) {
  std::string text;
  for (const std::string& name : plan.unplaced) text += (text.empty() ? "Not placed: " : ", ") + name;
  return text;
}

// A block that is drawn from the bottom of what is left upwards, with a rule above it.
template <typename Block>
void StackUp(Canvas& canvas, Box& left, double height, const Block& block) {
  constexpr double kGapMm = 2.6;
  if (height <= 0 || height + 2 * kGapMm > left.height()) return;
  const double top = left.y1 - height;
  block(Box{left.x0, top, left.x1, left.y1});
  Rule(canvas, left.x0, left.x1, top - kGapMm);
  left.y1 = top - 2 * kGapMm;
}

void StackUnplaced(Canvas& canvas, const Plan& plan, Box& left) {
  if (plan.unplaced.empty()) return;
  const TextBlock unplaced{UnplacedText(plan), {.size_mm = 2.8, .colour = Hex(0x8C3B2E)}, left.width(), 3};
  const double height = Measure(canvas, unplaced).height;
  DrawText(canvas, unplaced, {left.x0, left.y1 - height});
  left.y1 -= height + 2;
}

// Everything that comes before the key where there is not paper enough for all.
void StackLegends(Canvas& canvas, const Plan& plan, Box& left) {
  const double most_mm = 0.6 * left.height();
  StackUp(canvas, left, DrawOverlayLegend(canvas, plan, left, most_mm, false),
          [&](const Box& box) { DrawOverlayLegend(canvas, plan, box, most_mm, true); });
  if (left.height() - LeastKeyHeight(plan) > DrawSigns(canvas, plan, left, false) + 5)
    StackUp(canvas, left, DrawSigns(canvas, plan, left, false),
            [&](const Box& box) { DrawSigns(canvas, plan, box, true); });
}

// The style with its sentences, without them, or not at all, as long as `keep_mm` stay free.
void StackStyle(Canvas& canvas, const Plan& plan, double keep_mm, Box& left) {
  for (const bool words : {true, false}) {
    const double height = DrawStyle(canvas, plan, {left.x0, 0, left.x1, 0}, words, false);
    if (left.height() - height - 5 < keep_mm) continue;
    StackUp(canvas, left, height, [&](const Box& box) { DrawStyle(canvas, plan, box, words, true); });
    return;
  }
}

}  // namespace

double DrawTitle(Canvas& canvas, const Plan& plan, const Box& box) {
  TextBlock title{
      Capital(plan.title), {.size_mm = 7.4, .colour = kPanelInk, .serif = true, .condense = 0.94}, box.width(), 3};
  // Rather smaller than on two lines, rather smaller still than on three.
  const double line = Measure(canvas, {"A", title.style}).height;
  for (const auto& [size_mm, lines] : {std::pair{7.4, 1}, {6.2, 1}, {5.6, 1}, {6.6, 2}, {5.2, 3}}) {
    title.style.size_mm = size_mm;
    if (Measure(canvas, title).height < (lines + 0.5) * line * size_mm / 7.4) break;
  }
  DrawText(canvas, title, {box.x0, box.y0});
  double y = box.y0 + Measure(canvas, title).height + 1.4;
  std::string facts =
      fmt::format("{:.2f} × {:.2f} m   ·   {:.1f} m²", plan.bounds_m.width(), plan.bounds_m.height(), plan.area_m2);
  if (plan.height_m > 0) facts += fmt::format("   ·   {:.2f} m high", plan.height_m);
  DrawText(canvas, {facts, {.size_mm = 3.3, .colour = kPanelSoft}, box.width()}, {box.x0, y});
  y += 6.5;
  if (plan.remark.empty()) return y;
  const TextBlock remark{plan.remark, {.size_mm = 2.9, .colour = kPanelSoft, .line_spacing = 1.08}, box.width(), 5};
  DrawText(canvas, remark, {box.x0, y});
  return y + Measure(canvas, remark).height + 2;
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

double DrawStyle(Canvas& canvas, const Plan& plan, const Box& box, bool words, bool draw) {
  if (plan.style_name.empty() && plan.palette.empty() && plan.style_summary.empty()) return 0;
  double y = box.y0;
  const auto paragraph = [&](const std::string& text, TextStyle style, int lines) {
    if (text.empty()) return;
    const TextBlock block{text, style, box.width(), lines};
    if (draw) DrawText(canvas, block, {box.x0, y});
    y += Measure(canvas, block).height + 1.2;
  };
  if (draw) Heading(canvas, "STYLE", box.x0, y);
  y += 5.2;
  paragraph(Capital(plan.style_name), {.size_mm = 4.2, .colour = kPanelInk, .serif = true}, 1);
  if (words) paragraph(plan.style_summary, {.size_mm = 2.9, .colour = kPanelSoft, .line_spacing = 1.08}, 4);
  std::string finishes;
  if (!plan.floor_material.empty()) finishes += "Floor: " + plan.floor_material;
  if (!plan.wall_material.empty()) finishes += (finishes.empty() ? "" : "   ·   ") + ("Walls: " + plan.wall_material);
  if (words) paragraph(finishes, {.size_mm = 2.9, .colour = kPanelInk}, 2);
  if (!plan.palette.empty()) {
    y += 0.8;
    if (draw) DrawPalette(canvas, plan, box.x0, y, box.width());
    y += 14;
  }
  return y - box.y0;
}

std::string Capital(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 32);
  return text;
}

void Rule(Canvas& canvas, double x0, double x1, double y) {
  canvas.Line({x0, y}, {x1, y});
  canvas.Draw({kPanelRule, 0.2});
}

double Heading(Canvas& canvas, const std::string& text, double x, double y) {
  DrawText(canvas, {text, {.size_mm = 2.7, .colour = kPanelSoft, .bold = true, .tracking = 0.18}}, {x, y});
  return y + 5.2;
}

void DrawSidePanel(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  const Box side = sheet.side_mm;
  // Portrait: title, style and title block in a left column, the key beside it. Landscape: all in one column.
  Box left{side.x0, side.y0, sheet.portrait ? side.x0 + 0.40 * side.width() : side.x1, side.y1};
  left.y0 = DrawTitle(canvas, plan, left) + 0.5;
  DrawTitleBlock(canvas, plan, sheet, {left.x0, left.y1 - kTitleBlockMm, left.x1, left.y1});
  left.y1 -= kTitleBlockMm + 4;
  if (!sheet.portrait) Rule(canvas, left.x0, left.x1, left.y0);
  left.y0 += 3;
  if (sheet.portrait) {
    StackStyle(canvas, plan, 0, left);
    Box key{left.x1 + 8, side.y0, side.x1, side.y1};
    StackLegends(canvas, plan, key);
    StackUnplaced(canvas, plan, key);
    DrawKey(canvas, plan, key);
    return;
  }
  const double least_key = LeastKeyHeight(plan);
  Box rest = left;
  StackStyle(canvas, plan, least_key + DrawOverlayLegend(canvas, plan, left, 0.6 * left.height(), false), rest);
  StackLegends(canvas, plan, rest);
  StackUnplaced(canvas, plan, rest);
  DrawKey(canvas, plan, rest);
}

}  // namespace flair::renderer
