// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/drawing/svg_paths.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace flair::renderer {
namespace {

using Vector = flair::Vec2<double>;
using Polyline = std::vector<Vector>;

// Without what can be left out: -0.50 is -.5.
std::string NumberText(double value, double steps) {
  std::string text = fmt::format("{}", std::round(value * steps) / steps + 0.0);
  const size_t sign = text[0] == '-' ? 1 : 0;
  if (text.compare(sign, 2, "0.") == 0) text.erase(sign, 1);
  return text;
}

std::string PaintText(std::string_view what, const Rgb& colour, double alpha) {
  const auto channel = [](double value) { return std::lround(255 * value); };
  std::string text = fmt::format(" {}=\"#{:02x}{:02x}{:02x}\"", what, channel(colour.red), channel(colour.green),
                                 channel(colour.blue));
  if (alpha < 1) text += fmt::format(" {}-opacity=\"{}\"", what, NumberText(alpha, 1000));
  return text;
}

struct DestroyPath {
  void operator()(cairo_path_t* path) const { cairo_path_destroy(path); }
};
using PathPtr = std::unique_ptr<cairo_path_t, DestroyPath>;

// Each point from the one before, as that was rounded: so no error grows.
std::string DataOf(const cairo_path_t& path) {
  std::string data;
  char last = ' ';
  Point at, start;  // tenths of a millimetre
  for (int i = 0; i < path.num_data; i += path.data[i].header.length) {
    const cairo_path_data_t* part = &path.data[i];
    const char command = "mlcz"[part->header.type];
    // cairo ends closed paths with a move to their start.
    if (command == 'm' && i + part->header.length == path.num_data) break;
    if (command != last) data += command;
    Point to = command == 'z' ? start : at;
    for (int k = 1; k < part->header.length; ++k) {
      to = {std::round(10 * part[k].point.x), std::round(10 * part[k].point.y)};
      for (const double step : {to.x - at.x, to.y - at.y}) {
        if (step >= 0 && std::isalpha(data.back()) == 0) data += ' ';
        data += NumberText(step / 1e4, 1e4);
      }
    }
    at = to;
    if (command == 'm') start = to;
    last = command;
  }
  return data;
}

// The path's lines, curves as chords; closed ones end where they begin.
std::vector<Polyline> LinesOf(cairo_t* cairo) {
  const PathPtr path(cairo_copy_path_flat(cairo));
  std::vector<Polyline> lines;
  for (int i = 0; i < path->num_data; i += path->data[i].header.length) {
    const cairo_path_data_t* part = &path->data[i];
    if (part->header.type == CAIRO_PATH_MOVE_TO) lines.emplace_back();
    lines.back().push_back(part->header.type == CAIRO_PATH_CLOSE_PATH ? lines.back().front()
                                                                      : Vector{part[1].point.x, part[1].point.y});
  }
  std::erase_if(lines, [](const Polyline& line) { return line.size() < 2; });
  return lines;
}

Polygon CounterClockwise(Polyline corners) {
  if (flair::SignedArea(corners) < 0) std::ranges::reverse(corners);
  return {std::move(corners)};
}

void TraceWithin(const Polygon& clip, const Polygon& filled, cairo_t* cairo) {
  const Polygon cut = IsConvex(clip) ? ClipByConvex(filled, clip.vertices) : ClipByConvex(clip, filled.vertices);
  // Otherwise it would go on from where the one before began.
  cairo_new_sub_path(cairo);
  for (const Vector& corner : cut.vertices) cairo_line_to(cairo, corner.x, corner.y);
  if (!cut.vertices.empty()) cairo_close_path(cairo);
}

// `at` is where the last line within ended: one that goes on from there needs no move.
void TraceWithin(const Polygon& clip, const Vector& from, const Vector& to, Vector& at, cairo_t* cairo) {
  std::vector<double> shares = {0, 1};
  for (size_t i = 0; i < clip.vertices.size(); ++i) {
    const Segment edge = EdgeAt(clip, i);
    const Vector line = to - from, side = edge.end - edge.start, between = edge.start - from;
    const double turn = Cross(line, side), share = Cross(between, side) / turn, along = Cross(between, line) / turn;
    if (share > 0 && share < 1 && along >= 0 && along <= 1) shares.push_back(share);
  }
  std::ranges::sort(shares);
  const auto point = [&](double share) { return share == 1 ? to : from + share * (to - from); };
  for (size_t i = 0; i + 1 < shares.size(); ++i) {
    const Vector start = point(shares[i]), end = point(shares[i + 1]);
    if (!Contains(clip, Segment{start, end}.Middle())) continue;
    if (!(start == at)) cairo_move_to(cairo, start.x, start.y);
    cairo_line_to(cairo, end.x, end.y);
    at = end;
  }
}

}  // namespace

std::string SvgPaths::Data(cairo_t* cairo, bool filled) const {
  cairo_save(cairo);  // all but the path
  cairo_identity_matrix(cairo);
  PathPtr path(cairo_copy_path(cairo));
  const std::vector<Polyline> lines = LinesOf(cairo);
  const auto is_out = [this](const Vector& point) { return !Contains(clip_, point); };
  const bool cut = !clip_.vertices.empty() && (!IsConvex(clip_) || std::ranges::any_of(lines, [&](const auto& line) {
    return std::ranges::any_of(line, is_out);
  }));
  if (cut) {
    const PathPtr whole = std::move(path);
    cairo_new_path(cairo);
    for (const Polyline& line : lines) {
      Vector at{NAN, NAN};
      if (filled) TraceWithin(clip_, CounterClockwise(line), cairo);
      for (size_t i = 0; i + 1 < line.size() && !filled; ++i) TraceWithin(clip_, line[i], line[i + 1], at, cairo);
    }
    path.reset(cairo_copy_path(cairo));
    cairo_new_path(cairo);
    cairo_append_path(cairo, whole.get());
  }
  cairo_restore(cairo);
  return DataOf(*path);
}

void SvgPaths::Fill(cairo_t* cairo, const Rgb& colour, double alpha) {
  filled_ = Data(cairo, true);
  if (filled_.empty()) return;
  elements_ += fmt::format("<path d=\"{}\"{}", filled_, PaintText("fill", colour, alpha));
  if (cairo_get_fill_rule(cairo) == CAIRO_FILL_RULE_EVEN_ODD) elements_ += " fill-rule=\"evenodd\"";
  elements_ += "/>";
}

void SvgPaths::Draw(cairo_t* cairo, const Stroke& stroke) {
  const std::string data = Data(cairo, false);
  if (data.empty()) return;
  if (data == filled_) {
    elements_.resize(elements_.size() - 2);
  } else {
    elements_ += fmt::format("<path d=\"{}\"", data);
  }
  filled_.clear();
  const auto length = [this](double mm) { return NumberText(mm * m_per_mm_, 1e5); };
  elements_ += PaintText("stroke", stroke.colour, stroke.alpha);
  elements_ += fmt::format(" stroke-width=\"{}\"", length(stroke.width_mm));
  if (stroke.dash == Dash::kDashed) elements_ += fmt::format(" stroke-dasharray=\"{} {}\"", length(1.6), length(1));
  if (stroke.round) elements_ += " stroke-linejoin=\"round\" stroke-linecap=\"round\"";
  elements_ += "/>";
}

void SvgPaths::Clip(cairo_t* cairo) {
  cairo_save(cairo);
  cairo_identity_matrix(cairo);
  clip_ = CounterClockwise(LinesOf(cairo).front());
  clip_.vertices.pop_back();  // the first once more
  cairo_restore(cairo);
}

std::string SvgPaths::Take() {
  std::string group = "<g fill=\"none\" stroke-miterlimit=\"10\">" + std::move(elements_) + "</g>";
  elements_.clear();
  filled_.clear();
  return group;
}

}  // namespace flair::renderer
