// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "renderer_worker/drawing/canvas.h"
#include "renderer_worker/drawing/plan.h"
#include "renderer_worker/drawing/sheet.h"

namespace flair::renderer {

// A free distance inside the room: straight ahead from the middle of a large piece's front to the next solid piece or
// wall. Room frame R.
struct Clearance {
  Point from_m;
  Point to_m;
  double length_m = 0;
};

// The key clearances of [0.35, 2.5] m, of the largest pieces first, at most eight; of two that run beside each other
// over the same floor only one. None when the layer of dimensions is not drawn.
std::vector<Clearance> FindClearances(const Plan& plan);

// Those of them that are long enough on this paper to carry their number.
std::vector<Clearance> ShownClearances(const Plan& plan, const Sheet& sheet);

// The paper that the number of a clearance takes.
Box ClearanceTextBox(const Canvas& canvas, const Sheet& sheet, const Clearance& clearance);

void DrawClearances(Canvas& canvas, const Plan& plan, const Sheet& sheet);

}  // namespace flair::renderer
