// SPDX-License-Identifier: GPL-3.0-or-later
// Where a person can walk in a furnished room: a raster of disc positions, 64 cells to a word. A way of exactly the
// path's width is open.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "evaluation/metrics/layout_metrics.h"
#include "room/geometry/polygon.h"
#include "room/geometry/pose.h"
#include "room/scene/room.h"

namespace flair::evaluation {

// Something that stands on the floor and is in the way.
struct Obstacle {
  Pose<double> pose;
  Footprint footprint;
};

struct WalkResult {
  // Share of the free floor that the disc sweeps when it starts at a door, [0, 1]; 1 when there is no free floor.
  double reachable_share = 1;
  // Obstacles whose front cannot be stood at: no reachable disc centre within 0.6 m before it.
  int blocked_fronts = 0;
  // False when no disc fits at any door; then nothing is reachable.
  bool door_free = true;
};

// Cells of a search, and of measures and decisions between layouts that are exact already.
inline constexpr double kSearchCell_m = 0.05, kFineCell_m = 0.025;

// Half of what a person needs to walk.
inline constexpr double kPersonRadius_m = 0.3;

// Floor before a door where one starts; before an object's front where one stands at it, at least so wide to each side.
inline constexpr double kLanding_m = 0.6, kFrontStrip_m = 0.6, kNarrowestFront_m = 0.15;

// Accurate to the cell, which is coarser than asked for in rooms of more than 15 m (25 m for fine cells). Keeps scratch
// memory: one grid serves one thread; copies are independent.
class WalkGrid {
 public:
  // `path_width_m` is the diameter of the disc. Without doors the largest connected area counts as reachable.
  WalkGrid(const Room& room, double path_width_m, double cell_m = kSearchCell_m);
  WalkResult Measure(std::span<const Obstacle> obstacles);
  // Per obstacle of the last Measure: whether its front was reachable.
  const std::vector<char>& front_reachable() const { return front_reachable_; }

  int columns() const { return width_; }
  int rows() const { return height_; }
  // Nominal side of a cell; all columns together differ from it by at most half a cell, and so do all rows.
  double cell_m() const { return cell_m_; }
  Vec2<double> CenterOf(int column, int row) const {
    return {min_.x + (column + 0.5) * cell_x_m_, min_.y + (row + 0.5) * cell_y_m_};
  }
  // Whether the disc got to that cell in the last Measure.
  bool IsReached(int column, int row) const {
    return (reached_[static_cast<size_t>(row) * words_ + (column >> 6)] >> (column & 63) & 1) != 0;
  }
  // Calls visit(column, row, centre) for the reached cells whose centre is within the bounding box of `corners`.
  template <typename Points, typename Visit>
  void ForReached(const Points& corners, const Visit& visit) const {
    const BoundingBox box = BoundsOf(corners);
    const auto cell = [](double at_m, double cell_m, int count) {
      return static_cast<int>(std::clamp(at_m / cell_m, 0.0, count - 1.0));
    };
    const int last_column = cell(box.max.x - min_.x, cell_x_m_, width_);
    const int last_row = cell(box.max.y - min_.y, cell_y_m_, height_);
    for (int row = cell(box.min.y - min_.y, cell_y_m_, height_); row <= last_row; ++row) {
      for (int column = cell(box.min.x - min_.x, cell_x_m_, width_); column <= last_column; ++column) {
        if (IsReached(column, row)) visit(column, row, CenterOf(column, row));
      }
    }
  }

 private:
  // A raster, row by row.
  using Mask = std::vector<uint64_t>;
  // Cells [first, last] of a row that hang together, and the set they belong to.
  struct Run {
    int row, first, last, parent;
    bool at_door;
  };

  void Rasterize(const Room& room);
  void MarkDoor(const Polygon& landing);
  uint64_t* RowOf(Mask& mask, int y) const { return mask.data() + static_cast<size_t>(y) * words_; }
  // The cells of a shape that reaches so far from its middle, row by row.
  template <typename SliceAt, typename Take>
  void ForCells(const Frame<double>& frame, double reach, const SliceAt& slice_at, const Take& take) const;
  void ClearShape(Mask& mask, const Obstacle& obstacle, double radius_m) const;
  bool TouchesFront(const Obstacle& obstacle);
  void FindRuns();
  void JoinRows();
  int RootOf(int run);
  // The set to walk in; -1 when there is none.
  int ChooseArea();
  void Sweep(int area);
  double SweptShare();

  // Corner of the room's bounding box.
  Vec2<double> min_;
  // Cells divide the room evenly, so that it does not matter from which corner they are counted; thus two sizes, near
  // the one asked for.
  double cell_m_, cell_x_m_, cell_y_m_, radius_m_;
  int width_, height_, words_;
  bool has_door_ = false;
  Mask inside_, roomy_, door_;  // of the empty room: floor, disc fits, before a door
  Mask free_, open_, reached_, swept_;
  std::vector<Run> runs_;
  std::vector<int> row_start_;
  std::vector<int> area_size_;
  std::vector<char> front_reachable_;
};

// Which way somebody takes from the door to the front of each solid object: the shortest on the floor as it is walked
// (walk_grid.h), by steps to the eight neighbours of a cell, then pulled taut. Its middle line keeps 0.3 m from
// everything solid, less half a cell.

struct Route {
  std::string object_id;
  // From the middle of the door's opening to where one stands before the object.
  std::vector<Vec2<double>> points;
};

struct Routes {
  // In the scene's order; none for objects that are out of reach, none at all without a door.
  std::vector<Route> routes;
  // Objects that cannot be stood at, as Reach has them.
  std::vector<std::string> blocked;
};

// Deterministic.
Routes FindRoutes(const LayoutView& view);

// Where a person 0.6 m wide gets to from the door, on a raster of 0.025 m (coarser beyond 25 m). A gap of exactly 0.6 m
// lets the person through. Shares as the neutral judge of the released rooms has them (recorded_test.cc), so that they
// compare with its figures: a chair pushed under its table counts as out of reach, as its front does.

struct Reach {
  // Share of the free floor that the person's disc sweeps; 1 when no floor is free.
  double floor_share = 1;
  // Share of solid floor objects that can be stood at: a reached position within 0.6 m of the front. 1 when there are
  // none.
  double front_share = 1;
  // Objects that cannot be.
  std::vector<std::string> blocked;
};

// Starts in the 0.6 m before each door; the largest area that begins there counts. Without doors, the largest of all.
Reach MeasureReach(const LayoutView& view);

}  // namespace flair::evaluation
