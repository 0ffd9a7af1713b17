// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/fanout/range_plan.h"

#include <algorithm>

namespace flair::optimizer {

RangePlan::RangePlan(int first, int count, int range_size, int own_takers) : own_takers_(own_takers) {
  for (int done = 0; done < count; done += range_size) {
    pieces_.push_back(
        {{static_cast<int>(pieces_.size()), first + done, std::min(range_size, count - done)}, {}, false});
  }
  unfinished_ = pieces_.size();
}

bool RangePlan::IsRunHere(const Piece& piece) const {
  return !piece.takers.empty() && *piece.takers.begin() < own_takers_;
}

std::optional<RangePlan::Range> RangePlan::Take(int taker) {
  for (size_t most_takers : {size_t{0}, size_t{1}}) {
    for (Piece& piece : pieces_) {
      if (piece.finished || piece.takers.size() > most_takers || piece.takers.count(taker) != 0) continue;
      piece.takers.insert(taker);
      return piece.range;
    }
  }
  if (taker >= own_takers_) return std::nullopt;
  for (Piece& piece : pieces_) {
    if (piece.finished || IsRunHere(piece)) continue;
    piece.takers.insert(taker);
    return piece.range;
  }
  return std::nullopt;
}

bool RangePlan::Finish(const Range& range, int taker) {
  Piece& piece = pieces_[static_cast<size_t>(range.index)];
  piece.takers.erase(taker);
  if (piece.finished) return false;
  piece.finished = true;
  --unfinished_;
  return true;
}

void RangePlan::GiveUp(const Range& range, int taker) { pieces_[static_cast<size_t>(range.index)].takers.erase(taker); }

}  // namespace flair::optimizer
