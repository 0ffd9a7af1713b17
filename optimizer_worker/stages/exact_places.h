// SPDX-License-Identifier: GPL-3.0-or-later
// Where a tertiary may be so that it exactly touches what is beside it: the finitely many places among which a packing
// is searched.
#pragma once

#include <span>
#include <vector>

#include "optimizer_worker/stages/solve_input.h"

namespace flair::optimizer {

struct PlaceContext {
  const SolveInput& input;
  // Poses of what is placed.
  const Layout& layout;
  // What may be in the object's way.
  std::span<const int> others;
  // What a surface object stands on; -1 when nothing carries it.
  int carrier = -1;
  // Where it would be without the others.
  Pose<double> wanted;
};

// On a wall: backs flush on every wall that is wide enough, inside it and off its openings; offsets from its ends and
// middle, openings, partners, the others' edges and the wanted place. On a top: along it at its quarter turn and the
// next, not beyond its edges unless the object is larger (then 0.1 m of it stays on); at its middle, quarters and
// edges, the others' edges and middles, the wanted place. Under the ceiling, and where nothing carries it: the
// same with the room. Inside the room to
// 1e-7 m. Places may still be in the way of others. Empty for objects that stand on the floor.
std::vector<Pose<double>> ExactPlaces(const PlaceContext& context, int object);

}  // namespace flair::optimizer
