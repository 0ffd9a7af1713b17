// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/sentences/list_constraints.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "language_worker/handbook/objects/list_objects.h"
#include "language_worker/handbook/rooms/describe_room.h"
#include "language_worker/handbook/testing/test_handbook.h"
#include "worker_runtime/files/files.h"

namespace flair::language {
namespace {

struct Design {
  v1::ObjectList objects;
  v1::ConstraintList constraints;
};

Design Ask(const std::string& text, std::int64_t seed) {
  v1::Brief brief;
  brief.set_text(text);
  brief.set_seed(seed);
  const v1::Room room = *DescribeRoom(brief, TheHandbook());
  const v1::ZonePlan zones = *PlanZones(brief, room, TheHandbook());
  Design design;
  design.objects = *ListObjects(brief, room, zones, TheHandbook());
  design.constraints = *ListConstraints(brief, room, zones, design.objects, TheHandbook());
  return design;
}

void ExpectEveryTertiaryPlacedByOneSentence(const Design& design) {
  std::map<std::string, int> sentences;
  for (const v1::Sentence& sentence : design.constraints.sentences()) {
    if (sentence.scope() == v1::SENTENCE_SCOPE_TERTIARY) ++sentences[sentence.subject_ids(0)];
  }
  for (const v1::Object& object : design.objects.objects()) {
    if (object.role() == v1::OBJECT_ROLE_TERTIARY) EXPECT_EQ(sentences[object.id()], 1) << object.id();
  }
}

void ExpectEveryObjectInASentence(const Design& design) {
  std::map<std::string, int> sentences;
  for (const v1::Sentence& sentence : design.constraints.sentences()) {
    for (const std::string& id : sentence.subject_ids()) ++sentences[id];
  }
  for (const v1::Object& object : design.objects.objects()) EXPECT_GT(sentences[object.id()], 0) << object.id();
}

void ExpectThingsOnATopAtSpotsOfTheirOwn(const Design& design) {
  std::map<std::string, std::string> on_host;  // spot of a host -> who stands there
  std::map<std::string, std::string> host_of;
  for (const v1::Object& object : design.objects.objects()) {
    const bool flat = object.height_m() <= 0.03;  // lies under the others
    if (object.kind() == v1::OBJECT_KIND_SURFACE && !flat) host_of[object.id()] = object.host_id();
  }
  for (const v1::Sentence& sentence : design.constraints.sentences()) {
    const auto host = host_of.find(sentence.subject_ids(0));
    if (host == host_of.end()) continue;
    const std::size_t corner = sentence.text().find(" corner of ");
    const std::string spot = corner == std::string::npos ? "centre" : sentence.text().substr(corner - 10, 10);
    const auto [there, free] = on_host.emplace(host->second + ":" + spot, host->first);
    EXPECT_TRUE(free) << there->second << " and " << host->first << " both: " << sentence.text();
  }
}

// tests/stages compares what is meant with what is read.
void ExpectMeanings(const Design& design) {
  for (const v1::Sentence& sentence : design.constraints.sentences()) {
    EXPECT_GT(sentence.meaning().facts_size(), 0) << sentence.text();
    EXPECT_EQ(sentence.meaning().text_digest(), runtime::Sha256Hex(sentence.text())) << sentence.text();
  }
}

// Over every kind of room and a few seeds; all is looked at in each design: making it takes longer.
TEST(ListConstraints, SentencesOfEveryKindOfRoomAreInOrder) {
  for (const hb::Archetype& archetype : TheHandbook().contents().archetypes()) {
    for (std::int64_t seed = 0; seed < 3; ++seed) {
      SCOPED_TRACE(archetype.name() + " seed " + std::to_string(seed));
      const Design design = Ask("A " + archetype.name(), seed);
      ExpectEveryTertiaryPlacedByOneSentence(design);
      ExpectEveryObjectInASentence(design);
      ExpectThingsOnATopAtSpotsOfTheirOwn(design);
      ExpectMeanings(design);
    }
  }
}

TEST(ListConstraints, PlacesThatBriefsAskForCarryTheirMeaning) {
  for (const char* text : {"A bedroom 4 x 5 m with the bed against the north wall.",
                           "A study 4 x 4 m with the desk in the north east corner.",
                           "A living room 5 x 6 m with a floor lamp between the sofa and the armchair.",
                           "A study 4 x 5 m with a desk facing the door."}) {
    int asked = 0;
    const Design design = Ask(text, 0);
    for (const v1::Sentence& sentence : design.constraints.sentences()) {
      asked += sentence.origin() == v1::SENTENCE_ORIGIN_BRIEF;
      EXPECT_GT(sentence.meaning().facts_size(), 0) << sentence.text();
    }
    EXPECT_GT(asked, 0) << text;
  }
}

// The text, reason and meaning of the sentences that a brief asks for.
std::vector<v1::Sentence> AskedFor(const char* text) {
  std::vector<v1::Sentence> asked;
  const Design design = Ask(text, 0);
  for (const v1::Sentence& sentence : design.constraints.sentences()) {
    if (sentence.origin() == v1::SENTENCE_ORIGIN_BRIEF) asked.push_back(sentence);
  }
  return asked;
}

TEST(ListConstraints, PlacesGiveTheWordsOfTheBriefForTheirReason) {
  const std::vector<v1::Sentence> asked = AskedFor(
      "A dining room 5 x 5 m, door on the south wall, a garden door on the north wall, table near the garden "
      "door.");
  ASSERT_EQ(asked.size(), 1u);
  EXPECT_EQ(asked[0].reason(), "the brief asks for \"table near the garden door\"");
  EXPECT_FALSE(asked[0].has_meaning()) << "which door it is stands in its words";
}

TEST(ListConstraints, WhatStandsBetweenTwoKeepsThemOutOfARow) {
  std::string all;
  for (const v1::Sentence& sentence :
       AskedFor("A bedroom 4 x 5 m with two single beds side by side and a chest of drawers between them."))
    all += sentence.text() + "\n";
  EXPECT_EQ(all.find("in a row"), std::string::npos) << all;
}

TEST(ListObjects, SeatsOfSeveralTablesAreToldTogether) {
  const Design design =
      Ask("A cafe 7 x 6 m with six small round tables with two chairs each and one table for eight.", 0);
  const auto chairs = std::ranges::count(design.objects.objects(), "dining chair", &v1::Object::name);
  const bool told = std::ranges::any_of(design.objects.diagnostics(), [](const v1::Diagnostic& remark) {
    return remark.code() == "fewer_than_asked" && remark.message().find("dining chair") != std::string::npos;
  });
  EXPECT_EQ(told, chairs < 20) << chairs;
}

TEST(ListConstraints, OneOfSeveralDoorsAndWindowsIsNamed) {
  const auto asked = [](const char* text) {
    std::string sentences;
    const Design design = Ask(text, 0);
    for (const v1::Sentence& sentence : design.constraints.sentences()) {
      if (sentence.origin() == v1::SENTENCE_ORIGIN_BRIEF) sentences += sentence.text() + "\n";
    }
    return sentences;
  };
  EXPECT_EQ(asked("A dining room 5 x 5 m, door on the south wall, a garden door on the north wall, table near the "
                  "garden door."),
            "The dining table is near the north door.\n");
  EXPECT_EQ(asked("A study 4 x 4 m with a window on the north wall and one on the east wall, the desk under the east "
                  "window."),
            "The desk is under the east window.\n");
  EXPECT_EQ(asked("A study 4 x 4 m with one big window, the desk under the big window."),
            "The desk is under the window.\n");
}

TEST(ListConstraints, PlacesOfSeveralAreSharedOut) {
  const auto said = [](const std::string& text) {
    std::string all;
    const Design design = Ask(text, 1);
    for (const v1::Sentence& sentence : design.constraints.sentences()) all += sentence.text() + "\n";
    return all;
  };
  const std::string shelves =
      said("A bookshop, 4 by 11 m, door in the south, with four bookshelves on both long walls.");
  for (const char* wall : {"first bookshelf's back is against the east", "fourth bookshelf's back is against the west"})
    EXPECT_THAT(shelves, testing::HasSubstr(wall));
  EXPECT_THAT(said("A barber shop, 4.5 x 6 m, door in the north, with four barber chairs along the east wall."),
              testing::HasSubstr("The fourth styling station's back is against the east wall."));
  EXPECT_THAT(said("A student room, 3.2 x 2.6 m, with a single bed along the south wall."),
              testing::HasSubstr("One long side of the single bed is against the south wall."));
  EXPECT_THAT(said("A lounge, 6 x 6 m, with four armchairs around a coffee table."),
              testing::HasSubstr("The armchairs surround the coffee table 0.4 m away."));
  EXPECT_THAT(said("A bedroom, 4 x 5 m, with a bed and a dresser at the foot of the bed."),
              testing::HasSubstr("The dresser faces the double bed."));
}

TEST(ListConstraints, BenchesAreTheSeatsOfTheirTable) {
  const auto ends_with_bench = [](const v1::Object& one) { return one.name().ends_with(" bench"); };
  for (const char* const brief : {"A dining room with a long table with benches.",
                                  "A craft room, 5 x 4 m: one long table, benches down both sides.",
                                  "A kitchen, 6 x 5 m, with a big table and two benches."}) {
    const Design design = Ask(brief, 1);
    EXPECT_EQ(std::ranges::count_if(design.objects.objects(), ends_with_bench), 2) << brief;
    EXPECT_EQ(std::ranges::count(design.objects.objects(), "dining chair", &v1::Object::name), 0) << brief;
    std::string all;
    for (const v1::Sentence& sentence : design.constraints.sentences()) all += sentence.text() + "\n";
    EXPECT_THAT(all, testing::HasSubstr("bench is next to the front of the")) << brief;
    EXPECT_THAT(all, testing::HasSubstr("bench is next to the back of the")) << brief;
  }
  const Design hall = Ask("A beer hall, 12 x 9 m, with six long tables with benches.", 1);
  EXPECT_EQ(std::ranges::count_if(hall.objects.objects(), ends_with_bench), 12);
}

TEST(ListConstraints, VerbsFollowPluralNames) {
  const Design design = Ask("A dining room", 1);
  for (const v1::Sentence& sentence : design.constraints.sentences()) {
    EXPECT_EQ(sentence.text().find("flowers is"), std::string::npos) << sentence.text();
    EXPECT_EQ(sentence.text().find("candles is"), std::string::npos) << sentence.text();
  }
}

bool Says(const Design& design, const std::string& text) {
  return std::ranges::any_of(design.constraints.sentences(),
                             [&](const v1::Sentence& sentence) { return sentence.text() == text; });
}

const v1::Object* Find(const Design& design, const std::string& name) {
  const auto found = std::ranges::find(design.objects.objects(), name, &v1::Object::name);
  return found == design.objects.objects().end() ? nullptr : &*found;
}

TEST(ListConstraints, TheLadderOfABunkBedStaysFree) {
  const Design design = Ask("A child's bedroom, 4 x 3.2 m, with a bunk bed.", 0);
  EXPECT_TRUE(Says(design, "The left side of the bunk bed is against a wall."));
  EXPECT_TRUE(Says(design, "The right side of the bunk bed has 0.6 m of clear space."));
}

TEST(ListConstraints, KneesHaveRoomBetweenSofaAndLowTable) {
  EXPECT_TRUE(Says(Ask("A living room, 5 x 4 m.", 0), "The coffee table is at least 0.35 m away from the sofa."));
}

TEST(ListConstraints, ArmchairsMakeACornerWithTheSofaRoundTheFire) {
  const Design design = Ask("A sitting room, 5 x 4.5 m, with a wood stove, a sofa and two armchairs.", 0);
  EXPECT_TRUE(Says(design, "The sofa faces the wood stove."));
  EXPECT_TRUE(Says(design, "The second armchair is at a right angle to the sofa."));
}

TEST(ListConstraints, TheClosestOfSeveralTellsWhichNotWhereAllStand) {
  const std::string lamp = ", and a reading lamp beside the chair closest to the window.";
  const Design design = Ask("A living room, 5.4 x 4.1 m, with a sofa, two lounge chairs" + lamp, 0);
  EXPECT_FALSE(Says(design, "The first lounge chair is near the window."));
  ASSERT_NE(Find(design, "lounge chair"), nullptr);
  EXPECT_EQ(Find(design, "lounge chair")->zone_id(), Find(design, "sofa")->zone_id());
}

TEST(ListConstraints, LowStoragePiecesStandBesideAWindow) {
  const Design design = Ask("A dining room, 4 x 4.5 m, with a table for six and a sideboard.", 0);
  EXPECT_TRUE(Says(design, "The sideboard is at least 0.05 m away from the windows."));
}

TEST(ListObjects, NobodyWatchesAScreenBesideTheFireThatTheyAskedFor) {
  for (const char* fire : {"a fireplace", "a log burner"}) {
    EXPECT_EQ(Find(Ask(std::string("A living room with ") + fire, 0), "tv stand"), nullptr) << fire;
    EXPECT_NE(Find(Ask(std::string("A living room with a TV and ") + fire, 0), "tv stand"), nullptr) << fire;
  }
}

TEST(ListObjects, ATeenagersRoomHasAPlaceForClothesAndALargeRoomALargeRug) {
  EXPECT_NE(Find(Ask("A teenager's room, 3.7 x 3 m: a daybed, a desk and a vanity.", 0), "wardrobe"), nullptr);
  EXPECT_EQ(Find(Ask("A teenager's room, 3.7 x 3 m: a daybed, a desk, a dresser.", 0), "wardrobe"), nullptr);
  EXPECT_DOUBLE_EQ(Find(Ask("A living room, 6 x 5 m.", 0), "area rug")->width_m(), 3);
  EXPECT_LT(Find(Ask("A living room, 4 x 5 m.", 0), "area rug")->width_m(), 2.5);
}

TEST(ListObjects, ABathroomForAWheelchairHasRailsAndNothingToTripOver) {
  const Design design =
      Ask("A bathroom, 2.2 x 2.6 m, for my old parents, with a shower and place for a wheelchair.", 0);
  for (const char* there : {"grab rail", "washbasin"}) EXPECT_NE(Find(design, there), nullptr) << there;
  for (const char* gone : {"bath mat", "vanity unit"}) EXPECT_EQ(Find(design, gone), nullptr) << gone;
}

TEST(ListObjects, EachNightstandOfAStudioFlatHasALamp) {
  const Design design = Ask("A studio flat, 28 m2, with a double bed and two nightstands.", 0);
  EXPECT_EQ(std::ranges::count(design.objects.objects(), "table lamp", &v1::Object::name), 2);
}

TEST(ListConstraints, PlantsStandNotBehindADoor) {
  EXPECT_TRUE(Says(Ask("A living room, 5 x 4 m, with a floor plant.", 0),
                   "The floor plant is at least 0.5 m away from the door."));
}

}  // namespace
}  // namespace flair::language
