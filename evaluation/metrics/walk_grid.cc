// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluation/metrics/walk_grid.h"

#include <bit>
#include <cmath>
#include <limits>

namespace flair::evaluation {
namespace {

// No more cells along a side than these, of search cells and finer ones.
constexpr double kMostCells = 300, kMostFineCells = 1000;

struct Interval {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool empty() const { return low > high; }
  // Keeps x with |offset + slope · x| <= half.
  void Cut(double slope, double offset, double half) {
    if (std::abs(slope) < 1e-12) {
      if (std::abs(offset) > half) high = -std::numeric_limits<double>::infinity();
      return;
    }
    const double a = (-half - offset) / slope, b = (half - offset) / slope;
    low = std::max(low, std::min(a, b));
    high = std::min(high, std::max(a, b));
  }
  void Join(const Interval& other) {
    if (other.empty()) return;
    if (empty()) *this = other;
    low = std::min(low, other.low);
    high = std::max(high, other.high);
  }
};

// Where the horizontal line at height y is within the rectangle of half sides a (right) and b (front).
Interval Slice(const Frame<double>& frame, double a, double b, double y) {
  const double dy = y - frame.center.y;
  Interval slice;
  slice.Cut(frame.right.x, dy * frame.right.y, a);
  slice.Cut(frame.front.x, dy * frame.front.y, b);
  slice.low += frame.center.x;
  slice.high += frame.center.x;
  return slice;
}

// The same for the rectangle grown by a disc.
Interval RoundSlice(const Frame<double>& frame, const Footprint& footprint, double radius, double y) {
  const double a = footprint.width_m / 2, b = footprint.depth_m / 2;
  Interval slice = Slice(frame, a + radius, b, y);
  slice.Join(Slice(frame, a, b + radius, y));
  for (const Vec2<double>& corner : Corners(footprint, frame)) {
    const double dy = y - corner.y;
    if (std::abs(dy) > radius) continue;
    const double half = std::sqrt(radius * radius - dy * dy);
    slice.Join({corner.x - half, corner.x + half});
  }
  return slice;
}

// Calls word(index, bits) for the cells [first, last] of a row.
template <typename F>
void ForWords(int first, int last, const F& word) {
  for (int w = first >> 6; w <= last >> 6; ++w) {
    uint64_t bits = ~uint64_t{0};
    if (w == first >> 6) bits &= ~uint64_t{0} << (first & 63);
    if (w == last >> 6) bits &= ~uint64_t{0} >> (63 - (last & 63));
    word(w, bits);
  }
}

}  // namespace

WalkGrid::WalkGrid(const Room& room, double path_width_m, double cell_m) : radius_m_(path_width_m / 2) {
  const BoundingBox box = BoundsOf(room.floor);
  const double most = cell_m < kSearchCell_m ? kMostFineCells : kMostCells;
  min_ = box.min;
  cell_m_ = std::max(cell_m, std::max(box.width_m(), box.height_m()) / most);
  width_ = std::max(1, static_cast<int>(std::lround(box.width_m() / cell_m_)));
  height_ = std::max(1, static_cast<int>(std::lround(box.height_m() / cell_m_)));
  cell_x_m_ = box.width_m() / width_;
  cell_y_m_ = box.height_m() / height_;
  words_ = (width_ + 63) / 64;
  Rasterize(room);
}

void WalkGrid::Rasterize(const Room& room) {
  const Mask empty(static_cast<size_t>(words_) * height_, 0);
  inside_ = roomy_ = door_ = free_ = open_ = reached_ = swept_ = empty;
  row_start_.resize(height_ + 1);
  std::vector<Polygon> landings;
  for (const Opening& opening : room.openings) {
    if (opening.kind == OpeningKind::kDoor) landings.push_back(PassageArea(room, opening, kLanding_m));
  }
  has_door_ = !landings.empty();
  // Half a cell of slack, so that a way of exactly the path's width is open.
  const double needed = std::max(0.0, radius_m_ - cell_m_ / 2 - 1e-7);
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_;) {
      const double depth = SignedDistance(room.floor, CenterOf(x, y));
      // It changes by no more than the way walked: for so many cells the answers stay the same.
      const double to_change = std::min(std::abs(depth), std::abs(depth - needed));
      const int last = std::min(width_ - 1, x + std::max(0, static_cast<int>(to_change / cell_x_m_) - 1));
      const auto set = [&](Mask& mask) {
        uint64_t* row = RowOf(mask, y);
        ForWords(x, last, [row](int w, uint64_t bits) { row[w] |= bits; });
      };
      if (depth >= 0) set(inside_);
      if (depth >= 0 && depth >= needed) set(roomy_);
      x = last + 1;
    }
  }
  for (const Polygon& landing : landings) MarkDoor(landing);
}

void WalkGrid::MarkDoor(const Polygon& landing) {
  const BoundingBox box = BoundsOf(landing);
  const auto cell = [](double at_m, double cell_m, int most) {
    return static_cast<int>(std::clamp(std::floor(at_m / cell_m), 0.0, most - 1.0));
  };
  const int first = cell(box.min.x - min_.x, cell_x_m_, width_), last = cell(box.max.x - min_.x, cell_x_m_, width_);
  const int top = cell(box.max.y - min_.y, cell_y_m_, height_);
  for (int y = cell(box.min.y - min_.y, cell_y_m_, height_); y <= top; ++y) {
    for (int x = first; x <= last; ++x) {
      const uint64_t bit = RowOf(inside_, y)[x >> 6] & (uint64_t{1} << (x & 63));
      if (bit != 0 && Contains(landing, CenterOf(x, y))) RowOf(door_, y)[x >> 6] |= bit;
    }
  }
}

template <typename SliceAt, typename Take>
void WalkGrid::ForCells(const Frame<double>& frame, double reach, const SliceAt& slice_at, const Take& take) const {
  const int low = std::max(0, static_cast<int>(std::floor((frame.center.y - reach) / cell_y_m_)));
  const int high = std::min(height_ - 1, static_cast<int>(std::ceil((frame.center.y + reach) / cell_y_m_)));
  for (int y = low; y <= high; ++y) {
    const Interval slice = slice_at((y + 0.5) * cell_y_m_);
    if (slice.empty()) continue;
    const int first = std::max(0, static_cast<int>(std::ceil(slice.low / cell_x_m_ - 0.5)));
    const int last = std::min(width_ - 1, static_cast<int>(std::floor(slice.high / cell_x_m_ - 0.5)));
    if (first <= last) ForWords(first, last, [&](int w, uint64_t bits) { take(y, w, bits); });
  }
}

void WalkGrid::ClearShape(Mask& mask, const Obstacle& obstacle, double radius_m) const {
  Frame<double> frame = FrameOf(obstacle.pose);
  frame.center = frame.center - min_;
  ForCells(
      frame, std::hypot(obstacle.footprint.width_m, obstacle.footprint.depth_m) / 2 + radius_m,
      [&](double at_m) { return RoundSlice(frame, obstacle.footprint, radius_m, at_m); },
      [&](int y, int w, uint64_t bits) { RowOf(mask, y)[w] &= ~bits; });
}

bool WalkGrid::TouchesFront(const Obstacle& obstacle) {
  Frame<double> frame = FrameOf(obstacle.pose);
  frame.center = frame.center - min_;
  frame.center += (obstacle.footprint.depth_m / 2 + kFrontStrip_m / 2) * frame.front;
  const double a = std::max(obstacle.footprint.width_m / 2, kNarrowestFront_m), b = kFrontStrip_m / 2;
  bool touches = false;
  ForCells(
      frame, std::hypot(a, b), [&](double at_m) { return Slice(frame, a, b, at_m); },
      [&](int y, int w, uint64_t bits) { touches = touches || (RowOf(reached_, y)[w] & bits) != 0; });
  return touches;
}

void WalkGrid::FindRuns() {
  runs_.clear();
  for (int y = 0; y < height_; ++y) {
    row_start_[y] = static_cast<int>(runs_.size());
    const uint64_t* row = RowOf(open_, y);
    const uint64_t* door = RowOf(door_, y);
    for (int x = 0; x < width_;) {
      const uint64_t rest = row[x >> 6] >> (x & 63);
      if (rest == 0) {
        x = ((x >> 6) + 1) << 6;
        continue;
      }
      const int first = x + std::countr_zero(rest);
      int last = first;
      while (last < width_) {
        const int ones = std::min(std::countr_one(row[last >> 6] >> (last & 63)), 64 - (last & 63));
        last += ones;
        if (ones == 0 || (last & 63) != 0) break;
      }
      last = std::min(last, width_) - 1;
      bool at_door = false;
      ForWords(first, last, [&](int w, uint64_t bits) { at_door = at_door || (door[w] & bits) != 0; });
      runs_.push_back({y, first, last, static_cast<int>(runs_.size()), at_door});
      x = last + 1;
    }
  }
  row_start_[height_] = static_cast<int>(runs_.size());
}

int WalkGrid::RootOf(int run) {
  while (runs_[run].parent != run) run = runs_[run].parent = runs_[runs_[run].parent].parent;
  return run;
}

void WalkGrid::JoinRows() {
  for (int y = 1; y < height_; ++y) {
    int above = row_start_[y - 1], below = row_start_[y];
    while (above < row_start_[y] && below < row_start_[y + 1]) {
      if (runs_[above].first <= runs_[below].last && runs_[below].first <= runs_[above].last) {
        const int a = RootOf(above), b = RootOf(below);
        if (a != b) runs_[std::max(a, b)].parent = std::min(a, b);
      }
      (runs_[above].last < runs_[below].last ? above : below)++;
    }
  }
}

int WalkGrid::ChooseArea() {
  area_size_.assign(runs_.size(), 0);
  std::vector<char>& at_door = front_reachable_;  // scratch until the fronts are tested
  at_door.assign(runs_.size(), 0);
  for (int i = 0; i < static_cast<int>(runs_.size()); ++i) {
    const int root = RootOf(i);
    area_size_[root] += runs_[i].last - runs_[i].first + 1;
    at_door[root] = at_door[root] || runs_[i].at_door;
  }
  int best = -1;
  for (int i = 0; i < static_cast<int>(runs_.size()); ++i) {
    if (area_size_[i] == 0 || (has_door_ && !at_door[i])) continue;
    if (best < 0 || area_size_[i] > area_size_[best]) best = i;
  }
  return best;
}

void WalkGrid::Sweep(int area) {
  const int reach = static_cast<int>(radius_m_ / cell_m_ + 1e-9);
  for (int i = 0; i < static_cast<int>(runs_.size()); ++i) {
    if (RootOf(i) != area) continue;
    const Run& run = runs_[i];
    uint64_t* row = RowOf(reached_, run.row);
    ForWords(run.first, run.last, [row](int w, uint64_t bits) { row[w] |= bits; });
    for (int dy = -reach; dy <= reach; ++dy) {
      const int y = run.row + dy;
      if (y < 0 || y >= height_) continue;
      const double r = radius_m_ / cell_m_;
      const int half = static_cast<int>(std::sqrt(std::max(0.0, r * r - dy * dy)) + 1e-9);
      uint64_t* swept = RowOf(swept_, y);
      ForWords(std::max(0, run.first - half), std::min(width_ - 1, run.last + half),
               [swept](int w, uint64_t bits) { swept[w] |= bits; });
    }
  }
}

double WalkGrid::SweptShare() {
  int64_t swept = 0, free = 0;
  for (size_t i = 0; i < free_.size(); ++i) {
    swept += std::popcount(swept_[i] & free_[i]);
    free += std::popcount(free_[i]);
  }
  return free == 0 ? 1.0 : static_cast<double>(swept) / static_cast<double>(free);
}

WalkResult WalkGrid::Measure(std::span<const Obstacle> obstacles) {
  free_ = inside_;
  open_ = roomy_;
  std::ranges::fill(reached_, 0);
  std::ranges::fill(swept_, 0);
  const double needed = std::max(0.0, radius_m_ - cell_m_ / 2 - 1e-7);
  for (const Obstacle& obstacle : obstacles) {
    ClearShape(free_, obstacle, 0);
    ClearShape(open_, obstacle, needed);
  }
  FindRuns();
  JoinRows();
  const int area = ChooseArea();
  WalkResult result;
  result.door_free = area >= 0;
  if (area >= 0) Sweep(area);
  result.reachable_share = SweptShare();
  front_reachable_.resize(obstacles.size());
  for (size_t i = 0; i < obstacles.size(); ++i) {
    front_reachable_[i] = TouchesFront(obstacles[i]);
    if (!front_reachable_[i]) ++result.blocked_fronts;
  }
  return result;
}

}  // namespace flair::evaluation
