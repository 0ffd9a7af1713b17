// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "renderer_worker/comparison/comparison.h"
#include "renderer_worker/drawing/canvas.h"
#include "renderer_worker/drawing/sheet.h"

namespace flair::renderer {

// Of the paper.
inline const Rgb kWhite = Hex(0xFFFFFF);

Rgb ColourOf(ChangeKind kind);

// Marks the panel's changes in its plan: outlines of what stands there now, dashed ones of where and how large it was,
// arrows between them. Numbers are drawn with the names.
void DrawMarks(Canvas& canvas, const ComparisonPanel& panel, const Sheet& sheet);

// A small picture of the mark, for the legend.
void DrawMarkSign(Canvas& canvas, ChangeKind kind, const Box& box);

// The numbers of changes, each at its object, and the names of other things where there is room in them.
void DrawNames(Canvas& canvas, const ComparisonPanel& panel, const Sheet& sheet);

// The number of a change as it stands in the plan and in the list.
void DrawChangeNumber(Canvas& canvas, const PlanChange& change, Point centre_mm);

}  // namespace flair::renderer
