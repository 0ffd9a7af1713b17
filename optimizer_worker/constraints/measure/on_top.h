// SPDX-License-Identifier: GPL-3.0-or-later
// How far one rectangle sticks out over another.
#pragma once

#include <cmath>

#include "optimizer_worker/autodiff/smooth.h"
#include "optimizer_worker/constraints/measure/convex_piece.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

// Sum over the corners of `object` of the squared distances beyond the sides of `carrier`, in the carrier's frame [m2].
template <typename T>
T SquaredSticksOut(const Footprint& object, const Frame<T>& frame, const Footprint& carrier,
                   const Frame<T>& carrier_frame) {
  const Box<T> box(object, frame);
  const Frame<double> carrier_value = ValueOf(carrier_frame);
  T sum(0.0);
  for (int i = 0; i < box.count(); ++i) {
    const Vec2<double> value = carrier_value.ToObject(box.value(i));
    const double w = carrier.width_m / 2, d = carrier.depth_m / 2;
    if (std::abs(value.x) <= w && std::abs(value.y) <= d) continue;
    const Vec2<T> p = carrier_frame.ToObject(box.vertex(i));
    sum += SquaredOutside(p.x, -w, w) + SquaredOutside(p.y, -d, d);
  }
  return sum;
}

}  // namespace flair::optimizer
