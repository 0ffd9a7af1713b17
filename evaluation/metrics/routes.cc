// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluation/metrics/routes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <queue>

#include "evaluation/metrics/walk_floor.h"

namespace flair::evaluation {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr int kNone = -1;

// Lengths of the shortest ways from the doors to all reached cells.
class Ways {
 public:
  Ways(const LayoutView& view, const WalkFloor& floor)
      : floor_(floor), length_m_(floor.raster.size(), kFar), before_(floor.raster.size(), kNone) {
    for (const Opening& door : view.scene.room.openings) {
      if (door.kind == OpeningKind::kDoor) Enter(view.scene.room, door);
    }
    Spread();
  }

  double LengthTo_m(size_t cell) const { return length_m_[cell]; }

  // The way to the cell, taut.
  std::vector<Vec2<double>> To(size_t cell) const {
    std::vector<size_t> cells{cell};
    while (before_[cells.back()] >= 0) cells.push_back(static_cast<size_t>(before_[cells.back()]));
    std::reverse(cells.begin(), cells.end());
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
    const int columns = floor_.raster.columns();
    return floor_.raster.CenterOf(static_cast<int>(cell) % columns, static_cast<int>(cell) / columns);
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
    ForLanding(floor_.raster, LandingOf(room, door), [&](size_t cell, const Vec2<double>& p) {
      const double length_m = Norm(p - middle);
      if (!floor_.reached[cell] || length_m >= length_m_[cell]) return;
      length_m_[cell] = length_m;
      before_[cell] = mark;
      open_.push({length_m, cell});
    });
  }

  void Spread() {
    const int columns = floor_.raster.columns(), rows = floor_.raster.rows();
    const double step_m = floor_.raster.cell_m();
    while (!open_.empty()) {
      const auto [length_m, cell] = open_.top();
      open_.pop();
      if (length_m > length_m_[cell]) continue;
      const int column = static_cast<int>(cell) % columns, row = static_cast<int>(cell) / columns;
      for (int dr = -1; dr <= 1; ++dr) {
        for (int dc = -1; dc <= 1; ++dc) {
          const int c = column + dc, r = row + dr;
          if ((dc == 0 && dr == 0) || c < 0 || r < 0 || c >= columns || r >= rows) continue;
          const size_t next = floor_.raster.IndexOf(c, r);
          const double there_m = length_m + step_m * (dc != 0 && dr != 0 ? std::numbers::sqrt2 : 1);
          if (!floor_.reached[next] || there_m >= length_m_[next] - 1e-9) continue;
          length_m_[next] = there_m;
          before_[next] = static_cast<int>(cell);
          open_.push({there_m, next});
        }
      }
    }
  }

  // Whether the straight way between two cells stays on reached ones.
  bool Sees(size_t from, size_t to) const {
    const int columns = floor_.raster.columns();
    const int c0 = static_cast<int>(from) % columns, r0 = static_cast<int>(from) / columns;
    const int dc = static_cast<int>(to) % columns - c0, dr = static_cast<int>(to) / columns - r0;
    const int steps = 2 * std::max(std::abs(dc), std::abs(dr));
    for (int i = 1; i < steps; ++i) {
      // Rounded half up, in whole numbers.
      const int c = c0 + static_cast<int>(std::floor((2.0 * dc * i + steps) / (2.0 * steps)));
      const int r = r0 + static_cast<int>(std::floor((2.0 * dr * i + steps) / (2.0 * steps)));
      if (!floor_.reached[floor_.raster.IndexOf(c, r)]) return false;
    }
    return true;
  }

  using Entry = std::pair<double, size_t>;
  const WalkFloor& floor_;
  std::vector<double> length_m_;
  // The cell before on the way; below kNone: the door that the way starts at.
  std::vector<int> before_;
  std::vector<Vec2<double>> doors_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

// Where one stands at the object: near the way and near the middle of its front; kNone when nobody can.
int StandingPlace(const FrontStrip& strip, const WalkFloor& floor, const Ways& ways) {
  int best = kNone;
  double best_cost = kFar;
  const Vec2<double> ideal = strip.middle_of_front() + kPersonRadius_m * strip.outward();
  strip.ForCells(floor.raster, [&](size_t cell, const Vec2<double>& p) {
    if (!floor.reached[cell]) return;
    // The way may be infinite where there is no door: then any place will do.
    const double length_m = ways.LengthTo_m(cell);
    const double cost = (length_m == kFar ? 0 : length_m) + 3 * Norm(p - ideal);
    if (cost < best_cost) {
      best_cost = cost;
      best = static_cast<int>(cell);
    }
  });
  return best;
}

bool FrontReached(const LayoutView& view, size_t i, const WalkFloor& floor) {
  bool found = false;
  FrontStrip(view, i).ForCells(floor.raster,
                               [&](size_t cell, const Vec2<double>&) { found |= floor.reached[cell] != 0; });
  return found;
}

int Count(const CellSet& cells) { return std::accumulate(cells.begin(), cells.end(), 0); }

}  // namespace

Routes FindRoutes(const LayoutView& view) {
  const WalkFloor floor = MakeWalkFloor(view);
  const Ways ways(view, floor);
  Routes result;
  for (size_t i = 0; i < view.scene.objects.size(); ++i) {
    if (!view.Has(i) || !IsSolid(view.scene.objects[i])) continue;
    const int place = StandingPlace(FrontStrip(view, i), floor, ways);
    if (place == kNone) {
      result.blocked.push_back(view.scene.objects[i].id);
    } else if (ways.LengthTo_m(static_cast<size_t>(place)) < kFar) {
      result.routes.push_back({view.scene.objects[i].id, ways.To(static_cast<size_t>(place))});
    }
  }
  return result;
}

Reach MeasureReach(const LayoutView& view) {
  const WalkFloor floor = MakeWalkFloor(view);
  CellSet swept = floor.raster.Dilate(floor.reached, kPersonRadius_m);
  for (size_t i = 0; i < swept.size(); ++i) swept[i] = swept[i] && floor.free[i];

  Reach result;
  const int free_count = Count(floor.free);
  if (free_count > 0) result.floor_share = static_cast<double>(Count(swept)) / free_count;
  int tested = 0;
  for (size_t i = 0; i < view.scene.objects.size(); ++i) {
    if (!view.Has(i) || !IsSolid(view.scene.objects[i])) continue;
    ++tested;
    if (!FrontReached(view, i, floor)) result.blocked.push_back(view.scene.objects[i].id);
  }
  if (tested > 0) result.front_share = 1 - static_cast<double>(result.blocked.size()) / tested;
  return result;
}

}  // namespace flair::evaluation
