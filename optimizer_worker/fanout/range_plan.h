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
