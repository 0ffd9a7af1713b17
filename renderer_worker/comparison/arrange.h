// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "renderer_worker/comparison/comparison.h"
#include "renderer_worker/drawing/sheet.h"

namespace flair::renderer {

// Where everything lies on the paper, in S.
struct ComparisonSheet {
  Sheet paper;                // its plan_mm is where the panels are
  std::vector<Sheet> panels;  // one each, all of one scale; side_mm is where the caption goes
  Box list_mm;                // of changes; without height when there are none
  Box foot_mm;                // scale and signs
};

// The way up and the rows of panels with which all plans are drawn largest, at the given or else at the largest common
// scale. INVALID_ARGUMENT when they fit at none.
absl::StatusOr<ComparisonSheet> ArrangeComparison(const Comparison& comparison, const v1::RenderOptions& options);

}  // namespace flair::renderer
