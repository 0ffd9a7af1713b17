// SPDX-License-Identifier: GPL-3.0-or-later
// Edits of a layout, applied to its problem: what is to be solved afterwards, and what the edits are about.
#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/layout_edit.pb.h"
#include "flair/v1/solved_layout.pb.h"
#include "optimizer_worker/stages/leave_out.h"

namespace flair::optimizer {

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

}  // namespace flair::optimizer
