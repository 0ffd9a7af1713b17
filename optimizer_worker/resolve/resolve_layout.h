// SPDX-License-Identifier: GPL-3.0-or-later
// Solving again after edits: the layout as it stands, with as little moved as the edits ask for.
#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/v1/optimizer_service.pb.h"
#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/solve_input.h"

namespace flair::optimizer {

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
absl::StatusOr<ResolveResult> ResolveLayout(const v1::SolvedLayout& layout,
                                            const google::protobuf::RepeatedPtrField<v1::LayoutEdit>& edits,
                                            const v1::SolveOptions& options, const Solver& solver,
                                            const CancelCheck& cancelled = nullptr);

}  // namespace flair::optimizer
