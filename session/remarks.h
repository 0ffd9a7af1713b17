// SPDX-License-Identifier: GPL-3.0-or-later
// What a layout says of wishes that were not met, as acts answer them.
#pragma once

#include "session/layout_acts.h"

namespace flair::session {

// Forgets what an act has answered: sentences that ask for nothing any more, because they were dropped or their pieces
// are gone; remarks about those, about sentences that hold now and about pieces that are gone; and that a piece is
// missing which is there now. `before`: the graph that the act began with.
void ForgetWhatIsAnswered(const v1::LayoutGraph& before, v1::SolvedLayout& layout);

// A solve begins at an earlier graph than the one that is shown: what acts have forgotten since then stays forgotten.
void KeepForgotten(const v1::LayoutGraph& shown, v1::LayoutGraph& graph);

// Why a solve has moved nothing, in one sentence: what stands badly and what keeps it there, or that all is well.
v1::Diagnostic WhyNothingMoves(const Acted& acted);

}  // namespace flair::session
