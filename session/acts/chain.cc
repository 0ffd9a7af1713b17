// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/acts/chain.h"

#include <utility>

#include "session/layouts/edits.h"

namespace flair::session {

Standing Chain::standing() const {
  if (!any_) return first_;
  return {acted_.layout,
          acted_.anew    ? nullptr
          : was_settled_ ? &settled_
                         : first_.settled,
          acted_.pending, acted_.by_hand};
}

void Chain::Add(Acted acted) {
  acted.diagnostics.insert(acted.diagnostics.begin(), acted_.diagnostics.begin(), acted_.diagnostics.end());
  if (acted.settled) {
    settled_ = acted.layout;
    was_settled_ = true;
  }
  acted_ = std::move(acted);
  any_ = true;
}

Acted Chain::Take() {
  // What was solved on the way is kept nowhere: the next solve goes on from the end.
  if (was_settled_ && !acted_.settled) {
    acted_.settled = true;
    acted_.pending.Clear();
  }
  acted_.moved_ids = MovedIds(first_.shown, acted_.layout);
  return std::move(acted_);
}

}  // namespace flair::session
