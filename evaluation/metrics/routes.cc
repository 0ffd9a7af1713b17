// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

#include "evaluation/metrics/walk_grid.h"
#include "room/geometry/polygon.h"
#include "room/scene/room.h"

namespace flair::evaluation {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr int kNone = -1;

// Lengths of the shortest ways from the doors to all reached cells.
class Ways {
 public:
  Ways(const LayoutView& view, const WalkGrid& grid)
      : grid_(grid),
        length_m_(static_cast<size_t>(grid.columns()) * static_cast<size_t>(grid.rows()), kFar),
        before_(length_m_.size(), kNone) {
    for (const Opening& door : view.scene.room.openings) {
      if (door.kind == OpeningKind::kDoor) Enter(view.scene.room, door);
    }
    Spread();
  }

  size_t IndexOf(int column, int row) const {
    return static_cast<size_t>(row) * static_cast<size_t>(grid_.columns()) + static_cast<size_t>(column);
  }
  double LengthTo_m(size_t cell) const { return length_m_[cell]; }

  // The way to the cell, taut.
  std::vector<Vec2<double>> To(size_t cell) const {
    std::vector<size_t> cells{cell};
    while (before_[cells.back()] >= 0) cells.push_back(static_cast<size_t>(before_[cells.back()]));
    std::ranges::reverse(cells);
    std::vector<Vec2<double>> points{doors_[static_cast<size_t>(kNone - 1 - before_[cells.front()])],
                                     Center(cells.front())};
    for (size_t at = 0; at + 1 < cells.size();) {
      at = Furthest(cells, at);
      points.push_back(Center(cells[at]));
    }
    return points;
  }

 private:
  Vec2<double> Center(size_t cell) const {
    return grid_.CenterOf(static_cast<int>(cell) % grid_.columns(), static_cast<int>(cell) / grid_.columns());
  }

  // A cell far along the way that is seen from the one at `at`: strides double while it is, then halve. Ways have
  // hundreds of cells and few corners.
  size_t Furthest(const std::vector<size_t>& cells, size_t at) const {
    size_t seen = at + 1, stride = 1;
    while (seen + stride < cells.size() && Sees(cells[at], cells[seen + stride])) {
      seen += stride;
      stride *= 2;
    }
    for (; stride > 0; stride /= 2) {
      if (seen + stride < cells.size() && Sees(cells[at], cells[seen + stride])) seen += stride;
    }
    return seen;
  }

  void Enter(const Room& room, const Opening& door) {
    const Vec2<double> middle = room.walls[static_cast<size_t>(door.wall)].PointAt(door.offset_m + door.width_m / 2);
    doors_.push_back(middle);
    const int mark = kNone - static_cast<int>(doors_.size());
    const Polygon landing = PassageArea(room, door, kLanding_m);
    grid_.ForReached(landing.vertices, [&](int column, int row, const Vec2<double>& p) {
      const size_t cell = IndexOf(column, row);
      const double length_m = Norm(p - middle);
      if (!Contains(landing, p) || length_m >= length_m_[cell]) return;
      length_m_[cell] = length_m;
      before_[cell] = mark;
      open_.push({length_m, cell});
    });
  }

  void Spread() {
    const int columns = grid_.columns(), rows = grid_.rows();
    const double step_m = grid_.cell_m();
    while (!open_.empty()) {
      const auto [length_m, cell] = open_.top();
      open_.pop();
      if (length_m > length_m_[cell]) continue;
      const int column = static_cast<int>(cell) % columns, row = static_cast<int>(cell) / columns;
      for (int dr = -1; dr <= 1; ++dr) {
        for (int dc = -1; dc <= 1; ++dc) {
          const int c = column + dc, r = row + dr;
          if ((dc == 0 && dr == 0) || c < 0 || r < 0 || c >= columns || r >= rows) continue;
          const size_t next = IndexOf(c, r);
          const double there_m = length_m + step_m * (dc != 0 && dr != 0 ? std::numbers::sqrt2 : 1);
          if (!grid_.IsReached(c, r) || there_m >= length_m_[next] - 1e-9) continue;
          length_m_[next] = there_m;
          before_[next] = static_cast<int>(cell);
          open_.push({there_m, next});
        }
      }
    }
  }

  // Whether the straight way between two cells stays on reached ones.
  bool Sees(size_t from, size_t to) const {
    const int columns = grid_.columns();
    const int c0 = static_cast<int>(from) % columns, r0 = static_cast<int>(from) / columns;
    const int dc = static_cast<int>(to) % columns - c0, dr = static_cast<int>(to) / columns - r0;
    const int steps = 2 * std::max(std::abs(dc), std::abs(dr));
    for (int i = 1; i < steps; ++i) {
      // Rounded half up, in whole numbers.
      const int c = c0 + static_cast<int>(std::floor((2.0 * dc * i + steps) / (2.0 * steps)));
      const int r = r0 + static_cast<int>(std::floor((2.0 * dr * i + steps) / (2.0 * steps)));
      if (!grid_.IsReached(c, r)) return false;
    }
    return true;
  }

  using Entry = std::pair<double, size_t>;
  const WalkGrid& grid_;
  std::vector<double> length_m_;
  // The cell before on the way; below kNone: the door that the way starts at.
  std::vector<int> before_;
  std::vector<Vec2<double>> doors_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

// Where one stands at the object: near the way and near the middle of its front, in the strip before it; kNone when
// nobody can.
int StandingPlace(const LayoutView& view, size_t object, const WalkGrid& grid, const Ways& ways) {
  const Footprint& footprint = view.scene.objects[object].footprint;
  const SideEdge<double> edge = EdgeOf(footprint, view.layout[object], Side::kFront);
  const Vec2<double> middle = edge.Middle(), out = edge.outward_normal, along = Perpendicular(out);
  const double half = std::max(SideLength(footprint, Side::kFront) / 2, kNarrowestFront_m);
  const Vec2<double> ideal = middle + kPersonRadius_m * out;
  const std::array<Vec2<double>, 4> corners = {middle + half * along, middle - half * along,
                                               middle + half * along + kFrontStrip_m * out,
                                               middle - half * along + kFrontStrip_m * out};
  int best = kNone;
  double best_cost = kFar;
  grid.ForReached(corners, [&](int column, int row, const Vec2<double>& p) {
    const double ahead = Dot(p - middle, out);
    if (std::abs(Dot(p - middle, along)) > half || ahead < 0 || ahead > kFrontStrip_m) return;
    // The way may be infinite where there is no door: then any place will do.
    const double length_m = ways.LengthTo_m(ways.IndexOf(column, row));
    const double cost = (length_m == kFar ? 0 : length_m) + 3 * Norm(p - ideal);
    if (cost < best_cost) {
      best_cost = cost;
      best = static_cast<int>(ways.IndexOf(column, row));
    }
  });
  return best;
}

// Solid objects that stand, by their index.
std::vector<size_t> SolidOf(const LayoutView& view) {
  std::vector<size_t> solid;
  for (size_t i = 0; i < view.scene.objects.size(); ++i) {
    if (view.Has(i) && IsSolid(view.scene.objects[i])) solid.push_back(i);
  }
  return solid;
}

// The floor as the person walks it among them.
WalkResult Measure(const LayoutView& view, const std::vector<size_t>& solid, WalkGrid& grid) {
  std::vector<Obstacle> obstacles;
  for (size_t i : solid) obstacles.push_back({view.layout[i], view.scene.objects[i].footprint});
  return grid.Measure(obstacles);
}

}  // namespace

Routes FindRoutes(const LayoutView& view) {
  const std::vector<size_t> solid = SolidOf(view);
  WalkGrid grid(view.scene.room, 2 * kPersonRadius_m, kFineCell_m);
  Measure(view, solid, grid);
  const Ways ways(view, grid);
  Routes result;
  for (size_t i : solid) {
    const int place = StandingPlace(view, i, grid, ways);
    if (place == kNone) {
      result.blocked.push_back(view.scene.objects[i].id);
    } else if (ways.LengthTo_m(static_cast<size_t>(place)) < kFar) {
      result.routes.push_back({view.scene.objects[i].id, ways.To(static_cast<size_t>(place))});
    }
  }
  return result;
}

Reach MeasureReach(const LayoutView& view) {
  const std::vector<size_t> solid = SolidOf(view);
  WalkGrid grid(view.scene.room, 2 * kPersonRadius_m, kFineCell_m);
  Reach result;
  result.floor_share = Measure(view, solid, grid).reachable_share;
  for (size_t k = 0; k < solid.size(); ++k) {
    if (!grid.front_reachable()[k]) result.blocked.push_back(view.scene.objects[solid[k]].id);
  }
  if (!solid.empty()) result.front_share = 1 - static_cast<double>(result.blocked.size()) / solid.size();
  return result;
}

}  // namespace flair::evaluation
