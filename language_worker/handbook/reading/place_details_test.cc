// SPDX-License-Identifier: GPL-3.0-or-later
// Places that a brief tells of several pieces at once, of parts of the room, and of what it does not want somewhere.
#include "language_worker/handbook/reading/place_details.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "language_worker/handbook/testing/test_handbook.h"

namespace flair::language {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::Not;
using ::testing::SizeIs;

// "armchair at sofa", "sofa in a corner", "desk [far left]".
std::vector<std::string> PlacesIn(const std::string& text) {
  std::vector<std::string> places;
  for (const Place& place : FactsOf(text).places) {
    std::string sentence = place.furniture->name();
    if (place.target != nullptr) sentence += " at " + place.target->name();
    if (place.asked->relation().text().find("in a corner") != std::string::npos) sentence += " in a corner";
    if (!place.side.empty()) sentence += " [" + place.side + "]";
    places.push_back(sentence);
  }
  return places;
}

TEST(PlaceDetails, WhatAnAreaIsListedWithStandsThereTogether) {
  EXPECT_THAT(PlacesIn("A living room with a reading corner: an armchair, a floor lamp and a bookcase."),
              IsSupersetOf({"bookshelf in a corner", "armchair at bookshelf", "floor lamp at bookshelf"}));
  EXPECT_THAT(PlacesIn("A lounge area by the window with a sofa, two armchairs and a coffee table."),
              IsSupersetOf({"sofa", "armchair at sofa", "coffee table at sofa"}));
  EXPECT_THAT(PlacesIn("A waiting room. By the door a children's corner with a play table and a toy box."),
              IsSupersetOf({"toy chest", "play table at toy chest"}));
}

TEST(PlaceDetails, WhatIsListedBehindAnAreaIsNoPartOfIt) {
  EXPECT_THAT(
      PlacesIn("A living room with a reading corner with a bookshelf and a floor lamp, and a dining table for six."),
      Not(Contains("dining table at bookshelf")));
}

TEST(PlaceDetails, WhatComesWithAPieceStandsByIt) {
  EXPECT_THAT(PlacesIn("A bedroom. A rocking chair should stand by the window with a side table and a floor lamp."),
              IsSupersetOf({"rocking chair", "side table at rocking chair", "floor lamp at rocking chair"}));
  EXPECT_THAT(PlacesIn("An easy chair with a side table by the window."), IsSupersetOf({"side table at easy chair"}));
  EXPECT_THAT(PlacesIn("A dining table with six chairs and a sideboard on the left wall."), SizeIs(1))
      << "its own place";
}

TEST(PlaceDetails, WindowsWithAPieceBetweenThemAreInOneWall) {
  for (const char* text :
       {"A bedroom with two windows and a desk between them.", "A bedroom with a desk between the two windows.",
        "A bedroom with two tall windows with a desk in between."}) {
    const BriefFacts facts = FactsOf(text);
    ASSERT_THAT(facts.places, SizeIs(1)) << text;
    EXPECT_EQ(facts.places[0].side, "window") << text;
    ASSERT_THAT(facts.openings.wishes, SizeIs(1)) << text;
    EXPECT_EQ(facts.openings.wishes[0].side, "far") << text;
    EXPECT_EQ(facts.openings.wishes[0].count, 2) << text;
  }
  EXPECT_THAT(PlacesIn("Two armchairs by the windows with a lamp between them."),
              IsSupersetOf({"floor lamp at armchair"}));
}

TEST(PlaceDetails, CornersOfASideAndCornersWithoutTheWord) {
  EXPECT_THAT(PlacesIn("An office with a plant in each of the far corners."),
              IsSupersetOf({"floor plant in a corner [each far]"}));
  EXPECT_EQ(FactsOf("An office with four desks and a plant in each of the far corners.").wishes.back().count, 2);
  EXPECT_THAT(PlacesIn("A classroom, the teacher's desk front left, a bookcase back right."),
              IsSupersetOf({"teacher desk in a corner [far left]", "bookshelf in a corner [near right]"}))
      << "the pupils look at the front";
  EXPECT_THAT(PlacesIn("An office with a desk in the corner left of the door."),
              IsSupersetOf({"desk in a corner [near left]"}));
}

TEST(PlaceDetails, OppositeWithoutANounIsTheWallAcross) {
  EXPECT_THAT(PlacesIn("A laundry with a dryer on the left wall, a sink beside. Opposite, a drying rack."),
              IsSupersetOf({"drying rack [across left]"}));
  EXPECT_THAT(PlacesIn("A lounge with a sofa on the left wall, two armchairs opposite."),
              IsSupersetOf({"armchair at sofa"}));
}

TEST(PlaceDetails, SeatsFaceAPointOfTheCompassFromAcross) {
  EXPECT_THAT(PlacesIn("A living room with a sofa facing east."), ElementsAre("sofa [across east]"));
  EXPECT_THAT(PlacesIn("A sunroom with windows on the south wall, two armchairs with footstools facing south."),
              Contains("armchair [south]"));
  EXPECT_THAT(PlacesIn("A bedroom with two windows on the east wall, a dresser under or between the windows."),
              ElementsAre("dresser [window]"));
  EXPECT_TRUE(FactsOf("A hall with four tables. People can walk between them.").places_not_known.empty());
}

TEST(PlaceDetails, NobodySitsWithTheBackToTheDoor) {
  for (const char* text : {"An office with two desks so that nobody sits with his back to the door.",
                           "An office, two desks, no one should have their back to the door.",
                           "An office with a desk, not with my back to the door."}) {
    const BriefFacts facts = FactsOf(text);
    ASSERT_THAT(facts.places, SizeIs(1)) << text;
    EXPECT_EQ(facts.places[0].asked->text_of_desks(), "The {seat} faces the door.") << text;
  }
}

TEST(PlaceDetails, ThingsAlongAWallAreInWhatHoldsThem) {
  EXPECT_THAT(PlacesIn("A lounge with our books along the longest wall."), IsSupersetOf({"bookshelf [longest]"}));
  EXPECT_THAT(PlacesIn("A bar with four stools at the counter and three round tables."), SizeIs(1))
      << "no place: round";
}

TEST(PlaceDetails, WhatIsNotToBeThereIsToldAndWhereARoomLiesIsNot) {
  EXPECT_THAT(FactsOf("A nursery with a crib. Please do not put anything heavy above the crib.").unheard, SizeIs(1));
  EXPECT_THAT(FactsOf("A store room behind the kitchen with shelves on the left wall.").places_not_known, IsEmpty());
}

}  // namespace
}  // namespace flair::language
