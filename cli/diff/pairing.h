// SPDX-License-Identifier: GPL-3.0-or-later
// Which objects and calls of two graphs are the same.
#pragma once

#include <string>
#include <vector>

#include "cli/diff/matching.h"
#include "flair/v1/layout_graph.pb.h"

namespace flair::cli {

// Objects by id, then by name, kind and zone, then by name and kind: other ids for the same things are no difference.
std::vector<Pair> PairObjects(const v1::ObjectList& a, const v1::ObjectList& b);

// Calls by what they say and the sentence that says so, then by what they say, then by id and type. Ids of calls are
// mere numbers: one call more in front changes them all.
std::vector<Pair> PairCalls(const v1::LayoutGraph& a, const v1::LayoutGraph& b);

// Sentences by their words, then by id.
std::vector<Pair> PairSentences(const v1::ConstraintList& a, const v1::ConstraintList& b);

// A call as it is written, without its weight.
std::string BareCall(const v1::ConstraintEdge& edge);

}  // namespace flair::cli
