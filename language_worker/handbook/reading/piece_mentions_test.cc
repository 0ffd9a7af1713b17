// SPDX-License-Identifier: GPL-3.0-or-later
// Words that name pieces where nobody asks for any: whatever they are, no such piece may come into the room.
#include "language_worker/handbook/reading/piece_mentions.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <utility>

#include "language_worker/handbook/testing/test_handbook.h"

namespace flair::language {
namespace {

// "2 armchair, 1 sofa", in the order of the text.
std::string AskedIn(const std::string& text) {
  std::string all;
  for (const Wish& wish : FactsOf(text).wishes) {
    all += (all.empty() ? "" : ", ") + std::to_string(wish.count) + " " + wish.furniture->name();
  }
  return all;
}

void ExpectAsked(std::initializer_list<std::pair<const char*, const char*>> cases) {
  for (const auto& [text, wishes] : cases) EXPECT_EQ(AskedIn(text), wishes) << text;
}

TEST(PieceMentions, HowAThingStandsIsNone) {
  ExpectAsked({{"A physiotherapy room with a stool on wheels.", "1 stool"},
               {"A physiotherapy room with a stool on five locking castors.", "1 work stool"},
               {"A workshop with a workbench on legs and a shelf.", "1 workbench, 1 wall shelf"},
               {"A pottery with three wheels.", "3 pottery wheel"}});
}

TEST(PieceMentions, RoomsBehindDoorsAreNone) {
  ExpectAsked({{"A cafe with a back door to the toilets and a counter.", "1 bar counter"},
               {"A home office with a desk, door from the toilet on the west wall.", "1 desk"},
               {"A bedroom with a bed. The closet door is in the west wall, a chair near the closet.",
                "1 double bed, 1 armchair"},
               {"A bathroom with a door to the bedroom and a toilet.", "1 toilet"}});
  const BriefFacts facts = FactsOf("A bedroom, closet door on the west wall, an armchair near the closet.");
  ASSERT_EQ(facts.places.size(), 1u);
  EXPECT_EQ(facts.places[0].side, "closet");
}

TEST(PieceMentions, WhatOnlyDescribesOrIsShownIsNone) {
  ExpectAsked({{"A home office with a desk and nothing in camera view.", "1 desk"},
               {"A home office with a desk and sockets at desk height.", "1 desk, 2 socket"},
               {"A barber shop with a bench and a TV for the football.", "1 waiting bench, 1 television"},
               {"A playroom where they leave things standing.", ""},
               {"A bookshop with two bookcases, chest height, far enough apart for a pushchair.", "2 bookshelf"},
               {"A living room with an armchair. Nothing breakable on the floor.", "1 armchair"},
               {"A home office with lots of maps.", "8 map"}});
}

TEST(PieceMentions, ChairsAndBedsAreOfThoseWhoUseThem) {
  ExpectAsked({{"A prayer room with ten chairs.", "10 visitor chair"},
               {"A living room with two chairs.", "2 armchair"},
               {"A living room with a crystal ball and six chairs.", "1 crystal ball, 6 dining chair"},
               {"A living room with a bed for an old labrador.", "1 pet bed"},
               {"A kitchen with a sink and two burners.", "1 kitchen sink, 1 cooker"}});
}

TEST(PieceMentions, WhatDoesNotFitIsRefused) {
  for (const char* text : {"A bedroom. Tall wardrobes are impossible.", "A bedroom. A wardrobe would not fit.",
                           "A bedroom. Wardrobes won't fit.", "A bedroom where a wardrobe is out of the question.",
                           "A bedroom, a wardrobe is not possible."}) {
    const BriefFacts facts = FactsOf(text);
    EXPECT_TRUE(facts.wishes.empty()) << text;
    EXPECT_FALSE(facts.refusals.empty()) << text;
  }
}

TEST(PieceMentions, TimesAndHangersCountNobody) {
  EXPECT_FALSE(FactsOf("A guest room with a rail for ten hangers.").people);
  EXPECT_TRUE(FactsOf("A bedroom with a bed. I am up at 4:30 for shifts.").unheard.empty());
}

}  // namespace
}  // namespace flair::language
