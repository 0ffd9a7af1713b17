// SPDX-License-Identifier: GPL-3.0-or-later
// The sentences of a layout: which ones do not hold, how they pass from one graph to another, and which are forgotten.
#pragma once

#include <string>

#include "session/layouts/lists.h"

namespace flair::session {

// Sentences with an edge that does not hold, as a set; and why the first of `sentence_ids` does not, empty when all do.
IdSet UnmetSentences(const v1::SolvedLayout& layout);
std::string WhyUnmet(const v1::SolvedLayout& layout, const IdSet& sentence_ids);

// Of these sentences, those about a piece and the room.
IdSet OfRoom(const IdSet& sentence_ids, const v1::LayoutGraph& graph);

// "x", "x" and "y": texts of sentences, three at most.
std::string QuotedTexts(const v1::LayoutGraph& graph, const IdSet& sentence_ids);

// Gives `to` the sentences of `from` that it has not, without what they are about: its objects may be others.
void LendSentences(const v1::LayoutGraph& from, v1::LayoutGraph& to);
// Says of the sentences of `to` what they are about, as `from` knows it, as far as that is there.
void ReturnSubjects(const v1::LayoutGraph& from, v1::LayoutGraph& to);

// Forgets what an act has answered: sentences that ask for nothing any more, because they were dropped or their pieces
// are gone, and in the measures the uses that they asked for; remarks about those, about sentences that hold now and
// about pieces that are gone; and that a piece is missing which is there now. `before`: the graph that the act began
// with.
void ForgetWhatIsAnswered(const v1::LayoutGraph& before, v1::SolvedLayout& layout);

// Whether somebody has said in the room's field where one of these is to stand: it is the first that the sentence
// names.
bool IsSaidOf(const v1::LayoutGraph& graph, const IdSet& ids);
// Edits that drop what was so said of them and does not hold where they stand: a hand has put them elsewhere since.
EditList SaidOtherwise(const v1::SolvedLayout& layout, const IdSet& ids);
// Takes the edges that the edits remove out of the layout, with their outcomes.
void Drop(const EditList& edits, v1::SolvedLayout& layout);

// A solve begins at an earlier graph than the one that is shown: what acts have forgotten since then stays forgotten.
void KeepForgotten(const v1::LayoutGraph& shown, v1::LayoutGraph& graph);

// What stands badly and what keeps it there, the worst first; empty when all is well.
std::string StandingBadly(const v1::SolvedLayout& layout, const ObjectIds& by_hand);

// Why a solve has moved nothing, in one sentence: what stands badly and what keeps it there, or that all is well.
v1::Diagnostic WhyNothingMoves(const v1::SolvedLayout& layout, const ObjectIds& by_hand);

}  // namespace flair::session
