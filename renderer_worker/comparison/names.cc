// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/comparison/names.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "renderer_worker/comparison/marks.h"
#include "renderer_worker/drawing/labels.h"
#include "renderer_worker/drawing/layers.h"
#include "renderer_worker/drawing/text.h"

namespace flair::renderer {
namespace {

const Rgb kInk = Hex(0x2B2926);

TextBlock NameOf(const PlanObject& object) { return {object.name, {.size_mm = 2.9, .colour = kInk}}; }

LabelItem ItemAt(const PlanObject& object, const Sheet& sheet) {
  LabelItem item;
  item.centre_mm = sheet.ToSheet(object.centre_m);
  item.theta_rad = object.theta_rad;
  item.half_width_mm = object.width_m / 2 * sheet.mm_per_m();
  item.half_depth_mm = object.depth_m / 2 * sheet.mm_per_m();
  item.ellipse = object.symbol->outline == Outline::kEllipse;
  return item;
}

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
    for (const PlacedLabel& label : placed) {
      if (!label.leader) continue;
      canvas_.Line(label.box_mm.centre(), items_[label.item].centre_mm);
      canvas_.Draw({kWhite, 0.7, 0.8}, true);
      canvas_.Draw({kInk, 0.16});
    }
    for (const PlacedLabel& label : placed) DrawOne(label);
  }

 private:
  void AddChange(const PlanChange& change) {
    const std::optional<PlanObject>& object = change.after.has_value() ? change.after : change.before;
    if (!object.has_value()) return;
    LabelItem item = ItemAt(*object, sheet_);
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
    LabelItem item = ItemAt(object, sheet_);
    item.only_inside = true;
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
    std::vector<Point> corners;
    for (const Point corner : object.Corners()) corners.push_back(sheet_.ToSheet(corner));
    const Box box = BoundsOf(corners);
    const double cost = object.walk_over ? 0.02 : std::clamp(60 / std::max(box.width() * box.height(), 1.0), 0.12, 2.0);
    obstacles_.push_back({box, cost, static_cast<int>(items_.size())});
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

void DrawNames(Canvas& canvas, const ComparisonPanel& panel, const Sheet& sheet) { Names(canvas, panel, sheet).Draw(); }

void DrawChangeNumber(Canvas& canvas, const PlanChange& change, Point centre_mm) {
  const Rgb colour = ColourOf(change.kind);
  DrawBadge(canvas, change.number, centre_mm, Mix(colour, kWhite, 0.86), colour);
}

}  // namespace flair::renderer
