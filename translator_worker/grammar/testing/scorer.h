// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "flair/v1/layout_graph.pb.h"
#include "nlohmann/json.hpp"
#include "translator_worker/grammar/testing/labelled_rooms.h"

namespace flair::translator {

// Whether a call is what a label asks for. A parameter that the label does not name is not judged, except that
// against_wall and near_wall without side mean the back. Symmetric types may swap their objects; sides are a set.
bool Meets(const v1::ConstraintEdge& edge, const nlohmann::json& label);

// Counts over labelled sentences.
struct Score {
  int labelled_calls = 0;  // of the alternative met best, over all parts that are not refused
  int met_calls = 0;
  int made_calls = 0;
  int right_calls = 0;  // made calls that some alternative names
  int refusals = 0;     // sentences that must be refused wholly
  int right_refusals = 0;
  int silent = 0;  // sentences without call and without diagnostic

  double recall() const { return labelled_calls == 0 ? 1 : static_cast<double>(met_calls) / labelled_calls; }
  double precision() const { return made_calls == 0 ? 1 : static_cast<double>(right_calls) / made_calls; }
  double refusal_share() const { return refusals == 0 ? 1 : static_cast<double>(right_refusals) / refusals; }
};

// Adds one sentence; false when anything about it is wrong.
bool AddToScore(const LabelledSentence& labelled, const std::vector<v1::ConstraintEdge>& edges, bool has_diagnostic,
                Score& score);

// "near(object=bed, target=desk)".
std::string ToText(const v1::ConstraintEdge& edge);

}  // namespace flair::translator
