// SPDX-License-Identifier: GPL-3.0-or-later
// Counts what a solve does, stage by stage. A layout's own account holds only the branch that won.
#pragma once

#include <array>
#include <cstdint>
#include <mutex>

#include "optimizer_worker/stages/stage.h"

namespace flair::cli {

struct StageTally {
  int64_t restarts = 0;
  int64_t evaluations = 0;
  // CPU time of the threads that called; all of it when the solve has one thread.
  double cpu_s = 0;
};

inline constexpr std::array kStages = {optimizer::StageKind::kPrimary, optimizer::StageKind::kSecondary,
                                       optimizer::StageKind::kPolish, optimizer::StageKind::kTertiary};

// Runs restarts on this process's threads. Thread-safe.
class CountingRunner final : public optimizer::RestartRunner {
 public:
  absl::StatusOr<std::vector<optimizer::RestartResult>> Run(const optimizer::SolveInput& input,
                                                            const optimizer::StageSpec& stage,
                                                            const optimizer::PartialLayout& before, int first,
                                                            int count) const override;
  // In the order of kStages.
  std::array<StageTally, kStages.size()> Tallies() const;

 private:
  const optimizer::LocalRestartRunner local_;
  mutable std::mutex mutex_;
  mutable std::array<StageTally, kStages.size()> tallies_;
};

}  // namespace flair::cli
