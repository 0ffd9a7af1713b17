// SPDX-License-Identifier: GPL-3.0-or-later
// What cannot be: furniture that does not fit, what is left out for it, and constraints that cannot hold together.
#pragma once

#include <set>
#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/layout_graph.pb.h"
#include "flair/v1/provenance.pb.h"
#include "flair/v1/solved_layout.pb.h"
#include "optimizer_worker/solver/separation.h"
#include "optimizer_worker/stages/driver.h"
#include "optimizer_worker/stages/solve_input.h"
#include "optimizer_worker/stages/stage.h"
#include "room/scene/scene.h"

namespace flair::optimizer {

// What does not fit in a layout, in words: which object, in the way of what, by how much.

// By how much an object that may not be in the way is in the way, of another object or (`other` < 0) of the room.
struct Misfit {
  int object = -1;
  int other = -1;
  // "overlaps", "reaches out of the room" ...
  std::string what;
  double depth_m = 0;
};

// All that are deeper than 1e-6 m: floor objects against each other, the room and its doors; wall, ceiling and surface
// objects and rugs by their hard costs. `other`, when there is one, comes before `object` in the scene.
std::vector<Misfit> FindMisfits(const SolveInput& input, const SceneCosts& costs, const PartialLayout& state);

// One "does_not_fit" per misfit ("pinned_collides" where only pins could cure it), and one "not_placed" per object
// without a pose. Names the object with its size, the culprit, and the largest free place.
std::vector<v1::Diagnostic> FitDiagnostics(const SolveInput& input, const SceneCosts& costs,
                                           const PartialLayout& state);

// "no free place of 1.60 m x 0.90 m; the largest free one is 1.20 m x 0.80 m": for a floor object, with what else is
// placed as it stands.
std::string NoFreePlace(const SolveInput& input, const PartialLayout& state, int object);

// The largest empty place on the floor of a furnished room.
struct FreePlace {
  // Long and short side; 0 when the floor is full.
  double long_m = 0;
  double short_m = 0;
};

// The rectangle of largest area, along the axes, that holds no solid object of `standing`, no door's swing and nothing
// outside the floor. Accurate to the raster of 0.05 m, on the safe side: what is found is free.
FreePlace LargestFreePlace(const Scene& scene, const KeepOut& keep_out, std::span<const int> standing,
                           const Layout& layout);

// Misfits left out: what cannot stand in a room with the rest does not have to.

// Takes the fewest and least important objects out of a layout so that nothing is in anything's way any more:
// tertiaries first, then secondaries, then those that the brief asked for, primaries last, pinned ones never; what is
// carried by one that goes, goes with it. Notes each with its reason.
void LeaveOutOf(const SolveInput& input, Branch& branch);

// The same for the best of `branches`, then solves the rest anew and puts back, most important first, what fits after
// all: sometimes everything. Other complete branches lose what does not fit in them. Nothing stays out for something
// less important that fits only without it. Returns `branches` when everything fits. Errors as Driver::Run.
absl::StatusOr<std::vector<Branch>> SolveWithoutMisfits(const SolveInput& input, const RestartRunner& runner,
                                                        std::vector<Branch> branches);

// Leaves out spare objects (Object.spare) that do not stand as their own sentences want it by 0.15 m or more, do not fit,
// or keep another object from what it needs, with what they carry and what is placed by them; then solves the rest anew
// and keeps that when its calls hold no worse. Objects that carry, or place, what is to stay are not spare. Errors as
// Driver::Run.
absl::StatusOr<std::vector<Branch>> SolveWithoutBadSpares(const SolveInput& input, const RestartRunner& runner,
                                                          std::vector<Branch> branches);

using IdSet = std::set<std::string, std::less<>>;

// Takes objects out of a graph with all that refers to them: edges that name them (one that lists several objects only
// loses the name), pins, hosts, sentences' subjects and styles. Returns a diagnostic per edge changed or taken out.
std::vector<v1::Diagnostic> RemoveObjects(const IdSet& ids, v1::LayoutGraph& graph);

// Constraints that cannot hold together: why a violated one is violated.

// For each violated edge of `layout` (the result for input.graph) a minimal group of edges that cannot hold together,
// by deletion: the edge and the satisfied edges on its objects are solved for these objects alone, in the room with its
// pins; while they cannot hold, edges are left out one by one, and those without which they still cannot stay out. A
// group of one cannot hold in this room at all. No group is found where other furniture is in the way, where only more
// distant edges clash, or for edges about zones, which depend on everything.
//
// "Cannot hold" is what a bounded search finds: kHoldRestarts starts per stage, as deterministic as a solve. At most
// kMostTrials searches in all; violated edges are taken in the graph's order. Stops early when cancelled or out of
// time.
std::vector<v1::Contradiction> FindContradictions(const SolveInput& input, const v1::SolvedLayout& layout);

inline constexpr int kHoldRestarts = 4;
inline constexpr int kMostTrials = 150;

}  // namespace flair::optimizer
