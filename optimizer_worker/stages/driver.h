// SPDX-License-Identifier: GPL-3.0-or-later
// Takes a problem through the stages in order: primaries, secondaries zone by zone, polish, tertiaries. The best few
// primary layouts are furnished to the end, and the best of those wins.
#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/v1/solved_layout.pb.h"
#include "optimizer_worker/stages/restart_runner.h"
#include "optimizer_worker/stages/solve_input.h"
#include "optimizer_worker/stages/stage.h"

namespace flair::optimizer {

// One way through the stages so far.
struct Branch {
  PartialLayout state;
  // Cost of the floor objects, and what bad walkability is worth.
  double score = 0;
  std::vector<v1::StageOutcome> outcomes;
  // Wall time per outcome.
  std::vector<absl::Duration> durations;
};

class Driver {
 public:
  // Borrows both; they must outlive it.
  Driver(const SolveInput& input, const RestartRunner& runner) : input_(input), runner_(runner) {}

  // The branches, best first; the first has all stages. CANCELLED when the caller has gone, and the runner's errors.
  absl::StatusOr<std::vector<Branch>> Run() const;

 private:
  int RestartsOf(const StageSpec& stage) const;
  void Record(Branch& branch, const StageSpec& stage, const std::vector<RestartResult>& results, size_t taken,
              absl::Time started) const;
  absl::StatusOr<std::vector<Branch>> Primaries() const;
  absl::Status Extend(Branch& branch, StageKind kind, int zone) const;

  const SolveInput& input_;
  const RestartRunner& runner_;
};

}  // namespace flair::optimizer
