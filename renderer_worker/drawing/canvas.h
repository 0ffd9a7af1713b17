// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cairo.h>

#include <initializer_list>
#include <memory>
#include <span>

#include "renderer_worker/drawing/colour.h"
#include "renderer_worker/drawing/box.h"

namespace flair::renderer {

class Lettering;

enum class Dash { kSolid, kDashed };

// How a path is drawn along: widths and dashes are in millimetres of paper whatever the frame.
struct Stroke {
  Rgb colour;
  double width_mm = 0.18;
  double alpha = 1;
  Dash dash = Dash::kSolid;
  bool round = false;  // ends and corners
};

// Draws on any cairo surface whose user unit is one millimetre of paper (sheet frame S). Paths may be built in another
// frame (an object's, in metres); strokes keep their width on paper. Knows nothing of files or pixels.
class Canvas {
 public:
  // `cairo` must outlive the canvas.
  explicit Canvas(cairo_t* cairo);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  // Paths are from now on built in a frame with this origin (in S), `mm_per_unit` and, when `y_up`, its y axis pointing
  // up the sheet before turning counter-clockwise by `theta_rad`.
  void EnterFrame(Point origin_mm, double mm_per_unit, double theta_rad, bool y_up);
  // Back to S.
  void LeaveFrame();

  void MoveTo(Point point);
  void LineTo(Point point);
  void CurveTo(Point control_1, Point control_2, Point end);
  // Part of a circle from angle `from_rad` to `to_rad` in the current frame, in growing angles.
  void Arc(Point centre, double radius, double from_rad, double to_rad);
  void Close();
  void Line(Point from, Point to);
  void Polygon(std::span<const Point> points);
  void Rectangle(const Box& box, double radius = 0);
  void Ellipse(Point centre, double radius_x, double radius_y);

  // Each consumes the path, except when followed by the other through `keep`.
  void Fill(const Rgb& colour, double alpha = 1, bool keep = false);
  void FillEvenOdd(const Rgb& colour, double alpha = 1);
  void Draw(const Stroke& stroke, bool keep = false);
  void Discard();
  // Restricts drawing to the path until the matching Unclip.
  void Clip();
  void Unclip();

  cairo_t* cairo() const { return cairo_; }
  const Lettering& lettering() const { return *lettering_; }

 private:
  cairo_t* cairo_;
  std::unique_ptr<Lettering> lettering_;
  cairo_matrix_t sheet_;
  cairo_matrix_t frame_;
};

}  // namespace flair::renderer
