// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/drawing/canvas.h"

#include <algorithm>
#include <numbers>

#include "renderer_worker/drawing/text.h"

namespace flair::renderer {

using std::numbers::pi;

Canvas::Canvas(cairo_t* cairo) : cairo_(cairo), lettering_(std::make_unique<Lettering>()) {
  cairo_get_matrix(cairo_, &sheet_);
  frame_ = sheet_;
}

Canvas::~Canvas() = default;

void Canvas::EnterFrame(Point origin_mm, double mm_per_unit, double theta_rad, bool y_up) {
  cairo_set_matrix(cairo_, &sheet_);
  cairo_translate(cairo_, origin_mm.x, origin_mm.y);
  cairo_scale(cairo_, mm_per_unit, y_up ? -mm_per_unit : mm_per_unit);
  cairo_rotate(cairo_, theta_rad);
  cairo_get_matrix(cairo_, &frame_);
}

void Canvas::LeaveFrame() {
  frame_ = sheet_;
  cairo_set_matrix(cairo_, &sheet_);
}

void Canvas::MoveTo(Point point) { cairo_move_to(cairo_, point.x, point.y); }
void Canvas::LineTo(Point point) { cairo_line_to(cairo_, point.x, point.y); }
void Canvas::CurveTo(Point control_1, Point control_2, Point end) {
  cairo_curve_to(cairo_, control_1.x, control_1.y, control_2.x, control_2.y, end.x, end.y);
}
void Canvas::Arc(Point centre, double radius, double from_rad, double to_rad) {
  cairo_new_sub_path(cairo_);
  cairo_arc(cairo_, centre.x, centre.y, radius, from_rad, to_rad);
}
void Canvas::Close() { cairo_close_path(cairo_); }

void Canvas::Line(Point from, Point to) {
  MoveTo(from);
  LineTo(to);
}

void Canvas::Polygon(std::span<const Point> points) {
  if (points.empty()) return;
  MoveTo(points.front());
  for (Point point : points.subspan(1)) LineTo(point);
  Close();
}

void Canvas::Rectangle(const Box& box, double radius) {
  const double r = std::min({radius, box.width() / 2, box.height() / 2});
  if (r <= 0) {
    cairo_rectangle(cairo_, box.x0, box.y0, box.width(), box.height());
    return;
  }
  cairo_new_sub_path(cairo_);
  cairo_arc(cairo_, box.x1 - r, box.y0 + r, r, -pi / 2, 0);
  cairo_arc(cairo_, box.x1 - r, box.y1 - r, r, 0, pi / 2);
  cairo_arc(cairo_, box.x0 + r, box.y1 - r, r, pi / 2, pi);
  cairo_arc(cairo_, box.x0 + r, box.y0 + r, r, pi, 1.5 * pi);
  Close();
}

void Canvas::Ellipse(Point centre, double radius_x, double radius_y) {
  if (!(radius_x > 0) || !(radius_y > 0)) return;
  cairo_new_sub_path(cairo_);
  cairo_save(cairo_);
  cairo_translate(cairo_, centre.x, centre.y);
  cairo_scale(cairo_, radius_x, radius_y);
  cairo_arc(cairo_, 0, 0, 1, 0, 2 * pi);
  cairo_restore(cairo_);
  Close();
}

void Canvas::Fill(const Rgb& colour, double alpha, bool keep) {
  cairo_set_source_rgba(cairo_, colour.red, colour.green, colour.blue, alpha);
  keep ? cairo_fill_preserve(cairo_) : cairo_fill(cairo_);
}

void Canvas::FillEvenOdd(const Rgb& colour, double alpha) {
  cairo_set_fill_rule(cairo_, CAIRO_FILL_RULE_EVEN_ODD);
  Fill(colour, alpha);
  cairo_set_fill_rule(cairo_, CAIRO_FILL_RULE_WINDING);
}

void Canvas::Draw(const Stroke& stroke, bool keep) {
  cairo_set_matrix(cairo_, &sheet_);
  cairo_set_source_rgba(cairo_, stroke.colour.red, stroke.colour.green, stroke.colour.blue, stroke.alpha);
  cairo_set_line_width(cairo_, stroke.width_mm);
  const double dashed[] = {1.6, 1.0};
  const double dotted[] = {0.35, 0.8};
  if (stroke.dash != Dash::kSolid) cairo_set_dash(cairo_, stroke.dash == Dash::kDashed ? dashed : dotted, 2, 0);
  cairo_set_line_join(cairo_, stroke.round ? CAIRO_LINE_JOIN_ROUND : CAIRO_LINE_JOIN_MITER);
  cairo_set_line_cap(cairo_, stroke.round ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
  keep ? cairo_stroke_preserve(cairo_) : cairo_stroke(cairo_);
  cairo_set_dash(cairo_, nullptr, 0, 0);
  cairo_set_matrix(cairo_, &frame_);
}

void Canvas::Discard() { cairo_new_path(cairo_); }

void Canvas::Clip() {
  cairo_path_t* path = cairo_copy_path(cairo_);
  cairo_new_path(cairo_);
  cairo_save(cairo_);
  cairo_append_path(cairo_, path);
  cairo_path_destroy(path);
  cairo_clip(cairo_);
}

void Canvas::Unclip() {
  cairo_restore(cairo_);
  cairo_set_matrix(cairo_, &frame_);
}

}  // namespace flair::renderer
