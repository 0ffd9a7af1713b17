// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "fmt/format.h"
#include "optimizer_worker/constraints/whole_room.h"
#include "optimizer_worker/stages/infeasible.h"
#include "room/geometry/polygon.h"

namespace flair::optimizer {

namespace {

constexpr double kFits_m = 1e-6;

Misfit OnTheFloor(const Violation& violation) {
  if (violation.other >= 0) return {violation.object, violation.other, "overlaps", violation.depth_m};
  return {violation.object, -1, violation.at_door ? "stands in the way of a door" : "reaches out of the room",
          violation.depth_m};
}

// What a hard term about something that does not stand on the floor says; all are squared metres.
Misfit OffTheFloor(const Term& term, double cost) {
  const bool pair = term.name == kNoOverlapTerm;
  const std::string what = pair                          ? "overlaps"
                           : term.name == kOnWallTerm    ? "does not fit on a wall beside doors and windows"
                           : term.name == kDoorClearTerm ? "stands in the way of a door"
                                                         : "reaches out of the room";
  const int first = std::min(term.required.front(), term.required.back());
  const int last = std::max(term.required.front(), term.required.back());
  return {last, pair ? first : -1, what, std::sqrt(cost)};
}

bool IsPlaced(const Term& term, const PartialLayout& state) {
  return std::all_of(term.required.begin(), term.required.end(), [&](int object) { return state.placed[object] != 0; });
}

std::string SizeOf(const Scene& scene, int object) {
  const Footprint& size = scene.objects[object].footprint;
  return fmt::format("{} ({:.2f} m x {:.2f} m)", NameForPeople(scene, object), size.width_m, size.depth_m);
}

// `no_free_place` says it of the misfit's object.
v1::Diagnostic Describe(const SolveInput& input, const Misfit& misfit, const std::string& no_free_place) {
  const Scene& scene = input.scene;
  v1::Diagnostic diagnostic;
  diagnostic.set_severity(v1::SEVERITY_WARNING);
  diagnostic.set_subject_id(scene.objects[misfit.object].id);
  const std::string whom = misfit.other >= 0 ? " " + SizeOf(scene, misfit.other) : "";
  const std::string fact =
      fmt::format("{} {}{} by {:.2f} m", SizeOf(scene, misfit.object), misfit.what, whom, misfit.depth_m);
  if (input.pinned[misfit.object] && (misfit.other < 0 || input.pinned[misfit.other])) {
    diagnostic.set_code("pinned_collides");
    diagnostic.set_message(fact + ": it is held there; move it or let it move");
    return diagnostic;
  }
  diagnostic.set_code("does_not_fit");
  const std::string place = no_free_place.empty() ? "" : no_free_place + "; ";
  diagnostic.set_message(fmt::format("{}: {}leave something out or take smaller pieces", fact, place));
  return diagnostic;
}

v1::Diagnostic NotPlaced(const Scene& scene, int object) {
  v1::Diagnostic diagnostic;
  diagnostic.set_severity(v1::SEVERITY_ERROR);
  diagnostic.set_code("not_placed");
  diagnostic.set_subject_id(scene.objects[object].id);
  diagnostic.set_message(NameForPeople(scene, object) + " was not placed");
  return diagnostic;
}

}  // namespace

std::vector<Misfit> FindMisfits(const SolveInput& input, const SceneCosts& costs, const PartialLayout& state) {
  const Scene& scene = input.scene;
  std::vector<int> floor;
  for (int i = 0; i < static_cast<int>(scene.objects.size()); ++i) {
    if (state.placed[i]) floor.push_back(i);
  }
  std::vector<Misfit> misfits;
  for (const Violation& violation : FindViolations(scene, input.keep_out, floor, state.layout, kFits_m)) {
    misfits.push_back(OnTheFloor(violation));
  }
  for (const Term& term : costs.terms) {
    if (!term.hard || !IsPlaced(term, state)) continue;
    const auto solid = [&](int object) { return IsSolid(scene.objects[object]); };
    if (std::all_of(term.required.begin(), term.required.end(), solid)) continue;
    std::vector<Pose<double>> poses;
    for (int object : term.cost->objects()) poses.push_back(state.layout[object]);
    const double cost = term.cost->Value(poses);
    if (cost > kFits_m * kFits_m) misfits.push_back(OffTheFloor(term, cost));
  }
  return misfits;
}

std::string NoFreePlace(const SolveInput& input, const PartialLayout& state, int object) {
  std::vector<int> others;
  for (int i = 0; i < static_cast<int>(input.scene.objects.size()); ++i) {
    if (i != object && state.placed[i] && IsSolid(input.scene.objects[i])) others.push_back(i);
  }
  const FreePlace free = LargestFreePlace(input.scene, input.keep_out, others, state.layout);
  const Footprint& footprint = input.scene.objects[object].footprint;
  const double across = std::max(footprint.width_m, footprint.depth_m);
  const double along = std::min(footprint.width_m, footprint.depth_m);
  // There may be one, but not where its constraints or the ways let it stand.
  if (across <= free.long_m && along <= free.short_m) {
    return fmt::format("the free place of {:.2f} m x {:.2f} m does not suit it", free.long_m, free.short_m);
  }
  return fmt::format("no free place of {:.2f} m x {:.2f} m; the largest free one is {:.2f} m x {:.2f} m", across, along,
                     free.long_m, free.short_m);
}

std::vector<v1::Diagnostic> FitDiagnostics(const SolveInput& input, const SceneCosts& costs,
                                           const PartialLayout& state) {
  std::vector<v1::Diagnostic> diagnostics;
  for (size_t i = 0; i < input.scene.objects.size(); ++i) {
    if (!state.placed[i]) diagnostics.push_back(NotPlaced(input.scene, i));
  }
  // Of an object that is in the way of many the free places are looked for once.
  std::map<int, std::string> no_free_place;
  for (const Misfit& misfit : FindMisfits(input, costs, state)) {
    const auto [place, is_new] = no_free_place.try_emplace(misfit.object);
    if (is_new && IsSolid(input.scene.objects[misfit.object])) place->second = NoFreePlace(input, state, misfit.object);
    diagnostics.push_back(Describe(input, misfit, place->second));
  }
  return diagnostics;
}

namespace {

// Coarser in very large rooms, so that the raster has at most 400 cells a side.
constexpr double kCell_m = 0.05;
constexpr double kMostCells = 400;

// Cells as squares; one is free when its centre, grown by half a cell, is.
class FreeRaster {
 public:
  FreeRaster(const Scene& scene, const KeepOut& keep_out, std::span<const int> standing, const Layout& layout)
      : box_(BoundsOf(scene.room.floor)),
        cell_m_(std::max(kCell_m, std::max(box_.width_m(), box_.height_m()) / kMostCells)),
        columns_(static_cast<int>(box_.width_m() / cell_m_)),
        rows_(static_cast<int>(box_.height_m() / cell_m_)),
        free_(static_cast<size_t>(columns_) * rows_, 1) {
    TakeFloor(scene.room.floor);
    for (const ConvexPiece& area : keep_out.door_areas()) TakeAway(Polygon{area.vertices});
    for (int object : standing) Clear(scene.objects[object].footprint, layout[object]);
  }

  // The largest rectangle under the histogram of each row, by a stack of rising columns.
  FreePlace Largest() const {
    FreePlace best;
    std::vector<int> height(columns_ + 1, 0), open;
    for (int row = 0; row < rows_; ++row) {
      for (int c = 0; c < columns_; ++c) height[c] = free_[At(row, c)] ? height[c] + 1 : 0;
      open.clear();
      for (int c = 0; c <= columns_; ++c) {
        while (!open.empty() && height[open.back()] >= height[c]) {
          const int tall = height[open.back()];
          open.pop_back();
          Offer(tall, open.empty() ? c : c - open.back() - 1, best);
        }
        open.push_back(c);
      }
    }
    return best;
  }

 private:
  size_t At(int row, int column) const { return static_cast<size_t>(row) * columns_ + column; }
  Vec2<double> CenterOf(int row, int column) const {
    return {box_.min.x + (column + 0.5) * cell_m_, box_.min.y + (row + 0.5) * cell_m_};
  }
  // Cells [first, last) of a row or column that may hold points from `low_m` to `high_m`; two more at either end.
  struct Range {
    int first, last;
  };
  Range Cells(double low_m, double high_m, int count) const {
    const auto cell = [&](double at) { return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(count))); };
    return {cell(low_m / cell_m_ - 2), cell(high_m / cell_m_ + 2)};
  }
  void TakeFloor(const Polygon& floor) {
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_;) {
        const Vec2<double> p = CenterOf(row, column);
        const char free = Contains(floor, p) ? 1 : 0;
        // No side of the floor is nearer than this: so many cells have the same answer.
        const int same = std::max(1, static_cast<int>(std::abs(SignedDistance(floor, p)) / cell_m_) - 1);
        for (const int end = std::min(columns_, column + same); column < end; ++column) free_[At(row, column)] = free;
      }
    }
  }
  void TakeAway(const Polygon& area) {
    const BoundingBox box = BoundsOf(area);
    const Range rows = Cells(box.min.y - box_.min.y, box.max.y - box_.min.y, rows_);
    const Range columns = Cells(box.min.x - box_.min.x, box.max.x - box_.min.x, columns_);
    for (int row = rows.first; row < rows.last; ++row) {
      for (int column = columns.first; column < columns.last; ++column) {
        if (Contains(area, CenterOf(row, column))) free_[At(row, column)] = 0;
      }
    }
  }
  void Clear(const Footprint& footprint, const Pose<double>& pose) {
    const Frame<double> frame = FrameOf(pose);
    const double half = cell_m_ / 2 * (std::abs(frame.right.x) + std::abs(frame.right.y)) - 1e-9;
    const double reach_m = CircumscribedRadius(footprint), x = pose.x_m - box_.min.x, y = pose.y_m - box_.min.y;
    const Range rows = Cells(y - reach_m, y + reach_m, rows_), columns = Cells(x - reach_m, x + reach_m, columns_);
    for (int row = rows.first; row < rows.last; ++row) {
      for (int column = columns.first; column < columns.last; ++column) {
        const Vec2<double> local = frame.ToObject(CenterOf(row, column));
        const bool covered =
            std::abs(local.x) < footprint.width_m / 2 + half && std::abs(local.y) < footprint.depth_m / 2 + half;
        if (covered) free_[At(row, column)] = 0;
      }
    }
  }
  void Offer(int rows, int columns, FreePlace& best) const {
    const double a = rows * cell_m_, b = columns * cell_m_;
    if (a * b > best.long_m * best.short_m) best = {std::max(a, b), std::min(a, b)};
  }

  BoundingBox box_;
  double cell_m_;
  int columns_, rows_;
  std::vector<char> free_;
};

}  // namespace

FreePlace LargestFreePlace(const Scene& scene, const KeepOut& keep_out, std::span<const int> standing,
                           const Layout& layout) {
  return FreeRaster(scene, keep_out, standing, layout).Largest();
}

}  // namespace flair::optimizer
