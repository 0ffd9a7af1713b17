// SPDX-License-Identifier: GPL-3.0-or-later
// Deals a range of restarts out in pieces to takers of unknown speed, some of which die. Decides only; runs nothing,
// waits for nothing, knows no clock. Not thread-safe.
#pragma once

#include <optional>
#include <set>
#include <vector>

namespace flair::optimizer {

class RangePlan {
 public:
  // Restarts [first, first + count).
  struct Range {
    int index = 0;
    int first = 0;
    int count = 0;
  };

  // Cuts [first, first + count) into pieces of `range_size`, the last may be shorter; all arguments positive but
  // `first`, which is >= 0.
  RangePlan(int first, int count, int range_size);

  // What `taker` should run now: a piece that nobody runs; when there is none, the oldest unfinished one that a single
  // other taker runs, so that a slow taker holds nobody up. nullopt: nothing at the moment.
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

  std::vector<Piece> pieces_;
  size_t unfinished_;
};

}  // namespace flair::optimizer
