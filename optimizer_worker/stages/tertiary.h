// SPDX-License-Identifier: GPL-3.0-or-later
// Stage "tertiary": rugs, wall pieces, ceiling pieces and things on other things, with all floor objects fixed.
#pragma once

#include <span>
#include <vector>

#include "optimizer_worker/solver/problem.h"
#include "optimizer_worker/stages/solve_input.h"
#include "optimizer_worker/stages/stage.h"

namespace flair::optimizer {

// Stage "tertiary": rugs, wall pieces, ceiling pieces and things on other things, with all floor objects fixed.

// Most tertiaries hang on one constraint and meet others only where they would overlap, so each is placed by itself and
// swept until nothing changes, instead of in one large descent. Ends exactly: wall pieces flush on a wall, things on
// tops inside their host, rugs and lamps inside the room.
RestartResult TertiaryRestart(const SolveInput& input, const StageSpec& stage, const PartialLayout& before,
                              int restart);

// As of a scene.
inline int CarrierOf(const Scene& scene, int object, const PartialLayout& state) {
  return flair::CarrierOf(scene, object, state.layout, state.placed);
}

// A cloth, a tray: others may lie on it.
inline bool IsFlat(const Object& object) {
  constexpr double kFlat_m = 0.05;
  return object.kind == ObjectKind::kSurface && object.height_m <= kFlat_m;
}

// Whether an object is no larger than the top of `carrier`, one way round or the other.
bool FitsOn(const Scene& scene, int object, int carrier);

// Ends overlaps of things on tops, on walls and under the ceiling that pushing them apart has left.

// Takes what overlaps out, and what is in its way when that does not help, and searches the exact places
// depth first for the cheapest in which nothing overlaps: the least costs first, a bounded number of
// steps. Things stay on their tops; wall pieces may change walls. Where no such places are found nothing moves, but
// flat things (5 cm) may then lie under others. `problem` has the stage's objects placed. Deterministic.
void SeparateClusters(const SolveInput& input, const StageSpec& stage, Problem& problem, PartialLayout& state);

// Whether these two are in each other's way where they are. Flat things on tops are in nobody's way unless `strict`.
bool InTheWay(const Scene& scene, int a, int b, const Layout& layout, bool strict);

// Where a tertiary may be so that it exactly touches what is beside it: the finitely many places among which a packing
// is searched.

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
// next, not beyond its edges unless the object is larger (then its middle stays on); at its middle, quarters and
// edges, the others' edges and middles, the wanted place. Under the ceiling, and where nothing carries it: the
// same with the room. Inside the room to
// 1e-7 m. Places may still be in the way of others. Empty for objects that stand on the floor.
std::vector<Pose<double>> ExactPlaces(const PlaceContext& context, int object);

}  // namespace flair::optimizer
