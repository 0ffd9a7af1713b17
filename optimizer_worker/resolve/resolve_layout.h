// SPDX-License-Identifier: GPL-3.0-or-later
// Solving again after edits: the layout as it stands, with as little moved as the edits ask for.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/v1/layout_edit.pb.h"
#include "flair/v1/optimizer_service.pb.h"
#include "flair/v1/solved_layout.pb.h"
#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/infeasible.h"
#include "optimizer_worker/stages/solve_input.h"

namespace flair::optimizer {

// Edits as short lines, for command lines and tests:
//
//   move desk 1.2 0.5 [90]               centre, and heading in degrees counter-clockwise, 0 faces north; left out: as
//                                        it is
//   pin bed | unpin bed | remove plant_1
//   resize wardrobe 1.5x0.6[x2.1]        width x depth x height
//   add lamp 0.4x0.4x1.5 [near sofa]     a free-standing object of the target's zone, else of the first zone
//   weight e17 3 | drop e17
//   edge against_wall object=desk side=back [weight=2]     any type of the catalogue with its arguments
//
// `layout` tells poses and zones. INVALID_ARGUMENT says what the line should look like; whether the objects and edges
// exist is for ResolveLayout to say.
absl::StatusOr<v1::LayoutEdit> EditFromText(std::string_view line, const v1::SolvedLayout& layout);

// Edits of a layout, applied to its problem: what is to be solved afterwards, and what the edits are about.
using EditList = google::protobuf::RepeatedPtrField<v1::LayoutEdit>;

struct EditedProblem {
  v1::LayoutGraph graph;
  // Where things stand at the start: added objects have no placement yet; resized ones keep their back where it was.
  std::vector<v1::Placement> placements;
  // Objects that an edit names, or that an edge names which was added, dropped or weighed anew. Ids.
  IdSet touched;
  // Ids of edges that were added, dropped or weighed anew.
  IdSet edited_edges;
  // What an edit took with it.
  std::vector<v1::Diagnostic> diagnostics;
};

// Applies the edits in their order. INVALID_ARGUMENT is "edits[i]...: value, and what would be right"; the graph that
// results validates, and all added edges can be bound.
absl::StatusOr<EditedProblem> ApplyEdits(const v1::SolvedLayout& layout, const EditList& edits);

struct ResolveResult {
  v1::SolvedLayout layout;
  // Objects that stand elsewhere than before or are new, in the graph's order.
  std::vector<std::string> moved_ids;
  // Wall time per entry of layout.stage_outcomes.
  std::vector<absl::Duration> stage_durations;
};

// Applies the edits and solves from the given placements. What the edits do not affect keeps its pose bit for bit. The
// result is exact as that of a solve is; when no way is found to make it so from where things stand, everything that is
// not pinned is solved anew. Bit-identical for equal arguments, unless options.time_limit is set. INVALID_ARGUMENT
// names the edit or the field; CANCELLED when `cancelled` says so.
absl::StatusOr<ResolveResult> ResolveLayout(const v1::SolvedLayout& layout, const EditList& edits,
                                            const v1::SolveOptions& options, const Solver& solver,
                                            const CancelCheck& cancelled = nullptr);

}  // namespace flair::optimizer
