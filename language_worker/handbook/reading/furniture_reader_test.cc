// SPDX-License-Identifier: GPL-3.0-or-later
// What a brief asks for and refuses, in words that mean one thing here and another there.
#include "language_worker/handbook/reading/furniture_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "language_worker/handbook/testing/test_handbook.h"

namespace flair::language {
namespace {

const Wish* WishFor(const BriefFacts& facts, const std::string& name) {
  const auto wish = std::ranges::find_if(facts.wishes, [&](const Wish& one) { return one.furniture->name() == name; });
  return wish == facts.wishes.end() ? nullptr : &*wish;
}

bool Refuses(const BriefFacts& facts, const std::string& name) {
  return std::ranges::any_of(facts.refusals, [&](const auto* one) { return one->name() == name; });
}

TEST(FurnitureReader, ChairsBelongToTheTableTheyAreNamedWith) {
  const struct {
    const char* text;
    const char* table;
    int seats;
  } kCases[] = {{"An office with four desks and a meeting table with six chairs.", "conference table", 6},
                {"A dining room with a round table and five chairs.", "round dining table", 5},
                {"A library with six chairs around a reading table.", "library table", 6},
                {"A café with three tables with four chairs each.", "dining table", 4},
                {"A café with four tables and eight chairs.", "dining table", 2},
                {"A kitchen with an island with three stools.", "kitchen island", 3},
                {"A kitchen-diner, 6 x 4m, table for six by the window", "dining table", 6},
                {"A dining room with a table for 8 in the middle.", "dining table", 8},
                {"An office with a round meeting table for five under the window.", "round meeting table", 5},
                {"A dining room with a table for 2 by 1 m of rug.", "dining table", 0}};
  for (const auto& expected : kCases) {
    const BriefFacts facts = FactsOf(expected.text);
    const Wish* table = WishFor(facts, expected.table);
    ASSERT_NE(table, nullptr) << expected.text;
    EXPECT_EQ(table->seats, expected.seats) << expected.text;
    EXPECT_FALSE(std::ranges::any_of(facts.wishes, [](const Wish& wish) { return IsSeat(*wish.furniture); }))
        << expected.text;
  }
  // Of their own: nothing that they could stand at was named, or they are of another kind.
  EXPECT_EQ(WishFor(FactsOf("A waiting room with 12 chairs."), "visitor chair")->count, 12);
  EXPECT_EQ(WishFor(FactsOf("An office with a desk and two visitor chairs."), "visitor chair")->count, 2);
}

TEST(FurnitureReader, AWordForSeveralMeansWhatBelongsToTheRoom) {
  EXPECT_NE(WishFor(FactsOf("An entrance hall with a bench."), "hall bench"), nullptr);
  EXPECT_NE(WishFor(FactsOf("A workshop with a bench."), "workbench"), nullptr);
  EXPECT_NE(WishFor(FactsOf("A dorm room with three beds."), "single bed"), nullptr);
  EXPECT_NE(WishFor(FactsOf("A bedroom with a bed."), "double bed"), nullptr);
  EXPECT_NE(WishFor(FactsOf("A classroom with 12 desks."), "school desk"), nullptr);
  EXPECT_NE(WishFor(FactsOf("A bar with a pool table."), "billiard table"), nullptr);
  EXPECT_TRUE(FactsOf("A bedroom with a king size bed.").themes.empty());
}

TEST(FurnitureReader, APluralWithoutANumberMeansTwoAtLeast) {
  const BriefFacts facts = FactsOf("A living room with armchairs and a sofa.");
  EXPECT_EQ(WishFor(facts, "armchair")->count, 2);
  EXPECT_FALSE(WishFor(facts, "armchair")->counted);
  EXPECT_EQ(WishFor(facts, "sofa")->count, 1);
  EXPECT_EQ(WishFor(FactsOf("A hotel room with twin beds."), "single bed")->count, 2);
}

TEST(FurnitureReader, RefusalsAreOfAllOfAKindAndNotOfPlaces) {
  EXPECT_TRUE(Refuses(FactsOf("A living room without any chairs."), "armchair"));
  EXPECT_TRUE(Refuses(FactsOf("A bedroom with no lamps."), "floor lamp"));
  EXPECT_TRUE(Refuses(FactsOf("A bathroom with a shower instead of a bathtub."), "bathtub"));
  const BriefFacts but = FactsOf("A living room with no chairs but two armchairs.");
  EXPECT_TRUE(Refuses(but, "dining chair"));
  EXPECT_FALSE(Refuses(but, "armchair"));
  for (const char* text : {"A bedroom with a desk but not near the bed.", "A bedroom with no more than one bed."}) {
    EXPECT_FALSE(Refuses(FactsOf(text), "double bed")) << text;
  }
}

TEST(FurnitureReader, OnlyMeansNothingElse) {
  EXPECT_TRUE(FactsOf("A bedroom, only a bed and a wardrobe.").nothing_else);
  EXPECT_TRUE(FactsOf("A study with a desk and nothing else.").nothing_else);
  EXPECT_FALSE(FactsOf("Just a bedroom with a bed.").nothing_else);
  EXPECT_FALSE(FactsOf("A bedroom with a bed and only one window.").nothing_else);
}

TEST(FurnitureReader, PlacesAreThoseOfThePieceBeforeThem) {
  const struct {
    const char* text;
    const char* piece;
    const char* sentence;
    const char* target;
  } kCases[] = {{"A bedroom with the bed under the window.", "double bed", "The {object} is under the window.", ""},
                {"A study with a desk facing the wall.", "desk", "The {object}'s back is against {wall}.", ""},
                {"A living room where the sofa is placed opposite the fireplace.", "sofa",
                 "The {object} faces the {target}.", "fireplace"},
                {"A bedroom with a desk but not near the bed.", "desk",
                 "The {object} is at least 1.5 m away from the {target}.", "double bed"},
                {"A living room with a piano in the corner.", "upright piano", "The {object} is in a corner.", ""},
                {"A living room with two sofas facing each other.", "sofa", "The {objects} face each other.", ""}};
  for (const auto& expected : kCases) {
    const BriefFacts facts = FactsOf(expected.text);
    ASSERT_EQ(facts.places.size(), 1u) << expected.text;
    EXPECT_EQ(facts.places[0].furniture->name(), expected.piece);
    EXPECT_EQ(facts.places[0].asked->relation().text(), expected.sentence);
    EXPECT_EQ(facts.places[0].target == nullptr ? "" : facts.places[0].target->name(), expected.target);
  }
  EXPECT_TRUE(FactsOf("A bedroom with a desk and a bed near a castle.").places.empty());
}

}  // namespace
}  // namespace flair::language
