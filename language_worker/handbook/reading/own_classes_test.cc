// SPDX-License-Identifier: GPL-3.0-or-later
// Things that the handbook does not know, and pieces where their class does not belong.
#include "language_worker/handbook/reading/own_classes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "language_worker/handbook/testing/test_handbook.h"

namespace flair::language {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;

std::vector<std::string> OwnOf(const std::string& text) {
  const BriefFacts facts = FactsOf(text);
  std::vector<std::string> names;
  if (!facts.own_handbook) return names;
  for (const hb::Furniture& furniture : facts.own_handbook->own()) names.push_back(furniture.name());
  return names;
}

hb::FurnitureKind KindIn(const std::string& text, const std::string& name) {
  const BriefFacts facts = FactsOf(text);
  const hb::Furniture* furniture = facts.HandbookOr(TheHandbook()).FindFurniture(name);
  return furniture == nullptr ? hb::FURNITURE_KIND_UNSPECIFIED : furniture->kind();
}

TEST(OwnClasses, AThingThatIsPutSomewhereIsMade) {
  EXPECT_THAT(OwnOf("A study with a desk and a zither on the desk."), ElementsAre("zither"));
  EXPECT_EQ(KindIn("A study with a desk and a zither on the desk.", "zither"), hb::FURNITURE_KIND_SURFACE);
  EXPECT_EQ(KindIn("A study with a desk and a zither in the corner.", "zither"), hb::FURNITURE_KIND_FLOOR);
  EXPECT_EQ(KindIn("A study with a large wooden zither mounted on the wall.", "zither"), hb::FURNITURE_KIND_WALL);
  EXPECT_EQ(KindIn("A study with a zither hanging from the ceiling.", "zither"), hb::FURNITURE_KIND_CEILING);
}

TEST(OwnClasses, AThingThatIsListedIsMadeAndTheBriefIsTold) {
  const std::string text = "A workshop with a zither, two gloops and a touch of gold.";
  EXPECT_THAT(OwnOf(text), ElementsAre("zither", "gloop"));
  EXPECT_EQ(KindIn(text, "gloop"), hb::FURNITURE_KIND_FLOOR);
  EXPECT_THAT(FactsOf(text).made_plain, ElementsAre("zither", "gloop"));
}

TEST(OwnClasses, MoodsPeopleAndPartsOfTheRoomAreNoPieces) {
  for (const char* text :
       {"A living room for a zither.", "A living room with a slice of life.",
        "A living room with a touch of gold in the corner.", "A bedroom with a view over the garden.",
        "A study for a writer by the window.", "A study for a crime writer by the window.",
        "A bedroom with a high ceiling and a feature wall behind the bed."}) {
    EXPECT_THAT(OwnOf(text), IsEmpty()) << text;
  }
}

TEST(OwnClasses, AnEndlessWordIsNoName) {
  EXPECT_THAT(OwnOf("A workshop with a " + std::string(300, 'x') + " and a zither."), ElementsAre("zither"));
}

TEST(OwnClasses, ALastWordThatIsKnownSaysOfWhatKindItIs) {
  const BriefFacts facts = FactsOf("A study with a reagent cabinet against the wall.");
  ASSERT_THAT(OwnOf("A study with a reagent cabinet against the wall."), ElementsAre("reagent cabinet"));
  EXPECT_EQ(facts.base_of_own.at("reagent cabinet"), "storage cabinet");
  EXPECT_EQ(facts.wishes.front().furniture->name(), "reagent cabinet");
}

TEST(OwnClasses, SmallThingsAreCalledAsTheBriefCallsThem) {
  EXPECT_THAT(OwnOf("A living room with a coffee table that holds a mug, two plates and a novel."),
              ElementsAre("mug", "novel"));
  EXPECT_THAT(OwnOf("An office with a desk for writing letters."), IsEmpty());
}

TEST(OwnClasses, PiecesAreCarriedAsTheBriefSays) {
  constexpr const char* kOnATable = "A living room with a side table and a potted plant on the side table.";
  EXPECT_EQ(KindIn(kOnATable, "potted plant"), hb::FURNITURE_KIND_SURFACE);
  constexpr const char* kOnTheWall = "A living room with a television mounted on the wall and a sofa.";
  EXPECT_EQ(KindIn(kOnTheWall, "television"), hb::FURNITURE_KIND_WALL);
  EXPECT_THAT(OwnOf("A living room with a television and a potted plant by the window."),
              Not(Contains("potted plant")));
}

TEST(OwnClasses, AStandIsAThingWhereItIsNoVerb) {
  EXPECT_THAT(OwnOf("A bakery with an oven, merchandise stands and a table."), ElementsAre("merchandise stand"));
  EXPECT_THAT(OwnOf("A shop with a sample stand by the door."), ElementsAre("sample stand"));
  EXPECT_THAT(OwnOf("A bedroom where the bed stands by the door."), IsEmpty());
}

}  // namespace
}  // namespace flair::language
