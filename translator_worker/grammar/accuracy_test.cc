// SPDX-License-Identifier: GPL-3.0-or-later
// How well the grammar reads what real models wrote, against labels made by hand. Ten rooms were looked at while the
// grammar was written; 24 further ones were labelled, measured and then looked at four at a time (docs/benchmarks.md
// has the figures of before they were looked at), 13 more later, invented ones too. Of four held-out rooms one,
// 63_living_dining, was opened later and is now a development room; nobody has looked at the sentences of the other
// three. invented_rooms_7.jsonl and _13 are held out as well. FLAIR_SHOW_MISSES=1 prints what is wrong
// in all but the held-out ones; their sum is printed only with FLAIR_SHOW_HELD_OUT=1: who sees it at each run
// develops by it. A sentence is correct when every part of it gets all calls of one accepted reading and nothing else
// is made, or nothing at all where nothing is to be made. 86 % of sentences that the grammar was not written on and 92
// % of emitted calls are what we ask; turns of phrase that only one or two of the sentences have are not collected.
#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "gtest/gtest.h"
#include "translator_worker/grammar/testing/labelled_rooms.h"
#include "translator_worker/grammar/testing/scorer.h"
#include "translator_worker/grammar/translate.h"

namespace flair::translator {
namespace {

const std::string kFolder = std::string(FLAIR_SOURCE_DIR) + "/translator_worker/grammar/testdata/";

// The types that the labels know.
v1::ConstraintCatalog RecordedTypes() {
  v1::ConstraintCatalog catalog = ReadCatalog(kFolder + "catalog.textproto");
  auto& types = *catalog.mutable_types();
  for (int i = types.size() - 1; i >= 0; --i) {
    if (types[i].family() == "further") types.DeleteSubrange(i, 1);
  }
  return catalog;
}

void ShowMiss(const LabelledRoom& room, const LabelledSentence& labelled, const std::vector<v1::ConstraintEdge>& edges,
              const v1::LayoutGraph& graph) {
  std::cout << room.name << " " << labelled.sentence.id() << ": " << labelled.sentence.text() << "\n";
  for (const auto& part : labelled.parts) std::cout << "   want " << part.dump() << "\n";
  for (const v1::ConstraintEdge& edge : edges) std::cout << "   made " << ToText(edge) << "\n";
  for (const v1::Diagnostic& diagnostic : graph.diagnostics()) {
    if (diagnostic.subject_id() == labelled.sentence.id()) {
      std::cout << "   " << diagnostic.code() << ": " << diagnostic.message() << "\n";
    }
  }
}

struct Measured {
  Score score;
  int sentences = 0;
  int correct = 0;
  double correct_share() const { return static_cast<double>(correct) / std::max(1, sentences); }
};

void MeasureRoom(LabelledRoom& room, bool show, Measured& measured) {
  *room.request.mutable_catalog() = RecordedTypes();
  for (const LabelledSentence& labelled : room.sentences) {
    *room.request.mutable_constraint_list()->add_sentences() = labelled.sentence;
  }
  const v1::LayoutGraph graph = Translate(room.request);
  for (const LabelledSentence& labelled : room.sentences) {
    std::vector<v1::ConstraintEdge> edges;
    for (const v1::ConstraintEdge& edge : graph.edges()) {
      if (edge.sentence_id() == labelled.sentence.id()) edges.push_back(edge);
    }
    bool remarked = false;
    for (const v1::Diagnostic& diagnostic : graph.diagnostics()) {
      remarked = remarked || diagnostic.subject_id() == labelled.sentence.id();
    }
    const bool right = AddToScore(labelled, edges, remarked, measured.score);
    ++measured.sentences;
    measured.correct += right;
    if (!right && show) ShowMiss(room, labelled, edges, graph);
  }
}

Measured Measure(const std::string& file, bool held_out) {
  const bool show = !held_out && std::getenv("FLAIR_SHOW_MISSES") != nullptr;
  Measured measured;
  for (LabelledRoom& room : ReadLabelledRooms(kFolder + file)) {
    if (room.held_out == held_out) MeasureRoom(room, show, measured);
  }
  const Score& score = measured.score;
  if (held_out && std::getenv("FLAIR_SHOW_HELD_OUT") == nullptr) return measured;
  std::cout << file << (held_out ? ", held-out" : ", development") << " rooms: correct " << measured.correct_share()
            << " (" << measured.correct << "/" << measured.sentences << "), recall " << score.recall() << " ("
            << score.met_calls << "/" << score.labelled_calls << "), precision " << score.precision() << " ("
            << score.right_calls << "/" << score.made_calls << "), right refusals " << score.refusal_share() << " ("
            << score.right_refusals << "/" << score.refusals << ")\n";
  return measured;
}

TEST(Accuracy, OfSentencesThatTheGrammarWasWrittenWith) {
  const Measured measured = Measure("labelled_rooms.jsonl", false);
  EXPECT_GE(measured.correct_share(), 0.97);
  EXPECT_GE(measured.score.recall(), 0.965);
  EXPECT_GE(measured.score.precision(), 0.975);
  EXPECT_GE(measured.score.refusal_share(), 0.97);
  EXPECT_EQ(measured.score.silent, 0);
}

TEST(Accuracy, OfFurtherSentencesThatWereMeasuredAndThenLookedAt) {
  const Measured measured = Measure("further_rooms.jsonl", false);
  EXPECT_GE(measured.correct_share(), 0.96);
  EXPECT_GE(measured.score.recall(), 0.97);
  EXPECT_GE(measured.score.precision(), 0.965);
  EXPECT_GE(measured.score.refusal_share(), 0.9);
  EXPECT_EQ(measured.score.silent, 0);
}

// Seven rooms' lists, and the unsimplified ones of six others, labelled and measured before they were looked at.
TEST(Accuracy, OfListsOfThirteenMoreRooms) {
  const Measured measured = Measure("further_rooms_2.jsonl", false);
  EXPECT_GE(measured.correct_share(), 0.955);
  EXPECT_GE(measured.score.recall(), 0.96);
  EXPECT_GE(measured.score.precision(), 0.955);
  EXPECT_EQ(measured.score.silent, 0);
}

// Rooms that we made up in the manner of such a model, labelled before the grammar read them.
TEST(Accuracy, OfInventedSentencesThatWereMeasuredAndThenLookedAt) {
  for (const char* file : {"invented_rooms.jsonl", "invented_rooms_2.jsonl", "invented_rooms_3.jsonl"}) {
    const Measured measured = Measure(file, false);
    EXPECT_GE(measured.correct_share(), 0.93) << file;
    EXPECT_EQ(measured.score.silent, 0) << file;
  }
}

// Written to be hard: access, groups, clauses joined, doors and windows. 67 to 82 % when they were measured first.
TEST(Accuracy, OfHardSentencesThatWereMeasuredAndThenLookedAt) {
  const Measured measured = Measure("invented_rooms_4.jsonl", false);
  EXPECT_GE(measured.correct_share(), 0.86);
  EXPECT_EQ(measured.score.silent, 0);
}

// Rooms of other kinds, a shop, a clinic, a gym, a kitchen with an island..., in the plain manner of such a model,
// labelled before the grammar read them: 89 % correct when they were measured first.
TEST(Accuracy, OfRoomsOfOtherKindsThatWereMeasuredAndThenLookedAt) {
  const Measured measured = Measure("invented_rooms_6.jsonl", false);
  EXPECT_GE(measured.correct_share(), 0.955);
  EXPECT_GE(measured.score.recall(), 0.96);
  EXPECT_GE(measured.score.precision(), 0.97);
  EXPECT_EQ(measured.score.silent, 0);
}

// Other sentences of the same rooms, drawn by hash and never looked at.
TEST(Accuracy, OfRoomsOfOtherKindsThatNobodyLookedAt) {
  const Measured measured = Measure("invented_rooms_7.jsonl", true);
  EXPECT_GE(measured.correct_share(), 0.92);
  EXPECT_EQ(measured.score.silent, 0);
}

// Twelve rooms of yet other kinds, a chapel, a server room, a courtroom..., in many ways of speaking: relative clauses,
// shared figures and heads, passives, one of several. 81 % correct when they were measured first.
TEST(Accuracy, OfManyWaysOfSpeakingThatWereMeasuredAndThenLookedAt) {
  const Measured measured = Measure("invented_rooms_8.jsonl", false);
  EXPECT_GE(measured.correct_share(), 0.9);
  EXPECT_GE(measured.score.recall(), 0.93);
  EXPECT_GE(measured.score.precision(), 0.93);
  EXPECT_EQ(measured.score.silent, 0);
}

// Other sentences of the same twelve, sealed until 83.6 % of them were correct, and then looked at.
TEST(Accuracy, OfManyWaysOfSpeakingThatWereSealed) {
  const Measured measured = Measure("invented_rooms_9.jsonl", false);
  EXPECT_GE(measured.correct_share(), 0.88);
  EXPECT_EQ(measured.score.silent, 0);
}

// As hard as invented_rooms_4.jsonl, sealed until 77.8 % of them were correct, and then looked at.
TEST(Accuracy, OfHardSentencesThatWereSealed) {
  const Measured measured = Measure("invented_rooms_5.jsonl", false);
  EXPECT_GE(measured.correct_share(), 0.895);
  EXPECT_EQ(measured.score.silent, 0);
}

// Written statement by statement after the rules of the labels, before the grammar read them: a choir's room, a
// laundrette, a school library, a nursery school, a physiotherapist's, a kitchen with guests. 87 and 80 % of the four
// and the two were correct when they were measured first.
TEST(Accuracy, OfSentencesWrittenAfterTheRulesOfTheLabels) {
  const Measured measured = Measure("invented_rooms_10.jsonl", false);
  EXPECT_GE(measured.correct_share(), 0.905);
  EXPECT_EQ(measured.score.silent, 0);
}

// Seven rooms of other kinds, labelled before the last two sets above were gone through, sealed until 91.6 % of their
// sentences were correct, and then looked at.
TEST(Accuracy, OfSevenMoreRoomsThatWereSealed) {
  const Measured measured = Measure("invented_rooms_11.jsonl", false);
  EXPECT_GE(measured.correct_share(), 0.945);
  EXPECT_EQ(measured.score.silent, 0);
}

// Eight rooms that were written and labelled independently of the grammar, four of them sealed. 92.7 and 89.5 % of
// their sentences were correct when they were measured first.
TEST(Accuracy, OfRoomsOfAnotherHandThatWereMeasuredAndThenLookedAt) {
  const Measured measured = Measure("invented_rooms_12.jsonl", false);
  EXPECT_GE(measured.correct_share(), 0.96);
  EXPECT_EQ(measured.score.silent, 0);
}

TEST(Accuracy, OfRoomsOfAnotherHandThatNobodyLookedAt) {
  const Measured measured = Measure("invented_rooms_13.jsonl", true);
  EXPECT_GE(measured.correct_share(), 0.88);
  EXPECT_EQ(measured.score.silent, 0);
}

TEST(Accuracy, OfSentencesOfHeldOutRooms) {
  const Measured measured = Measure("labelled_rooms.jsonl", true);
  EXPECT_GE(measured.correct_share(), 0.88);
  EXPECT_GE(measured.score.recall(), 0.84);
  EXPECT_GE(measured.score.precision(), 0.89);
  EXPECT_GE(measured.score.refusal_share(), 0.84);
  EXPECT_EQ(measured.score.silent, 0);
}

}  // namespace
}  // namespace flair::translator
