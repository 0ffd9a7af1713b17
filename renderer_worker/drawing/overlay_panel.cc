// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "renderer_worker/drawing/layers.h"
#include "renderer_worker/drawing/panel.h"
#include "renderer_worker/drawing/text.h"

namespace flair::renderer {
namespace {

constexpr double kRowMm = 5;

int Count(const Plan& plan, v1::OutcomeStatus status) {
  return static_cast<int>(std::count_if(plan.edges.begin(), plan.edges.end(),
                                        [status](const PlanEdge& edge) { return edge.status == status; }));
}

// Writes lines below each other, or only adds up their heights.
class Column {
 public:
  Column(Canvas& canvas, const Box& box, bool draw) : canvas_(canvas), box_(box), y_(box.y0), draw_(draw) {}

  void Head(const std::string& text) {
    if (y_ > box_.y0) y_ += 2;
    if (draw_) Heading(canvas_, text, box_.x0, y_);
    y_ += 5.2;
  }

  // `sign` draws what the text explains into the box that it is given.
  template <typename Sign>
  void Line(const std::string& text, int lines, const Sign& sign) {
    const TextBlock block{text, {.size_mm = 2.9, .colour = kPanelInk}, box_.width() - 12, lines};
    const double height = std::max(kRowMm, Measure(canvas_, block).height + 1);
    if (draw_) {
      sign(Box{box_.x0, y_ + 0.8, box_.x0 + 9, y_ + kRowMm - 0.8});
      DrawText(canvas_, block, {box_.x0 + 12, y_ + 0.5});
    }
    y_ += height;
  }

  double height() const { return y_ - box_.y0; }

 private:
  Canvas& canvas_;
  Box box_;
  double y_;
  bool draw_;
};

void ListConstraints(Canvas& canvas, const Plan& plan, double most_mm, Column& column) {
  column.Head("CONSTRAINTS");
  for (const auto& [status, verdict] : {std::pair{v1::OUTCOME_STATUS_SATISFIED, "satisfied"},
                                        {v1::OUTCOME_STATUS_VIOLATED, "violated"},
                                        {v1::OUTCOME_STATUS_DROPPED, "dropped"}}) {
    if (status == v1::OUTCOME_STATUS_DROPPED && Count(plan, status) == 0) continue;
    column.Line(fmt::format("{} {}", Count(plan, status), verdict), 1, [&, status = status](const Box& box) {
      canvas.Line({box.x0, box.centre().y}, {box.x1, box.centre().y});
      canvas.Draw(VerdictStroke(status));
    });
  }
  const int violated = Count(plan, v1::OUTCOME_STATUS_VIOLATED);
  int index = 0;
  for (const PlanEdge& edge : plan.edges) {
    if (edge.status != v1::OUTCOME_STATUS_VIOLATED) continue;
    if (column.height() > most_mm - 3 * kRowMm && violated - index > 1) {
      column.Line(fmt::format("… and {} more", violated - index), 1, [](const Box&) {});
      return;
    }
    const std::string words = edge.words + (edge.miss.empty() ? "" : " (by " + edge.miss + ")");
    column.Line(words, 2, [&](const Box& box) { DrawViolationBadge(canvas, index, {box.x0 + 4.5, box.centre().y}); });
    ++index;
  }
}

void ListWays(Canvas& canvas, const Plan& plan, Column& column) {
  column.Head("CIRCULATION");
  column.Line(fmt::format("Ways from the door to {} fronts, 0.60 m wide", plan.routes_m.size()), 2,
              [&](const Box& box) { DrawRouteSign(canvas, box, false); });
  std::string names;
  for (const std::string& name : plan.blocked) names += (names.empty() ? "" : ", ") + name;
  if (!plan.blocked.empty())
    column.Line(fmt::format("{} out of reach: {}", plan.blocked.size(), names), 4,
                [&](const Box& box) { DrawRouteSign(canvas, box, true); });
}

}  // namespace

double DrawOverlayLegend(Canvas& canvas, const Plan& plan, const Box& box, double most_mm, bool draw) {
  Column column(canvas, box, draw);
  if (plan.layers.circulation) ListWays(canvas, plan, column);
  if (plan.layers.constraints) ListConstraints(canvas, plan, most_mm, column);
  return column.height();
}

}  // namespace flair::renderer
