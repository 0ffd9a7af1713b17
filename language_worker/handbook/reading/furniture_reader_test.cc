// SPDX-License-Identifier: GPL-3.0-or-later
// What words for several pieces, compounds and other spellings become in one kind of room and another.
// What a brief asks for and refuses, in words that mean one thing here and another there.
#include "language_worker/handbook/reading/furniture_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <set>
#include <string>
#include <utility>

#include "language_worker/handbook/program/room_program.h"
#include "language_worker/handbook/reading/piece_words.h"
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
                {"A lounge with a stove.", "1 wood stove"}});
}

TEST(NounBook, TheWordsBeforeANounTellWhichOne) {
  ExpectWishes({{"A living room with two wingback chairs.", "2 wingback chair"},
                {"A living room with two frobnicated chairs.", "2 armchair"},
                {"A home office with a comfy leather chair to think in.", "1 armchair"},
                {"A study with an L-shaped desk.", "1 corner desk"},
                {"A living room with a sectional couch.", "1 corner sofa"},
                {"A study with a small round table.", "1 small round table"},
                {"A consulting room with a privacy screen.", "1 privacy screen"}});
}

TEST(NounBook, NumbersWithinACompoundAreSizesAndNoCounts) {
  ExpectWishes(
      {{"A living room with a three-seat sofa.", "1 sofa"},
       {"A living room with a 2-seater sofa.", "1 loveseat"},
       {"A living room with a two-seater.", "1 loveseat"},
       {"A dining room with a ten-foot table.", "1 dining table"},
       {"A bedroom with a four-poster bed and two four-drawer chests.", "1 four-poster bed, 2 chest of drawers"},
       {"A bedroom with a 4-poster bed and a two-door wardrobe.", "1 four-poster bed, 1 wardrobe"},
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

TEST(NounBook, OtherThingsAreNoneOfTheirLikeAndTold) {
  for (const char* thing : {"tie rack", "key rack", "toast rack"}) {
    const BriefFacts facts = FactsOf(std::string("A bedroom, 4m x 5m, with a ") + thing + ".");
    ASSERT_EQ(facts.wishes.size(), 1u) << thing;
    EXPECT_EQ(facts.wishes[0].furniture->name(), thing);
    EXPECT_EQ(facts.made_plain, std::vector<std::string>{thing});
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
                {"A dining room with a round table.", "round table", "dining table"}};
  for (const auto& one : kCases) {
    const BriefFacts facts = FactsOf(one.text);
    const RoomProgram program = MakeRoomProgram(facts, facts.HandbookOr(TheHandbook()), 20, Choice(0, one.text));
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
                {"A dining room with a round table and five chairs.", "round table", 5},
                {"A library with six chairs around a reading table.", "library table", 6},
                {"A café with three tables with four chairs each.", "dining table", 4},
                {"A café with four tables and eight chairs.", "dining table", 2},
                {"A kitchen with an island with three stools.", "kitchen island", 3},
                {"A kitchen-diner, 6 x 4m, table for six by the window", "dining table", 6},
                {"A dining room with a table for 8 in the middle.", "dining table", 8},
                {"An office with a round meeting table for five under the window.", "round meeting table", 5},
                {"A dining room that will sit ten round a long table.", "dining table", 10},
                {"A dining room with an eight-seater table.", "dining table", 8},
                {"A café with tables of four and a counter.", "dining table", 4},
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

TEST(FurnitureReader, CountsStandBeforeBehindAndInGroups) {
  const struct {
    const char* text;
    const char* piece;
    int count;
    int in_each;
  } kCases[] = {{"A lounge with fourteen big high-backed armchairs.", "armchair", 14, 0},
                {"A playroom with stools, five of them.", "stool", 5, 0},
                {"A bar with 4 x high tables.", "high table", 4, 0},
                {"An office with sixteen desks in four blocks of four.", "desk", 16, 4},
                {"A lounge with armchairs in three clusters of two.", "armchair", 6, 2},
                {"A home cinema with two rows of three recliners.", "recliner", 6, 3},
                {"A bar with two high tables with three stools each.", "bar stool", 6, 0},
                {"A waiting room with 18 seats, three of them wide.", "visitor chair", 18, 0},
                {"A meeting room with chairs for twelve.", "office chair", 12, 0},
                {"A study with 200 books on shelves.", "bookshelf", 2, 0}};
  for (const auto& expected : kCases) {
    const BriefFacts facts = FactsOf(expected.text);
    const Wish* wish = WishFor(facts, expected.piece);
    ASSERT_NE(wish, nullptr) << expected.text;
    EXPECT_EQ(wish->count, expected.count) << expected.text;
    EXPECT_EQ(wish->in_each, expected.in_each) << expected.text;
  }
}

TEST(FurnitureReader, WhatIsOnlySpokenOfIsNoPiece) {
  const auto wishes = [](const char* text, const char* name) {
    const BriefFacts facts = FactsOf(text);
    const auto found = std::ranges::find_if(
        facts.wishes, [&](const Wish& wish) { return wish.furniture->name().find(name) != std::string::npos; });
    return found == facts.wishes.end() ? 0 : found->count;
  };
  EXPECT_EQ(wishes("A workshop. I build wooden boats. A workbench.", "boat"), 0);
  EXPECT_EQ(wishes("A café with a table for the mums with prams.", "pram"), 0);
  EXPECT_EQ(wishes("A bedroom with a king bed. Keep 80 cm clear round bed.", "round bed"), 0);
  EXPECT_EQ(wishes("A bedroom. She keeps a hamster, the cage is in the shade.", "recovery"), 0);
  EXPECT_EQ(wishes("A treatment room, one treatment table accessible on all four sides.", "couch"), 1);
}

TEST(FurnitureReader, TablesOfTwoSizesAreToldApart) {
  for (const char* text :
       {"A café with six tables for two and one big table.", "A café with one large table and six small tables.",
        "A café, six little tables, a long table."}) {
    const BriefFacts facts = FactsOf(text);
    std::multiset<std::pair<int, int>> tables;
    for (const Wish& wish : facts.wishes) tables.emplace(wish.count, wish.seats);
    EXPECT_EQ(tables, (std::multiset<std::pair<int, int>>{{1, 8}, {6, 2}})) << text;
  }
  EXPECT_EQ(FactsOf("A dining room with one large table.").wishes[0].seats, 0);
}

TEST(FurnitureReader, TablesOfTwoSizesKeepTheirSeats) {
  const BriefFacts facts = FactsOf("A café with four tables for four and three tables for two, mismatched chairs.");
  ASSERT_EQ(facts.wishes.size(), 2u);
  EXPECT_EQ(facts.wishes[0].count * facts.wishes[0].seats + facts.wishes[1].count * facts.wishes[1].seats, 22);
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

TEST(FurnitureReader, WhatAPieceIsForNamesItAndIsNoPiece) {
  ExpectWishes({{"A bicycle workshop with a rack for eight bikes.", "1 bike rack"},
                {"A hall with a cupboard for linen and a rack for shoes.", "1 linen cabinet, 1 shoe rack"},
                {"A guest room with a bed for the dog.", "1 pet bed"},
                {"A teenager's room with a keyboard stand for his piano.", "1 keyboard stand"},
                {"A restaurant with aisles for waiters with trays.", ""},
                {"A bicycle workshop with a counter where customers drop off bikes.", "1 cash desk"}});
}

TEST(FurnitureReader, SeatsAreSaidPerDeskAndDesksInColumns) {
  const BriefFacts columns = FactsOf("A classroom for 24 pupils, two to a desk, in four columns of three desks.");
  ASSERT_EQ(columns.wishes.size(), 1u);
  EXPECT_EQ(columns.wishes[0].count, 12);
  EXPECT_EQ(columns.wishes[0].seats, 2);
  EXPECT_EQ(columns.wishes[0].in_each, 4) << "of a row";
  const BriefFacts tables = FactsOf("A classroom with 6 tables, four pupils at each table.");
  ASSERT_EQ(tables.wishes.size(), 1u);
  EXPECT_EQ(tables.wishes[0].seats, 4);
  EXPECT_FALSE(tables.people) << "of each table, not of the room";
}

TEST(FurnitureReader, AWallOfThemIsMoreThanTwo) {
  ExpectWishes({{"A library of 8 m x 6 m with bookcases along the long wall.", "6 bookshelf"},
                {"A library of 8 m x 6 m with bookcases on the wall.", "2 bookshelf"},
                {"A library of 8 m x 6 m with two bookcases along the wall.", "2 bookshelf"},
                {"A library of 8 m x 6 m with bookcases on both side walls.", "10 bookshelf"}});
}

TEST(FurnitureReader, ABenchInsteadOfSomeOfTheChairsRefusesNone) {
  const char* text = "A kitchen with a farmhouse table with six chairs, a bench instead of chairs on the wall side.";
  EXPECT_FALSE(Refuses(FactsOf(text), "dining chair"));
  EXPECT_TRUE(Refuses(FactsOf("A dining room with a bench instead of chairs."), "dining chair"));
}

TEST(FurnitureReader, TheTubIsTheOneThatWasAskedFor) {
  ExpectWishes(
      {{"A bathroom with a freestanding bathtub and a shower opposite the tub.", "1 freestanding bathtub, 1 shower"},
       {"A bedroom with a bed. Keep 1.5 m free for turning.", "1 double bed"}});
}

TEST(FurnitureReader, WhatIsHeldPassedByOrRefusedIsNoPiece) {
  ExpectWishes({{"A laundry with a tall cupboard for the vacuum cleaner and ironing board.", "1 storage cabinet"},
                {"A hall with a cabinet to hide the litter box.", "1 storage cabinet"},
                {"A home gym with a rack with dumbbells.", "1 dumbbell rack"},
                {"A physiotherapy room with a desk, an office chair for me and one chair for the patient.",
                 "1 desk, 1 office chair, 1 visitor chair"},
                {"A practice room with a rack holding four guitars.", "1 guitar stand"},
                {"A shop with a till and aisles wide enough for prams.", "1 cash desk"},
                {"A clinic with a reception desk, so that wheelchairs and prams can pass.", "1 reception desk"},
                {"A bedroom with a wardrobe with many small drawers.", "1 wardrobe"},
                {"A kitchen with navy blue cabinets and an island.", "1 kitchen island"},
                {"A kitchen with two cabinets in sage green.", "2 storage cabinet"}});
  EXPECT_TRUE(Refuses(FactsOf("A bathroom with everything except a bath."), "bathtub"));
  EXPECT_FALSE(Refuses(FactsOf("A waiting room with no seats besides two chairs."), "visitor chair"));
}

TEST(FurnitureReader, TheCompanyOfANounTellsWhichOneItIs) {
  ExpectWishes({{"A sewing room with a cutting table and two sewing machines on tables.",
                 "1 cutting table, 2 sewing machine, 2 sewing machine table"},
                {"A team office with four desks, each with a low pedestal.", "4 desk, 4 desk pedestal"},
                {"A gallery with four pedestals.", "4 plinth"},
                {"A practice room with six chairs and six music stands.", "6 dining chair, 6 music stand"},
                {"A bedroom with a sofa with cushions.", "1 sofa, 2 cushion"},
                {"A kitchen with a fold-down table with two chairs.", "1 fold-down table"},
                {"A pottery with two drying racks.", "2 ware rack"}});
}

TEST(FurnitureReader, CountsFollowWhatOneStandsWith) {
  ExpectWishes(
      {{"A chapel with six pews on each side of the aisle.", "12 pew"},
       {"A dining room with a big table seating eight.", "1 dining table"},
       {"A meditation hall with sixteen mats with cushions.", "16 floor cushion"},
       {"A bedroom with two single beds on either side of the window.", "2 single bed"},
       {"A barber shop with three chairs with mirrors.", "3 barber chair, 3 mirror"},
       {"A bedroom with a bed and a nightstand with a lamp at each side.", "1 double bed, 2 nightstand, 2 table lamp"},
       {"A living room with plenty of bookcases.", "5 bookshelf"},
       {"A bedroom for our twin girls, each needs her own desk.", "2 desk"},
       {"A bedroom for our twin boys, both want their own desk.", "2 desk"},
       {"A bedroom for three boys. They want their own desks.", "3 desk"},
       {"A bedroom for three boys, a bed and a desk each.", "3 single bed, 3 desk"},
       {"A bedroom for the two of us. We both need a sofa.", "1 sofa"},
       {"A kindergarten with three low tables with six chairs each.", "3 play table"}});
  const BriefFacts desks = FactsOf("A classroom with ten double desks.");
  ASSERT_EQ(desks.wishes.size(), 1u);
  EXPECT_EQ(desks.wishes[0].count, 10);
  EXPECT_EQ(desks.wishes[0].seats, 2);
  EXPECT_NEAR(desks.wishes[0].size.width_m.value_or(0), 1.3, 1e-9);
  EXPECT_TRUE(FactsOf("A hotel room with twin beds.").needs.empty());
  const BriefFacts nails = FactsOf("A nail salon with four manicure tables in two rows each with two chairs.");
  ASSERT_EQ(nails.wishes.size(), 1u);
  EXPECT_EQ(nails.wishes[0].seats, 2);
}

TEST(FurnitureReader, RefusalsAreOfTheWholeKind) {
  const auto refuses = [](const char* text, const char* name) {
    return std::ranges::any_of(FactsOf(text).refusals, [&](const hb::Furniture* one) { return one->name() == name; });
  };
  EXPECT_TRUE(refuses("A bedroom without lamps.", "chandelier"));
  EXPECT_TRUE(refuses("A living room with no lighting.", "floor lamp"));
  EXPECT_TRUE(refuses("A living room, no sofa.", "loveseat"));
  EXPECT_TRUE(refuses("A guest room with no bed.", "daybed"));
  EXPECT_TRUE(refuses("A kid's room with no toys.", "teddy bear"));
  EXPECT_FALSE(refuses("A studio flat without a table.", "desk"));
  EXPECT_FALSE(refuses("A living room, no sofa.", "armchair"));
}

TEST(FurnitureReader, ADoorIsNotWhatIsBehindIt) {
  ExpectWishes({{"A boiler room. The furnace room door is on the north wall.", ""},
                {"A living room with a bar door in the east wall and a sofa.", "1 sofa"}});
}

}  // namespace

}  // namespace flair::language
