// SPDX-License-Identifier: GPL-3.0-or-later
// Runs restarts on this process's threads and on other optimizers at once.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "flair/v1/optimizer_service.pb.h"
#include "optimizer_worker/fanout/peer_pool.h"
#include "optimizer_worker/stages/stage.h"

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

// Deals a range of restarts out in pieces to takers of unknown speed, some of which die. Decides only; runs nothing,
// waits for nothing, knows no clock. Not thread-safe.
class RangePlan {
 public:
  // Restarts [first, first + count).
  struct Range {
    int index = 0;
    int first = 0;
    int count = 0;
  };

  // Cuts [first, first + count) into pieces of `range_size`, the last may be shorter; all positive but `first`, which
  // is
  // >= 0. Takers below `own_takers` are this process's threads, which always come back; the others are peers.
  RangePlan(int first, int count, int range_size, int own_takers);

  // What `taker` should run now: a piece that nobody runs; when there is none, the oldest unfinished one that a single
  // other taker runs, so that a slow taker holds nobody up; for an own thread then the oldest one that only peers run,
  // however many, so that any number of stuck peers holds nobody up. nullopt: nothing at the moment.
  std::optional<Range> Take(int taker);
  // `taker` has the results. True when they are the first ones for this piece.
  bool Finish(const Range& range, int taker);
  // `taker` will not finish; others may take the piece again.
  void GiveUp(const Range& range, int taker);

  bool done() const { return unfinished_ == 0; }

 private:
  struct Piece {
    Range range;
    std::set<int> takers;
    bool finished = false;
  };

  // Whether an own thread runs it.
  bool IsRunHere(const Piece& piece) const;

  std::vector<Piece> pieces_;
  const int own_takers_;
  size_t unfinished_;
};

}  // namespace flair::optimizer
