// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/drawing/symbols/symbol.h"

#include <algorithm>

namespace flair::renderer {
namespace {

constexpr double kOutlineMm = 0.30;
constexpr double kDetailMm = 0.16;
constexpr double kFaintMm = 0.11;

Box Ordered(Box box) {
  return {std::min(box.x0, box.x1), std::min(box.y0, box.y1), std::max(box.x0, box.x1), std::max(box.y0, box.y1)};
}

// Anything that has no symbol of its own.
void DrawPlainBox(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kBody, Line::kOutline);
  pen.Area(pen.whole().Grown(-std::min(0.04, 0.08 * pen.smaller())), Tone::kLight, Line::kFaint);
  pen.FrontMark();
}

}  // namespace

Rgb SymbolPen::ColourOf(Tone tone) const {
  const Rgb white = Hex(0xFFFFFF);
  switch (tone) {
    case Tone::kNone:
    case Tone::kBody:
      return ink_.fill;
    case Tone::kLight:
      return Mix(ink_.fill, white, 0.42);
    case Tone::kPale:
      return Mix(ink_.fill, white, 0.78);
    case Tone::kDark:
      return Mix(ink_.fill, ink_.line, 0.16);
    case Tone::kDeep:
      return Mix(ink_.fill, ink_.line, 0.62);
    case Tone::kWater:
      return Hex(0xDCEBF0);
    case Tone::kGlass:
      return Hex(0xE8EFF1);
    case Tone::kLeaf:
      return Mix(Hex(0xA9C29A), ink_.fill, 0.25);
    case Tone::kWood:
      return Hex(0xD9C3A3);
    case Tone::kMetal:
      return Hex(0xD3D5D6);
    case Tone::kFire:
      return Hex(0xE9A36B);
  }
  return ink_.fill;
}

void SymbolPen::Paint(Tone tone, Line line) {
  if (tone != Tone::kNone) canvas_.Fill(ColourOf(tone), 1, line != Line::kNone);
  const double width_mm = line == Line::kOutline ? kOutlineMm : line == Line::kFaint ? kFaintMm : kDetailMm;
  const double alpha = line == Line::kFaint ? 0.55 : line == Line::kDetail ? 0.8 : 1;
  if (line != Line::kNone) {
    canvas_.Draw({ink_.line, width_mm, alpha, line == Line::kDashed ? Dash::kDashed : Dash::kSolid});
  }
  canvas_.Discard();
}

void SymbolPen::Area(Box box, Tone tone, Line line, double radius_m) {
  canvas_.Rectangle(Ordered(box), radius_m);
  Paint(tone, line);
}

void SymbolPen::Oval(Point centre, double radius_x, double radius_y, Tone tone, Line line) {
  canvas_.Ellipse(centre, radius_x, radius_y);
  Paint(tone, line);
}

void SymbolPen::Shape(std::span<const Point> points, Tone tone, Line line) {
  canvas_.Polygon(points);
  Paint(tone, line);
}

void SymbolPen::Segment(Point from, Point to, Line line) {
  canvas_.Line(from, to);
  Paint(Tone::kNone, line);
}

void SymbolPen::Arc(Point centre, double radius, double from_rad, double to_rad, Line line) {
  canvas_.Arc(centre, radius, from_rad, to_rad);
  Paint(Tone::kNone, line);
}

void SymbolPen::Curve(Point from, Point control_1, Point control_2, Point to, Line line) {
  canvas_.MoveTo(from);
  canvas_.CurveTo(control_1, control_2, to);
  Paint(Tone::kNone, line);
}

void SymbolPen::FrontMark() {
  const double half = std::min(0.05, 0.14 * smaller());
  const Point wedge[] = {{-half, front() - 1.9 * half}, {half, front() - 1.9 * half}, {0, front() - 0.5 * half}};
  Shape(wedge, Tone::kDeep, Line::kNone);
}

std::vector<Symbol> Symbols() {
  std::vector<Symbol> all = {{"plain_box", DrawPlainBox}};
  for (const auto family : {KitchenAndBathSymbols(), DecorSymbols(), SeatAndBedSymbols(), TableAndStorageSymbols(),
                            LeisureAndCraftSymbols()}) {
    all.insert(all.end(), family.begin(), family.end());
  }
  return all;
}

const Symbol& SymbolNamed(std::string_view name) {
  static const std::vector<Symbol>& all = *new std::vector<Symbol>(Symbols());
  const auto at = std::find_if(all.begin(), all.end(), [name](const Symbol& symbol) { return symbol.name == name; });
  return at != all.end() ? *at : all.front();
}

}  // namespace flair::renderer
