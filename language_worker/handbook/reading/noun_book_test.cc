// SPDX-License-Identifier: GPL-3.0-or-later
// What words for several pieces, compounds and other spellings become in one kind of room and another.
#include "language_worker/handbook/reading/noun_book.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <string>
#include <utility>

#include "language_worker/handbook/program/room_program.h"
#include "language_worker/handbook/testing/test_handbook.h"

namespace flair::language {
namespace {

// "2 armchair, 1 sofa", in the order of the text.
std::string WishesOf(const std::string& text) {
  std::string all;
  for (const Wish& wish : FactsOf(text).wishes) {
    all += (all.empty() ? "" : ", ") + std::to_string(wish.count) + " " + wish.furniture->name();
  }
  return all;
}

void ExpectWishes(std::initializer_list<std::pair<const char*, const char*>> cases) {
  for (const auto& [text, wishes] : cases) EXPECT_EQ(WishesOf(text), wishes) << text;
}

TEST(NounBook, ANounMeansWhatTheRoomHas) {
  ExpectWishes({{"A meeting room for 8, 4m x 5m: table in the centre.", "1 conference table"},
                {"A bedroom with a bed, a chair and a table.", "1 double bed, 1 armchair, 1 side table"},
                {"A dining room with a table and six chairs.", "1 dining table"},
                {"A home office with a chair.", "1 office chair"},
                {"A living room with a table.", "1 coffee table"},
                {"A kitchen with a sink.", "1 kitchen sink"},
                {"A bathroom with a sink.", "1 washbasin"},
                {"An art studio with a sink.", "1 utility sink"},
                {"A child's bedroom with storage.", "1 toy chest"},
                {"A bedroom with a lamp.", "1 table lamp"},
                {"A home office with somewhere to sit.", "1 armchair"},
                {"A lounge with a stove.", "1 fireplace"}});
}

TEST(NounBook, TheWordsBeforeANounTellWhichOne) {
  ExpectWishes({{"A living room with two wingback chairs.", "2 armchair"},
                {"A living room with two frobnicated chairs.", "2 armchair"},
                {"A home office with a comfy leather chair to think in.", "1 armchair"},
                {"A study with an L-shaped desk.", "1 corner desk"},
                {"A living room with a sectional couch.", "1 corner sofa"},
                {"A study with a small round table.", "1 round dining table"},
                {"A consulting room with a privacy screen.", "1 room divider"}});
}

TEST(NounBook, NumbersWithinACompoundAreSizesAndNoCounts) {
  ExpectWishes({{"A living room with a three-seat sofa.", "1 sofa"},
                {"A living room with a 2-seater sofa.", "1 loveseat"},
                {"A living room with a two-seater.", "1 loveseat"},
                {"A dining room with a ten-foot table.", "1 dining table"},
                {"A bedroom with a four-poster bed and two four-drawer chests.", "1 double bed, 2 chest of drawers"},
                {"A bedroom with a 4-poster bed and a two-door wardrobe.", "1 double bed, 1 wardrobe"},
                {"A living room with a 2 m long sofa and a 65\" tv.", "1 sofa, 1 television"},
                {"A kitchen with a six-burner cooker.", "1 cooker"}});
}

TEST(NounBook, RowsTimesPiecesAreTheirNumber) {
  ExpectWishes({{"A chapel with two rows of five benches.", "10 pew"},
                {"A home cinema with 2 rows of four leather recliners.", "8 recliner"},
                {"A yoga studio with mats in 3 rows of 4.", "12 yoga mat"},
                {"A chapel with five pews.", "5 pew"}});
}

TEST(NounBook, FewIsOneAndNoneIsNoneOfTheKind) {
  ExpectWishes({{"A living room with not too many pictures.", "1 painting"},
                {"A living room, hardly any cushions.", "1 cushion"},
                {"A living room with a few armchairs.", "3 armchair"}});
  const BriefFacts facts = FactsOf("A living room without plants.");
  for (const char* name : {"floor plant", "hanging planter", "plant stand", "bonsai"}) {
    EXPECT_TRUE(std::ranges::any_of(facts.refusals, [&](const auto* one) { return one->name() == name; })) << name;
  }
}

TEST(NounBook, OneWordMayBeTwoAndTwoOne) {
  ExpectWishes(
      {{"A bar with 8 barstools.", "8 bar stool"},
       {"A living room with an arm chair, a book case and a foot stool.", "1 armchair, 1 bookshelf, 1 ottoman"}});
  EXPECT_EQ(FactsOf("A bed room with 2 single beds.").archetype->name(), "bedroom");
  EXPECT_EQ(WishesOf("A bed room with 2 single beds."), "2 single bed");
}

TEST(NounBook, OtherThingsAreToldAndNotFurnished) {
  for (const char* thing : {"commode chair", "luggage rack", "vending stand", "proofing cabinet", "flower bed"}) {
    const BriefFacts facts = FactsOf(std::string("A bedroom, 4m x 5m, with a ") + thing + ".");
    EXPECT_TRUE(facts.wishes.empty()) << thing;
    ASSERT_EQ(facts.not_known.size(), 1u) << thing;
    EXPECT_EQ(facts.not_known[0], thing);
  }
}

TEST(NounBook, WhatIsAskedForComesInsteadOfItsLike) {
  const struct {
    const char* text;
    const char* asked;
    const char* usual;
  } kCases[] = {{"A living room with a corner sofa.", "corner sofa", "sofa"},
                {"A study with an L-shaped desk.", "corner desk", "desk"},
                {"A bedroom with a king bed.", "king bed", "double bed"},
                {"A dining room with a round table.", "round dining table", "dining table"}};
  for (const auto& one : kCases) {
    const RoomProgram program = MakeRoomProgram(FactsOf(one.text), TheHandbook(), 20, Choice(0, one.text));
    EXPECT_TRUE(Lists(program, one.asked)) << one.text;
    EXPECT_FALSE(Lists(program, one.usual)) << one.text;
  }
}

TEST(NounBook, MisspeltWordsAreReadAndTold) {
  const BriefFacts facts = FactsOf("A kichen with an iland.");
  EXPECT_EQ(facts.archetype->name(), "kitchen");
  ASSERT_EQ(facts.corrections.size(), 2u);
  EXPECT_EQ(facts.corrections[1].written, "iland");
  EXPECT_EQ(WishesOf("A kichen with an iland."), "1 kitchen island");
}

}  // namespace
}  // namespace flair::language
