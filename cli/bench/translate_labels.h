// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences of recorded rooms with the calls that a careful reader accepts for them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/layout_graph.pb.h"
#include "flair/v1/translator_service.pb.h"
#include "nlohmann/json.hpp"

namespace flair::cli {

// A labelled call {"function", "objects", "params"} in our words, with no more arguments than it states. Objects are
// indices, "t3" is a tertiary one. INVALID_ARGUMENT and NOT_FOUND say which name or value the room does not know.
absl::StatusOr<v1::ConstraintEdge> ReadGoldCall(const nlohmann::json& call, const v1::LayoutGraph& room);

// Id of the object with a labelled index.
absl::StatusOr<std::string> ReadGoldObject(const nlohmann::json& index, const v1::LayoutGraph& room);

// One labelled clause: a whole bullet, or one fact of it.
struct TranslateLabel {
  std::string text;
  // The reference function of the best alternative; "refuse" when nothing is to be made of it.
  std::string function;
  // What is accepted, best first: all calls of one of them. Only the arguments that the label states. Empty when the
  // clause is to be refused.
  std::vector<std::vector<v1::ConstraintEdge>> alternatives;
};

// A sentence as the model wrote it, with the labels of its clauses.
struct LabelledBullet {
  v1::Sentence sentence;
  // "primary_intra", "secondary_inter", "tertiary"...
  std::string list;
  std::vector<TranslateLabel> labels;
};

// A room and its sentences, which the request holds too, in the same order. Its catalogue is left to the caller.
struct LabelledRoom {
  std::string name;
  v1::TranslateRequest request;
  std::vector<LabelledBullet> bullets;
};

struct TranslateLabels {
  std::vector<LabelledRoom> rooms;
  // "FILE:LINE: reason" of lines that say nothing that can be measured.
  std::vector<std::string> failures;
};

// Reads `path`, or the .jsonl files of the folder `path`. A line is an object with room, list, subject_index, sentence
// and gold, and with bullet and part where a bullet was split: lines of one bullet make one sentence. The recorded room
// NAME.json is looked for in `rooms`, when that is empty in `path`, in its "rooms" and in the "rooms" beside it.
// NOT_FOUND when there is no file of labels, INVALID_ARGUMENT when no line can be measured.
absl::StatusOr<TranslateLabels> ReadTranslateLabels(const std::filesystem::path& path,
                                                    const std::filesystem::path& rooms);

}  // namespace flair::cli
