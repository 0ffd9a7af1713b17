// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "renderer_worker/comparison/comparison.h"
#include "renderer_worker/drawing/canvas.h"
#include "renderer_worker/drawing/sheet.h"

namespace flair::renderer {

// The numbers of changes, each at its object, and the names of other things where there is room in them.
void DrawNames(Canvas& canvas, const ComparisonPanel& panel, const Sheet& sheet);

// The number of a change as it stands in the plan and in the list.
void DrawChangeNumber(Canvas& canvas, const PlanChange& change, Point centre_mm);

}  // namespace flair::renderer
