// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/drawing/labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

namespace flair::renderer {
namespace {

constexpr double kGapMm = 0.7;       // between two labels
constexpr double kPaddingMm = 0.8;   // between a label and its piece's outline
constexpr double kOutsideCost = 12;  // per corner of a zone's name beyond its zone
constexpr size_t kMostLabels = 600;
constexpr size_t kMostTried = 24;    // of a group
constexpr size_t kMostNumbered = 4;  // of a group, each by itself
constexpr double kNoLimit = std::numeric_limits<double>::infinity();

std::array<Point, 4> CornersOf(const Box& box) {
  return {{{box.x0, box.y0}, {box.x1, box.y0}, {box.x1, box.y1}, {box.x0, box.y1}}};
}

// A point of S in the item's own frame.
Point Local(const LabelItem& item, Point point) {
  const Point d = point - item.centre_mm;
  const double c = std::cos(item.theta_rad), s = std::sin(item.theta_rad);
  return {d.x * c - d.y * s, d.x * s + d.y * c};
}

Point FromLocal(const LabelItem& item, Point local) {
  const double c = std::cos(item.theta_rad), s = std::sin(item.theta_rad);
  return item.centre_mm + Point{local.x * c + local.y * s, -local.x * s + local.y * c};
}

bool LiesInside(const LabelItem& item, const Box& box, double padding) {
  const double w = item.half_width_mm - padding, d = item.half_depth_mm - padding;
  if (w <= 0 || d <= 0) return false;
  for (Point corner : CornersOf(box)) {
    const Point p = Local(item, corner);
    if (item.ellipse ? (p.x * p.x) / (w * w) + (p.y * p.y) / (d * d) > 1 : std::abs(p.x) > w || std::abs(p.y) > d)
      return false;
  }
  return true;
}

double OverlapArea(const Box& a, const Box& b) {
  const double w = std::min(a.x1, b.x1) - std::max(a.x0, b.x0), h = std::min(a.y1, b.y1) - std::max(a.y0, b.y0);
  return w > 0 && h > 0 ? w * h : 0;
}

class Placer {
 public:
  Placer(const std::vector<LabelItem>& items, const std::vector<LabelObstacle>& obstacles,
         const std::vector<Point>& floor, const std::vector<Box>& taken)
      : items_(items), obstacles_(obstacles), floor_(floor), taken_(taken) {}

  struct Best {
    double cost;
    bool found = false;
    Box box{};
  };

  // The cheapest place inside the item, at most `limit` dear.
  Best Inside(int item, Size size, double padding, double limit) const {
    const LabelItem& it = items_[item];
    constexpr int kSteps = 6;
    Best best{limit};
    for (int i = -kSteps; i <= kSteps; ++i) {
      for (int j = -kSteps; j <= kSteps; ++j) {
        const Point local{it.half_width_mm * i / kSteps, it.half_depth_mm * j / kSteps};
        const Box box = BoxAround(FromLocal(it, local), size);
        if (LiesInside(it, box, padding)) Consider(item, box, 0.25 * std::hypot(local.x, local.y), true, best);
      }
    }
    return best;
  }

  // The cheapest place around the item, within `ring_count` rings, at most `limit` dear.
  Best Around(int item, Size size, int ring_count, double limit) const {
    const LabelItem& it = items_[item];
    Best best{limit};
    for (int ring = 0; ring < ring_count; ++ring) {
      const double gap = 0.5 + 1.6 * ring + 0.12 * ring * ring;
      for (int i = 0; i < 24; ++i) {
        const double angle = 2 * std::numbers::pi * i / 24, c = std::cos(angle), s = std::sin(angle);
        // From the outline of the piece outwards in this direction, by as much as the label reaches back in it.
        const Point axis = Local(it, it.centre_mm + Point{c, s});
        const double edge = std::min(it.half_width_mm / std::max(std::abs(axis.x), 1e-6),
                                     it.half_depth_mm / std::max(std::abs(axis.y), 1e-6));
        const double reach =
            std::min(size.width / 2 / std::max(std::abs(c), 1e-6), size.height / 2 / std::max(std::abs(s), 1e-6));
        const Point centre = it.centre_mm + Point{c, s} * (edge + reach + gap);
        Consider(item, BoxAround(centre, size), 2.2 * gap + (i % 6 == 0 ? 0 : 0.4), false, best);
      }
      if (best.found && best.cost < 2.2 * gap) break;
    }
    return best;
  }

  // Labels the one of the group for which `way` finds the cheapest place.
  template <typename Way>
  bool Place(const std::vector<int>& group, int form, bool leader, const Way& way) {
    Best best{kNoLimit};
    int chosen = 0;
    for (const int item : group) {
      const Size size = form == kBadgeForm ? items_[item].badge_mm : items_[item].forms_mm[form];
      if (const Best here = way(item, size); here.found && here.cost < best.cost) best = here, chosen = item;
    }
    if (best.found) placed_.push_back({chosen, form, best.box, leader});
    return best.found;
  }

  std::vector<PlacedLabel> placed() && { return std::move(placed_); }

 private:
  // `owned`: the label may cover its own piece.
  void Consider(int item, const Box& box, double cost, bool owned, Best& best) const {
    if (cost >= best.cost) return;
    for (Point corner : CornersOf(box)) {
      if (!PolygonContains(floor_, corner)) return;
    }
    const LabelItem& it = items_[item];
    if (!it.region_mm.empty()) {
      if (!PolygonContains(it.region_mm, box.centre())) return;
      for (Point corner : CornersOf(box)) cost += PolygonContains(it.region_mm, corner) ? 0 : kOutsideCost;
    }
    for (const PlacedLabel& other : placed_) {
      if (other.box_mm.Overlaps(box.Grown(kGapMm))) return;
    }
    for (const Box& other : taken_) {
      if (other.Overlaps(box.Grown(kGapMm))) return;
    }
    for (const LabelObstacle& obstacle : obstacles_) {
      if (!owned || obstacle.owner != item) cost += it.shyness * obstacle.cost * OverlapArea(obstacle.box_mm, box);
    }
    if (cost < best.cost) best = {cost, true, box};
  }

  const std::vector<LabelItem>& items_;
  const std::vector<LabelObstacle>& obstacles_;
  const std::vector<Point>& floor_;
  const std::vector<Box>& taken_;
  std::vector<PlacedLabel> placed_;
};

using Group = std::vector<int>;  // items of which one gets the label

// Items by their groups, the largest first.
std::vector<Group> GroupsOf(const std::vector<LabelItem>& items) {
  std::vector<Group> groups;
  std::map<int, size_t> known;
  for (size_t i = 0; i < items.size(); ++i) {
    const int item = static_cast<int>(i);
    const auto [at, is_new] =
        items[i].group < 0 ? std::pair(known.end(), true) : known.try_emplace(items[i].group, groups.size());
    if (is_new) {
      groups.push_back({item});
    } else if (groups[at->second].size() < kMostTried) {
      groups[at->second].push_back(item);
    }
  }
  const auto area = [&items](const Group& group) {
    return items[group[0]].half_width_mm * items[group[0]].half_depth_mm;
  };
  std::ranges::stable_sort(groups, [&](const Group& a, const Group& b) { return area(a) > area(b); });
  if (groups.size() > kMostLabels) groups.resize(kMostLabels);
  return groups;
}

}  // namespace

std::vector<PlacedLabel> PlaceLabels(const std::vector<LabelItem>& items, const std::vector<LabelObstacle>& obstacles,
                                     const std::vector<Point>& floor_mm, const std::vector<Box>& taken) {
  Placer placer(items, obstacles, floor_mm, taken);
  const std::vector<Group> groups = GroupsOf(items);
  // Whether one of the forms finds a place that way.
  const auto any_form = [&](const Group& group, bool leader, const auto& way) {
    for (size_t form = 0; form < items[group[0]].forms_mm.size(); ++form) {
      if (placer.Place(group, static_cast<int>(form), leader, way)) return true;
    }
    return false;
  };
  const auto inside = [&placer](double padding, double limit) {
    return [&placer, padding, limit](int item, Size size) { return placer.Inside(item, size, padding, limit); };
  };
  const auto around = [&placer](int ring_count, double limit) {
    return [&placer, ring_count, limit](int item, Size size) { return placer.Around(item, size, ring_count, limit); };
  };
  // Names where they fit without covering anything, largest pieces first; then smallest pieces first.
  std::vector<Group> left;
  for (const Group& group : groups) {
    if (items[group[0]].only_inside || !any_form(group, false, inside(kPaddingMm, 15))) left.push_back(group);
  }
  std::ranges::reverse(left);
  for (const Group& group : left) {
    const LabelItem& first = items[group[0]];
    if (first.only_inside || (first.named_beside && any_form(group, true, around(4, 12)))) continue;
    // Of a few that look alike each carries the number: both lamps, not one of them.
    bool placed = false;
    for (size_t i = 0; i < group.size() && group.size() <= kMostNumbered; ++i) {
      const Group one = {group[i]};
      placed = placer.Place(one, kBadgeForm, false, inside(0.1, 8)) ||
               placer.Place(one, kBadgeForm, true, around(14, kNoLimit)) || placed;
    }
    if (!placed && !placer.Place(group, kBadgeForm, false, inside(0.1, 8))) {
      placer.Place(group, kBadgeForm, true, around(14, kNoLimit));
    }
  }
  for (const Group& group : left) {
    if (items[group[0]].only_inside) any_form(group, false, inside(0.5, 250));
  }
  return std::move(placer).placed();
}

}  // namespace flair::renderer
