// SPDX-License-Identifier: GPL-3.0-or-later
// What says the same is read the same: labelled sentences that are read right stay right when words that place nothing
// are added, when a reason follows, and when words are replaced by others of their meaning.
#include <functional>
#include <string>
#include <vector>

#include "absl/strings/str_replace.h"
#include "absl/strings/strip.h"
#include "gtest/gtest.h"
#include "translator_worker/grammar/testing/labelled_rooms.h"
#include "translator_worker/grammar/testing/scorer.h"
#include "translator_worker/grammar/translate.h"

namespace flair::translator {
namespace {

const std::string kParaphraseData = std::string(FLAIR_SOURCE_DIR) + "/translator_worker/grammar/testdata/";

using Paraphrase = std::function<std::string(const std::string&)>;

// Which sentences of the rooms are read right.
std::vector<bool> ReadRight(std::vector<LabelledRoom> rooms, const Paraphrase& paraphrase) {
  std::vector<bool> right;
  for (LabelledRoom& room : rooms) {
    *room.request.mutable_catalog() = ReadCatalog(kParaphraseData + "catalog.textproto");
    for (const LabelledSentence& labelled : room.sentences) {
      v1::Sentence& sentence = *room.request.mutable_constraint_list()->add_sentences();
      sentence = labelled.sentence;
      sentence.set_text(paraphrase(sentence.text()));
    }
    const v1::LayoutGraph graph = Translate(room.request);
    for (const LabelledSentence& labelled : room.sentences) {
      std::vector<v1::ConstraintEdge> edges;
      for (const v1::ConstraintEdge& edge : graph.edges()) {
        if (edge.sentence_id() == labelled.sentence.id()) edges.push_back(edge);
      }
      Score score;
      right.push_back(AddToScore(labelled, edges, true, score));
    }
  }
  return right;
}

std::string WithoutStop(const std::string& text) { return std::string(absl::StripSuffix(text, ".")); }

Paraphrase Replacing(const std::string& from, const std::string& to) {
  return [=](const std::string& text) { return absl::StrReplaceAll(text, {{from, to}}); };
}

Paraphrase Adding(const std::string& end) {
  return [=](const std::string& text) { return WithoutStop(text) + end; };
}

Paraphrase Opening(const std::string& begin) {
  return [=](const std::string& text) { return begin + text; };
}

struct ParaphraseCase {
  const char* name;
  Paraphrase paraphrase;
};

TEST(Paraphrases, OfLabelledSentencesAreReadTheSame) {
  const std::vector<ParaphraseCase> cases = {
      {"ideally", Opening("Ideally, ")},
      {"label", Opening("Placement: ")},
      {"so that", Adding(" so that it can be used comfortably.")},
      {"because", Adding(" because this makes the room more comfortable.")},
      {"while", Adding(", while keeping the room functional.")},
      {"without a stop", WithoutStop},
      {"must", Replacing("should", "must")},
      {"has to be", Replacing("should be", "has to be")},
      {"cannot", Replacing("should not", "cannot")},
      {"must never", Replacing("should not", "must never")},
      {"always", Replacing("should be", "should always be")},
      {"ensuring", Replacing(" to ensure ", ", ensuring ")},
      {"a minimum of", Replacing("at least 0", "a minimum of 0")},
      {"beside", Replacing("next to", "beside")},
  };
  const std::vector<LabelledRoom> rooms = ReadLabelledRooms(kParaphraseData + "invented_rooms_10.jsonl");
  const std::vector<bool> plain = ReadRight(rooms, [](const std::string& text) { return text; });
  for (const ParaphraseCase& one : cases) {
    const std::vector<bool> paraphrased = ReadRight(rooms, one.paraphrase);
    int right = 0;
    int lost = 0;
    for (size_t i = 0; i < plain.size(); ++i) {
      right += plain[i];
      lost += plain[i] && !paraphrased[i];
    }
    EXPECT_GT(right, 310) << one.name;
    EXPECT_LE(lost, 2) << one.name;
  }
}

}  // namespace
}  // namespace flair::translator
