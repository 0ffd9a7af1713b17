// SPDX-License-Identifier: GPL-3.0-or-later
// Improves a layout from where it stands, moving only what has to move: begins with the objects that an edit is about
// and grows outwards, to what collides with them and what their moves have spoiled, while anything is left to repair.
#pragma once

#include <map>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/v1/solved_layout.pb.h"
#include "optimizer_worker/resolve/layout_state.h"
#include "optimizer_worker/stages/solve_input.h"
#include "optimizer_worker/stages/stage.h"

namespace flair::optimizer {

// What stands into something else or out of the room by less than this stands well.
inline constexpr double kFits_m = 1e-6;

struct WarmStart {
  // Where everything stands; objects without a pose are placed.
  PartialLayout state;
  // Where they stood before the edits. What stands on an object follows it from there.
  PartialLayout before;
  // Objects that may move from the beginning, ascending; pinned ones are skipped.
  std::vector<int> touched;
  Baseline baseline;
  // What things stood on that is gone, by what stood on it.
  std::map<int, Object> lost_carriers = {};
};

struct WarmResult {
  PartialLayout state;
  std::vector<v1::StageOutcome> outcomes;
  std::vector<absl::Duration> durations;
};

// Objects that no round frees keep their poses bit for bit. Deterministic. CANCELLED when the caller has gone.
absl::StatusOr<WarmResult> SearchWarm(const SolveInput& input, const WarmStart& start);

}  // namespace flair::optimizer
