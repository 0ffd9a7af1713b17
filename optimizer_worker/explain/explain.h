// SPDX-License-Identifier: GPL-3.0-or-later
// Why a call does not hold, in the terms of its sentence: what was measured, and what would be right.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "flair/v1/layout_graph.pb.h"
#include "optimizer_worker/constraints/linked_pairs.h"
#include "room/scene/scene.h"

namespace flair::optimizer {

// The part of a call that is missed by most.
struct Shortfall {
  // "the desk is 0.92 m from the window, at most 0.50 m". No capital, no full stop.
  std::string sentence;
  double missed_by = 0;
  // "m" or "deg".
  std::string unit;
};

// What a call is measured in.
struct Furnished {
  const Scene& scene;
  const Layout& layout;
  // Mean point of each zone.
  std::span<const Vec2<double>> zone_centers;
  // As for BindContext.
  const LinkedPairs* linked = nullptr;
};

// For a call that binds and whose objects all have poses; in general terms for a type without words of its own. nullopt
// when its cost is 0, when no measure of it is off by more than 1 mm or 0.1 degrees, and for whole-room terms. Pure;
// safe to call from several threads.
std::optional<Shortfall> Explain(const v1::ConstraintEdge& edge, const Furnished& where);

// "the desk"; "dining chair 2" when the scene has several of that name.
std::string NameForPeople(const Scene& scene, int object);

}  // namespace flair::optimizer
