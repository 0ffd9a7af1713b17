// SPDX-License-Identifier: GPL-3.0-or-later
// Clauses that lean on others, and words that mean a part of the room, people or the next of several: in a school
// library of testdata/invented_rooms_10.jsonl.
#include <algorithm>
#include <string>
#include <vector>

#include "absl/strings/str_join.h"
#include "absl/strings/str_replace.h"
#include "absl/strings/str_split.h"
#include "gtest/gtest.h"
#include "translator_worker/grammar/testing/labelled_rooms.h"
#include "translator_worker/grammar/testing/scorer.h"
#include "translator_worker/grammar/translate.h"

namespace flair::translator {
namespace {

const std::string kClauseData = std::string(FLAIR_SOURCE_DIR) + "/translator_worker/grammar/testdata/";

v1::TranslateRequest Library() {
  for (LabelledRoom& room : ReadLabelledRooms(kClauseData + "invented_rooms_10.jsonl")) {
    if (room.name != "country_school_library") continue;
    *room.request.mutable_catalog() = ReadCatalog(kClauseData + "catalog.textproto");
    return room.request;
  }
  return {};
}

struct ClauseCase {
  const char* text;
  // With spaces between them.
  const char* subjects;
  // Names of parameters left out: "near(globe, lending_desk)".
  const char* calls;
};

std::string CallsOf(const ClauseCase& one, v1::SentenceScope scope) {
  v1::TranslateRequest request = Library();
  v1::Sentence& sentence = *request.mutable_constraint_list()->add_sentences();
  sentence.set_id("s1");
  sentence.set_text(one.text);
  sentence.set_scope(scope);
  for (const auto subject : absl::StrSplit(one.subjects, ' ', absl::SkipEmpty())) {
    sentence.add_subject_ids(std::string(subject));
  }
  std::vector<std::string> calls;
  const v1::LayoutGraph graph = Translate(request);
  for (const v1::ConstraintEdge& edge : graph.edges()) {
    calls.push_back(absl::StrReplaceAll(ToText(edge), {{"object=", ""},
                                                       {"target=", ""},
                                                       {"feature=", ""},
                                                       {"sides=", ""},
                                                       {"min_clearance_m=", ""},
                                                       {"min_distance_m=", ""},
                                                       {"max_distance_m=", ""},
                                                       {"\"", ""}}));
  }
  return absl::StrJoin(calls, "; ");
}

void ExpectEach(const std::vector<ClauseCase>& cases, v1::SentenceScope scope) {
  for (const ClauseCase& one : cases) EXPECT_EQ(CallsOf(one, scope), one.calls) << one.text;
}

TEST(Clauses, ViewsAndReachStartFromWherePeopleAre) {
  ExpectEach(
      {{"From the lending desk one should have a view of the study table.", "", "facing(lending_desk, study_table)"},
       {"It should be possible to see the lending desk from the reading couch.", "reading_couch lending_desk",
        "facing(reading_couch, lending_desk)"}},
      v1::SENTENCE_SCOPE_INTER);
}

TEST(Clauses, DenialReachesOverItsClause) {
  ExpectEach({{"No book stack may be closer than 1.2 m to the globe.", "",
               "away_from(book_stack_1, globe, 1.2); away_from(book_stack_2, globe, 1.2); "
               "away_from(book_stack_3, globe, 1.2)"},
              {"Avoid placing the globe or the atlas stand in front of windows.", "",
               "clear_of_feature(globe, window); clear_of_feature(atlas_stand, window)"},
              {"The globe must be neither beside nor opposite the atlas stand.", "globe atlas_stand",
               "away_from(globe, atlas_stand); not_facing(globe, atlas_stand)"}},
             v1::SENTENCE_SCOPE_INTER);
  ExpectEach(
      {{"It should not be placed with its back against the wall.", "globe", "not_against_wall(globe, side=back)"},
       {"Should not hinder anyone.", "globe", ""}},
      v1::SENTENCE_SCOPE_INTRA);
}

TEST(Clauses, PartsOfTheRoomAreMeantByItAndOne) {
  ExpectEach({{"Needs to be near a socket and have its back to the wall.", "globe",
               "close_to_feature(globe, socket); against_wall(globe, side=back)"}},
             v1::SENTENCE_SCOPE_INTRA);
}

TEST(Clauses, SidesAreOfWhatIsSpokenOf) {
  ExpectEach(
      {{"Pupils sit on two opposite sides, so both must be free by 0.9 m.", "study_table",
        "accessible(study_table, [left,right], 0.9)"},
       {"Leave 5 cm on each side and at the back.", "computer_station",
        "accessible(computer_station, [left,right,back], 0.05)"},
       {"Both the front and one side should be accessible.", "study_table", "accessible(study_table, [front,left])"},
       {"Back side: against a wall. Front side: clear.", "computer_station",
        "against_wall(computer_station, side=back); accessible(computer_station, [front])"},
       {"Leave 1 m in front of and 0.8 m behind it.", "globe",
        "accessible(globe, [front], 1.0); accessible(globe, [back], 0.8)"}},
      v1::SENTENCE_SCOPE_INTRA);
}

TEST(Clauses, SeveralAreSharedOut) {
  ExpectEach({{"One bean bag goes at each end of the couch.", "bean_bag_1 bean_bag_2 reading_couch",
               "next_to(bean_bag_1, reading_couch, object_side=right, target_side=left); "
               "next_to(bean_bag_2, reading_couch, object_side=left, target_side=right)"},
              {"Two bean bags stand on opposite long sides of the study table.", "bean_bag_1 bean_bag_2 study_table",
               "next_to(bean_bag_1, study_table, target_side=front); next_to(bean_bag_2, study_table, "
               "target_side=back)"},
              {"The chair stands behind the desk and faces the same direction.", "librarian_chair lending_desk",
               "next_to(librarian_chair, lending_desk, target_side=back); parallel(librarian_chair, lending_desk)"},
              {"The globe goes on the right of the atlas stand, so that its left side touches the stand.",
               "globe atlas_stand", "next_to(globe, atlas_stand, target_side=right, object_side=left)"}},
             v1::SENTENCE_SCOPE_INTER);
}

}  // namespace
}  // namespace flair::translator
