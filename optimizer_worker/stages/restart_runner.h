// SPDX-License-Identifier: GPL-3.0-or-later
// Where the restarts of a stage run: on this process's threads, or spread over other optimizers as well.
#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "optimizer_worker/stages/stage.h"

namespace flair::optimizer {

class RestartRunner {
 public:
  virtual ~RestartRunner() = default;
  // As RunRestarts, whose results it must give bit for bit. Thread-safe.
  virtual absl::StatusOr<std::vector<RestartResult>> Run(const SolveInput& input, const StageSpec& stage,
                                                         const PartialLayout& before, int first, int count) const = 0;
};

// Runs them on the settings' threads.
class LocalRestartRunner final : public RestartRunner {
 public:
  absl::StatusOr<std::vector<RestartResult>> Run(const SolveInput& input, const StageSpec& stage,
                                                 const PartialLayout& before, int first, int count) const override {
    return RunRestarts(input, stage, before, first, count);
  }
};

}  // namespace flair::optimizer
