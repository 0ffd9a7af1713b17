// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "renderer_worker/drawing/layers.h"
#include "renderer_worker/drawing/panel.h"
#include "renderer_worker/drawing/text.h"

namespace flair::renderer {
namespace {

constexpr double kRowMm = 5.2, kSignMm = 9;

struct Sign {
  const char* words;
  void (*draw)(Canvas& canvas, const Box& box);
};

void Frame(Canvas& canvas, const Box& box) {
  canvas.Rectangle(box);
  canvas.Fill(kWhite, 1, true);
  canvas.Draw({kPanelInk, 0.25});
}

void WindowSign(Canvas& canvas, const Box& box) {
  Frame(canvas, {box.x0, box.y0 + 0.4, box.x1, box.y1 - 0.4});
  for (double share : {0.38, 0.62}) {
    const double y = box.y0 + share * box.height();
    canvas.Line({box.x0, y}, {box.x1, y});
  }
  canvas.Draw({kPanelInk, 0.16});
}

void DoorSign(Canvas& canvas, const Box& box) {
  const double r = box.height();
  canvas.Arc({box.x0 + 2.4, box.y1}, r, -1.5708, 0);
  canvas.Draw({kPanelInk, 0.16});
  canvas.Line({box.x0 + 2.4, box.y1}, {box.x0 + 2.4, box.y0});
  canvas.Draw({kPanelInk, 0.45});
}

void SlidingSign(Canvas& canvas, const Box& box) {
  const double y = box.centre().y;
  canvas.Line({box.x0, y - 1}, {box.x1, y - 1});
  canvas.Line({box.x0, y + 1}, {box.x1, y + 1});
  canvas.Draw({kPanelInk, 0.16});
  Frame(canvas, {box.x0, y - 0.35, box.centre().x, y + 0.35});
}

void PassageSign(Canvas& canvas, const Box& box) {
  for (double y : {box.y0 + 0.7, box.y1 - 0.7}) canvas.Line({box.x0, y}, {box.x1, y});
  canvas.Draw({kPanelInk, 0.18, 1, Dash::kDashed});
}

void SocketSignBox(Canvas& canvas, const Box& box) { DrawSocketSign(canvas, {box.centre().x, box.y0 + 0.2}, {0, 1}); }

void OverheadSign(Canvas& canvas, const Box& box) {
  canvas.Rectangle({box.x0 + 1, box.y0, box.x1 - 1, box.y1});
  canvas.Draw({kPanelInk, 0.2, 0.9, Dash::kDashed});
}

void FrontSign(Canvas& canvas, const Box& box) {
  Frame(canvas, {box.x0 + 1.5, box.y0, box.x1 - 1.5, box.y1});
  const double x = box.centre().x;
  const Point wedge[] = {{x - 0.8, box.y1 - 1.7}, {x + 0.8, box.y1 - 1.7}, {x, box.y1 - 0.5}};
  canvas.Polygon(wedge);
  canvas.Fill(kPanelInk);
}

// Those that are on the plan.
std::vector<Sign> SignsOf(const Plan& plan) {
  const auto any_opening = [&plan](auto holds) {
    return std::any_of(plan.openings.begin(), plan.openings.end(), holds);
  };
  std::vector<Sign> signs;
  if (any_opening([](const PlanOpening& o) { return !o.door; })) signs.push_back({"window, sill outside", WindowSign});
  if (any_opening([](const PlanOpening& o) {
        return o.door && (o.swing == v1::DOOR_SWING_INWARD || o.swing == v1::DOOR_SWING_OUTWARD);
      }))
    signs.push_back({"door and its swing", DoorSign});
  if (any_opening([](const PlanOpening& o) { return o.door && o.swing == v1::DOOR_SWING_SLIDING; }))
    signs.push_back({"sliding door", SlidingSign});
  if (any_opening([](const PlanOpening& o) { return o.door && o.swing == v1::DOOR_SWING_NONE; }))
    signs.push_back({"open passage", PassageSign});
  if (!plan.sockets.empty()) signs.push_back({"socket", SocketSignBox});
  if (std::any_of(plan.objects.begin(), plan.objects.end(),
                  [](const PlanObject& object) { return object.kind == v1::OBJECT_KIND_CEILING; }))
    signs.push_back({"hangs above", OverheadSign});
  if (std::any_of(plan.objects.begin(), plan.objects.end(),
                  [](const PlanObject& object) { return object.shown_as->front_mark(); }))
    signs.push_back({"front of a piece", FrontSign});
  return signs;
}

}  // namespace

double DrawSigns(Canvas& canvas, const Plan& plan, const Box& box, bool draw) {
  const std::vector<Sign> signs = SignsOf(plan);
  if (signs.empty()) return 0;
  const int columns = std::max(1, static_cast<int>(box.width() / 36));
  const double pitch = box.width() / columns;
  const int rows = (static_cast<int>(signs.size()) + columns - 1) / columns;
  if (draw) {
    const double y0 = Heading(canvas, "SIGNS", box.x0, box.y0);
    for (size_t i = 0; i < signs.size(); ++i) {
      const double x = box.x0 + static_cast<double>(i % columns) * pitch,
                   y = y0 + static_cast<double>(i / columns) * kRowMm;
      signs[i].draw(canvas, {x, y + 0.7, x + kSignMm, y + kRowMm - 1});
      const TextBlock words{signs[i].words, {.size_mm = 2.8, .colour = kPanelInk}, pitch - kSignMm - 3};
      DrawText(canvas, words, {x + kSignMm + 2, y + kRowMm / 2 - Measure(canvas, words).height / 2});
    }
  }
  return 5.2 + rows * kRowMm;
}

namespace {

constexpr double kLineMm = 5;

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
    const double height = std::max(kLineMm, Measure(canvas_, block).height + 1);
    if (draw_) {
      sign(Box{box_.x0, y_ + 0.8, box_.x0 + 9, y_ + kLineMm - 0.8});
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
    if (column.height() > most_mm - 3 * kLineMm && violated - index > 1) {
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
