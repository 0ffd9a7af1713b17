// SPDX-License-Identifier: GPL-3.0-or-later
// One solve's problem and settings, worked out once from the messages.
#pragma once

#include <cstdint>
#include <functional>
#include <future>
#include <span>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "evaluation/metrics/walk_grid.h"
#include "flair/v1/layout_graph.pb.h"
#include "flair/v1/optimizer_service.pb.h"
#include "optimizer_worker/constraints/linked_pairs.h"
#include "optimizer_worker/solver/problem.h"
#include "optimizer_worker/solver/separation.h"
#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/groups.h"
#include "room/scene/scene.h"

namespace flair::optimizer {

// How to solve, with every default filled in.

// The paper's factors of the whole-room terms; names as in flair.v1.Lambdas.
struct LambdaValues {
  double door_overlap = 100;
  double wall_attraction_divisor = 20;
  double no_overlap = 5;
  double balanced = 10;
  double in_bounds = 10;
  double zone = 10;
  double tertiary_in_bounds = 500;
  double on_wall = 500;
};

// When a descent along the gradient ends; names as in flair.v1.Tolerances.
struct ToleranceValues {
  double relative = 1e-4;
  double absolute = 1e-5;
  int max_evaluations = 60;
};

struct SolveSettings {
  uint64_t seed = 0;
  // 0: each stage's own number.
  int max_restarts = 0;
  int threads = 1;
  double path_width_m = 0.6;
  LambdaValues lambdas;
  ToleranceValues tolerances;
  int variant_count = 1;
  // Objects that do not fit are left out instead of kept where they are least bad.
  bool leave_out_misfits = false;
  // Search for groups of constraints that cannot hold together.
  bool find_contradictions = false;
  // What is used together is placed as one piece first; else in the paper's order.
  bool groups = true;
  // Of wall time; infinite when the result may depend on no clock.
  absl::Duration time_limit = absl::InfiniteDuration();
};

// The settings with defaults filled in. INVALID_ARGUMENT names the field, its value and what would be right.
absl::StatusOr<SolveSettings> ReadSettings(const v1::SolveOptions& options);

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
  // Of the empty room, made when first asked for: a verdict needs none. Any thread may ask.
  std::shared_future<evaluation::WalkGrid> walk_grid;
  // For layouts that are exact already: a search on the coarse grid finds the gaps of 0.55 m that it passes for ways.
  std::shared_future<evaluation::WalkGrid> fine_walk_grid;
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

// The same with the edges of `graph`, which must outlive the result: other calls of single objects, all else being
// alike. Nothing is measured anew, and the time limit runs on.
SolveInput WithEdgesOf(const v1::LayoutGraph& graph, const SolveInput& input);

// Mean centre of the placed floor objects of each zone; far outside the room for a zone that has none. Rugs and
// tertiaries do not count.
std::vector<Vec2<double>> ZoneCenters(const Scene& scene, std::span<const char> placed, const Layout& layout);
inline constexpr double kEmptyZone_m = 1e6;

}  // namespace flair::optimizer
