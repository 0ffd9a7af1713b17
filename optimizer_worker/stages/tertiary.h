// SPDX-License-Identifier: GPL-3.0-or-later
// Stage "tertiary": rugs, wall pieces, ceiling pieces and things on other things, with all floor objects fixed.
#pragma once

#include "optimizer_worker/stages/stage.h"

namespace flair::optimizer {

// Most tertiaries hang on one constraint and meet others only where they would overlap, so each is placed by itself and
// swept until nothing changes, instead of in one large descent. Ends exactly: wall pieces flush on a wall, things on
// tops inside their host, rugs and lamps inside the room.
RestartResult TertiaryRestart(const SolveInput& input, const StageSpec& stage, const PartialLayout& before,
                              int restart);

// What a surface object stands on: its host, or the placed floor object under its centre; -1 when there is none.
int CarrierOf(const Scene& scene, int object, const PartialLayout& state);

// Whether an object is no larger than the top of `carrier`, one way round or the other.
bool FitsOn(const Scene& scene, int object, int carrier);

}  // namespace flair::optimizer
