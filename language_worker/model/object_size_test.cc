// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <string>

#include "language_worker/model/model_tools.h"
#include "language_worker/service/testing/model_session.h"

namespace flair::language {
namespace {

std::string NameOf(const hb::Furniture* furniture) { return furniture == nullptr ? "" : furniture->name(); }

TEST(FurnitureIndex, FindsTheLongestEndingThatIsKnown) {
  const FurnitureIndex index(ModelSession::handbook());
  EXPECT_EQ(NameOf(index.Find("Oak coffee tables")), "coffee table");
  EXPECT_EQ(NameOf(index.Find("ergonomic desk-chair")), "office chair");
  EXPECT_EQ(NameOf(index.Find("tall bookshelves")), "bookshelf");
  EXPECT_EQ(NameOf(index.Find("couch")), "sofa");
  EXPECT_EQ(NameOf(index.Find("flux capacitor")), "");
  EXPECT_EQ(NameOf(index.Find("")), "");
  EXPECT_EQ(NameOf(index.FindExact("oak coffee table")), "");
}

TEST(FurnitureIndex, RugsAreWhatLiesOnTheFloor) {
  for (const char* name : {"Persian rug", "bath mat", "area rugs", "carpet"}) EXPECT_TRUE(IsRugName(name)) << name;
  for (const char* name : {"table runner", "place mat", "rug beater", "mattress"})
    EXPECT_FALSE(IsRugName(name)) << name;
}

TEST(IdMaker, IdsAreUniqueShortAndPlain) {
  IdMaker ids;
  EXPECT_EQ(ids.Make("Café Table!", "object"), "caf_table");
  EXPECT_EQ(ids.Make("café table", "object"), "caf_table_2");
  EXPECT_EQ(ids.Make("家具", "object"), "object");
  EXPECT_EQ(ids.MakeSeveral("chair 1", 1, "object").front(), "chair_1");
  EXPECT_EQ(ids.MakeSeveral("chair", 2, "object").front(), "chair_2") << "chair_1 is taken";
  const std::string longest = ids.Make(std::string(200, 'x'), "object");
  EXPECT_LE(longest.size(), 64U);
  EXPECT_NE(ids.Make(std::string(200, 'x'), "object"), longest);
}

TEST(OddSize, TellsAWrongUnitFromAnUnusualPiece) {
  const hb::Furniture* desk = ModelSession::handbook().FindFurniture("desk");
  ASSERT_NE(desk, nullptr);
  EXPECT_EQ(OddSize({1.2, 0.6, 0.75}, desk), "");
  EXPECT_EQ(OddSize({0.6, 1.2, 0.75}, desk), "") << "the sides swapped";
  EXPECT_EQ(OddSize({2.4, 0.9, 0.75}, desk), "") << "a long one";
  EXPECT_NE(OddSize({5.2, 2.6, 0.75}, desk), "") << "feet taken for metres";
  EXPECT_NE(OddSize({0.12, 0.06, 0.75}, desk), "");
  EXPECT_EQ(OddSize({9, 9, 9}, nullptr), "");
}

}  // namespace
}  // namespace flair::language
