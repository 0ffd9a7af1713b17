// SPDX-License-Identifier: GPL-3.0-or-later
// The largest empty place on the floor of a furnished room.
#pragma once

#include <span>

#include "optimizer_worker/solver/separation.h"
#include "room/scene/scene.h"

namespace flair::optimizer {

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
