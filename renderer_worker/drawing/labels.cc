// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/drawing/labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace flair::renderer {
namespace {

constexpr double kGapMm = 0.7;       // between two labels
constexpr double kPaddingMm = 0.8;   // between a label and its piece's outline
constexpr double kOutsideCost = 12;  // per corner of a zone's name beyond its zone
constexpr size_t kMostLabels = 600;

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

bool Inside(const LabelItem& item, const Box& box, double padding) {
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

  // The cheapest place for the form inside the item, at most `limit` dear.
  bool TryInside(int item, int form, Size size, double padding, double limit) {
    const LabelItem& it = items_[item];
    constexpr int kSteps = 6;
    Best best{limit};
    for (int i = -kSteps; i <= kSteps; ++i) {
      for (int j = -kSteps; j <= kSteps; ++j) {
        const Point local{it.half_width_mm * i / kSteps, it.half_depth_mm * j / kSteps};
        const Box box = BoxAround(FromLocal(it, local), size);
        if (!Inside(it, box, padding)) continue;
        Consider(item, box, 0.25 * std::hypot(local.x, local.y), best);
      }
    }
    return Take(item, form, best, false);
  }

  // The cheapest place around the item, with a leader unless it touches.
  bool TryAround(int item, Size size) {
    const LabelItem& it = items_[item];
    Best best{std::numeric_limits<double>::infinity()};
    const double reach = std::hypot(size.width, size.height) / 2;
    for (int ring = 0; ring < 14; ++ring) {
      const double gap = 0.5 + 1.6 * ring + 0.12 * ring * ring;
      for (int i = 0; i < 24; ++i) {
        const double angle = 2 * std::numbers::pi * i / 24, c = std::cos(angle), s = std::sin(angle);
        // From the outline of the piece outwards in this direction.
        const Point axis = Local(it, it.centre_mm + Point{c, s});
        const double edge = std::min(it.half_width_mm / std::max(std::abs(axis.x), 1e-6),
                                     it.half_depth_mm / std::max(std::abs(axis.y), 1e-6));
        const Point centre = it.centre_mm + Point{c, s} * (edge + 0.85 * reach + gap);
        Consider(item, BoxAround(centre, size), 2.2 * gap + (i % 6 == 0 ? 0 : 0.4), best);
      }
      if (best.found && best.cost < 2.2 * gap) break;
    }
    return Take(item, kBadgeForm, best, true);
  }

  std::vector<PlacedLabel> placed() && { return std::move(placed_); }

 private:
  struct Best {
    double cost;
    bool found = false;
    Box box{};
  };

  void Consider(int item, const Box& box, double cost, Best& best) const {
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
      if (obstacle.owner != item) cost += it.shyness * obstacle.cost * OverlapArea(obstacle.box_mm, box);
    }
    if (cost < best.cost) best = {cost, true, box};
  }

  bool Take(int item, int form, const Best& best, bool leader) {
    if (!best.found) return false;
    placed_.push_back({item, form, best.box, leader});
    return true;
  }

  const std::vector<LabelItem>& items_;
  const std::vector<LabelObstacle>& obstacles_;
  const std::vector<Point>& floor_;
  const std::vector<Box>& taken_;
  std::vector<PlacedLabel> placed_;
};

double Area(const LabelItem& item) { return item.half_width_mm * item.half_depth_mm; }

}  // namespace

std::vector<PlacedLabel> PlaceLabels(const std::vector<LabelItem>& items, const std::vector<LabelObstacle>& obstacles,
                                     const std::vector<Point>& floor_mm, const std::vector<Box>& taken) {
  Placer placer(items, obstacles, floor_mm, taken);
  std::vector<int> order;
  for (size_t i = 0; i < items.size(); ++i) order.push_back(static_cast<int>(i));
  std::stable_sort(order.begin(), order.end(), [&items](int a, int b) { return Area(items[a]) > Area(items[b]); });
  if (order.size() > kMostLabels) order.resize(kMostLabels);
  // Names where they fit without covering anything, largest pieces first; then numbers, smallest pieces first.
  std::vector<int> left;
  for (int i : order) {
    bool done = false;
    if (items[i].only_inside) {
      left.push_back(i);
      continue;
    }
    for (size_t form = 0; form < items[i].forms_mm.size() && !done; ++form) {
      done = placer.TryInside(i, static_cast<int>(form), items[i].forms_mm[form], kPaddingMm, 25);
    }
    if (!done) left.push_back(i);
  }
  std::reverse(left.begin(), left.end());
  for (int i : left) {
    if (items[i].only_inside) continue;
    const Size badge = items[i].badge_mm;
    if (placer.TryInside(i, kBadgeForm, badge, 0.1, 8)) continue;
    placer.TryAround(i, badge);
  }
  for (int i : left) {
    if (!items[i].only_inside) continue;
    for (size_t form = 0; form < items[i].forms_mm.size(); ++form) {
      if (placer.TryInside(i, static_cast<int>(form), items[i].forms_mm[form], 0.5, 250)) break;
    }
  }
  return std::move(placer).placed();
}

}  // namespace flair::renderer
