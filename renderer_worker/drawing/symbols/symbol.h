// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "renderer_worker/drawing/canvas.h"

namespace flair::renderer {

// The colours one object is drawn in.
struct Ink {
  Rgb fill;
  Rgb line;
};

// Which colour an area of a symbol takes, relative to its object's.
enum class Tone { kNone, kBody, kLight, kPale, kDark, kDeep, kWater, kGlass, kLeaf, kWood, kMetal, kFire };

// How a symbol's line is drawn.
enum class Line { kNone, kOutline, kDetail, kFaint, kDashed };

// Draws one plan symbol in object frame O: origin in the middle, x to the right of someone who stands behind the object
// and looks the way it faces, y to its front, metres. Symbols fill exactly [left, right] x [back, front].
class SymbolPen {
 public:
  // The canvas must be in frame O already and outlive the pen.
  SymbolPen(Canvas& canvas, const Ink& ink, double width_m, double depth_m)
      : canvas_(canvas), ink_(ink), width_m_(width_m), depth_m_(depth_m) {}

  double width() const { return width_m_; }
  double depth() const { return depth_m_; }
  double left() const { return -width_m_ / 2; }
  double right() const { return width_m_ / 2; }
  double back() const { return -depth_m_ / 2; }
  double front() const { return depth_m_ / 2; }
  double smaller() const { return width_m_ < depth_m_ ? width_m_ : depth_m_; }
  Box whole() const { return {left(), back(), right(), front()}; }

  // Areas and lines; any box may be given in any corner order.
  void Area(Box box, Tone tone, Line line = Line::kOutline, double radius_m = 0);
  void Oval(Point centre, double radius_x, double radius_y, Tone tone, Line line = Line::kDetail);
  void Circle(Point centre, double radius, Tone tone, Line line = Line::kDetail) {
    Oval(centre, radius, radius, tone, line);
  }
  void Shape(std::span<const Point> points, Tone tone, Line line = Line::kOutline);
  void Segment(Point from, Point to, Line line = Line::kDetail);
  void Arc(Point centre, double radius, double from_rad, double to_rad, Line line = Line::kDetail);
  void Curve(Point from, Point control_1, Point control_2, Point to, Line line = Line::kDetail);
  // A small solid wedge on the front edge, pointing out: for pieces whose front cannot be told otherwise.
  void FrontMark();

 private:
  void Paint(Tone tone, Line line);
  Rgb ColourOf(Tone tone) const;

  Canvas& canvas_;
  Ink ink_;
  double width_m_;
  double depth_m_;
};

// A plan symbol.
struct Symbol {
  std::string_view name;  // what records of furniture call it
  void (*draw)(SymbolPen& pen);
};

// Every symbol, families in the order of their files.
std::vector<Symbol> Symbols();

// The symbol that a class of furniture is drawn with; that of a plain block for a name that is none.
const Symbol& SymbolNamed(std::string_view name);

// The symbols by family, each in the file of its name.
std::span<const Symbol> KitchenAndBathSymbols();
std::span<const Symbol> DecorSymbols();
std::span<const Symbol> SeatAndBedSymbols();
std::span<const Symbol> TableAndStorageSymbols();
std::span<const Symbol> LeisureAndCraftSymbols();

}  // namespace flair::renderer
