// SPDX-License-Identifier: GPL-3.0-or-later
// Where briefs want their pieces, in many wordings, and what they say of it that is not understood.
// Over 400 lines: one table of cases after the other, read from top to bottom.
#include "language_worker/handbook/reading/place_reader.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "language_worker/handbook/testing/test_handbook.h"

namespace flair::language {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

// "floor lamp: is between the armchair and the armchair", with the words for the side of a wall in brackets.
std::vector<std::string> PlacesIn(const std::string& text) {
  std::vector<std::string> places;
  for (const Place& place : FactsOf(text).places) {
    std::string sentence = place.asked->relation().text();
    const auto put = [&](const std::string& slot, const hb::Furniture* piece) {
      const std::size_t at = sentence.find(slot);
      const std::string name = piece == nullptr ? "" : piece->name() + (slot == "{objects}" ? "s" : "");
      if (at != std::string::npos && piece != nullptr) sentence.replace(at, slot.size(), name);
    };
    put("{target}", place.target);
    put("{first}", place.target);
    put("{second}", place.other);
    put("{object}", place.furniture);
    put("{objects}", place.furniture);
    if (!place.side.empty()) sentence += " [" + place.side + "]";
    if (place.which >= 0) sentence += fmt::format(" #{}", place.which);
    places.push_back(sentence);
  }
  return places;
}

struct PlaceCase {
  const char* text;
  const char* sentence;
};

void ExpectEach(const std::vector<PlaceCase>& cases) {
  for (const PlaceCase& one : cases) EXPECT_THAT(PlacesIn(one.text), ElementsAre(one.sentence)) << one.text;
}

TEST(PlaceReader, WallsAreAlsoSidesAndEndsAndWhatIsAcrossFromAPiece) {
  const struct {
    const char* text;
    const char* piece;
    const char* sentence;
    const char* side;
    const char* target;
  } kCases[] = {
      {"A study with a desk at the far end.", "desk", "The {object}'s back is against {wall}.", "far", ""},
      {"A chapel with an altar at the east end.", "altar", "The {object}'s back is against {wall}.", "east", ""},
      {"A study with an armchair on the left as you enter.", "armchair", "The {object}'s back is against {wall}.",
       "left", ""},
      {"A bedroom with a bed and one nightstand on the left.", "nightstand",
       "The {object} is next to the right side of the {target}.", "", "double bed"},
      {"A bedroom with a bed, two nightstands and a bench at the foot.", "bedroom bench",
       "The {object} is next to the front of the {target}.", "", "double bed"},
      {"A bedroom with the bed on the north wall and a wardrobe on the wall across from it.", "wardrobe",
       "The {object}'s back is against {wall}.", "across north", ""},
      {"A living room with a sofa facing the fire, a low table between.", "coffee table",
       "The {object} is between the {first} and the {second}.", "", "sofa"}};
  for (const auto& expected : kCases) {
    const BriefFacts facts = FactsOf(expected.text);
    const auto place =
        std::ranges::find_if(facts.places, [&](const Place& one) { return one.furniture->name() == expected.piece; });
    ASSERT_NE(place, facts.places.end()) << expected.text;
    EXPECT_EQ(place->asked->relation().text(), expected.sentence) << expected.text;
    EXPECT_EQ(place->side, expected.side) << expected.text;
    EXPECT_EQ(place->target == nullptr ? "" : place->target->name(), expected.target) << expected.text;
  }
}

TEST(PlaceReader, WhatHangsHangsOnTheWallThatIsNamed) {
  ExpectEach(
      {{"A meeting room with a whiteboard on the west wall.", "The whiteboard hangs on {wall}. [west]"},
       {"A meeting room with a screen on the wall opposite the door.", "The projector screen hangs on {wall}. [far]"},
       {"A ballet studio, mirrors along a long wall.", "The dance mirror hangs on {wall}. [long]"},
       {"A hallway with a mirror halfway along the right wall.", "The mirror is in the middle of {wall}. [right]"},
       {"A hallway with coat hooks beside the door.", "The wall hooks is near the door."}});
}

TEST(PlaceReader, SidesAreThoseOfWhoComesIn) {
  ExpectEach(
      {{"A bedroom, wardrobe right as you step in.", "The wardrobe's back is against {wall}. [right]"},
       {"A study with a bookshelf on the wall you face as you walk in.",
        "The bookshelf's back is against {wall}. [far]"},
       {"A hallway with a mirror on the left-hand wall seen from the door.", "The mirror hangs on {wall}. [left]"}});
}

TEST(PlaceReader, WhatIsFacedHangsWherePeopleLook) {
  EXPECT_THAT(PlacesIn("A barber shop with four barber chairs facing the mirrors."),
              ElementsAre("The barber chair faces the mirror.", "The mirror hangs on {wall}. [blank far]"));
  EXPECT_THAT(PlacesIn("A living room with a whiteboard on the north wall and a sofa facing it."),
              ElementsAre("The whiteboard hangs on {wall}. [north]", "The sofa faces the whiteboard."));
  ExpectEach({{"A lecture room with a lectern by the screen.",
               "The projector screen hangs on the wall near the teacher desk."},
              {"A living room with a TV on the wall opposite the sofa.",
               "The television hangs on the wall opposite the sofa."}});
}

TEST(PlaceReader, CornersByTheDoorOppositeAndAllOfThem) {
  ExpectEach(
      {{"A bedroom with a wardrobe in the corner by the door.", "The wardrobe is in a corner. [at door]"},
       {"A living room with a plant in each corner.", "The floor plant is in a corner. [each]"},
       {"A hall with four statues, one in each corner.", "The statue is in a corner. [each]"},
       {"A home office with a desk diagonally opposite the door.", "The desk is in a corner. [across at door]"}});
  EXPECT_THAT(
      PlacesIn("A shed with a feed bin in one corner and a waste bin in the opposite corner."),
      ElementsAre("The feed bin is in a corner. [far right]", "The waste bin is in a corner. [across far right]"));
  EXPECT_EQ(FactsOf("A living room with a plant in each corner.").wishes.front().count, 4);
}

TEST(PlaceReader, BetweenAPieceAndAnOpeningIsNearBoth) {
  const BriefFacts facts = FactsOf("A dining room with a drinks trolley between the sideboard and the window.");
  EXPECT_THAT(PlacesIn("A dining room with a drinks trolley between the sideboard and the window."),
              ElementsAre("The bar cart is within 1 m of the sideboard.", "The bar cart is near the window."));
  EXPECT_EQ(facts.places_loosely_kept.size(), 1U);
}

TEST(PlaceReader, DividersStandBetween) {
  constexpr const char* kBookshelf = "The bookshelf is between the desk and the desk.";
  ExpectEach({{"A home office with two desks and a bookcase dividing them.", kBookshelf},
              {"A home office with two desks separated by a bookcase.", kBookshelf}});
}

TEST(PlaceReader, FrontAndBackAreThoseOfWhoSitsThere) {
  ExpectEach(
      {{"A classroom with a bookcase at the back of the room.", "The bookshelf's back is against {wall}. [near]"},
       {"A florist with a bookcase at the back.", "The bookshelf's back is against {wall}. [back]"}});
}

TEST(PlaceReader, BetweenTwoOfAKindThoughOthersAreNamedInBetween) {
  const char* kText = "A bedroom with two single beds, each bed with its own nightstand, and a screen between them.";
  EXPECT_EQ(FactsOf(kText).wishes[1].count, 2);
  EXPECT_THAT(PlacesIn("A library with two armchairs, a floor plant and a side table between them."),
              ElementsAre("The side table is between the armchair and the armchair."));
}

TEST(PlaceReader, OneMoreOnTheOtherSide) {
  const BriefFacts facts = FactsOf("A bedroom with a double bed with a nightstand on the left and one on the right.");
  ASSERT_EQ(facts.places.size(), 2U);
  EXPECT_EQ(facts.places[0].which, 0);
  EXPECT_EQ(facts.places[1].which, 1);
  EXPECT_EQ(facts.wishes[1].count, 2);
}

TEST(PlaceReader, BetweenTwoPieces) {
  constexpr const char* kLamp = "The floor lamp is between the armchair and the armchair.";
  ExpectEach({{"A living room with two armchairs with a floor lamp between them.", kLamp},
              {"A living room with two armchairs and a floor lamp in between.", kLamp},
              {"A lounge: two armchairs, and between them a floor lamp.", kLamp},
              {"A living room with a floor lamp between the two armchairs.", kLamp},
              {"A living room with two armchairs. Between the armchairs there is a floor lamp.", kLamp},
              {"A living room. I want a pair of armchairs, a floor lamp standing between both.", kLamp},
              {"A bedroom with a bed and a desk with a floor lamp between them.",
               "The floor lamp is between the double bed and the desk."},
              {"A bedroom with a floor lamp between the bed and the wardrobe.",
               "The floor lamp is between the double bed and the wardrobe."},
              {"A living room with a fireplace between two bookshelves.",
               "The fireplace is between the bookshelf and the bookshelf."},
              {"A bedroom with two single beds and a nightstand between.",
               "The nightstand is between the single bed and the single bed."}});
}

TEST(PlaceReader, ATableBetweenSeatsIsASideTable) {
  EXPECT_THAT(PlacesIn("A living room with two armchairs with a table between them."),
              ElementsAre("The side table is between the armchair and the armchair."));
}

TEST(PlaceReader, AnEndOrASideIsOfWhatHasOne) {
  EXPECT_THAT(PlacesIn("A kitchen with a sink, the fridge at the end."), ElementsAre());
  EXPECT_THAT(PlacesIn("A kitchen with an island with two stools on one side."), ElementsAre());
}

TEST(PlaceReader, DoorsAndWindowsWithWordsBeforeThem) {
  ExpectEach({{"A dining room with a sideboard near the kitchen door.", "The sideboard is near the door. [kitchen]"},
              {"A living room with an armchair by the balcony door.", "The armchair is near the door. [balcony]"},
              {"A living room with a sofa across from the window.", "The sofa faces the window."},
              {"A study with the desk right under the big bay window.", "The desk is under the window. [big bay]"},
              {"A study with a desk for writing letters by the window.", "The desk is near the window."},
              {"A study with a desk. It should face the window.", "The desk faces the window."},
              {"A study with a desk, which must not be near the door.", "The desk is at least 2 m away from the door."},
              {"A living room with a sofa with its back to the window.", "The back of the sofa is near the window."},
              {"Under the window, a desk, in this study.", "The desk is under the window."},
              {"A bedroom where the wardrobe goes behind the door.", "The wardrobe is near the door."}});
}

TEST(PlaceReader, WallsAndCornersByTheirSide) {
  constexpr const char* kWall = "The bookshelf's back is against {wall}.";
  const auto wall = [&](const char* side) { return fmt::format("{} [{}]", kWall, side); };
  EXPECT_THAT(PlacesIn("A study with a bookshelf along the left wall as you enter."), ElementsAre(wall("left")));
  EXPECT_THAT(PlacesIn("A study with a bookshelf on the north wall."), ElementsAre(wall("north")));
  EXPECT_THAT(PlacesIn("A study with a bookshelf against the wall opposite the door."), ElementsAre(wall("far")));
  EXPECT_THAT(PlacesIn("A study; the bookshelf stands against the long wall."), ElementsAre(wall("long")));
  EXPECT_THAT(PlacesIn("A study with a bookshelf on the wall with the window."), ElementsAre(wall("window")));
  EXPECT_THAT(PlacesIn("A study with a bookshelf against a plain white wall."), ElementsAre(kWall));
  ExpectEach({{"A living room with an armchair in the far corner.", "The armchair is in a corner. [far]"},
              {"A living room with an armchair in the north-east corner.", "The armchair is in a corner. [north east]"},
              {"A living room with a piano in one corner of the room.", "The upright piano is in a corner."},
              {"A study with a desk in the middle of the west wall.", "The desk is in the middle of {wall}. [west]"}});
}

TEST(PlaceReader, OnePieceAndAnother) {
  ExpectEach({{"A bedroom with a bed with a nightstand next to it.", "The nightstand is next to the double bed."},
              {"A bedroom with nightstands on both sides of the bed.",
               "The nightstand is next to the {side} side of the double bed."},
              {"A bedroom with a nightstand on either side of the bed.",
               "The nightstand is next to the {side} side of the double bed."},
              {"A living room with a console table behind the sofa.", "The console table is behind the sofa."},
              {"A living room with two armchairs flanking the fireplace.",
               "The armchair is next to the {side} side of the fireplace."},
              {"An office with two desks back to back.", "The desks are back to back."},
              {"An office with three desks side by side.", "The desks stand side by side in a row."},
              {"A living room with a sofa to the left of the fireplace.",
               "The sofa is next to the right side of the fireplace."},
              {"A bedroom with a desk not next to the bed.", "The desk is at least 1.5 m away from the double bed."},
              {"A living room with an armchair at right angles to the sofa.",
               "The armchair is at a right angle to the sofa."}});
}

TEST(PlaceReader, WhoseThePlaceIs) {
  EXPECT_THAT(PlacesIn("Kitchen with sink and dishwasher on the north wall."),
              UnorderedElementsAre("The kitchen sink's back is against {wall}. [north]",
                                   "The dishwasher's back is against {wall}. [north]"));
  EXPECT_THAT(PlacesIn("Bedroom with a bed and a desk under the window."),
              ElementsAre("The desk is under the window."));
  ExpectEach({
      {"Dining room with a table with six chairs in the middle.", "The dining table is central in the room."},
      {"Bedroom: a bed with a bench at the foot of it.", "The bedroom bench is next to the front of the double bed."},
      {"Bedroom with a narrow bed that he never makes, in the corner.", "The single bed is in a corner."},
      {"A bedroom, bed 100 x 200, headboard on the north wall.", "The double bed's back is against {wall}. [north]"},
      {"Office with one desk; put it under the window.", "The desk is under the window."},
  });
}

TEST(PlaceReader, WhatIsHeldSharesTheWallOfItsHolder) {
  ExpectEach({
      {"Bathroom, washbasin with mirror on the right wall.", "The washbasin's back is against {wall}. [right]"},
      {"Bedroom with a dressing table with a mirror on the north wall.",
       "The vanity table's back is against {wall}. [north]"},
      {"Living room with a TV opposite the window.", "The tv stand's back is against {wall}. [across window]"},
      {"Living room with a TV on the east wall.", "The television hangs on {wall}. [east]"},
      {"Living room with a TV on the wall.", "The television hangs on {wall}."},
  });
  EXPECT_THAT(PlacesIn("Bathroom with a bathtub, a washbasin with a mirror and a toilet between them."),
              ElementsAre("The toilet is between the bathtub and the washbasin."));
}

TEST(PlaceReader, WindowsOverPiecesAndWallsOfOpenings) {
  ExpectEach({
      {"Kitchen with a window over the sink.", "The kitchen sink is under the window."},
      {"Bedroom with a wardrobe on the same wall as the door.", "The wardrobe's back is against {wall}. [door]"},
  });
}

TEST(PlaceReader, HeadsAreThoseOfBeds) {
  EXPECT_THAT(PlacesIn("Hotel room with two single beds side by side with a nightstand between, headboards on the left "
                       "wall."),
              ElementsAre("The nightstand is between the single bed and the single bed.",
                          "The single bed's back is against {wall}. [left]"));
}

TEST(PlaceReader, SeveralWalls) {
  const struct {
    const char* text;
    int walls;
    int least;
  } kCases[] = {{"A study of 20 m2 with bookcases on three walls.", 3, 6},
                {"A bookshop, 6 by 9 m, bookcases all along both side walls.", 2, 6},
                {"A study of 20 m2 with bookcases on the north and east walls.", 2, 4},
                {"A study of 20 m2 with bookcases along the north wall.", 1, 2},
                {"A study of 20 m2 with two bookcases along the north wall.", 1, 2}};
  for (const auto& one : kCases) {
    const BriefFacts facts = FactsOf(one.text);
    ASSERT_EQ(facts.places.size(), 1) << one.text;
    EXPECT_EQ(facts.places[0].walls, one.walls) << one.text;
    EXPECT_GE(facts.wishes[0].count, one.least) << one.text;
  }
  EXPECT_EQ(FactsOf(kCases[4].text).wishes[0].count, 2) << "what is counted stays";
}

TEST(PlaceReader, WithinReachAndNotFacingEachOther) {
  EXPECT_THAT(PlacesIn("Office for two. Two desks should not face each other, and each of us wants a bookcase within "
                       "reach."),
              ElementsAre("The desk does not face the desk.", "The bookshelf is within 0.8 m of the desk."));
  ExpectEach({{"A workshop with two workbenches which must not stand near the door.",
               "The workbench is at least 2 m away from the door."},
              {"A clinic with an examination couch you can walk around.",
               "There is {length} of clear space around the examination couch."},
              {"A bedroom with a double bed. At least 80 cm circulation all round the bed.",
               "There is {length} of clear space around the double bed."}});
  const BriefFacts facts = FactsOf("A workshop with two workbenches with at least a metre of space all round.");
  ASSERT_EQ(facts.places.size(), 1);
  EXPECT_DOUBLE_EQ(facts.places[0].length_m, 1);
}

TEST(PlaceReader, WallsByTheDoorAndBehindAPronoun) {
  ExpectEach(
      {{"A studio with a wardrobe on the wall near the entrance.", "The wardrobe's back is against {wall}. [door]"},
       {"A bookshop. At the back I want an armchair.", "The armchair's back is against {wall}. [back]"}});
}

TEST(PlaceReader, EndsAislesSocketsAndWindows) {
  ExpectEach({
      {"A study with a desk near the socket.", "The desk is near a socket."},
      {"A hall with a piano at one end.", "The upright piano's back is against {wall}. [short]"},
      {"A shop with shelves on the windowless wall.", "The shop shelves's back is against {wall}. [blank]"},
  });
  EXPECT_THAT(PlacesIn("A hall with a piano on the left side and a sofa on the other."),
              UnorderedElementsAre("The upright piano's back is against {wall}. [left]",
                                   "The sofa's back is against {wall}. [across left]"));
}

TEST(PlaceReader, LengthsOfFreeFloor) {
  const struct {
    const char* text;
    double length_m;
  } kCases[] = {{"A gym with two treadmills at least 1.5 m apart.", 1.5},
                {"A gym with a treadmill with 90 cm free behind it.", 0.9},
                {"A gym with a treadmill with space behind it.", 0.9},
                {"A workshop with a workbench with 3 ft free all around.", 0.9144}};
  for (const auto& one : kCases) {
    const BriefFacts facts = FactsOf(one.text);
    ASSERT_EQ(facts.places.size(), 1) << one.text;
    EXPECT_DOUBLE_EQ(facts.places[0].length_m, one.length_m) << one.text;
  }
}

TEST(PlaceReader, WhatHangsStandsOnTopOrIsWalkedOver) {
  ExpectEach(
      {{"A living room with a painting above the sofa.", "The painting hangs on the wall above the sofa."},
       {"A dining room with a chandelier over the dining table.", "The chandelier hangs above the dining table."},
       {"A living room with an area rug under the coffee table.", "The area rug is under the coffee table."},
       {"A bedroom with a vase on the dresser.", "The vase is on the dresser."},
       {"A bedroom with a television opposite the bed.", "The tv stand faces the double bed."}});
}

TEST(PlaceReader, SeveralPlacesOfOnePieceAndPlacesOfSeveralPieces) {
  EXPECT_THAT(PlacesIn("A study with a desk near the window and facing the door."),
              ElementsAre("The desk is near the window.", "The desk faces the door."));
  EXPECT_THAT(
      PlacesIn("A bedroom with a desk under the window, a wardrobe next to the door and, in the corner, an "
               "armchair."),
      ElementsAre("The desk is under the window.", "The wardrobe is near the door.", "The armchair is in a corner."));
  EXPECT_THAT(PlacesIn("An office with two desks, one under the window and the other by the door."),
              ElementsAre("The desk is under the window. #0", "The desk is near the door. #1"));
  EXPECT_THAT(PlacesIn("A study with a desk under the window and another desk by the door."),
              ElementsAre("The desk is under the window. #0", "The desk is near the door. #1"));
}

TEST(PlaceReader, APieceThatWasNamedIsMeantAgain) {
  EXPECT_THAT(PlacesIn("A bedroom with two single beds and a nightstand between the beds."),
              ElementsAre("The nightstand is between the single bed and the single bed."));
  EXPECT_THAT(PlacesIn("A bedroom with a king bed and a storage trunk at the foot of the bed."),
              ElementsAre("The storage trunk is next to the front of the king bed."));
}

TEST(PlaceReader, WhatIsNotUnderstoodIsKept) {
  const auto not_known = [](const char* text) { return FactsOf(text).places_not_known; };
  EXPECT_THAT(not_known("A living room with a sofa diagonally across the rug."), testing::SizeIs(1));
  EXPECT_THAT(not_known("A bedroom with a desk near the unicorn."), ElementsAre("desk near the unicorn"));
  EXPECT_THAT(not_known("A living room with an armchair between the window and the door."), testing::SizeIs(1));
  for (const char* text : {"A bedroom, 4m x 5m, with a desk and two nightstands.", "A bedroom under 20 m2 with a desk.",
                           "A house by the sea.", "A dining room for a family between Christmas and New Year."}) {
    EXPECT_THAT(not_known(text), IsEmpty()) << text;
  }
}

TEST(PlaceReader, AWindowOfItsOwnTakesNoPieceWithIt) {
  EXPECT_THAT(PlacesIn("A bedroom with a bed and a window on the north wall."), IsEmpty());
  EXPECT_THAT(PlacesIn("A bedroom with a desk and a bed near a castle."), IsEmpty());
}

TEST(PlaceReader, ThreeSidesAndEveryWallAreSoMany) {
  for (const auto& [text, walls] : {std::pair("A lounge with low seating on three sides.", 3),
                                    std::pair("A library with bookcases on every wall.", 4),
                                    std::pair("A locker room with lockers along each wall.", 4)}) {
    const std::vector<Place> places = FactsOf(text).places;
    ASSERT_EQ(places.size(), 1u) << text;
    EXPECT_EQ(places[0].walls, walls) << text;
  }
}

TEST(PlaceReader, ItMayBeAWindow) {
  ExpectEach({
      {"A room with one broad window on the west wall and a radiator below it.", "The radiator is under the window."},
      {"A bar with three windows and high stools in front of them.", "The bar stool is near the window."},
  });
}

}  // namespace
}  // namespace flair::language
