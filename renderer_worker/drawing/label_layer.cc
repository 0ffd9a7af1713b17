// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "absl/strings/str_split.h"
#include "renderer_worker/drawing/layers.h"
#include "renderer_worker/drawing/text.h"

namespace flair::renderer {
namespace {

constexpr double kBadgeMm = 4.5;

// A name on that many lines, as short as they can be; empty when it has fewer words.
std::vector<std::string> Wrapped(const std::string& name, size_t count) {
  const std::vector<std::string> words = absl::StrSplit(name, ' ', absl::SkipEmpty());
  if (words.size() < count || words.size() > 12) return {};
  for (size_t width = 1;; ++width) {
    std::vector<std::string> lines;
    for (const std::string& word : words) {
      if (lines.empty() || lines.back().size() + 1 + word.size() > width) {
        lines.push_back(word);
      } else {
        lines.back() += ' ' + word;
      }
    }
    if (lines.size() <= count) return lines.size() == count ? lines : std::vector<std::string>();
  }
}

using Form = std::vector<std::string>;  // its lines

class LabelLayer {
 public:
  LabelLayer(Canvas& canvas, const Plan& plan, const Sheet& sheet) : canvas_(canvas), plan_(plan), sheet_(sheet) {
    for (Point vertex : plan.floor) floor_mm_.push_back(sheet.ToSheet(vertex));
    for (const PlanObject& object : plan.objects) AddObject(object);
    if (plan.layers.zones) {
      for (const PlanZone& zone : plan.zones) AddArea(zone.name, zone.parts, LineColourFor(zone.tint));
    }
    const auto has_floor = [](const PlanZone& zone) { return !zone.parts.empty(); };
    if (!plan.layers.zones || std::ranges::count_if(plan.zones, has_floor) < 2) {
      for (LabelItem& item : items_) item.forms_mm.resize(item.only_inside ? 0 : item.forms_mm.size());
      AddArea(plan.room_type, {plan.floor}, Hex(0x4A4641));
    }
    for (const PlanOpening& opening : plan.openings) AddDoor(opening);
    for (const Clearance& clearance : ShownClearances(plan, sheet)) {
      taken_.push_back(ClearanceTextBox(canvas, sheet, clearance));
      // In pieces: the box of a slanted line would be all paper.
      const Point from = sheet.ToSheet(clearance.from_m), along = sheet.ToSheet(clearance.to_m) - from;
      const int pieces = 1 + static_cast<int>(std::hypot(along.x, along.y) / 4);
      for (int i = 0; i < pieces; ++i) {
        Box piece;
        for (int end : {i, i + 1}) piece.Include(from + along * (static_cast<double>(end) / pieces));
        obstacles_.push_back({piece.Grown(0.4), 1, -1});
      }
    }
  }

  std::vector<PlacedLabel> Place() const { return PlaceLabels(items_, obstacles_, floor_mm_, taken_); }

  const Form& FormOf(const PlacedLabel& label) const { return forms_[label.item][label.form]; }

  // Numbers run through the key without gaps: `number_of_key` is 0 for what has its name in the drawing.
  std::vector<PlacedLabel> Draw(std::vector<int>& number_of_key) {
    std::vector<PlacedLabel> placed = Place();
    number_of_key.assign(plan_.keys.size(), 0);
    for (const PlacedLabel& label : placed) {
      if (label.form == kBadgeForm && label.item < static_cast<int>(plan_.objects.size()))
        number_of_key[plan_.objects[label.item].key] = 1;
    }
    int last = 0;
    for (int& number : number_of_key) number = number > 0 ? ++last : 0;
    numbers_ = number_of_key;
    for (const PlacedLabel& label : placed) DrawLeader(canvas_, label, items_[label.item]);
    for (const PlacedLabel& label : placed) DrawOne(label);
    return placed;
  }

 private:
  static constexpr double kLineMm = 3.9;

  TextStyle NameStyle() const { return {.size_mm = kNameSizeMm, .colour = Hex(0x2B2926)}; }
  static TextStyle AreaStyle(const Rgb& colour) {
    return {.size_mm = 3.1, .colour = colour, .bold = true, .tracking = 0.14};
  }
  static TextStyle NumberStyle() { return {.size_mm = 2.9, .colour = Hex(0x4A4641)}; }

  void AddObject(const PlanObject& object) {
    LabelItem item = LabelItemOf(object, sheet_);
    item.badge_mm = BadgeSize(object.key + 1);
    item.group = object.key;
    if (object.walk_over) item.shyness = 10;
    const bool floor_piece = object.kind == v1::OBJECT_KIND_FLOOR && !object.name.empty();
    item.named_beside = floor_piece && !object.walk_over && object.name.size() < 40;
    std::vector<Form> forms;
    if (floor_piece) {
      const int count = plan_.keys[object.key].count;
      const std::string name = count > 1 ? fmt::format("{} × {}", count, object.name) : object.name;
      forms.push_back({name});
      for (const size_t lines : {2, 3}) {
        if (Form form = Wrapped(name, lines); !form.empty()) forms.push_back(std::move(form));
      }
    }
    for (const Form& form : forms) item.forms_mm.push_back(SizeOf(form));
    obstacles_.push_back(LabelObstacleOf(object, sheet_, static_cast<int>(items_.size())));
    items_.push_back(std::move(item));
    forms_.push_back(std::move(forms));
  }

  // The name of a zone or of the room with its area.
  void AddArea(const std::string& name, const std::vector<std::vector<Point>>& parts, const Rgb& colour) {
    LabelItem item;
    item.only_inside = true;
    std::vector<Point> corners;
    double area_m2 = 0;
    for (const std::vector<Point>& part : parts) {
      for (size_t i = 0; i < part.size(); ++i) {
        corners.push_back(sheet_.ToSheet(part[i]));
        area_m2 += Cross(part[i], part[(i + 1) % part.size()]) / 2;
      }
    }
    areas_.push_back({Upper(name), fmt::format("{:.1f} m²", area_m2), colour});
    if (parts.size() == 1) item.region_mm = corners;
    item.shyness = 10;
    const Box box = BoundsOf(corners);
    item.centre_mm = box.empty() ? Point{} : box.centre();
    item.half_width_mm = box.empty() ? 0 : box.width() / 2;
    item.half_depth_mm = box.empty() ? 0 : box.height() / 2;
    if (!box.empty()) {
      const Size title = Measure(canvas_, {areas_.back().name, AreaStyle(colour)}),
                 number = Measure(canvas_, {areas_.back().area, NumberStyle()});
      item.forms_mm.push_back({std::max(title.width, number.width), title.height + number.height});
    }
    items_.push_back(std::move(item));
  }

  void AddDoor(const PlanOpening& opening) {
    if (!opening.door || opening.swing != v1::DOOR_SWING_INWARD) return;
    const DoorLeafGeometry leaf = LeafOf(plan_, opening);
    const Point corners[] = {sheet_.ToSheet(leaf.hinge_m), sheet_.ToSheet(leaf.open_end_m),
                             sheet_.ToSheet(leaf.closed_end_m)};
    obstacles_.push_back({BoundsOf(corners), 0.35, -1});
  }

  static std::string Upper(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
    return text;
  }

  Size SizeOf(const Form& form) const {
    double width = 0;
    for (const std::string& line : form) width = std::max(width, Measure(canvas_, {line, NameStyle()}).width);
    return {width + 0.6, kLineMm * static_cast<double>(form.size())};
  }

  void DrawOne(const PlacedLabel& label) {
    const Point centre = label.box_mm.centre();
    if (label.item >= static_cast<int>(plan_.objects.size())) {
      const Area& area = areas_[label.item - plan_.objects.size()];
      const double title = Measure(canvas_, {area.name, AreaStyle(area.colour)}).height;
      DrawTextAt(canvas_, {area.name, AreaStyle(area.colour)}, {centre.x, label.box_mm.y0 + title / 2}, 0,
                 &plan_.floor_tint);
      DrawTextAt(canvas_, {area.area, NumberStyle()}, {centre.x, (label.box_mm.y0 + title + label.box_mm.y1) / 2}, 0,
                 &plan_.floor_tint);
      return;
    }
    const PlanObject& object = plan_.objects[label.item];
    const Rgb fill = Mix(object.ink.fill, kWhite, 0.82);
    if (label.form == kBadgeForm) {
      DrawBadge(canvas_, numbers_[object.key], centre, fill, object.ink.line);
      return;
    }
    // Its halo hides the lines of the piece below the name.
    const Form& form = FormOf(label);
    const Rgb halo = label.leader ? plan_.floor_tint : Mix(object.ink.fill, kWhite, 0.6);
    double y = centre.y - kLineMm * (static_cast<double>(form.size()) - 1) / 2;
    for (const std::string& line : form) {
      DrawTextAt(canvas_, {line, NameStyle()}, {centre.x, y}, 0, &halo);
      y += kLineMm;
    }
  }

  struct Area {
    std::string name, area;
    Rgb colour;
  };

  Canvas& canvas_;
  const Plan& plan_;
  const Sheet& sheet_;
  std::vector<Point> floor_mm_;
  std::vector<LabelItem> items_;  // objects, then areas
  std::vector<Area> areas_;
  std::vector<std::vector<Form>> forms_;
  std::vector<LabelObstacle> obstacles_;
  std::vector<Box> taken_;    // by the numbers of clearances
  std::vector<int> numbers_;  // of keys
};

}  // namespace

LabelItem LabelItemOf(const PlanObject& object, const Sheet& sheet) {
  LabelItem item;
  item.centre_mm = sheet.ToSheet(object.centre_m);
  item.theta_rad = object.theta_rad;
  item.half_width_mm = object.width_m / 2 * sheet.mm_per_m();
  item.half_depth_mm = object.depth_m / 2 * sheet.mm_per_m();
  item.ellipse = object.shown_as->outline() == FurnitureClass::ELLIPSE;
  return item;
}

// Small things should stay visible; large ones may carry the numbers of what stands near them.
LabelObstacle LabelObstacleOf(const PlanObject& object, const Sheet& sheet, int owner) {
  std::vector<Point> corners;
  for (Point corner : object.Corners()) corners.push_back(sheet.ToSheet(corner));
  const Box box = BoundsOf(corners);
  const double cost = object.walk_over ? 0.02
                      : object.kind == v1::OBJECT_KIND_CEILING
                          ? 0.15
                          : std::clamp(140 / std::max(box.width() * box.height(), 1.0), 0.12, 4.0);
  return {box, cost, owner};
}

void DrawLeader(Canvas& canvas, const PlacedLabel& label, const LabelItem& item) {
  if (!label.leader) return;
  // From the label's border to a little within the piece's.
  const Box& box = label.box_mm;
  const Point from{std::clamp(item.centre_mm.x, box.x0, box.x1), std::clamp(item.centre_mm.y, box.y0, box.y1)};
  const Point way = from - item.centre_mm;
  const double length = std::hypot(way.x, way.y), c = std::cos(item.theta_rad), s = std::sin(item.theta_rad);
  const Point axis{std::abs(way.x * c - way.y * s), std::abs(way.x * s + way.y * c)};
  const double edge =
      std::min({item.half_width_mm / std::max(axis.x, 1e-6), item.half_depth_mm / std::max(axis.y, 1e-6), 1.0});
  const Point target = item.centre_mm + way * std::max(0.0, edge - 1.5 / std::max(length, 1e-6));
  canvas.Line(from, target);
  canvas.Draw({kWhite, 0.7, 0.8}, true);
  canvas.Draw({Hex(0x4A4641), 0.16});
  canvas.Ellipse(target, 0.42, 0.42);
  canvas.Fill(Hex(0x4A4641));
}

Size BadgeSize(int number) { return {number > 99 ? 1.7 * kBadgeMm : number > 9 ? 1.2 * kBadgeMm : kBadgeMm, kBadgeMm}; }

void DrawBadge(Canvas& canvas, int number, Point centre_mm, const Rgb& fill, const Rgb& line, double factor) {
  const Size size = BadgeSize(number);
  canvas.Rectangle(BoxAround(centre_mm, {size.width * factor, size.height * factor}), kBadgeMm / 2);
  canvas.Fill(fill, 1, true);
  canvas.Draw({line, 0.2});
  DrawTextAt(canvas, {fmt::format("{}", number), {.size_mm = 2.9 * factor, .colour = Hex(0x26231F), .bold = true}},
             centre_mm);
}

std::vector<PlacedLabel> DrawLabels(Canvas& canvas, const Sheet& sheet, Plan& plan) {
  std::vector<int> numbers;
  std::vector<PlacedLabel> placed = LabelLayer(canvas, plan, sheet).Draw(numbers);
  for (size_t i = 0; i < numbers.size(); ++i) plan.keys[i].number = numbers[i];
  return placed;
}

std::vector<NameOnPiece> NamesOnPieces(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  const LabelLayer layer(canvas, plan, sheet);
  std::vector<NameOnPiece> names;
  for (const PlacedLabel& label : layer.Place()) {
    if (label.item >= static_cast<int>(plan.objects.size()) || label.form == kBadgeForm || label.leader) continue;
    names.push_back({label.item, layer.FormOf(label), label.box_mm.centre()});
  }
  return names;
}

}  // namespace flair::renderer
