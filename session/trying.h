// SPDX-License-Identifier: GPL-3.0-or-later
// What an act on a sentence is for, and how well it has come out.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "flair/v1/solved_layout.pb.h"

namespace flair::session {

using IdSet = std::set<std::string>;

// What is to hold afterwards.
struct Aim {
  IdSet sentence_ids;
  // What it is about: these move first.
  IdSet object_ids;
  // Whether others may be solved anew for it as well; else only against faults, and for its place in the room: that it
  // stands at a wall, with its front clear.
  bool others_may_move = true;
};

// The objects that an edge names.
IdSet ObjectsOf(const v1::ConstraintEdge& edge, const v1::LayoutGraph& graph);
// Those that the edges of sentences name.
IdSet ObjectsOf(const IdSet& sentence_ids, const v1::LayoutGraph& graph);

// Sentences with an edge that does not hold, as a set; and why the first of `sentence_ids` does not, empty when all do.
IdSet UnmetSentences(const v1::SolvedLayout& layout);
std::string WhyUnmet(const v1::SolvedLayout& layout, const IdSet& sentence_ids);

// `ids` with what sentences name together with them, what stands around them, and what stands on any of these.
IdSet InReach(const v1::SolvedLayout& layout, const IdSet& ids);

// Whether `a` is better than `b`, both made of `before`: fewer faults, then less weight of what does not hold, then
// less cost by more than moving is worth.
bool IsBetter(const v1::SolvedLayout& a, const v1::SolvedLayout& b, const v1::SolvedLayout& before);

// Of these sentences, those about a piece and the room.
IdSet OfRoom(const IdSet& sentence_ids, const v1::LayoutGraph& graph);

bool HasMoreFaults(const v1::SolvedLayout& layout, const v1::SolvedLayout& before);
// Whether there are more faults than before, or clearly less of the floor can be reached.
bool IsWorseOff(const v1::SolvedLayout& layout, const v1::SolvedLayout& before);

// Gives `to` the sentences of `from` that it has not, without what they are about: its objects may be others.
void LendSentences(const v1::LayoutGraph& from, v1::LayoutGraph& to);
// Says of the sentences of `to` what they are about, as `from` knows it, as far as that is there.
void ReturnSubjects(const v1::LayoutGraph& from, v1::LayoutGraph& to);

// Forgets the sentences that say nothing any more, because what they spoke of is gone.
// False when there are none.
bool ForgetWhatIsGone(const v1::LayoutGraph& before, v1::LayoutGraph& graph);

// "x", "x" and "y": texts of sentences, three at most.
std::string QuotedTexts(const v1::LayoutGraph& graph, const IdSet& sentence_ids);

}  // namespace flair::session
