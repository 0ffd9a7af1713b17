// SPDX-License-Identifier: GPL-3.0-or-later
// Translations of labelled rooms, scored: how a translation compares with labels, for people and for programs.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/constraint_catalog.pb.h"
#include "flair/v1/layout_graph.pb.h"
#include "flair/v1/translator_service.pb.h"
#include "nlohmann/json.hpp"

namespace flair::cli {

// Sentences of recorded rooms with the calls that a careful reader accepts for them.

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

// What became of one labelled clause.
enum class TranslateOutcome {
  kCorrect,         // all calls of an alternative are made and none besides; or, where nothing is wanted, none is made
  kWrong,           // a call is made that no alternative names
  kMissed,          // other clauses of the sentence gave calls, or a part of this one's
  kWronglyRefused,  // the sentence gave no call at all
};
inline constexpr std::array<const char*, 4> kTranslateOutcomes = {"correct", "wrong", "missed", "refused"};

struct TranslateTally {
  std::array<int, 4> counts = {};
  int Total() const { return counts[0] + counts[1] + counts[2] + counts[3]; }
  double CorrectShare() const { return Total() == 0 ? 1 : static_cast<double>(counts[0]) / Total(); }
};

struct TranslateScore {
  TranslateTally all;
  // Functions of the reference, "refuse" for what is to be refused.
  std::map<std::string, TranslateTally> by_function;
  std::map<std::string, TranslateTally> by_list;
  std::map<std::string, TranslateTally> by_room;
  // Sentences that gave neither a call nor a remark.
  int silent = 0;
  // Every sentence of which something is not correct: what is accepted, what was made, what was remarked.
  std::string misses;
};

// Whether a made call is the labelled one: the same type, and each labelled argument the same. Types that mean the same
// both ways may swap their objects with their sides; sides and surrounding objects are sets; against_wall and near_wall
// without a labelled side mean the back, accessible without sides the front.
bool MeetsGold(const v1::ConstraintEdge& made, const v1::ConstraintEdge& gold);

// One outcome per label of the bullet. A call that no label of the bullet names counts once: against the first clause
// that is not met, else against one to be refused, else against the last.
std::vector<TranslateOutcome> OutcomesOf(const LabelledBullet& bullet, const std::vector<v1::ConstraintEdge>& made);

// Adds a room's sentences, as its request was translated.
void AddToScore(const LabelledRoom& room, const v1::LayoutGraph& translated, TranslateScore& score);

// Any form of TranslatorService.Translate.
using TranslateCall = std::function<absl::StatusOr<v1::TranslateResponse>(const v1::TranslateRequest&)>;

// The types of `catalog` that the reference library knows by their name or an alias: labels speak of no others.
v1::ConstraintCatalog TypesOfTheReference(const v1::ConstraintCatalog& catalog);

// Sends every room as one request with `catalog`, in the order of the labels; the first error ends it, with the room's
// name.
absl::StatusOr<TranslateScore> MeasureTranslation(const std::vector<LabelledRoom>& rooms,
                                                  const v1::ConstraintCatalog& catalog, const TranslateCall& translate);

// Tables by kind of list, by function and by room, and the totals. `cpu_ms` is of all translations together.
std::string TranslateScoreText(const TranslateScore& score, double cpu_ms);

}  // namespace flair::cli
