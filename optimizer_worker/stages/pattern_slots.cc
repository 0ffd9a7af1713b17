// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/pattern_slots.h"

#include <algorithm>
#include <optional>

namespace flair::optimizer {
namespace {

// Gaps within and between rows; kSpread stands for an equal share of what is free.
constexpr double kSpread = -1;
constexpr double kGaps_m[] = {0, 0.6, 0.9, kSpread};
// A row that is not full has at least this share of the others' boxes; up to so many rows are to spare.
constexpr double kFullEnough = 0.5;
constexpr int kSpareRows = 1;
// Rows along walls, shared evenly, may be by so many longer.
constexpr int kSpareOnWall = 3;

// Rows of a grid: all look the same way, or every second one is turned.
struct Bank {
  bool turned;
  // Whether the first two rows face each other (or stand back to back).
  bool facing;
  // Between rows that face each other or look the same way; and those that stand back to back.
  double front_gap, back_gap;

  bool FrontAfter(int row) const { return !turned || (row % 2 == 0) == facing; }
};

class GridMaker {
 public:
  GridMaker(const Room& room, const BoundingBox& box, double heading, Ways ways, const VisitSlots& visit)
      : box_(box), heading_(heading), ways_(ways), visit_(visit), frame_(FrameOf(Pose<double>{0, 0, heading})) {
    std::vector<Vec2<double>> corners;
    for (const Vec2<double>& p : room.floor.vertices) corners.push_back(frame_.ToObject(p));
    floor_ = BoundsOf(corners);
  }

  void All(int count) {
    for (int columns = 1; columns <= count && columns * box_.width_m() <= floor_.width_m(); ++columns) {
      const int fewest = (count + columns - 1) / columns;
      if (fewest > 1 && count - columns * (fewest - 1) < kFullEnough * columns) continue;
      for (int rows = fewest; rows <= fewest + kSpareRows; ++rows) {
        if (rows * box_.height_m() > floor_.height_m()) break;
        for (double gap : kGaps_m) {
          if (columns > 1 ? gap != 0 || ways_ == Ways::kNone : gap == 0) Across(columns, rows, gap);
        }
      }
    }
  }

 private:
  // Calls place(start, gap) for a row of `count` gaps in `free`: in the middle and at both ends, or spread.
  template <typename F>
  static void ForStarts(double free, int count, double gap, const F& place) {
    const double step = gap == kSpread ? std::max(0.0, free) / (count + 2) : gap;
    const double slack = free - count * step;
    if (slack < 0) return;
    place(slack / 2, step);
    if (gap == kSpread || slack < 0.1) return;
    place(0.0, step);
    place(slack, step);
  }

  void Across(int columns, int rows, double gap) {
    const double w = box_.width_m();
    ForStarts(floor_.width_m() - columns * w, columns - 1, gap, [&](double start, double step) {
      middles_.clear();
      for (int c = 0; c < columns; ++c) middles_.push_back(floor_.min.x + start + c * (w + step) + w / 2);
      for (double front : kGaps_m) {
        if (rows > 1 && front == 0 && ways_ == Ways::kAllRound) continue;
        if (rows > 1 || front == 0) Down(rows, {false, false, front, front});
        if (rows == 1 || front == kGaps_m[2] || ways_ == Ways::kAllRound) continue;
        for (double back : {kGaps_m[0], kGaps_m[1]}) {
          for (bool facing : {false, true}) Down(rows, {true, facing, front, back});
        }
      }
    });
  }

  void Down(int rows, const Bank& bank) {
    const double d = box_.height_m();
    int fronts = 0;
    for (int row = 0; row + 1 < rows; ++row) fronts += bank.FrontAfter(row) ? 1 : 0;
    const double free = floor_.height_m() - rows * d - (rows - 1 - fronts) * bank.back_gap;
    ForStarts(free, fronts, bank.front_gap, [&](double start, double front) {
      slots_.clear();
      double at = floor_.min.y + start + d / 2;
      for (int row = 0; row < rows; ++row) {
        for (double x : middles_) Add(x, at, bank.FrontAfter(row));
        at += d + (bank.FrontAfter(row) ? front : bank.back_gap);
      }
      visit_(slots_);
    });
  }

  // The box's middle at (x, y), looking along the heading or the other way.
  void Add(double x, double y, bool along) {
    const Vec2<double> c = box_.Center();
    const Vec2<double> p = along ? frame_.ToRoom(x - c.x, y - c.y) : frame_.ToRoom(x + c.x, y + c.y);
    slots_.push_back({p.x, p.y, along ? heading_ : heading_ + kPi});
  }

  const BoundingBox& box_;
  double heading_;
  Ways ways_;
  const VisitSlots& visit_;
  Frame<double> frame_;
  BoundingBox floor_;  // in frame_
  std::vector<double> middles_;
  std::vector<Pose<double>> slots_;
};

// Boxes along every wall in turn, or every second one: opposite rows. With a margin only where walls are so far from
// windows and doors.
class WallRows {
 public:
  WallRows(const Room& room, const BoundingBox& box, size_t first, size_t step, std::optional<double> margin_m)
      : box_(box) {
    const double d = box.height_m();
    for (size_t k = 0; k < room.walls.size(); k += step) {
      const size_t index = (first + k) % room.walls.size();
      const Wall& wall = room.walls[index];
      // Corners are left to the row that comes first.
      double low = k > 0 && step == 1 ? d : 0.0;
      const double end = wall.length_m - (k > 0 && k + 1 == room.walls.size() ? d : 0.0);
      std::vector<const Opening*> openings;
      for (const Opening& opening : room.openings) {
        if (margin_m.has_value() && static_cast<size_t>(opening.wall) == index) {
          openings.push_back(&opening);
        }
      }
      std::sort(openings.begin(), openings.end(),
                [](const Opening* a, const Opening* b) { return a->offset_m < b->offset_m; });
      for (const Opening* opening : openings) {
        rows_.push_back({&wall, low, std::min(end, opening->offset_m - *margin_m)});
        low = std::max(low, opening->offset_m + opening->width_m + *margin_m);
      }
      rows_.push_back({&wall, low, end});
    }
    std::erase_if(rows_, [&](const Row& row) { return row.high - row.low < box.width_m(); });
  }

  // As many as fit with such gaps, one wall after the other.
  void Filled(double gap, size_t count, const VisitSlots& visit) const {
    std::vector<Pose<double>> slots;
    for (const Row& row : rows_) {
      const int fit = static_cast<int>((row.high - row.low + gap) / (box_.width_m() + gap));
      const double start = row.low + (row.high - row.low - fit * box_.width_m() - (fit - 1) * gap) / 2;
      for (int n = 0; n < fit; ++n) slots.push_back(At(row, start + n * (box_.width_m() + gap)));
    }
    if (slots.size() >= count) visit(slots);
  }

  // `each` to a wall that has room for them, evenly, the walls by turns.
  void Shared(int each, size_t count, const VisitSlots& visit) const {
    std::vector<Pose<double>> slots;
    for (int n = 0; n < each; ++n) {
      for (const Row& row : rows_) {
        const double gap = (row.high - row.low - each * box_.width_m()) / (each + 1);
        if (gap >= 0) slots.push_back(At(row, row.low + gap + n * (box_.width_m() + gap)));
      }
    }
    if (slots.size() >= count) visit(slots);
  }

 private:
  // Free along the wall between `low` and `high`.
  struct Row {
    const Wall* wall;
    double low, high;
  };

  Pose<double> At(const Row& row, double offset) const {
    const double heading = row.wall->BackHeading();
    const Vec2<double> off = FrameOf(Pose<double>{0, 0, heading}).ToRoom(box_.Center().x, box_.Center().y);
    const Vec2<double> p =
        row.wall->PointAt(offset + box_.width_m() / 2) + (box_.height_m() / 2) * row.wall->inward_normal - off;
    return {p.x, p.y, heading};
  }

  const BoundingBox& box_;
  std::vector<Row> rows_;
};

}  // namespace

void ForEachPattern(const Room& room, const BoundingBox& box, int count, Ways ways, const VisitSlots& visit) {
  const Wall& longest = *std::max_element(room.walls.begin(), room.walls.end(),
                                          [](const Wall& a, const Wall& b) { return a.length_m < b.length_m; });
  for (int quarter = 0; quarter < 4; ++quarter) {
    GridMaker(room, box, longest.BackHeading() + quarter * kPi / 2, ways, visit).All(count);
  }
  for (size_t wall = 0; wall < room.walls.size(); ++wall) {
    for (size_t step : {size_t{1}, size_t{2}}) {
      for (double margin_m : {0.5, 1.0}) {
        const WallRows between(room, box, wall, step, margin_m);
        for (double gap : {0.1, 0.6}) between.Filled(gap, count, visit);
        for (int each = 1; each <= kSpareOnWall; ++each) between.Shared(each, count, visit);
      }
      const WallRows rows(room, box, wall, step, std::nullopt);
      for (double gap : {0.0, 0.1, 0.6}) rows.Filled(gap, count, visit);
      const int fewest = std::max(2, count * static_cast<int>(step) / static_cast<int>(room.walls.size()));
      for (int each = fewest; each <= fewest + kSpareOnWall; ++each) rows.Shared(each, count, visit);
    }
  }
}

}  // namespace flair::optimizer
