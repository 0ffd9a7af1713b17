// SPDX-License-Identifier: GPL-3.0-or-later
// Runs restarts on this process's threads and on other optimizers at once.
#pragma once

#include "flair/v1/optimizer_service.pb.h"
#include "optimizer_worker/fanout/peer_pool.h"
#include "optimizer_worker/stages/restart_runner.h"

namespace flair::optimizer {

// Cuts the restarts into pieces that own threads and peers take one after the other. A piece of a peer that fails goes
// to somebody else, and whoever is idle repeats a piece that is still out, so neither a dead nor a slow peer holds the
// solve up or fails it. Restarts do not depend on where they run, so the results are those of RunRestarts bit for bit.
// Fewer than kLeastRestarts are not worth the graph's way over the network, and neither is a solve with a time limit,
// which is a promise of this process alone: these run here.
class FanOutRestartRunner final : public RestartRunner {
 public:
  static constexpr int kLeastRestarts = 6;

  // `options` as they came with the request. Both are borrowed and must outlive the runner.
  FanOutRestartRunner(PeerPool& pool, const v1::SolveOptions& options) : pool_(pool), options_(options) {}
  absl::StatusOr<std::vector<RestartResult>> Run(const SolveInput& input, const StageSpec& stage,
                                                 const PartialLayout& before, int first, int count) const override;

 private:
  PeerPool& pool_;
  const v1::SolveOptions& options_;
};

}  // namespace flair::optimizer
