// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/drawing/canvas.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer_worker/drawing/svg_paths.h"
#include "renderer_worker/drawing/text.h"

namespace flair::renderer {
namespace {

double ToLinear(double channel) {
  return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double FromLinear(double channel) {
  return channel <= 0.0031308 ? channel * 12.92 : 1.055 * std::pow(channel, 1 / 2.4) - 0.055;
}

// Linear sRGB of an OKLCH colour, not clamped. Matrices: B. Ottosson, "A perceptual color space for image processing".
Rgb LinearOf(const Oklch& colour) {
  const double a = colour.chroma * std::cos(colour.hue_rad);
  const double b = colour.chroma * std::sin(colour.hue_rad);
  const double l = std::pow(colour.lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = std::pow(colour.lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = std::pow(colour.lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
  return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
          -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
          -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

bool Exists(const Rgb& linear) {
  const auto inside = [](double channel) { return channel > -1e-4 && channel < 1.0001; };
  return inside(linear.red) && inside(linear.green) && inside(linear.blue);
}

}  // namespace

using std::numbers::pi;

Canvas::Canvas(cairo_t* cairo, SvgPaths* svg) : cairo_(cairo), svg_(svg), lettering_(std::make_unique<Lettering>()) {
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
  if (svg_ != nullptr) {
    svg_->Fill(cairo_, colour, alpha);
    if (!keep) Discard();
    return;
  }
  cairo_set_source_rgba(cairo_, colour.red, colour.green, colour.blue, alpha);
  keep ? cairo_fill_preserve(cairo_) : cairo_fill(cairo_);
}

void Canvas::FillEvenOdd(const Rgb& colour, double alpha) {
  cairo_set_fill_rule(cairo_, CAIRO_FILL_RULE_EVEN_ODD);
  Fill(colour, alpha);
  cairo_set_fill_rule(cairo_, CAIRO_FILL_RULE_WINDING);
}

void Canvas::Draw(const Stroke& stroke, bool keep) {
  if (svg_ != nullptr) {
    svg_->Draw(cairo_, stroke);
    if (!keep) Discard();
    return;
  }
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
  if (svg_ != nullptr) svg_->Clip(cairo_);
  cairo_clip(cairo_);
}

void Canvas::Unclip() {
  if (svg_ != nullptr) svg_->Unclip();
  cairo_restore(cairo_);
  cairo_set_matrix(cairo_, &frame_);
}

Rgb Hex(unsigned value) { return {((value >> 16) & 255) / 255.0, ((value >> 8) & 255) / 255.0, (value & 255) / 255.0}; }

Rgb FromLinear(const Vec3& linear) { return {FromLinear(linear.x), FromLinear(linear.y), FromLinear(linear.z)}; }

Rgb FromProto(const v1::Colour& colour) {
  const auto channel = [](int value) { return std::clamp(value, 0, 255) / 255.0; };
  return {channel(colour.red()), channel(colour.green()), channel(colour.blue())};
}

Rgb Mix(const Rgb& from, const Rgb& to, double share) {
  const auto channel = [share](double a, double b) { return a + (b - a) * share; };
  return {channel(from.red, to.red), channel(from.green, to.green), channel(from.blue, to.blue)};
}

Oklch ToOklch(const Rgb& colour) {
  const double r = ToLinear(colour.red), g = ToLinear(colour.green), b = ToLinear(colour.blue);
  const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  const double lab_a = 1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s;
  const double lab_b = 0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s;
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s, std::hypot(lab_a, lab_b), std::atan2(lab_b, lab_a)};
}

Rgb FromOklch(const Oklch& colour) {
  Oklch nearest = colour;
  Rgb linear = LinearOf(nearest);
  for (int step = 0; step < 40 && !Exists(linear); ++step) {
    nearest.chroma *= 0.9;
    linear = LinearOf(nearest);
  }
  const auto channel = [](double value) { return std::clamp(FromLinear(std::clamp(value, 0.0, 1.0)), 0.0, 1.0); };
  return {channel(linear.red), channel(linear.green), channel(linear.blue)};
}

Rgb ZoneTint(int index) { return FromOklch({0.80, 0.075, 1.0 + 2.399963 * index}); }

Rgb SoftenForPrint(const Rgb& colour) {
  Oklch soft = ToOklch(colour);
  soft.lightness = 0.605 + 0.03 * soft.lightness + 0.34 * std::pow(soft.lightness, 1.5);
  soft.chroma = std::min(0.72 * soft.chroma, 0.10);
  return FromOklch(soft);
}

Rgb TintForPrint(const Rgb& colour) {
  Oklch tint = ToOklch(colour);
  tint.lightness = 0.902 + 0.05 * tint.lightness;
  tint.chroma = std::min(0.4 * tint.chroma, 0.034);
  return FromOklch(tint);
}

Rgb LineColourFor(const Rgb& fill) {
  Oklch line = ToOklch(fill);
  line.lightness = 0.34;
  line.chroma = std::min(0.9 * line.chroma, 0.05);
  return FromOklch(line);
}

}  // namespace flair::renderer
