// SPDX-License-Identifier: GPL-3.0-or-later
// Improves a layout from where it stands, moving only what has to move: begins with the objects that an edit is about
// and grows outwards, to what collides with them and what their moves have spoiled, while anything is left to repair.
#pragma once

#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/v1/solved_layout.pb.h"
#include "optimizer_worker/stages/solve_input.h"
#include "optimizer_worker/stages/stage.h"

namespace flair::optimizer {

// What is wrong with a layout, for deciding what must move and whether a move has helped.

// What is no business of an edit.
struct Baseline {
  // Per edge of the graph: it held before the edits and has not been edited, so it should hold afterwards.
  std::vector<char> held;
  // Pairs (object, other or -1) that were in each other's way before.
  std::set<std::pair<int, int>> tolerated;
  // Of the floor, from the door; 0 when no way through the room counts.
  double reachable_share = 0;
};

// What an edit has made worse.
struct Violations {
  // Floor objects that collide, ascending, without pinned ones.
  std::vector<int> colliding;
  // Sum of the depths of their collisions.
  double depth_m = 0;
  // Edges (indices) that held before and do not now.
  std::vector<int> broken;
  // How much less of the floor can be reached from the door than before, in steps of 0.05.
  double unreachable_share = 0;
  // Wall, ceiling and surface objects and rugs that are in the way, without pinned ones.
  std::vector<int> astray;
};

Violations FindViolations(const SolveInput& input, const PartialLayout& state, const Baseline& baseline);

// Share of the free floor that can be reached from the door, [0, 1].
double ReachableShare(const SolveInput& input, const PartialLayout& state);

// The pairs that are in each other's way in `state`.
std::set<std::pair<int, int>> PairsInTheWay(const SolveInput& input, const PartialLayout& state);

// Cost of the stage's objects, as the stage reckons it; on the floor with the ways through the room and collisions.
double ScoreOf(const SolveInput& input, const StageSpec& stage, const PartialLayout& state);

// What goes along when an object moves.

// The pose of a rider that keeps its place relative to its carrier.
Pose<double> Carried(const Pose<double>& carrier_before, const Pose<double>& carrier_after, const Pose<double>& rider);

// Things that stood on one of `movers` in `before` keep their place on it in `after`, and so does what stands on them.
// Pinned things and those that are movers themselves do not follow.
void Follow(const SolveInput& input, const PartialLayout& before, std::span<const int> movers, PartialLayout& after);

// Puts a surface object whose carrier is gone on another piece of furniture that has room for it: the nearest of the
// name or category of what it stood on, else the nearest of a like kind: cushions go from seat to seat, books do not.
// Takes it out of the layout when there is none. `lost` is what it stood on, null when not known.
void PutOnLikeTop(const SolveInput& input, int object, const Object* lost, PartialLayout& state);

// Objects that an edge names, ascending.
std::vector<int> ObjectsOfEdge(const SolveInput& input, int edge);

// What stands into something else or out of the room by less than this stands well.
inline constexpr double kFits_m = 1e-6;

struct WarmStart {
  // Where everything stands; objects without a pose are placed.
  PartialLayout state;
  // Where they stood before the edits. What stands on an object follows it from there.
  PartialLayout before;
  // Objects that may move from the beginning, ascending; pinned ones are skipped.
  std::vector<int> touched;
  Baseline baseline;
  // What things stood on that is gone, by what stood on it.
  std::map<int, Object> lost_carriers = {};
};

struct WarmResult {
  PartialLayout state;
  std::vector<v1::StageOutcome> outcomes;
  std::vector<absl::Duration> durations;
};

// Objects that no round frees keep their poses bit for bit. Deterministic. CANCELLED when the caller has gone.
absl::StatusOr<WarmResult> SearchWarm(const SolveInput& input, const WarmStart& start);

}  // namespace flair::optimizer
