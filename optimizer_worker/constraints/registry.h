// SPDX-License-Identifier: GPL-3.0-or-later
// The library of constraints: finds a type by name or alias, checks the arguments of a call, binds it to a scene.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "absl/status/statusor.h"
#include "flair/v1/constraint_catalog.pb.h"
#include "flair/v1/layout_graph.pb.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/linked_pairs.h"
#include "room/geometry/pose.h"
#include "room/scene/scene.h"

namespace flair::optimizer {

struct ConstraintFacts;
struct ConstraintLibrary;

// What a call is bound to. The scene must outlive the Bind call only; costs copy what they need.
struct BindContext {
  const Scene& scene;
  // Mean point of each zone, in the order of Scene::zones. Costs copy them: bind again when they move.
  std::span<const Vec2<double>> zone_centers;
  // Pairs that belong together, so that a chair does not block its own desk; null means none.
  const LinkedPairs* linked = nullptr;
};

// The cost of one call, without its weight. Fails with INVALID_ARGUMENT (unknown type, missing, unknown or ill-typed
// argument, value out of range), NOT_FOUND (unknown object, zone or wall) or FAILED_PRECONDITION (the room has no such
// feature, or the objects are of a kind the type cannot serve); the message names the argument and what would be right.
absl::StatusOr<std::unique_ptr<Cost>> Bind(const v1::ConstraintEdge& edge, const BindContext& context);

// FAILED_PRECONDITION when nothing stands in the zone.
absl::Status CheckHasPlace(const BindContext& context, int zone);

// Objects that a call names, ascending, each once; those it merely reads as obstacles are not among them. Empty when
// the call is not valid.
std::vector<int> NamedObjects(const v1::ConstraintEdge& edge, const Scene& scene);

// What the program has, see facts.h; the types sorted by name. Stays valid.
const ConstraintLibrary& Library();

// Its types.
std::span<const ConstraintFacts> AllConstraints();

// By name or alias; null when there is none.
const ConstraintFacts* FindConstraint(std::string_view name);

// The whole library as published by RPC. Built once; the reference stays valid.
const v1::ConstraintCatalog& MakeCatalog();

}  // namespace flair::optimizer
