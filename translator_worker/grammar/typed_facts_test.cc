// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences that carry their meaning: it counts as long as it is the text's, and nothing that it says does harm.
#include <google/protobuf/text_format.h>

#include <string>
#include <vector>

#include "absl/strings/str_join.h"
#include "english/language.h"
#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "translator_worker/grammar/testing/labelled_rooms.h"
#include "translator_worker/grammar/testing/scorer.h"
#include "translator_worker/grammar/translate.h"
#include "worker_runtime/files/files.h"

namespace flair::translator {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// A bed and two chairs of one name, a lamp on the wall.
v1::TranslateRequest BedAndTwoChairs() {
  v1::TranslateRequest request;
  *request.mutable_catalog() = ReadCatalog(FLAIR_SOURCE_DIR "/translator_worker/grammar/testdata/catalog.textproto");
  EXPECT_TRUE(google::protobuf::TextFormat::MergeFromString(
      R"pb(room {
             walls { name: "south" }
             walls { name: "north" }
             openings { kind: OPENING_KIND_DOOR }
           }
           zone_plan { zones { id: "sleeping" name: "sleeping" } }
           object_list {
             objects { id: "bed" name: "bed" kind: OBJECT_KIND_FLOOR width_m: 1.6 depth_m: 2 zone_id: "sleeping" }
             objects { id: "chair_1" name: "chair" kind: OBJECT_KIND_FLOOR width_m: 0.5 depth_m: 0.5 }
             objects { id: "chair_2" name: "chair" kind: OBJECT_KIND_FLOOR width_m: 0.5 depth_m: 0.5 }
             objects { id: "lamp" name: "lamp" kind: OBJECT_KIND_WALL width_m: 0.2 depth_m: 0.2 }
           }
           constraint_list { sentences { id: "s1" weight: 1 scope: SENTENCE_SCOPE_INTER } })pb",
      &request));
  return request;
}

struct Outcome {
  std::string calls;
  std::string remarks;
  double weight = 0;
};

// What becomes of a sentence with these facts, whose digest is that of `digested`.
Outcome Translated(const std::string& text, const std::string& facts, const std::string& digested) {
  v1::TranslateRequest request = BedAndTwoChairs();
  v1::Sentence& sentence = *request.mutable_constraint_list()->mutable_sentences(0);
  sentence.set_text(text);
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(facts, sentence.mutable_meaning())) << facts;
  sentence.mutable_meaning()->set_text_digest(runtime::Sha256Hex(digested));
  const v1::LayoutGraph graph = Translate(request);
  Outcome outcome;
  std::vector<std::string> calls;
  for (const v1::ConstraintEdge& edge : graph.edges()) {
    calls.push_back(ToText(edge));
    outcome.weight = edge.weight();
  }
  outcome.calls = absl::StrJoin(calls, "; ");
  for (const v1::Diagnostic& remark : graph.diagnostics()) outcome.remarks += remark.code() + ": " + remark.message();
  return outcome;
}

Outcome Meant(const std::string& facts) { return Translated("Xyzzy.", facts, "Xyzzy."); }

TEST(TypedFacts, CountInsteadOfTheTextThatTheyAreOf) {
  const Outcome outcome = Meant(
      R"(facts { relation: "against" movers { object_id: "bed" side: PARTICIPANT_SIDE_BACK } targets { wall: "north" } })");
  EXPECT_EQ(outcome.calls, "against_wall(object=bed, side=back, wall=north)");
  EXPECT_EQ(outcome.remarks, "");
}

TEST(TypedFacts, MeanOneOfSeveralThatShareAName) {
  EXPECT_EQ(Meant(R"(facts { relation: "near" movers { object_id: "chair_2" } targets { object_id: "bed" }
                             measure { max_m: 1.5 } })")
                .calls,
            "near(object=chair_2, target=bed, max_distance_m=1.5)");
  EXPECT_EQ(Meant(R"(facts { relation: "surround" movers { object_id: "chair_1" } movers { object_id: "chair_2" }
                             targets { object_id: "bed" } })")
                .calls,
            R"(surround(center=bed, objects=["chair_1","chair_2"]))");
}

TEST(TypedFacts, ThatAreWishesCountHalf) {
  EXPECT_EQ(Meant(R"(facts { relation: "in_corner" movers { object_id: "bed" } })").weight, 1);
  EXPECT_EQ(Meant(R"(facts { relation: "in_corner" movers { object_id: "bed" } strength: FACT_STRENGTH_WISH })").weight,
            0.5);
}

TEST(TypedFacts, CountForNothingWhenTheTextWasEdited) {
  const Outcome outcome =
      Translated("The bed is in a corner.", R"(facts { relation: "central" movers { object_id: "bed" } })",
                 "The bed is central in the room.");
  EXPECT_EQ(outcome.calls, "in_corner(object=bed)");
  EXPECT_EQ(outcome.remarks, "");
}

TEST(TypedFacts, ThatCannotBeUsedAreNamedAndTheTextIsRead) {
  const auto read_instead = [](const std::string& facts) {
    const Outcome outcome = Translated("The bed is in a corner.", facts, "The bed is in a corner.");
    EXPECT_EQ(outcome.calls, "in_corner(object=bed)") << facts;
    return outcome.remarks;
  };
  EXPECT_THAT(read_instead(R"(facts { relation: "levitates_over" movers { object_id: "bed" } })"),
              AllOf(HasSubstr("meaning_not_used"), HasSubstr("levitates_over")));
  EXPECT_THAT(read_instead(R"(facts { relation: "near" movers { object_id: "ghost" } })"),
              HasSubstr("there is no object \"ghost\""));
  EXPECT_THAT(read_instead(R"(facts { relation: "against" movers { object_id: "bed" } targets { wall: "wall_9" } })"),
              HasSubstr("there is no wall \"wall_9\""));
  EXPECT_THAT(read_instead(R"(facts { relation: "on" movers { zone_id: "attic" } })"),
              HasSubstr("there is no zone \"attic\""));
  EXPECT_THAT(read_instead(R"(facts { relation: "near" movers { object_id: "bed" } targets { } })"),
              HasSubstr("meaning_not_used"));
  EXPECT_THAT(read_instead(R"(facts { relation: "place_between" movers { object_id: "bed" } })"),
              HasSubstr("no frame is \"place_between\" of such participants"));
}

// Of every relation there is, with all that can be said in each place.
TEST(TypedFacts, AlwaysEndInCallsOrADiagnostic) {
  const std::vector<std::string> participants = {"",
                                                 "{ object_id: 'bed' }",
                                                 "{ object_id: 'bed' side: PARTICIPANT_SIDE_LONG }",
                                                 "{ object_id: 'lamp' side: PARTICIPANT_SIDE_ALL }",
                                                 "{ zone_id: 'sleeping' }",
                                                 "{ part: ROOM_PART_WINDOW side: PARTICIPANT_SIDE_LEFT }",
                                                 "{ part: ROOM_PART_WALL }"};
  v1::TranslateRequest request = BedAndTwoChairs();
  v1::Sentence& sentence = *request.mutable_constraint_list()->mutable_sentences(0);
  sentence.set_text("Xyzzy.");
  int used = 0;
  for (const auto& frame : english::Language::Get().data().frames()) {
    for (size_t i = 0; i < participants.size() * participants.size() * 4; ++i) {
      const std::string& mover = participants[i % participants.size()];
      const std::string& target = participants[i / participants.size() % participants.size()];
      const size_t further = i / participants.size() / participants.size();
      std::string fact = "facts { relation: '" + frame.meaning() + "' detail: '" + frame.detail() + "'";
      if (!mover.empty()) fact += " movers " + mover;
      if (!target.empty()) fact += " targets " + target;
      if (further % 2 == 1) fact += " measure { min_m: 0.5 }";
      if (further / 2 > 0) fact += " others " + participants[further / 2];
      ASSERT_TRUE(google::protobuf::TextFormat::ParseFromString(fact + " }", sentence.mutable_meaning()));
      sentence.mutable_meaning()->set_text_digest(runtime::Sha256Hex(sentence.text()));
      const v1::LayoutGraph graph = Translate(request);
      used += graph.edges_size() > 0;
      ASSERT_GT(graph.edges_size() + graph.diagnostics_size(), 0) << fact;
    }
  }
  EXPECT_GT(used, 100);
}

}  // namespace
}  // namespace flair::translator
