// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "renderer_worker/comparison/draw_comparison.h"
#include "renderer_worker/drawing/labels.h"
#include "renderer_worker/drawing/layers.h"
#include "renderer_worker/drawing/text.h"

namespace flair::renderer {
namespace {

constexpr double kLeastArrowMm = 3;
constexpr double kLeastTurnRad = 0.087;

// The outline of an object in the frame of the sheet.
void TraceOutline(Canvas& canvas, const PlanObject& object, const Sheet& sheet) {
  canvas.EnterFrame(sheet.ToSheet(object.centre_m), sheet.mm_per_m(), object.theta_rad, true);
  const double w = object.width_m / 2, d = object.depth_m / 2;
  // Long ellipses are the shadows of things with corners.
  const bool is_round = object.shown_as->outline() == FurnitureClass::ELLIPSE && std::max(w, d) < 1.3 * std::min(w, d);
  if (is_round) {
    canvas.Ellipse({0, 0}, w, d);
  } else {
    canvas.Rectangle({-w, -d, w, d},
                     object.shown_as->outline() == FurnitureClass::ROUNDED ? 0.12 * std::min(w, d) : 0.01);
  }
  canvas.LeaveFrame();
}

void DrawNow(Canvas& canvas, const PlanObject& object, const Sheet& sheet, const Rgb& colour) {
  TraceOutline(canvas, object, sheet);
  canvas.Fill(colour, 0.14, true);
  canvas.Draw({kWhite, 1.3, 0.9}, true);
  canvas.Draw({colour, 0.7});
}

void DrawGhost(Canvas& canvas, const PlanObject& object, const Sheet& sheet, const Rgb& colour) {
  TraceOutline(canvas, object, sheet);
  canvas.Draw({kWhite, 1.0, 0.8}, true);
  canvas.Draw({colour, 0.4, 1, Dash::kDashed});
  // Where its front was, so that a turn can be seen.
  canvas.EnterFrame(sheet.ToSheet(object.centre_m), sheet.mm_per_m(), object.theta_rad, true);
  const double size = 1.4 / sheet.mm_per_m(), front = object.depth_m / 2;
  const Point wedge[] = {{-size, front - size}, {size, front - size}, {0, front}};
  canvas.Polygon(wedge);
  canvas.Fill(colour, 0.8);
  canvas.LeaveFrame();
}

void DrawCross(Canvas& canvas, const PlanObject& object, const Sheet& sheet, const Rgb& colour) {
  const std::vector<Point> corners = object.Corners();
  canvas.Line(sheet.ToSheet(corners[0]), sheet.ToSheet(corners[2]));
  canvas.Line(sheet.ToSheet(corners[1]), sheet.ToSheet(corners[3]));
  canvas.Draw({colour, 0.25, 0.8});
}

void DrawHead(Canvas& canvas, Point tip, Point along, const Rgb& colour) {
  constexpr double kLengthMm = 2.6, kHalfMm = 1.05;
  const Point side{-along.y, along.x}, back = tip - along * kLengthMm;
  const Point head[] = {tip, back + side * kHalfMm, back - side * kHalfMm};
  canvas.Polygon(head);
  canvas.Draw({kWhite, 0.8, 0.9}, true);
  canvas.Fill(colour);
}

void DrawArrow(Canvas& canvas, Point from, Point to, const Rgb& colour) {
  const Point way = to - from;
  const double length = std::hypot(way.x, way.y);
  if (length < kLeastArrowMm) return;
  const Point along = way * (1 / length);
  canvas.Line(from, to - along * 2);
  canvas.Draw({kWhite, 1.2, 0.9}, true);
  canvas.Draw({colour, 0.5});
  canvas.Ellipse(from, 0.7, 0.7);
  canvas.Fill(colour);
  DrawHead(canvas, to, along, colour);
}

// Part of a circle with a head, for what turned on the spot.
void DrawTurn(Canvas& canvas, const PlanObject& before, const PlanObject& after, const Sheet& sheet,
              const Rgb& colour) {
  const double turn = std::remainder(after.theta_rad - before.theta_rad, 2 * std::numbers::pi);
  if (std::abs(turn) < kLeastTurnRad) return;
  const double radius = std::max(2.6, 0.32 * std::min(after.width_m, after.depth_m) * sheet.mm_per_m());
  const Point centre = sheet.ToSheet(after.centre_m);
  // In S angles grow clockwise; a heading of 0 points up the sheet.
  const double from = -std::numbers::pi / 2 - before.theta_rad, to = from - turn;
  canvas.Arc(centre, radius, std::min(from, to), std::max(from, to));
  canvas.Draw({kWhite, 1.2, 0.9}, true);
  canvas.Draw({colour, 0.5});
  const double sense = turn > 0 ? -1 : 1;
  DrawHead(canvas, centre + Point{std::cos(to), std::sin(to)} * radius, Point{-std::sin(to), std::cos(to)} * sense,
           colour);
}

void DrawRemoved(Canvas& canvas, const PlanObject& object, const Sheet& sheet) {
  const Rgb colour = ColourOf(ChangeKind::kRemoved);
  TraceOutline(canvas, object, sheet);
  canvas.Fill(colour, 0.07, true);
  canvas.Draw({kWhite, 1.1, 0.8}, true);
  canvas.Draw({colour, 0.5, 1, Dash::kDashed});
  DrawCross(canvas, object, sheet, colour);
}

const Rgb kInk = Hex(0x2B2926);

TextBlock NameOf(const PlanObject& object) { return {object.name, {.size_mm = 2.9, .colour = kInk}}; }

class Names {
 public:
  Names(Canvas& canvas, const ComparisonPanel& panel, const Sheet& sheet) : canvas_(canvas), sheet_(sheet) {
    for (const Point vertex : panel.plan.floor) floor_mm_.push_back(sheet.ToSheet(vertex));
    for (const PlanChange& change : panel.changes) {
      AddChange(change);
      AddArrow(change);
    }
    for (const PlanChange& change : panel.removed) AddChange(change);
    for (const PlanObject& object : panel.plan.objects) AddName(object);
  }

  void Draw() {
    const std::vector<PlacedLabel> placed = PlaceLabels(items_, obstacles_, floor_mm_);
    for (const PlacedLabel& label : placed) DrawLeader(canvas_, label, items_[label.item]);
    for (const PlacedLabel& label : placed) DrawOne(label);
  }

 private:
  void AddChange(const PlanChange& change) {
    const std::optional<PlanObject>& object = change.after.has_value() ? change.after : change.before;
    if (!object.has_value()) return;
    LabelItem item = LabelItemOf(*object, sheet_);
    item.badge_mm = BadgeSize(change.number);
    changed_.insert(object->id);
    Add(std::move(item), *object, {&change, nullptr});
  }

  // Numbers stay clear of arrows: in pieces, for the box of a slanted one would be all paper.
  void AddArrow(const PlanChange& change) {
    if (!change.before.has_value() || !change.after.has_value()) return;
    const Point from = sheet_.ToSheet(change.before->centre_m), along = sheet_.ToSheet(change.after->centre_m) - from;
    const int pieces = 1 + static_cast<int>(std::hypot(along.x, along.y) / 3);
    for (int i = 0; i < pieces; ++i) {
      Box piece;
      for (const int end : {i, i + 1}) piece.Include(from + along * (static_cast<double>(end) / pieces));
      obstacles_.push_back({piece.Grown(1.2), 6, -1});
    }
  }

  void AddName(const PlanObject& object) {
    if (changed_.contains(object.id) || object.kind == v1::OBJECT_KIND_CEILING) return;
    LabelItem item = LabelItemOf(object, sheet_);
    item.only_inside = true;
    item.group = object.key;
    if (object.kind == v1::OBJECT_KIND_FLOOR) item.forms_mm = {Measure(canvas_, NameOf(object))};
    // A rug's name would be hidden by what stands on it.
    if (object.walk_over) item.forms_mm.clear();
    Add(std::move(item), object, {nullptr, &object});
  }

  struct Meaning {
    const PlanChange* change = nullptr;
    const PlanObject* object = nullptr;
  };
  void Add(LabelItem item, const PlanObject& object, Meaning meaning) {
    obstacles_.push_back(LabelObstacleOf(object, sheet_, static_cast<int>(items_.size())));
    items_.push_back(std::move(item));
    meanings_.push_back(meaning);
  }

  void DrawOne(const PlacedLabel& label) {
    const auto& [change, object] = meanings_[label.item];
    const Point centre = label.box_mm.centre();
    if (change != nullptr) return DrawChangeNumber(canvas_, *change, centre);
    if (label.form == kBadgeForm) return;
    canvas_.Rectangle(label.box_mm.Grown(0.3), 1);
    canvas_.Fill(Mix(object->ink.fill, kWhite, 0.72), 0.85);
    DrawTextAt(canvas_, NameOf(*object), centre);
  }

  Canvas& canvas_;
  const Sheet& sheet_;
  std::vector<Point> floor_mm_;
  std::vector<LabelItem> items_;
  std::vector<Meaning> meanings_;
  std::vector<LabelObstacle> obstacles_;
  std::set<std::string> changed_;
};

}  // namespace

Rgb ColourOf(ChangeKind kind) {
  constexpr unsigned kColours[] = {0x1F66B0, 0x8A3FA0, 0x2E8B4F, 0xC62F26};
  return Hex(kColours[static_cast<int>(kind)]);
}

void DrawMarks(Canvas& canvas, const ComparisonPanel& panel, const Sheet& sheet) {
  // In another room there may be no floor where it was.
  const auto has_floor = [&panel](const std::optional<PlanObject>& object) {
    return object.has_value() && PolygonContains(panel.plan.floor, object->centre_m);
  };
  for (const PlanChange& change : panel.removed) {
    if (change.before.has_value()) DrawRemoved(canvas, *change.before, sheet);
  }
  for (const PlanChange& change : panel.changes) {
    if (change.kind == ChangeKind::kRemoved) {
      if (has_floor(change.before)) DrawRemoved(canvas, *change.before, sheet);
    } else if (change.kind != ChangeKind::kAdded && change.after.has_value() && has_floor(change.before)) {
      DrawGhost(canvas, *change.before, sheet, ColourOf(change.kind));
    }
  }
  for (const PlanChange& change : panel.changes) {
    if (change.after.has_value()) DrawNow(canvas, *change.after, sheet, ColourOf(change.kind));
  }
  for (const PlanChange& change : panel.changes) {
    if (!change.after.has_value() || !has_floor(change.before)) continue;
    const Point from = sheet.ToSheet(change.before->centre_m), to = sheet.ToSheet(change.after->centre_m);
    const bool is_far = std::hypot(to.x - from.x, to.y - from.y) >= kLeastArrowMm;
    if (is_far) DrawArrow(canvas, from, to, ColourOf(change.kind));
    if (!is_far) DrawTurn(canvas, *change.before, *change.after, sheet, ColourOf(change.kind));
  }
}

void DrawMarkSign(Canvas& canvas, ChangeKind kind, const Box& box) {
  const Rgb colour = ColourOf(kind);
  const bool has_ghost = kind == ChangeKind::kMoved || kind == ChangeKind::kResized;
  const Box now = kind == ChangeKind::kMoved ? Box{box.x1 - 4, box.y0, box.x1, box.y1}
                                             : Box{box.x0 + 2, box.y0, box.x1 - 2, box.y1};
  const Box was = kind == ChangeKind::kMoved ? Box{box.x0, box.y0, box.x0 + 4, box.y1} : now.Grown(-0.9);
  if (has_ghost) {
    canvas.Rectangle(was);
    canvas.Draw({colour, 0.3, 1, Dash::kDashed});
  }
  canvas.Rectangle(now);
  if (kind == ChangeKind::kRemoved) {
    canvas.Draw({colour, 0.4, 1, Dash::kDashed});
    return;
  }
  canvas.Fill(colour, 0.14, true);
  canvas.Draw({colour, 0.6});
  if (kind == ChangeKind::kMoved) DrawArrow(canvas, was.centre(), now.centre(), colour);
}

void DrawNames(Canvas& canvas, const ComparisonPanel& panel, const Sheet& sheet) { Names(canvas, panel, sheet).Draw(); }

void DrawChangeNumber(Canvas& canvas, const PlanChange& change, Point centre_mm) {
  const Rgb colour = ColourOf(change.kind);
  DrawBadge(canvas, change.number, centre_mm, Mix(colour, kWhite, 0.86), colour);
}

}  // namespace flair::renderer
