// SPDX-License-Identifier: GPL-3.0-or-later
// Which objects of a name a sentence moves: those that its subjects name, or those that belong to what they name.
#include <string>
#include <vector>

#include "absl/strings/str_join.h"
#include "gtest/gtest.h"
#include "translator_worker/grammar/testing/labelled_rooms.h"
#include "translator_worker/grammar/testing/scorer.h"
#include "translator_worker/grammar/translate.h"

namespace flair::translator {
namespace {

v1::Object& AddSeat(const std::string& id, const std::string& name, const std::string& zone, v1::ObjectList& list) {
  v1::Object& object = *list.add_objects();
  object.set_id(id);
  object.set_name(name);
  object.set_zone_id(zone);
  object.set_kind(v1::OBJECT_KIND_FLOOR);
  object.set_role(v1::OBJECT_ROLE_SECONDARY);
  object.set_width_m(0.6);
  object.set_depth_m(0.6);
  return object;
}

// An office: two chairs at a meeting table, two at desks, all of one name, and two stools.
v1::TranslateRequest Office() {
  v1::TranslateRequest request;
  *request.mutable_catalog() =
      ReadCatalog(std::string(FLAIR_SOURCE_DIR) + "/translator_worker/grammar/testdata/catalog.textproto");
  for (const char* zone : {"meeting", "work"}) {
    v1::Zone& added = *request.mutable_zone_plan()->add_zones();
    added.set_id(zone);
    added.set_name(zone);
  }
  v1::ObjectList& list = *request.mutable_object_list();
  AddSeat("table", "table", "meeting", list).set_role(v1::OBJECT_ROLE_PRIMARY);
  AddSeat("chair_1", "office chair", "work", list);
  AddSeat("chair_2", "office chair", "work", list);
  AddSeat("chair_3", "office chair", "meeting", list);
  AddSeat("chair_4", "office chair", "meeting", list);
  AddSeat("stool_1", "stool", "meeting", list);
  AddSeat("stool_2", "stool", "meeting", list);
  return request;
}

std::string CallsOf(v1::TranslateRequest request, const std::string& text, const std::vector<std::string>& subjects,
                    v1::SentenceScope scope = v1::SENTENCE_SCOPE_INTER) {
  v1::Sentence& sentence = *request.mutable_constraint_list()->add_sentences();
  sentence.set_id("s1");
  sentence.set_text(text);
  sentence.set_scope(scope);
  for (const std::string& subject : subjects) sentence.add_subject_ids(subject);
  const v1::LayoutGraph graph = Translate(request);
  std::vector<std::string> calls;
  for (const v1::ConstraintEdge& edge : graph.edges()) calls.push_back(ToText(edge));
  return absl::StrJoin(calls, "\n");
}

TEST(Subjects, AreTheOnesOfTheirNameThatMove) {
  EXPECT_EQ(CallsOf(Office(), "The office chairs surround the table.", {"chair_1", "chair_4", "table"}),
            "surround(center=table, objects=[\"chair_1\",\"chair_4\"])");
  EXPECT_EQ(CallsOf(Office(), "The office chairs surround the table.", {"table", "chair_2"}),
            "surround(center=table, objects=[\"chair_2\"])");
  EXPECT_EQ(CallsOf(Office(), "The office chairs face the table.", {"chair_2", "chair_3"}),
            "facing(object=chair_2, target=table)\nfacing(object=chair_3, target=table)");
}

TEST(Subjects, AreAlsoWhatOtherThingsAreRelatedTo) {
  EXPECT_EQ(CallsOf(Office(), "The table is surrounded by the office chairs.", {"table", "chair_1", "chair_2"}),
            "surround(center=table, objects=[\"chair_1\",\"chair_2\"])");
  EXPECT_EQ(CallsOf(Office(), "The table is near the office chairs.", {"table", "chair_3", "chair_4"}),
            "near(object=table, target=chair_3)\nnear(object=table, target=chair_4)");
}

TEST(Subjects, AreCountedAmongAllOfTheirName) {
  v1::TranslateRequest request = Office();
  for (const char* id : {"lamp_1", "lamp_2"}) {
    v1::Object& lamp = AddSeat(id, "lamp", "meeting", *request.mutable_object_list());
    lamp.set_role(v1::OBJECT_ROLE_TERTIARY);
    lamp.set_kind(v1::OBJECT_KIND_SURFACE);
  }
  const auto read = [&](const std::string& text, const std::vector<std::string>& subjects) {
    return CallsOf(request, text, subjects, v1::SENTENCE_SCOPE_TERTIARY);
  };
  EXPECT_EQ(read("The second lamp is on the second stool.", {"lamp_2"}), "on_top_center(object=lamp_2, host=stool_2)");
  EXPECT_EQ(read("The second lamp is on the second stool.", {"lamp_2", "stool_2"}),
            "on_top_center(object=lamp_2, host=stool_2)");
  EXPECT_EQ(read("The first lamp is on the first stool.", {"lamp_1"}), "on_top_center(object=lamp_1, host=stool_1)");
}

TEST(Subjects, ThatNameNoChairTakeThoseOfTheirZoneOrTheirOwn) {
  EXPECT_EQ(CallsOf(Office(), "The office chairs surround the table.", {"table"}),
            "surround(center=table, objects=[\"chair_3\",\"chair_4\"])");
  v1::TranslateRequest hosted = Office();
  for (const int i : {2, 3}) hosted.mutable_object_list()->mutable_objects(i)->set_host_id("table");
  EXPECT_EQ(CallsOf(hosted, "The office chairs surround the table.", {"table"}),
            "surround(center=table, objects=[\"chair_2\",\"chair_3\"])");
}

TEST(Subjects, LookAtWhatCarriesAThingThatIsPlacedLater) {
  v1::TranslateRequest request = Office();
  v1::Object& television = AddSeat("television", "television", "meeting", *request.mutable_object_list());
  television.set_role(v1::OBJECT_ROLE_TERTIARY);
  television.set_kind(v1::OBJECT_KIND_SURFACE);
  EXPECT_EQ(CallsOf(request, "The first stool faces the television.", {"stool_1"}), "");
  request.mutable_object_list()->mutable_objects()->rbegin()->set_host_id("table");
  EXPECT_EQ(CallsOf(request, "The first stool faces the television.", {"stool_1"}),
            "facing(object=stool_1, target=table)");
}

TEST(Subjects, OfAnotherNameForASeatAreMeantByChairs) {
  EXPECT_EQ(CallsOf(Office(), "The chairs surround the table.", {"table", "stool_1", "stool_2"}),
            "surround(center=table, objects=[\"stool_1\",\"stool_2\"])");
}

TEST(Subjects, OfWhichOneIsNamedMeanTheKindAfterEachAndBoth) {
  EXPECT_EQ(CallsOf(Office(), "Each stool faces the table.", {"stool_1", "table"}),
            "facing(object=stool_1, target=table)\nfacing(object=stool_2, target=table)");
}

TEST(Subjects, AbsentLeaveAllOfTheName) {
  EXPECT_EQ(CallsOf(Office(), "The office chairs surround the table.", {}),
            "surround(center=table, objects=[\"chair_1\",\"chair_2\",\"chair_3\",\"chair_4\"])");
}

}  // namespace
}  // namespace flair::translator
