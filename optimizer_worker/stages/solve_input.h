// SPDX-License-Identifier: GPL-3.0-or-later
// One solve's problem and settings, worked out once from the messages.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "evaluation/metrics/walk_grid.h"
#include "flair/v1/layout_graph.pb.h"
#include "optimizer_worker/constraints/linked_pairs.h"
#include "optimizer_worker/solver/problem.h"
#include "optimizer_worker/solver/separation.h"
#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/groups.h"
#include "optimizer_worker/stages/solve_settings.h"
#include "room/scene/scene.h"

namespace flair::optimizer {

// True when nobody waits for the answer any more; polled once per restart, from any thread.
using CancelCheck = std::function<bool()>;

// An object that stands where the user put it.
struct Pin {
  int object = -1;
  Pose<double> pose;
};

struct SolveInput {
  const v1::LayoutGraph& graph;
  Scene scene;
  SolveSettings settings;
  std::vector<Pin> pins;
  // Per object, whether it is pinned.
  std::vector<char> pinned;
  // Per object, the objects that edges name together with it, without repeats.
  std::vector<std::vector<int>> partners;
  // Pairs that belong together, for the costs.
  LinkedPairs linked;
  // What is placed together; none where pieces are placed one by one.
  Groups groups = {};
  KeepOut keep_out;
  evaluation::WalkGrid walk_grid;
  // For layouts that are exact already: a search on the coarse grid finds the gaps of 0.55 m that it passes for ways.
  evaluation::WalkGrid fine_walk_grid;
  const Solver& solver;
  CancelCheck cancelled;
  // True when the settings' time limit has passed since MakeSolveInput; then every stage ends as soon as it has one
  // result. Null when there is no limit.
  CancelCheck out_of_time;

  bool Cancelled() const { return cancelled && cancelled(); }
  bool OutOfTime() const { return out_of_time && out_of_time(); }
  // For searches: true when improving should end. Borrows this.
  StopCheck Over() const {
    if (!cancelled && !out_of_time) return nullptr;
    return [this] { return Cancelled() || OutOfTime(); };
  }
};

// `graph` and `solver` must outlive the result. INVALID_ARGUMENT when the graph does not validate.
absl::StatusOr<SolveInput> MakeSolveInput(const v1::LayoutGraph& graph, const v1::SolveOptions& options,
                                          const Solver& solver, CancelCheck cancelled);

// Mean centre of the placed floor objects of each zone; far outside the room for a zone that has none. Rugs and
// tertiaries do not count.
std::vector<Vec2<double>> ZoneCenters(const Scene& scene, std::span<const char> placed, const Layout& layout);
inline constexpr double kEmptyZone_m = 1e6;

}  // namespace flair::optimizer
