// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/brief_facts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "language_worker/handbook/testing/test_handbook.h"

namespace flair::language {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

int WishCount(const BriefFacts& facts, const std::string& name) {
  for (const Wish& wish : facts.wishes) {
    if (wish.furniture->name() == name) return wish.count;
  }
  return 0;
}

struct RoomCase {
  const char* name;
  const char* text;
  const char* archetype;
};
class NamedKind : public testing::TestWithParam<RoomCase> {};
TEST_P(NamedKind, IsFoundInTheBrief) { EXPECT_EQ(FactsOf(GetParam().text).archetype->name(), GetParam().archetype); }
INSTANTIATE_TEST_SUITE_P(
    Briefs, NamedKind,
    testing::Values(RoomCase{"plain", "A bedroom that is 4m x 5m.", "bedroom"},
                    RoomCase{"slash", "A living/dining room that is 6m x 3m.", "living dining room"},
                    RoomCase{"inside_furniture", "A bedroom with an office chair", "bedroom"},
                    RoomCase{"after_a_clause", "Now that we work from home, the bedroom needs a desk.", "bedroom"},
                    RoomCase{"translator", "I translate poems and sit here all day. A chair.", "home office"},
                    RoomCase{"crockery", "A dresser for the tableware, a table with eight chairs.", "dining room"},
                    RoomCase{"synonym", "An office for a bestselling writer", "home office"}),
    [](const auto& info) { return info.param.name; });

struct WishCase {
  const char* name;
  const char* text;
  const char* furniture;
  int count;
};
class Wishes : public testing::TestWithParam<WishCase> {};
TEST_P(Wishes, AreCounted) { EXPECT_EQ(WishCount(FactsOf(GetParam().text), GetParam().furniture), GetParam().count); }
INSTANTIATE_TEST_SUITE_P(
    Briefs, Wishes,
    testing::Values(WishCase{"chairs_for", "a quaker meeting room, chairs for fourteen in a ring", "visitor chair", 14},
                    WishCase{"one_more", "a yoga studio, nine mats in rows and two more in front", "yoga mat", 11},
                    WishCase{"word", "a living room with two armchairs", "armchair", 2},
                    WishCase{"adjectives", "a living room with three deep leather armchairs", "armchair", 3},
                    WishCase{"pair", "a living room with a pair of armchairs", "armchair", 2},
                    WishCase{"digits", "a bedroom with 2 nightstands", "nightstand", 2},
                    WishCase{"refused", "a bedroom without a desk", "desk", 0}),
    [](const auto& info) { return info.param.name; });

TEST(ReadBrief, CountsPeople) {
  EXPECT_EQ(FactsOf("A dining room for eight people").people, 8);
  EXPECT_EQ(FactsOf("A meeting room for 6").people, 6);
  EXPECT_FALSE(FactsOf("A bedroom for a vampire").people.has_value());
}

TEST(ReadBrief, LargeNumbersMayBeWords) {
  EXPECT_EQ(WishCount(FactsOf("A dining room with forty dining chairs"), "dining chair"), 40);
  EXPECT_EQ(WishCount(FactsOf("A library with twenty-four bookshelves and thirteen desks"), "bookshelf"), 24);
  EXPECT_EQ(WishCount(FactsOf("A library with twenty four bookshelves and thirteen desks"), "desk"), 13);
  EXPECT_EQ(WishCount(FactsOf("A hall with a hundred stools"), "stool"), 40);
  EXPECT_EQ(FactsOf("A hall with a hundred stools").too_many.size(), 1u);
  EXPECT_TRUE(FactsOf("A hall with forty stools").too_many.empty());
  EXPECT_EQ(FactsOf("A classroom for twenty-five pupils").people, 25);
  EXPECT_NEAR(*FactsOf("A bedroom of twenty square metres").size.area_m2, 20, 1e-9);
  EXPECT_NEAR(*FactsOf("A hall of a hundred square metres").size.area_m2, 100, 1e-9);
  EXPECT_NEAR(*FactsOf("A hall of two hundred square metres").size.area_m2, 200, 1e-9);
}

TEST(ReadBrief, AKingBedMakesNoKing) {
  EXPECT_TRUE(FactsOf("a bedroom with a king bed").themes.empty());
  EXPECT_FALSE(FactsOf("a bedroom for a king").themes.empty());
}

TEST(ReadBrief, AColourBeforeAPieceBelongsToThePiece) {
  const BriefFacts piece = FactsOf("A bedroom with a green armchair");
  EXPECT_TRUE(piece.colours.empty());
  ASSERT_EQ(piece.object_colours.size(), 1u);
  EXPECT_EQ(piece.object_colours[0].first->name(), "armchair");
  EXPECT_EQ(FactsOf("A small green boho dining room.").colours.size(), 1u);
  const BriefFacts wood = FactsOf("A dining room with a dark oak sideboard and a pale armchair");
  ASSERT_EQ(wood.object_materials.size(), 2u);
  EXPECT_EQ(wood.object_materials[0].second, "dark oak");
  EXPECT_EQ(wood.object_materials[1].second, "pale");
  // Of no piece, and so of all that are of wood.
  const BriefFacts all = FactsOf("A dining room with a table, dark wood, nothing modern.");
  const hb::Furniture* sideboard = TheHandbook().FindFurniture("sideboard");
  EXPECT_EQ(std::ranges::count(all.object_materials, std::pair(sideboard, std::string("dark wood"))), 1);
}

TEST(ReadBrief, WordsTellHowLargeAPieceIs) {
  const BriefFacts facts = FactsOf("A study with a long narrow desk, a small bookcase and a wardrobe");
  ASSERT_EQ(facts.wishes.size(), 3u);
  EXPECT_GT(facts.wishes[0].size.width_m.value_or(0), 1.2);
  EXPECT_LT(facts.wishes[0].size.depth_m.value_or(1), 0.6);
  EXPECT_LT(facts.wishes[1].size.width_m.value_or(1), 0.8);
  EXPECT_FALSE(facts.wishes[2].size.any());
}

TEST(ReadBrief, ARoomOfAWizardIsOfHisTimeAndATreatmentRoomOfAPhysioOneRoom) {
  EXPECT_EQ(FactsOf("A wizard's study with a desk").year, 1500);
  EXPECT_FALSE(FactsOf("A study with a desk").year.has_value());
  EXPECT_TRUE(FactsOf("A physiotherapy practice, one treatment room with a couch").also.empty());
}

TEST(ReadBrief, AWordForFewMakesNoNeed) {
  const auto needs = [](const std::string& text) { return FactsOf(text).needs.size(); };
  EXPECT_EQ(needs("A living room with plants"), 1u);
  EXPECT_EQ(needs("A living room with a few plants"), 1u);
  EXPECT_EQ(needs("A living room. Not too many plants."), 0u);
  EXPECT_EQ(needs("A living room with hardly any plants"), 0u);
  EXPECT_EQ(needs("A living room without plants or paintings"), 0u);
  for (const auto& [text, need] :
       {std::pair("A laundry with a place to iron and a door to the garden.", "ironing"),
        {"A student room, a bed and somewhere to eat that isn't my desk.", "eating here, too"},
        {"A bedroom with a work corner.", "working here, too"},
        {"A music room. A parent should be able to sit and wait.", "waiting here, too"},
        {"A music room. I have three metres of sheet music to store.", "sheet music to keep"},
        {"A cafe with a corner for kids.", "a corner for children"},
        {"A living room where we sit on the floor.", "floor sitters"},
        {"A conservatory, somewhere for my geraniums to spend the winter.", "plants to winter"}}) {
    const BriefFacts facts = FactsOf(text);
    EXPECT_TRUE(std::ranges::any_of(facts.needs, [&](const hb::Need* one) { return one->name() == need; })) << text;
    EXPECT_THAT(facts.unheard, testing::Not(testing::Contains(testing::HasSubstr("corner")))) << text;
  }
}

TEST(ReadBrief, ALivingRoomToEatInHasATableForAllWhoEat) {
  const BriefFacts facts = FactsOf("A living room where four people can also eat.");
  EXPECT_EQ(facts.archetype->name(), "living dining room");
  EXPECT_EQ(facts.people, 4);
}

TEST(ReadBrief, AGamesRoomIsAGameRoom) {
  EXPECT_TRUE(FactsOf("Games room").archetype_named);
  EXPECT_EQ(FactsOf("A games room with a billiard table").archetype, FactsOf("A game room").archetype);
}

TEST(ReadBrief, TheSquareOfSquareMetresIsNoShape) {
  EXPECT_FALSE(FactsOf("A bedroom of 20 square metres").size.side_ratio.has_value());
  EXPECT_TRUE(FactsOf("A square bedroom").size.side_ratio.has_value());
}

struct SizeCase {
  const char* text;
  double width_m;
  double depth_m;
};

// Of the first piece that is asked for; 0 where nothing is said.
TEST(PieceSizes, AreReadBeforeAndBehindTheirPiece) {
  const SizeCase kCases[] = {
      {"A study with a 1.6 m x 0.8 m oak desk.", 1.6, 0.8},
      {"A study with a desk of 80 cm by 160 cm.", 1.6, 0.8},
      {"A bedroom with a bed (1.6 x 2 m).", 1.6, 2},
      {"A dining room with a ten-foot table.", 3.048, 0},
      {"A living room with a sofa 2.2 m long, and a rug.", 2.2, 0},
      {"A living room with a bookcase, 40 cm deep, and a rug.", 0, 0.4},
      {"A bedroom with a 160 cm wide bed.", 1.6, 0},
      {"A living room with a bookcase 35 cm deep.", 0, 0.35},
      {"A study with a desk, 3 x 4 m.", 0, 0},
      {"A study with a desk 2 m from the window.", 0, 0},
      {"A living room with a sofa 40 m long.", 0, 0},
  };
  for (const auto& [text, width_m, depth_m] : kCases) {
    const BriefFacts facts = FactsOf(text);
    ASSERT_FALSE(facts.wishes.empty()) << text;
    EXPECT_NEAR(facts.wishes[0].size.width_m.value_or(0), width_m, 1e-9) << text;
    EXPECT_NEAR(facts.wishes[0].size.depth_m.value_or(0), depth_m, 1e-9) << text;
  }
  EXPECT_EQ(FactsOf("A living room with a sofa 40 m long.").sizes_not_had.size(), 1u);
  const BriefFacts desks = FactsOf("A home office with two desks side by side at the window, 140 x 70 cm each.");
  ASSERT_FALSE(desks.wishes.empty());
  EXPECT_NEAR(desks.wishes[0].size.width_m.value_or(0), 1.4, 1e-9);
}

// Whatever no reader took: things, colours, materials, numbers and directions that nothing was made of.
TEST(UnheardClauses, AreAllThatAskForSomething) {
  for (const char* text : {"A bedroom, the zither of my aunt must stay.", "A study where the door is made of oak.",
                           "A living room, so keep furniture off that wall.", "A den for 65 of those.",
                           "A bedroom with a bed, nothing against the windows."}) {
    const BriefFacts facts = FactsOf(text);
    EXPECT_FALSE(facts.unheard.empty() && facts.not_known.empty() && !facts.people) << text;
  }
  for (const char* text : {"Please make me a very nice study with a desk.", "A bedroom of 3 x 4 m with a bed.",
                           "I would like a living room where the door is on the south wall."}) {
    EXPECT_TRUE(FactsOf(text).unheard.empty()) << text << ": " << FactsOf(text).unheard[0];
  }
}

TEST(UnheardClauses, AreQuotedWholeAndOnce) {
  EXPECT_THAT(FactsOf("A study with a desk, keep the old zither safe by the bed and a chair.").unheard,
              ElementsAre("keep the old zither"));
  EXPECT_THAT(FactsOf("A bedroom with a bed. He does handstands there.").unheard,
              ElementsAre("he does handstands there"));
  EXPECT_THAT(FactsOf("A bedroom for twin girls age 6 with two beds.").unheard, IsEmpty());
}

TEST(BriefFacts, ARoomThatBecomesAnotherIsThat) {
  EXPECT_EQ(FactsOf("Turning the garage (5.5 x 3 m) into a bedroom for my father.").archetype->name(), "bedroom");
  EXPECT_TRUE(FactsOf("Six foot by nine, with a bath and two basins.").room_words.empty());
}

TEST(BriefFacts, PlacesAreToldAsLooselyKeptOnlyWhereTheyAre) {
  EXPECT_TRUE(FactsOf("A shop with a cutting table right in the centre.").places_loosely_kept.empty());
  EXPECT_TRUE(FactsOf("A chapel with a font just inside the door.").places_loosely_kept.empty());
  EXPECT_EQ(
      FactsOf("A bedroom with a bed and a commode to the right of the bed.").places_loosely_kept,
      std::vector<std::string>{"\"commode to the right of the bed\" is read as one sees it who looks at the front."});
}

TEST(BriefFacts, WordsOfPiecesAreNoneOfTheRoom) {
  const BriefFacts workshop = FactsOf("A workshop 6 x 5 m, two benches with a metre of space all round, a vice.");
  EXPECT_EQ(workshop.shape.shape, RoomShape::kRectangle);
  EXPECT_THAT(FactsOf("A living room with an L-shaped sofa.").unheard, IsEmpty());
  EXPECT_EQ(FactsOf("A teen bedroom with a desk and wall space for 3 guitars.").people, std::nullopt);
  EXPECT_EQ(FactsOf("A team room, ten staff.").people_said, "ten staff");
  const BriefFacts dining = FactsOf("A dining room, a long table for eight so the grandparents fit.");
  ASSERT_FALSE(dining.wishes.empty());
  EXPECT_EQ(dining.wishes.front().seats, 8);
}

TEST(BriefFacts, DoorsOfAPieceAreNoDoorsOfTheRoomAndTheOtherWayRound) {
  EXPECT_EQ(FactsOf("A bedroom with a wardrobe, door in the north wall. Nothing should block the wardrobe doors.")
                .openings.wishes.size(),
            1u);
  EXPECT_EQ(FactsOf("A mudroom on a farm with two doors on opposite walls, a bench.").openings.wishes.size(), 2u);
  const BriefFacts behind = FactsOf("A bedroom with a bed, the wardrobe behind the door.");
  ASSERT_EQ(behind.places.size(), 1u);
  EXPECT_EQ(behind.places.front().Words(), "wardrobe behind the door");
}

TEST(BriefFacts, PiecesCalledOtherwiseAreTold) {
  EXPECT_EQ(FactsOf("A seminar room with a flipchart, a couch and a table.").other_names,
            std::vector<std::string>{"\"flipchart\" as easel"});
}

// Surface, material and colour of all finishes that are read.
std::string FinishesOf(const std::string& text) {
  std::string all;
  for (const AskedFinish& one : FactsOf(text).finishes) {
    const bool walls = one.surface == AskedFinish::Surface::kWalls;
    all += (all.empty() ? "" : "; ") +
           std::string(walls                                         ? "walls"
                       : one.surface == AskedFinish::Surface::kFloor ? "floor"
                                                                     : "ceiling") +
           " " + one.material + (one.colour == nullptr ? "" : " " + one.colour->name());
  }
  return all;
}

TEST(BriefFacts, FinishesAreReadFromEitherSide) {
  EXPECT_EQ(FinishesOf("A bedroom with walls covered in cork."), "walls cork");
  EXPECT_EQ(FinishesOf("A kitchen with dark green walls and an oak floor."), "walls  dark green; floor oak");
  EXPECT_EQ(FinishesOf("A hall with black and white checkered floor tiles."), "floor checkered tiles black");
  EXPECT_EQ(FinishesOf("A bathroom with sage green tiles."), "walls tiles sage green");
  EXPECT_EQ(FinishesOf("A meeting room with grey carpet tile and a Persian carpet."), "floor carpet tile grey");
  EXPECT_EQ(FinishesOf("A parlour with moss for a floor, its walls lined with oak bookshelves."), "floor moss");
  EXPECT_EQ(FinishesOf("Terracotta tiles on the floor, reclaimed oak walls"),
            "floor tiles terracotta; walls reclaimed oak");
  EXPECT_EQ(FinishesOf("A pottery. The floor has to be something I can hose down."), "floor sealed tile");
  EXPECT_EQ(FinishesOf("A room with a floor lamp of brass and a desk at the white wall."), "");
}

TEST(BriefFacts, PaintOnTheWallsAndFairyLightsMakeNobodyAnArtistOrAFairy) {
  const BriefFacts office = FactsOf("A home office with two desks, warm white paint and a cork floor.");
  EXPECT_EQ(FinishesOf("A home office with two desks, warm white paint and a cork floor."), "walls  white; floor cork");
  EXPECT_TRUE(office.needs.empty());
  EXPECT_TRUE(FactsOf("A bedroom with a loft bed and fairy lights.").styles.empty());
}

TEST(BriefFacts, RefusedColoursAreNotTheRooms) {
  const BriefFacts facts = FactsOf("A nursery in mustard and white, NO pink.");
  ASSERT_EQ(facts.refused_colours.size(), 1u);
  EXPECT_EQ(facts.refused_colours.front()->name(), "pink");
  EXPECT_TRUE(std::ranges::find(facts.colours, facts.refused_colours.front()) == facts.colours.end());
}

TEST(BriefFacts, TheTimeOfARoomIsThatOfItsThemesNotOfItsHouse) {
  const auto year = [](const char* text) {
    const BriefFacts facts = FactsOf(text);
    return facts.themes.empty() ? 0 : facts.themes.back()->changes().year();
  };
  EXPECT_EQ(year("A victorian study."), 1885);
  EXPECT_EQ(year("A kitchen in a Victorian terrace."), 0);
}

}  // namespace
}  // namespace flair::language
