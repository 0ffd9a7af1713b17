// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "renderer_worker/drawing/layers.h"
#include "renderer_worker/drawing/text.h"

namespace flair::renderer {
namespace {

constexpr double kSignRowMm = 5.2, kSignMm = 9;

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
  const auto any_opening = [&plan](auto holds) { return std::ranges::any_of(plan.openings, holds); };
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
  if (std::ranges::any_of(plan.objects,
                          [](const PlanObject& object) { return object.kind == v1::OBJECT_KIND_CEILING; }))
    signs.push_back({"hangs above", OverheadSign});
  if (std::ranges::any_of(plan.objects, [](const PlanObject& object) { return object.shown_as->front_mark(); }))
    signs.push_back({"front of a piece", FrontSign});
  return signs;
}

constexpr double kLineMm = 5;

int Count(const Plan& plan, v1::OutcomeStatus status) {
  return static_cast<int>(
      std::ranges::count_if(plan.edges, [status](const PlanEdge& edge) { return edge.status == status; }));
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

void DrawKeyRow(Canvas& canvas, const Plan& plan, int index, const Box& row, double size) {
  const PlanKey& key = plan.keys[index];
  const auto object = std::ranges::find(plan.objects, index, &PlanObject::key);
  const Ink ink = object != plan.objects.end() ? object->ink : Ink{Hex(0xE5E0D8), kPanelSoft};
  const double middle = (row.y0 + row.y1) / 2;
  if (key.number > 0) {
    DrawBadge(canvas, key.number, {row.x0 + 2.9, middle}, Mix(ink.fill, kWhite, 0.25), ink.line,
              std::min(1.0, 0.9 * row.height() / BadgeSize(1).height));
  } else {
    canvas.Rectangle({row.x0 + 1.2, middle - 1.7, row.x0 + 4.6, middle + 1.7}, 0.5);
    canvas.Fill(Mix(ink.fill, kWhite, 0.25), 1, true);
    canvas.Draw({ink.line, 0.2});
  }
  // Where columns are narrow, names are worth more than sizes.
  const TextBlock dims{row.width() < 55 ? "" : fmt::format("{:.2f} × {:.2f}", key.width_m, key.depth_m),
                       {.size_mm = 0.86 * size, .colour = kPanelSoft}};
  const Size dims_size = Measure(canvas, dims);
  DrawText(canvas, dims, {row.x1 - dims_size.width, middle - dims_size.height / 2});
  std::string name = key.name;
  if (key.count > 1) name += fmt::format("  ×{}", key.count);
  if (*Carrier(key) != 0) name += fmt::format("  ({})", Carrier(key));
  const TextBlock text{name, {.size_mm = size, .colour = kPanelInk}, row.width() - dims_size.width - 9};
  DrawText(canvas, text, {row.x0 + 7, middle - Measure(canvas, text).height / 2});
}

void DrawZoneRow(Canvas& canvas, const Plan& plan, int zone, const Box& row, double size) {
  const double y = row.y1 - 0.85 * size;
  const bool tinted = zone >= 0 && plan.layers.zones;
  if (tinted) {
    canvas.Rectangle({row.x0 + 1.2, y - 1.7, row.x0 + 4.6, y + 1.7}, 0.5);
    canvas.Fill(Mix(kWhite, plan.zones[zone].tint, 0.55), 1, true);
    canvas.Draw({LineColourFor(plan.zones[zone].tint), 0.18});
  }
  const TextBlock text{Capital(zone < 0 ? "whole room" : plan.zones[zone].name),
                       {.size_mm = size, .colour = kPanelInk, .bold = true},
                       row.width() - 8};
  DrawText(canvas, text, {row.x0 + (tinted ? 7 : 1.2), y - Measure(canvas, text).height / 2});
}

constexpr double kPitchMm = 5.5, kLeastPitchMm = 3.7;

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
                   y = y0 + static_cast<double>(i / columns) * kSignRowMm;
      signs[i].draw(canvas, {x, y + 0.7, x + kSignMm, y + kSignRowMm - 1});
      const TextBlock words{signs[i].words, {.size_mm = 2.8, .colour = kPanelInk}, pitch - kSignMm - 3};
      DrawText(canvas, words, {x + kSignMm + 2, y + kSignRowMm / 2 - Measure(canvas, words).height / 2});
    }
  }
  return 5.2 + rows * kSignRowMm;
}

double DrawOverlayLegend(Canvas& canvas, const Plan& plan, const Box& box, double most_mm, bool draw) {
  Column column(canvas, box, draw);
  if (plan.layers.circulation) ListWays(canvas, plan, column);
  if (plan.layers.constraints) ListConstraints(canvas, plan, most_mm, column);
  return column.height();
}

double LeastKeyHeight(const Plan& plan) { return 5.2 + kLeastPitchMm * static_cast<double>(RowsOf(plan).size() + 2); }

// The key in as many columns as the box is wide; shrinks, then ends with "and N more".
void DrawKey(Canvas& canvas, const Plan& plan, const Box& box) {
  const std::vector<Row> rows = RowsOf(plan);
  const double y0 = Heading(canvas, "KEY", box.x0, box.y0);
  const TextBlock unit{"width × depth, m", {.size_mm = 2.6, .colour = kPanelSoft}};
  DrawText(canvas, unit, {box.x1 - Measure(canvas, unit).width, box.y0 + 0.2});
  int columns = std::max(1, static_cast<int>(box.width() / 68));
  double pitch = kPitchMm;
  const auto fits = [&] {
    // Headings take more than a row.
    return rows.size() + 2 * columns <= static_cast<size_t>(std::max(0.0, (box.y1 - y0) / pitch)) * columns;
  };
  while (!fits() && pitch > kLeastPitchMm) pitch -= 0.25;
  if (!fits() && !rows.empty()) {
    columns *= 2;
    for (pitch = 4.6; !fits() && pitch > kLeastPitchMm;) pitch -= 0.25;
  }
  const double size = std::min(3.4, 0.68 * pitch);
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
        DrawText(canvas, {fmt::format("… and {} more", left), {.size_mm = 2.8, .colour = kPanelSoft}},
                 {box.x0, box.y1 - 0.5});
        return;
      }
      y = y0;
    }
    const double x = box.x0 + column * (width + 5);
    const double height = heading && y > y0 ? pitch + 1.2 : pitch;
    const Box row{x, y, x + width, y + height};
    heading ? DrawZoneRow(canvas, plan, rows[i].index, row, size) : DrawKeyRow(canvas, plan, rows[i].index, row, size);
    y += height;
  }
}

}  // namespace flair::renderer
