// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/completion/complete_constraints.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "language_worker/handbook/cleaning/clean_constraints.h"
#include "language_worker/handbook/objects/list_objects.h"
#include "language_worker/handbook/rooms/describe_room.h"
#include "language_worker/handbook/sentences/list_constraints.h"
#include "language_worker/handbook/testing/test_handbook.h"

namespace flair::language {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;

// A room with somebody else's objects and sentences.
class Strangers : public ::testing::Test {
 protected:
  explicit Strangers(const std::string& text = "A room of 5 m x 4 m.") {
    brief_.set_text(text);
    room_ = *DescribeRoom(brief_, TheHandbook());
    zones_.add_zones()->set_id("main");
  }
  void Piece(const std::string& id, const std::string& name, v1::ObjectRole role = v1::OBJECT_ROLE_PRIMARY) {
    v1::Object& object = *objects_.add_objects();
    object.set_id(id);
    object.set_name(name);
    object.set_role(role);
    object.set_kind(v1::OBJECT_KIND_FLOOR);
    object.set_zone_id("main");
  }
  v1::Sentence& Say(const std::string& text, const std::vector<std::string>& subjects) {
    v1::Sentence& sentence = *list_.add_sentences();
    sentence.set_id("s" + std::to_string(list_.sentences_size()));
    sentence.set_text(text);
    sentence.set_scope(subjects.size() > 1 ? v1::SENTENCE_SCOPE_INTER : v1::SENTENCE_SCOPE_INTRA);
    for (const std::string& id : subjects) sentence.add_subject_ids(id);
    return sentence;
  }
  void Complete() { completed_ = CompleteConstraints({brief_, room_, zones_}, objects_, list_, TheHandbook()); }
  std::vector<std::string> Implied() const {
    std::vector<std::string> texts;
    for (const v1::Sentence& sentence : completed_.sentences()) {
      if (sentence.origin() == v1::SENTENCE_ORIGIN_IMPLIED) texts.push_back(sentence.text());
    }
    return texts;
  }
  std::vector<std::string> Written() const {
    std::vector<std::string> texts;
    for (const v1::Sentence& sentence : completed_.sentences()) {
      if (sentence.origin() != v1::SENTENCE_ORIGIN_IMPLIED) texts.push_back(sentence.text());
    }
    return texts;
  }

  v1::Brief brief_;
  v1::Room room_;
  v1::ZonePlan zones_;
  v1::ObjectList objects_;
  v1::ConstraintList list_;
  v1::ConstraintList completed_;
};

TEST_F(Strangers, ChairIsDrawnUpToItsDesk) {
  Piece("desk", "oak writing desk");
  Piece("seat", "ergonomic desk chair");
  Complete();
  EXPECT_THAT(Implied(),
              Contains("The front of the ergonomic desk chair is next to the front of the oak writing desk."));
  const auto chair = std::ranges::find_if(completed_.sentences(), [](const v1::Sentence& one) {
    return one.text().find("chair is next") != std::string::npos;
  });
  ASSERT_NE(chair, completed_.sentences().end());
  EXPECT_EQ(chair->reason(), "nobody asked for it: one sits down to work there");
  EXPECT_TRUE(chair->use());
}

TEST_F(Strangers, DoorsOpenOnlyWhereThereIsRoom) {
  Piece("wardrobe", "wardrobe");
  Complete();
  EXPECT_THAT(Implied(), Contains(::testing::MatchesRegex("The front of the wardrobe has .* m of clear space.")));
}

TEST_F(Strangers, ChairsSurroundTheirTable) {
  Piece("table", "walnut dining table");
  for (const char* id : {"a", "b", "c", "d"}) Piece(id, "dining_chair");
  Complete();
  EXPECT_THAT(Implied(), Contains("The dining_chairs surround the walnut dining table."));
}

TEST_F(Strangers, PlainChairIsWhatTheRoomNeeds) {
  Piece("desk", "desk");
  Piece("seat", "chair");
  Complete();
  EXPECT_THAT(Implied(), Contains("The front of the chair is next to the front of the desk."));
}

TEST_F(Strangers, NamesInThePluralAreOnePieceEach) {
  Piece("table", "dining table");
  Piece("a", "dining chairs");
  Piece("b", "dining chairs");
  Complete();
  EXPECT_THAT(Implied(), Contains("The dining chairs surround the dining table."));
}

TEST_F(Strangers, LampOnADeskIsNoFloorLamp) {
  Piece("seat", "armchair");
  Piece("light", "reading lamp", v1::OBJECT_ROLE_TERTIARY);
  objects_.mutable_objects(1)->set_kind(v1::OBJECT_KIND_SURFACE);
  Complete();
  for (const std::string& text : Implied()) EXPECT_THAT(text, Not(::testing::HasSubstr("lamp")));
}

TEST_F(Strangers, WhatGoesAgainstAUseGivesWayAndIsTold) {
  Piece("table", "dining table");
  Piece("a", "dining chair");
  Piece("b", "dining chair");
  Say("Each dining chair is near a wall.", {"a", "b"});
  Say("The dining table is in the middle of the room.", {"table"});
  Complete();
  EXPECT_THAT(Written(), ElementsAre("The dining table is in the middle of the room."));
  ASSERT_EQ(completed_.cleaning_steps_size(), 1);
  EXPECT_EQ(completed_.cleaning_steps(0).action(), v1::CLEANING_ACTION_USE_FIRST);
  EXPECT_EQ(completed_.cleaning_steps(0).reason(),
            "\"Each dining chair is near a wall.\" gives way to \"The dining chairs surround the dining table.\"");
}

TEST_F(Strangers, TheUsersWordsGiveWayToNothing) {
  Piece("table", "dining table");
  Piece("a", "dining chair");
  Piece("b", "dining chair");
  Say("Each dining chair is near a wall.", {"a", "b"}).set_origin(v1::SENTENCE_ORIGIN_BRIEF);
  Complete();
  EXPECT_THAT(Written(), ElementsAre("Each dining chair is near a wall."));
}

TEST_F(Strangers, NorDoTheConstraintsThatABriefBrings) {
  Piece("table", "dining table");
  Piece("a", "dining chair");
  Piece("b", "dining chair");
  Say("Each dining chair is near a wall.", {"a", "b"});
  *brief_.mutable_constraint_list() = list_;
  list_.mutable_sentences(0)->set_id("s1_simple");
  list_.mutable_sentences(0)->add_made_from_ids("s1");
  Complete();
  EXPECT_THAT(Written(), ElementsAre("Each dining chair is near a wall."));
}

TEST_F(Strangers, WhatIsSaidIsNotSaidAgain) {
  Piece("sofa", "sofa");
  Piece("low", "coffee table");
  Say("The coffee table is at most 0.4 m in front of the sofa.", {"low", "sofa"});
  Complete();
  EXPECT_THAT(Implied(), Not(Contains("The coffee table is at most 0.4 m in front of the sofa.")));
}

TEST_F(Strangers, TertiaryThatIsPlacedStaysThere) {
  Piece("sofa", "sofa");
  Piece("rug", "area rug", v1::OBJECT_ROLE_TERTIARY);
  Say("The area rug lies in the middle of the room.", {"rug"}).set_scope(v1::SENTENCE_SCOPE_TERTIARY);
  Complete();
  for (const std::string& text : Implied()) EXPECT_THAT(text, Not(::testing::HasSubstr("rug")));
}

TEST_F(Strangers, UnknownThingsGetNothing) {
  Piece("x", "flux capacitor");
  Complete();
  EXPECT_THAT(Implied(), IsEmpty());
  EXPECT_EQ(completed_.SerializeAsString(), list_.SerializeAsString());
}

TEST(CompleteConstraints, AddsNothingToTheHandbooksOwnButSaysWhatIsAUse) {
  int uses = 0;
  for (const hb::Archetype& archetype : TheHandbook().contents().archetypes()) {
    SCOPED_TRACE(archetype.name());
    v1::Brief brief;
    brief.set_text("A " + archetype.name());
    const v1::Room room = *DescribeRoom(brief, TheHandbook());
    const v1::ZonePlan zones = *PlanZones(brief, room, TheHandbook());
    const v1::ObjectList objects = *ListObjects(brief, room, zones, TheHandbook());
    const v1::ConstraintList cleaned = CleanConstraints(*ListConstraints(brief, room, zones, objects, TheHandbook()));
    v1::ConstraintList completed = CompleteConstraints({brief, room, zones}, objects, cleaned, TheHandbook());
    for (v1::Sentence& sentence : *completed.mutable_sentences()) {
      uses += sentence.use() ? 1 : 0;
      sentence.clear_use();
    }
    EXPECT_EQ(completed.DebugString(), cleaned.DebugString());
  }
  EXPECT_GT(uses, 0);
}

}  // namespace
}  // namespace flair::language
