// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "renderer_worker/drawing/layers.h"
#include "renderer_worker/drawing/text.h"

namespace flair::renderer {
namespace {

const Rgb kInk = Hex(0x2B2926);
const Rgb kSoft = Hex(0x6B665F);
const Rgb kRule = Hex(0xB9B2A7);

std::string Capital(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 32);
  return text;
}

void Rule(Canvas& canvas, double x0, double x1, double y) {
  canvas.Line({x0, y}, {x1, y});
  canvas.Draw({kRule, 0.2});
}

double Heading(Canvas& canvas, const std::string& text, double x, double y) {
  DrawText(canvas, {text, {.size_mm = 2.9, .colour = kSoft, .bold = true, .tracking = 0.18}}, {x, y});
  return y + 5.2;
}

// Title and the room's facts; returns where it ends.
double DrawTitle(Canvas& canvas, const Plan& plan, const Box& box) {
  TextBlock title{
      Capital(plan.title), {.size_mm = 7.4, .colour = kInk, .serif = true, .condense = 0.94}, box.width(), 3};
  if (Measure(canvas, title).height > 18) title.style.size_mm = 5.6;
  DrawText(canvas, title, {box.x0, box.y0});
  double y = box.y0 + Measure(canvas, title).height + 1.4;
  std::string facts =
      fmt::format("{:.2f} × {:.2f} m   ·   {:.1f} m²", plan.bounds_m.width(), plan.bounds_m.height(), plan.area_m2);
  if (plan.height_m > 0) facts += fmt::format("   ·   {:.2f} m high", plan.height_m);
  DrawText(canvas, {facts, {.size_mm = 3.3, .colour = kSoft}, box.width()}, {box.x0, y});
  return y + 6.5;
}

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
  const Ink ink = object != plan.objects.end() ? object->ink : Ink{Hex(0xE5E0D8), kSoft};
  const double middle = (row.y0 + row.y1) / 2;
  DrawBadge(canvas, number, {row.x0 + 2.9, middle}, Mix(ink.fill, Hex(0xFFFFFF), 0.25), ink.line);
  const TextBlock dims{fmt::format("{:.2f} × {:.2f}", key.width_m, key.depth_m),
                       {.size_mm = 0.86 * size, .colour = kSoft}};
  const Size dims_size = Measure(canvas, dims);
  DrawText(canvas, dims, {row.x1 - dims_size.width, middle - dims_size.height / 2});
  std::string name = key.name;
  if (key.count > 1) name += fmt::format("  ×{}", key.count);
  if (*Carrier(key) != 0) name += fmt::format("  ({})", Carrier(key));
  const TextBlock text{name, {.size_mm = size, .colour = kInk}, row.width() - dims_size.width - 9};
  DrawText(canvas, text, {row.x0 + 7, middle - Measure(canvas, text).height / 2});
}

void DrawZoneRow(Canvas& canvas, const Plan& plan, int zone, const Box& row, double size) {
  const double y = row.y1 - 0.85 * size;
  if (zone >= 0) {
    canvas.Rectangle({row.x0 + 1.2, y - 1.7, row.x0 + 4.6, y + 1.7}, 0.5);
    canvas.Fill(Mix(Hex(0xFFFFFF), plan.zones[zone].tint, 0.55), 1, true);
    canvas.Draw({LineColourFor(plan.zones[zone].tint), 0.18});
  }
  const TextBlock text{Capital(zone < 0 ? "whole room" : plan.zones[zone].name),
                       {.size_mm = size, .colour = kInk, .bold = true},
                       row.width() - 8};
  DrawText(canvas, text, {row.x0 + (zone < 0 ? 1.2 : 7), y - Measure(canvas, text).height / 2});
}

// The key in as many columns as the box is wide; shrinks, then ends with "and N more".
void DrawKey(Canvas& canvas, const Plan& plan, const Box& box) {
  const std::vector<Row> rows = RowsOf(plan);
  const double y0 = Heading(canvas, "KEY", box.x0, box.y0);
  const TextBlock unit{"width × depth, m", {.size_mm = 2.6, .colour = kSoft}};
  DrawText(canvas, unit, {box.x1 - Measure(canvas, unit).width, box.y0 + 0.2});
  int columns = std::max(1, static_cast<int>(box.width() / 88));
  double pitch = 5.5;
  size_t capacity = 0;
  for (; pitch > 3.9; pitch -= 0.4) {
    capacity = static_cast<size_t>(std::max(0.0, (box.y1 - y0) / pitch)) * columns;
    if (rows.size() + columns <= capacity) break;
  }
  if (rows.size() + columns > capacity && !rows.empty()) {
    columns *= 2;
    pitch = 4.7;
    capacity *= 2;
  }
  const double size = std::min(3.4, 0.66 * pitch);
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
        DrawText(canvas, {fmt::format("… and {} more", left), {.size_mm = 2.8, .colour = kSoft}},
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

double DrawPalette(Canvas& canvas, const Plan& plan, double x, double y, double width) {
  const size_t count = std::min<size_t>(plan.palette.size(), 6);
  const double pitch = width / static_cast<double>(std::max<size_t>(count, 5));
  for (size_t i = 0; i < count; ++i) {
    const Box swatch{x + i * pitch, y, x + (i + 1) * pitch - 1.6, y + 7};
    canvas.Rectangle(swatch, 0.8);
    canvas.Fill(plan.palette[i].second, 1, true);
    canvas.Draw({Hex(0x8A8379), 0.12});
    TextBlock name{plan.palette[i].first, {.size_mm = 2.4, .colour = kSoft}, pitch - 1.0, 2};
    DrawText(canvas, name, {swatch.x0, swatch.y1 + 0.7});
  }
  return y + 15;
}

// Style in words, palette, finishes; returns its height. With `draw` false it only measures.
double DrawStyle(Canvas& canvas, const Plan& plan, const Box& box, bool draw) {
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
  paragraph(Capital(plan.style_name), {.size_mm = 4.2, .colour = kInk, .serif = true}, 1);
  paragraph(plan.style_summary, {.size_mm = 2.9, .colour = kSoft, .line_spacing = 1.08}, 4);
  std::string finishes;
  if (!plan.floor_material.empty()) finishes += "Floor: " + plan.floor_material;
  if (!plan.wall_material.empty()) finishes += (finishes.empty() ? "" : "   ·   ") + ("Walls: " + plan.wall_material);
  paragraph(finishes, {.size_mm = 2.9, .colour = kInk}, 2);
  if (!plan.palette.empty()) {
    y += 0.8;
    if (draw) DrawPalette(canvas, plan, box.x0, y, box.width());
    y += 14;
  }
  return y - box.y0;
}

void DrawNorthArrow(Canvas& canvas, Point centre) {
  const double r = 6.2;
  canvas.Ellipse(centre, r, r);
  canvas.Draw({kInk, 0.22});
  const Point east[] = {
      {centre.x, centre.y - r + 0.6}, {centre.x + 2.4, centre.y + 0.72 * r}, {centre.x, centre.y + 0.38 * r}};
  const Point west[] = {
      {centre.x, centre.y - r + 0.6}, {centre.x - 2.4, centre.y + 0.72 * r}, {centre.x, centre.y + 0.38 * r}};
  canvas.Polygon(east);
  canvas.Fill(kInk, 1, true);
  canvas.Draw({kInk, 0.2});
  canvas.Polygon(west);
  canvas.Fill(Hex(0xFFFFFF), 1, true);
  canvas.Draw({kInk, 0.2});
  DrawTextAt(canvas, {"N", {.size_mm = 3.4, .colour = kInk, .bold = true}}, {centre.x, centre.y - r - 2.4});
}

// Five alternating fields of a round length, about 55 mm of paper in all.
void DrawScaleBar(Canvas& canvas, const Sheet& sheet, Point left) {
  double field_m = 0.1;
  for (double step : {0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0}) {
    if (4 * step * sheet.mm_per_m() <= 56) field_m = step;
  }
  const double field = field_m * sheet.mm_per_m();
  for (int i = 0; i < 4; ++i) {
    canvas.Rectangle({left.x + i * field, left.y, left.x + (i + 1) * field, left.y + 1.7});
    canvas.Fill(i % 2 == 0 ? kInk : Hex(0xFFFFFF), 1, true);
    canvas.Draw({kInk, 0.2});
  }
  for (int i = 0; i <= 4; i += 2) {
    const std::string text = fmt::format("{:g}{}", i * field_m, i == 4 ? " m" : "");
    DrawTextAt(canvas, {text, {.size_mm = 2.8, .colour = kInk}}, {left.x + i * field, left.y + 4.2});
  }
}

// Scale, scale bar, north arrow.
void DrawScale(Canvas& canvas, const Sheet& sheet, const Box& box) {
  const TextBlock scale{fmt::format("1:{}", sheet.scale), {.size_mm = 5.6, .colour = kInk, .serif = true}};
  DrawText(canvas, scale, {box.x0, box.y0});
  DrawText(canvas, {fmt::format("at {}, dimensions in metres", sheet.paper), {.size_mm = 2.7, .colour = kSoft}},
           {box.x0 + Measure(canvas, scale).width + 2.5, box.y0 + 2.6});
  DrawScaleBar(canvas, sheet, {box.x0 + 0.5, box.y0 + 10.5});
  DrawNorthArrow(canvas, {box.x1 - 8, box.y0 + 11});
}

std::string UnplacedText(const Plan& plan) {
  std::string text;
  for (const std::string& name : plan.unplaced) text += (text.empty() ? "Not placed: " : ", ") + name;
  return text;
}

}  // namespace

void DrawSidePanel(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  constexpr double kScaleHeight = 19;
  const Box side = sheet.side_mm;
  // Portrait: title, style and scale in a left column, the key beside it. Landscape: all in one column.
  const Box left{side.x0, side.y0, sheet.portrait ? side.x0 + 98 : side.x1, side.y1};
  double y = DrawTitle(canvas, plan, left);
  const Box scale{left.x0, left.y1 - kScaleHeight, left.x1, left.y1};
  Rule(canvas, left.x0, left.x1, scale.y0 - 2.5);
  DrawScale(canvas, sheet, scale);
  double bottom = scale.y0 - 5;
  const double style_height = DrawStyle(canvas, plan, {left.x0, 0, left.x1, 0}, false);
  if (style_height > 0 && bottom - style_height > y) {
    const double top = sheet.portrait ? y + 3 : bottom - style_height;
    Rule(canvas, left.x0, left.x1, top - 2.5);
    DrawStyle(canvas, plan, {left.x0, top, left.x1, bottom}, true);
    if (!sheet.portrait) bottom = top - 5;
  }
  Box key = sheet.portrait ? Box{left.x1 + 8, side.y0, side.x1, side.y1} : Box{left.x0, y + 3, left.x1, bottom};
  if (!plan.unplaced.empty()) {
    const TextBlock unplaced{UnplacedText(plan), {.size_mm = 2.8, .colour = Hex(0x8C3B2E)}, key.width(), 3};
    const double height = Measure(canvas, unplaced).height;
    DrawText(canvas, unplaced, {key.x0, key.y1 - height});
    key.y1 -= height + 2;
  }
  if (!sheet.portrait) Rule(canvas, left.x0, left.x1, y + 0.2);
  DrawKey(canvas, plan, key);
}

}  // namespace flair::renderer
