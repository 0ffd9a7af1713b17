// SPDX-License-Identifier: GPL-3.0-or-later
// How far one rectangle sticks out over another.
#pragma once

#include "optimizer_worker/autodiff/smooth.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

// Sum over the corners of `object` of the squared distances beyond the sides of `carrier`, in the carrier's frame [m2].
template <typename T>
T SquaredSticksOut(const Footprint& object, const Frame<T>& frame, const Footprint& carrier,
                   const Frame<T>& carrier_frame) {
  T sum(0.0);
  for (const Vec2<T>& corner : Corners(object, frame)) {
    const Vec2<T> p = carrier_frame.ToObject(corner);
    sum += SquaredOutside(p.x, -carrier.width_m / 2, carrier.width_m / 2) +
           SquaredOutside(p.y, -carrier.depth_m / 2, carrier.depth_m / 2);
  }
  return sum;
}

}  // namespace flair::optimizer
