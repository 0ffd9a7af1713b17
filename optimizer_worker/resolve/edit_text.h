// SPDX-License-Identifier: GPL-3.0-or-later
// Edits as short lines, for command lines and tests:
//   move desk 1.2 0.5 [90]          centre, and heading in degrees counter-clockwise, 0 faces north (as it is when left
//   out) pin bed | unpin bed | remove plant_1 resize wardrobe 1.5x0.6[x2.1]   width x depth x height add lamp
//   0.4x0.4x1.5 [near sofa]    a free-standing object of the target's zone (the first zone without a target) weight e17
//   3 | drop e17 edge against_wall object=desk side=back [weight=2]     any type of the catalogue with its arguments
#pragma once

#include <string_view>

#include "absl/status/statusor.h"
#include "flair/v1/layout_edit.pb.h"
#include "flair/v1/solved_layout.pb.h"

namespace flair::optimizer {

// `layout` tells poses and zones. INVALID_ARGUMENT says what the line should look like; whether the objects and edges
// exist is for ResolveLayout to say.
absl::StatusOr<v1::LayoutEdit> EditFromText(std::string_view line, const v1::SolvedLayout& layout);

}  // namespace flair::optimizer
