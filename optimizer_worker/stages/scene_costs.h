// SPDX-License-Identifier: GPL-3.0-or-later
// All terms of a scene: the graph's edges and the whole-room terms, with their weights.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "optimizer_worker/solver/problem.h"
#include "optimizer_worker/stages/solve_input.h"

namespace flair::optimizer {

enum class StageKind : int;
struct PartialLayout;
struct PartialLayout;

struct SceneCosts {
  std::vector<Term> terms;
  // Per edge: why it could not be bound; empty when it was.
  std::vector<std::string> dropped;
};

// Binds everything against the zones' present centres.
SceneCosts BindCosts(const SolveInput& input, std::span<const Vec2<double>> zone_centers);

// The same, where the zones are in a layout.
SceneCosts BindCosts(const SolveInput& input, const PartialLayout& state);

// Whether a stage counts a term at all: the balance of the room is the primaries' business, zones begin with the
// secondaries.
bool CountsIn(const Term& term, StageKind stage);

}  // namespace flair::optimizer
