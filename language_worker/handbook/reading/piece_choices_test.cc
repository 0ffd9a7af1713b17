// SPDX-License-Identifier: GPL-3.0-or-later
// Which of what a brief names is to be in the room, and how much of it.
#include "language_worker/handbook/reading/piece_choices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "language_worker/handbook/objects/list_objects.h"
#include "language_worker/handbook/rooms/describe_room.h"
#include "language_worker/handbook/styling/choose_style.h"
#include "language_worker/handbook/testing/test_handbook.h"

namespace flair::language {
namespace {

int CountOf(const BriefFacts& facts, const std::string& name) {
  const auto wish = std::ranges::find_if(facts.wishes, [&](const Wish& one) { return one.furniture->name() == name; });
  return wish == facts.wishes.end() ? 0 : wish->count;
}

v1::ObjectList ObjectsOf(const v1::Brief& brief, const v1::Room& room) {
  return *ListObjects(brief, room, *PlanZones(brief, room, TheHandbook()), TheHandbook());
}

int Listed(const std::string& text, const std::string& name) {
  v1::Brief brief;
  brief.set_text(text);
  const v1::ObjectList list = ObjectsOf(brief, RoomOf(text, 0));
  return static_cast<int>(std::ranges::count(list.objects(), name, &v1::Object::name));
}

TEST(PieceChoices, OfTwoTheFirstUnlessThereIsSpaceForTheOther) {
  const BriefFacts small =
      FactsOf("A kitchen, 3 x 2.4 m, with a table for two or an island with stools if there is space.");
  EXPECT_EQ(CountOf(small, "dining table"), 1);
  EXPECT_EQ(CountOf(small, "kitchen island"), 0);
  const std::string large = "A kitchen, 6 x 5 m, with a table for two or an island with two stools if there is space.";
  EXPECT_EQ(CountOf(FactsOf(large), "kitchen island"), 1);
  EXPECT_EQ(Listed(large, "dining table"), 0);
  const BriefFacts plain = FactsOf("A study with a recliner or a chaise longue and a desk.");
  EXPECT_EQ(CountOf(plain, "recliner"), 1);
  EXPECT_EQ(CountOf(plain, "chaise longue"), 0);
}

TEST(PieceChoices, NumbersThatAreLeftOpenAreNoChoiceOfPieces) {
  const BriefFacts cafe = FactsOf("A cafe of 40 sq m. A counter with a cake display, four or five tables for two.");
  EXPECT_EQ(CountOf(cafe, "dining table"), 5);
  EXPECT_EQ(CountOf(cafe, "pastry display"), 1);
}

TEST(PieceChoices, OnePieceMayServeAsAnother) {
  const std::string text =
      "A nursery with a crib, a rocking chair and a chest of drawers which also serves as changing table.";
  EXPECT_EQ(CountOf(FactsOf(text), "changing table"), 0);
  EXPECT_EQ(Listed(text, "changing table"), 0);
  EXPECT_EQ(Listed(text, "chest of drawers"), 1);
}

TEST(PieceChoices, WhatIsAskedForTakesThePlaceOfTheUsual) {
  EXPECT_EQ(Listed("A teenager's room, 3 x 4 m, with a daybed, a desk and a bookshelf.", "single bed"), 0);
  EXPECT_EQ(Listed("A bathroom, 3 x 3 m, with a double vanity, a shower and a toilet.", "vanity unit"), 0);
}

TEST(PieceChoices, WhatPeopleBringOrIsElsewhereIsNotInTheRoom) {
  EXPECT_EQ(CountOf(FactsOf("A café with four tables. Guests arrive with suitcases and prams."), "pram"), 0);
  EXPECT_EQ(Listed("A café with four tables. Guests arrive with suitcases and prams.", "suitcase"), 0);
  EXPECT_EQ(CountOf(FactsOf("A playroom with a toy chest. Use the wardrobe in the hall for coats."), "wardrobe"), 0);
  EXPECT_EQ(CountOf(FactsOf("A playroom with a toy chest and a wardrobe in the corner."), "wardrobe"), 1);
}

TEST(PieceChoices, ManyAreAsManyAsTheFloorHasPlacesFor) {
  EXPECT_EQ(CountOf(FactsOf("A living room of 20 m2 with loads of plants."), "floor plant"), 4);
  EXPECT_EQ(CountOf(FactsOf("A living room of 20 m2 with eight plants."), "floor plant"), 8);
}

TEST(PieceChoices, PeopleInGroupsHaveTablesForAsMany) {
  const std::string text = "A classroom, 9 x 8 m, for 20 children sitting in groups of five, with a teacher's desk.";
  EXPECT_EQ(Listed(text, "classroom table"), 4);
  EXPECT_EQ(Listed(text, "school chair"), 20);
  EXPECT_GE(Listed("A classroom, 9 x 8 m, for 18 pupils, a teacher's desk, a sink and a bookcase.", "school desk"), 18);
}

TEST(PieceChoices, OverheadLightsAreAllThatHang) {
  const BriefFacts facts = FactsOf("A living room with a sofa, no overhead lighting.");
  for (const char* lamp : {"chandelier", "pendant light", "ceiling light"}) {
    EXPECT_TRUE(std::ranges::any_of(facts.refusals, [&](const auto* one) { return one->name() == lamp; })) << lamp;
  }
}

TEST(PieceChoices, LooksThatARoomIsNotToHaveAreNone) {
  const BriefFacts facts = FactsOf("A bedroom in mint, nothing orange or rustic.");
  ASSERT_EQ(facts.colours.size(), 1U);
  EXPECT_EQ(facts.colours[0]->name(), "mint");
  ASSERT_EQ(facts.refused_colours.size(), 1U);
  EXPECT_EQ(facts.refused_colours[0]->name(), "orange");
}

TEST(PieceChoices, ColoursOfTheBriefAreThoseOfSeatsAndCushions) {
  v1::Brief brief;
  brief.set_text("A living room in cream, teal and mustard with a sofa and a rug.");
  const v1::Room room = RoomOf(brief.text(), 0);
  const v1::ObjectList objects = ObjectsOf(brief, room);
  const v1::StyleSheet style = *ChooseStyle(brief, room, objects, TheHandbook());
  const auto colour_of = [&](const std::string& id) {
    const auto one = std::ranges::find(style.objects(), id, &v1::ObjectStyle::subject_id);
    return one == style.objects().end() ? "" : one->colour().name();
  };
  EXPECT_EQ(colour_of("sofa"), "teal");
  EXPECT_EQ(colour_of("area_rug"), "mustard");
}

}  // namespace
}  // namespace flair::language
