// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/counting_runner.h"

#include "cli/bench/statistics.h"

namespace flair::cli {

absl::StatusOr<std::vector<optimizer::RestartResult>> CountingRunner::Run(const optimizer::SolveInput& input,
                                                                          const optimizer::StageSpec& stage,
                                                                          const optimizer::PartialLayout& before,
                                                                          int first, int count) const {
  const double started = ThreadCpu_s();
  absl::StatusOr<std::vector<optimizer::RestartResult>> results = local_.Run(input, stage, before, first, count);
  const double cpu_s = ThreadCpu_s() - started;
  if (!results.ok()) return results;
  const std::lock_guard lock(mutex_);
  StageTally& tally = tallies_[static_cast<size_t>(stage.kind)];
  tally.cpu_s += cpu_s;
  tally.restarts += static_cast<int64_t>(results->size());
  for (const optimizer::RestartResult& result : *results) tally.evaluations += result.evaluations;
  return results;
}

std::array<StageTally, kStages.size()> CountingRunner::Tallies() const {
  const std::lock_guard lock(mutex_);
  return tallies_;
}

}  // namespace flair::cli
