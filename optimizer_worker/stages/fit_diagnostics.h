// SPDX-License-Identifier: GPL-3.0-or-later
// What does not fit in a layout, in words: which object, in the way of what, by how much.
#pragma once

#include <span>
#include <vector>

#include "flair/v1/provenance.pb.h"
#include "optimizer_worker/solver/separation.h"
#include "optimizer_worker/stages/scene_costs.h"
#include "optimizer_worker/stages/solve_input.h"
#include "optimizer_worker/stages/stage.h"
#include "room/scene/scene.h"

namespace flair::optimizer {

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

}  // namespace flair::optimizer
