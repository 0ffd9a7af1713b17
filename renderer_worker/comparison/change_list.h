// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "renderer_worker/comparison/comparison.h"
#include "renderer_worker/drawing/canvas.h"

namespace flair::renderer {

// What the list of all changes takes of paper of that width, millimetres; 0 when there are none.
double ChangeListHeight(const Comparison& comparison, double width_mm);

// Number, name and words of each, in columns; the last place says how many more there are.
void DrawChangeList(Canvas& canvas, const Comparison& comparison, const Box& box);

}  // namespace flair::renderer
