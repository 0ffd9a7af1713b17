// SPDX-License-Identifier: GPL-3.0-or-later
// Who sits where: tables with their chairs, rows that look to the front, and what goes when there is no room.
// Over 400 lines: one table of cases after the other, read from top to bottom.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "language_worker/handbook/objects/list_objects.h"
#include "language_worker/handbook/program/room_program.h"
#include "language_worker/handbook/rooms/describe_room.h"
#include "language_worker/handbook/sentences/list_constraints.h"
#include "language_worker/handbook/testing/test_handbook.h"

namespace flair::language {
namespace {

struct Plan {
  v1::ObjectList objects;
  v1::ConstraintList constraints;

  int Count(const std::string& name, const std::string& zone = "") const {
    return static_cast<int>(std::count_if(objects.objects().begin(), objects.objects().end(), [&](const auto& object) {
      return object.name() == name && (zone.empty() || object.zone_id() == zone);
    }));
  }
  const v1::Object& First(const std::string& name) const {
    const auto found = std::find_if(objects.objects().begin(), objects.objects().end(),
                                    [&](const auto& object) { return object.name() == name; });
    return found == objects.objects().end() ? v1::Object::default_instance() : *found;
  }
  int Sentences(const std::string& part) const {
    return static_cast<int>(
        std::count_if(constraints.sentences().begin(), constraints.sentences().end(),
                      [&](const auto& sentence) { return sentence.text().find(part) != std::string::npos; }));
  }
  std::string Omission(const std::string& name) const {
    for (const v1::Omission& omission : objects.omissions()) {
      if (omission.name() == name) return omission.reason();
    }
    return "";
  }
};

Plan PlanFor(const std::string& text) {
  v1::Brief brief;
  brief.set_text(text);
  const v1::Room room = *DescribeRoom(brief, TheHandbook());
  const v1::ZonePlan zones = *PlanZones(brief, room, TheHandbook());
  Plan plan;
  plan.objects = *ListObjects(brief, room, zones, TheHandbook());
  plan.constraints = *ListConstraints(brief, room, zones, plan.objects, TheHandbook());
  return plan;
}

TEST(Groups, TablesOfTwoKindsHaveTheirOwnChairs) {
  const Plan plan =
      PlanFor("A cafe, 9 m x 8 m, with three round tables with two chairs each and a dining table for eight.");
  const std::string communal = plan.First("dining table").zone_id();
  ASSERT_NE(communal, "");
  EXPECT_EQ(plan.Count("dining chair"), 14);
  EXPECT_EQ(plan.Count("dining chair", communal), 8);
  EXPECT_EQ(plan.Count("dining table", communal), 1);
  for (const v1::Sentence& sentence : plan.constraints.sentences()) {
    const auto& about = sentence.subject_ids();
    const bool at_it = std::ranges::find(about, plan.First("dining table").id()) != about.end();
    for (const v1::Object& chair : plan.objects.objects()) {
      if (!at_it || chair.name() != "dining chair" || chair.zone_id() == communal) continue;
      EXPECT_EQ(std::ranges::find(about, chair.id()), about.end()) << sentence.text();
    }
  }
}

TEST(Stock, SmallThingsBesideWhatWasAskedForStayAndLargeOnesGo) {
  const Plan plan = PlanFor("A living room with a sofa, two armchairs and a fireplace.");
  EXPECT_EQ(plan.Count("floor lamp"), 1);
  EXPECT_EQ(plan.Count("side table"), 1);
  EXPECT_EQ(plan.Count("tv stand"), 0);
}

TEST(Stock, WhatWasAskedForIsCarriedWhereItsClassMayBe) {
  const Plan plan = PlanFor("A hotel room with a TV.");  // there it usually hangs on the wall
  EXPECT_EQ(plan.Count("television"), 1);
  EXPECT_EQ(plan.Omission("television"), "");
}

TEST(Groups, ZonesOfGroupsHaveNamesOfTheirOwn) {
  v1::Brief brief;
  brief.set_text("Care home lounge: fourteen armchairs arranged in small clusters, two side tables per cluster.");
  std::map<std::string, int> ids;
  const v1::ZonePlan plan = *PlanZones(brief, *DescribeRoom(brief, TheHandbook()), TheHandbook());
  for (const v1::Zone& zone : plan.zones()) {
    EXPECT_EQ(++ids[zone.id()], 1) << zone.id();
  }
  EXPECT_GE(ids.size(), 3u);
}

TEST(Groups, AClassroomHasRowsOfDesksThatLookToTheTeacher) {
  const Plan plan = PlanFor("A classroom for 24 pupils.");
  EXPECT_EQ(plan.Count("school desk"), 24);
  EXPECT_EQ(plan.Count("school chair"), 24);
  EXPECT_EQ(plan.Count("teacher desk"), 1);
  const int across = plan.Count("school desk", "first_row");
  ASSERT_GE(across, 4);
  const int rows = (24 + across - 1) / across;
  EXPECT_EQ(plan.Count("school chair", "first_row"), across) << "everyone sits in the row of the desk";
  EXPECT_EQ(plan.Sentences("is at most 1 m in front of the"), 2 * (rows - 1))
      << "every row behind the one before, at both ends";
  EXPECT_EQ(plan.Sentences("faces the teacher desk"), rows + 1) << "every row, and whoever teaches";
  EXPECT_EQ(plan.Sentences("The left side of the"), 12) << "two side by side, then a way";
  EXPECT_EQ(plan.Sentences("desks stand in a row 0.75 m apart"), rows * (across / 2 - 1)) << "the row goes on";
  EXPECT_EQ(plan.Sentences("faces the same way as the first school desk"), 1) << "whoever teaches";
  EXPECT_EQ(plan.Sentences("The teacher desk is at most 2 m in front of the "), 1) << "of the middle of the first row";
}

TEST(Groups, ManyDesksStandInIslands) {
  const Plan plan = PlanFor("An office for twelve: twelve desks, 10 x 7 m.");
  ASSERT_EQ(plan.Count("desk"), 12);
  EXPECT_EQ(plan.Count("desk", "workstation"), 4);
  EXPECT_EQ(plan.Sentences("The back side of the"), 6) << "two and two, back to back";
  EXPECT_EQ(plan.Sentences("is next to the right side of the"), 3);
  EXPECT_EQ(plan.Sentences("desk is near a wall"), 0);
  EXPECT_EQ(PlanFor("A 4 m x 4 m office with four desks.").Sentences("The back side of the"), 0) << "no room";
  EXPECT_EQ(PlanFor("An office of 8 x 8 m, six desks facing the windows.").Sentences("The back side of the"), 0);
}

TEST(Groups, WhatIsInRowsIsInNoIslands) {
  const Plan rows = PlanFor("A classroom with 24 desks in rows, 9 x 7 m.");
  EXPECT_GT(rows.Count("school desk", "first_row"), 2);
  EXPECT_EQ(rows.Sentences("The back side of the"), 0);
  const Plan groups = PlanFor("A classroom with 24 desks in groups of four, 9 x 7 m.");
  EXPECT_EQ(groups.Count("school desk", "pupils"), 4);
  EXPECT_EQ(groups.Sentences("The back side of the"), 12);
}

TEST(Groups, BenchesLeaveAnAisleAndArmchairsComeToTheSofa) {
  const Plan chapel = PlanFor("A small chapel with eight pews and an altar, 6 x 9 m.");
  EXPECT_EQ(chapel.Count("pew", "first_row"), 2);
  EXPECT_EQ(chapel.Sentences("side of the second pew is"), 0);
  const Plan living = PlanFor("A living room 5 x 4.5 m: sofa, two armchairs, coffee table, television.");
  EXPECT_EQ(living.Count("armchair", living.First("sofa").zone_id()), 2);
}

TEST(Groups, EveryTableHasItsOwnChairs) {
  const Plan plan = PlanFor("A café with five tables for two.");
  EXPECT_EQ(plan.Count("dining table"), 5);
  EXPECT_EQ(plan.Count("dining chair"), 10);
  std::map<std::string, int> chairs;
  for (const v1::Object& object : plan.objects.objects()) {
    if (object.name() == "dining chair") ++chairs[object.zone_id()];
  }
  EXPECT_EQ(chairs.size(), 5u);
  for (const auto& [zone, count] : chairs) EXPECT_EQ(count, 2) << zone;
}

TEST(Groups, TheChairsOfAMeetingTableDoNotStandAtTheDesks) {
  const Plan plan = PlanFor("An office with four desks and a meeting table with six chairs.");
  EXPECT_EQ(plan.Count("office chair", "meeting"), 6);
  EXPECT_EQ(plan.Count("office chair", "workstation"), 4);
  EXPECT_EQ(plan.Count("dining chair"), 0);
}

TEST(Groups, ATableIsAsLongAsThoseWhoSitAtItNeed) {
  const v1::Object table = PlanFor("A 6 m x 8 m dining room with a table for 14.").First("dining table");
  EXPECT_GE(table.width_m(), 3.5);
  hb::Furniture rectangular;
  rectangular.set_category("table");
  EXPECT_EQ(SeatsRound(rectangular, 1.5, 0.9), 6);
  EXPECT_EQ(SeatsRound(rectangular, 1.2, 0.6), 4) << "nobody at a narrow end";
  EXPECT_DOUBLE_EQ(WidthForSeats(rectangular, 8, 1.5, 0.9), 1.8);
  // More than any table takes: several.
  const Plan restaurant = PlanFor("A restaurant for 30 guests.");
  EXPECT_GE(restaurant.Count("dining table"), 4);
  EXPECT_EQ(restaurant.Count("dining chair"), 30);
}

TEST(Groups, WhatDoesNotFitGoesWithItsSeatsAndIsCounted) {
  const Plan plan = PlanFor("A 4m x 4m office with twenty desks.");
  const int desks = plan.Count("desk");
  EXPECT_GE(desks, 4);
  EXPECT_LT(desks, 20);
  EXPECT_EQ(plan.Count("office chair"), desks) << "a desk without a chair is no place to work";
  EXPECT_TRUE(plan.Omission("desk").starts_with(std::to_string(20 - desks) + " of 20:")) << plan.Omission("desk");
  EXPECT_EQ(PlanFor("A 3m x 3m bedroom with ten single beds.").Omission("single bed").substr(0, 8), "8 of 10:");
}

TEST(Groups, NothingElseMeansNothingElse) {
  const Plan plan = PlanFor("A bedroom, only a bed and a desk.");
  EXPECT_EQ(plan.Count("double bed"), 1);
  EXPECT_EQ(plan.Count("office chair"), 1) << "the desk's own";
  EXPECT_EQ(plan.Count("wardrobe") + plan.Count("dresser"), 0);
}

TEST(Groups, CountsFollowWhatIsAsked) {
  EXPECT_EQ(PlanFor("A barber shop, 5 x 7 m, with four barber chairs.").Count("styling station"), 4);
  EXPECT_EQ(PlanFor("An open office for 16, 7 x 9 m, in clusters of 4 desks.").Count("desk"), 16);
  EXPECT_EQ(PlanFor("A kitchen, 3.5 x 4 m, with an island and three stools.").Count("round dining table"), 0);
  EXPECT_EQ(PlanFor("A lounge with three armchairs around a round table.").Count("dining chair"), 0);
  EXPECT_EQ(PlanFor("A living room with a television opposite the sofa.").Count("tv stand"), 1);
  const Plan beds = PlanFor("A bedroom, 4 x 5 m, separate beds please. Two twin beds.");
  EXPECT_EQ(beds.Count("single bed"), 2);
  EXPECT_EQ(beds.Count("double bed"), 0);
}

TEST(Groups, WhatTheBriefSaysOfAPlaceIsWrittenInsteadOfTheUsual) {
  const Plan plan = PlanFor("A bedroom with the bed under the window.");
  EXPECT_EQ(plan.Sentences("The double bed is under the window."), 1);
  EXPECT_EQ(plan.Sentences("The double bed is at least 0.4 m away from the windows."), 0);
  EXPECT_EQ(PlanFor("A bedroom.").Sentences("The double bed is at least 0.4 m away from the windows."), 1);
}

TEST(Groups, EveryoneHasAPlaceOrItIsSaid) {
  const auto seats = [](const Plan& plan) { return plan.Count("dining chair"); };
  const Plan library = PlanFor("A library for forty readers.");
  EXPECT_EQ(seats(library), 40);
  EXPECT_TRUE(library.objects.diagnostics().empty());
  EXPECT_EQ(seats(PlanFor("A dining room for a family of five.")), 5);
  EXPECT_EQ(PlanFor("A classroom where twenty students learn.").Count("school desk"), 20);
  EXPECT_EQ(PlanFor("A chapel that seats sixty.").Count("pew"), 20);
  EXPECT_EQ(PlanFor("A dorm room that sleeps six.").Count("single bed"), 6);
  EXPECT_GE(PlanFor("A living room for a family of six.").Count("armchair"), 3);
  // Too many for the floor: as many as fit, and how many that is.
  const Plan full = PlanFor("A library of 4 m x 4 m for forty readers.");
  EXPECT_LT(seats(full), 20);
  ASSERT_EQ(full.objects.diagnostics_size(), 1);
  EXPECT_EQ(full.objects.diagnostics(0).code(), "people_without_place");
}

TEST(Groups, WhatIsAskedForInGroupsStandsInZonesOfItsOwn) {
  const Plan office = PlanFor("An office of 10 m x 9 m with sixteen desks in four blocks of four.");
  std::map<std::string, int> in_zone;
  for (const v1::Object& object : office.objects.objects())
    in_zone[object.zone_id()] += object.name() == "desk" ? 1 : 0;
  EXPECT_EQ(std::ranges::count(in_zone, 4, &std::pair<const std::string, int>::second), 4);
  const Plan cafe = PlanFor("A café of 9 m x 8 m with four tables for four and three tables for two.");
  EXPECT_EQ(cafe.Count("dining table"), 7);
  EXPECT_EQ(cafe.Count("dining chair"), 22);
  // Groups of two classes in one zone have names of their own.
  v1::Brief brief;
  brief.set_text("A lounge of 9 m x 8 m with twelve armchairs in small clusters and six side tables in three groups.");
  const v1::Room room = *DescribeRoom(brief, TheHandbook());
  std::map<std::string, int> ids;
  const v1::ZonePlan zones = *PlanZones(brief, room, TheHandbook());
  for (const v1::Zone& zone : zones.zones()) EXPECT_EQ(++ids[zone.id()], 1) << zone.id();
  EXPECT_GE(ids.size(), 4u);
}

TEST(Groups, ChairsForVisitorsLeaveTheDeskItsOwn) {
  const Plan plan = PlanFor("A home office, 4 x 4 m, with a desk, a bookshelf and three chairs for guests.");
  EXPECT_EQ(plan.Count("visitor chair"), 3);
  EXPECT_EQ(plan.Count("office chair"), 1);
  EXPECT_EQ(PlanFor("A dining room, 4 x 4 m, round table with half a dozen chairs.").Count("dining chair"), 6);
}

TEST(Groups, WhatIsAskedForStaysWhereItIsTight) {
  const Plan bedroom = PlanFor(
      "A bedroom, 3.2 x 3 m, with a double bed, two nightstands, a floor lamp, a wardrobe and a chest of drawers.");
  EXPECT_EQ(bedroom.Count("nightstand"), 2);
  EXPECT_EQ(bedroom.Count("double bed"), 1);
  EXPECT_EQ(bedroom.Count("floor lamp"), 1);
}

TEST(Groups, WhatIsWantedOnlyIfThereIsRoomGoesFirstAndIsNoComplaint) {
  const Plan roomy = PlanFor("A dining room of 6 m x 6 m with a bench if there is room.");
  EXPECT_EQ(roomy.Count("dining bench"), 1);
  const Plan tight = PlanFor("A bedroom of 2.5 m x 3 m with a double bed, a wardrobe and a sofa if there is room.");
  EXPECT_EQ(tight.Count("sofa") + tight.Count("loveseat"), 0);
  EXPECT_EQ(tight.Count("double bed"), 1);
  EXPECT_EQ(tight.Omission("sofa").find("the brief wants it only if there is room"), 0u) << tight.Omission("sofa");
  for (const v1::Omission& omission : tight.objects.omissions()) {
    if (omission.name() == "sofa") EXPECT_FALSE(omission.requested());
  }
}

TEST(Groups, TheStoolOfADressingTableStays) {
  constexpr const char* kText =
      "A bedroom of 4.5 m x 4 m with a king size bed, a wardrobe, a bench and a dressing table with a stool.";
  EXPECT_EQ(PlanFor(kText).Count("stool"), 1);
  const Plan desk = PlanFor("A bedroom of 4 m x 5 m with a bed and a desk with a stool.");
  EXPECT_EQ(desk.Count("stool"), 1);
  EXPECT_EQ(desk.Count("office chair"), 0);
  EXPECT_EQ(PlanFor("A classroom of 9 m x 7.5 m for 24 pupils, desks, and three beanbags.").Count("school chair"), 24);
}

TEST(Groups, AnIslandOfFourIsTwoPairsBackToBack) {
  const Plan plan = PlanFor("An office of 8 m x 6 m with four desks in a group of four.");
  EXPECT_EQ(plan.Sentences("The back side of the second desk is next to the back side of the first desk."), 1);
  EXPECT_EQ(plan.Sentences("The left side of the third desk is next to the right side of the first desk."), 1);
  EXPECT_EQ(plan.Sentences("The back side of the fourth desk is next to the back side of the third desk."), 1);
}

TEST(Groups, OfTwoChairsAtATableWithTwoSidesOneIsAcross) {
  const Plan plan = PlanFor("A nail salon, 5 x 6 m, with four manicure tables with two chairs each facing each other.");
  EXPECT_EQ(plan.Count("office chair"), 4);
  EXPECT_EQ(plan.Count("visitor chair"), 4);
  EXPECT_EQ(plan.Sentences("visitor chair is next to the back of the"), 4);
  EXPECT_EQ(plan.Sentences("face each other"), 0);
  EXPECT_TRUE(plan.objects.diagnostics().empty()) << plan.objects.diagnostics(0).message();
}

TEST(Groups, WhatFacesOneThingStandsInRowsInAnyKindOfRoom) {
  const Plan plan = PlanFor("A sewing room, 9 x 8 m, with ten desks facing the whiteboard.");
  std::map<std::string, int> in_zone;
  for (const v1::Object& object : plan.objects.objects())
    if (object.name() == "desk") ++in_zone[object.zone_id()];
  EXPECT_EQ(plan.Count("desk"), 10);
  EXPECT_GT(in_zone.size(), 1u);
}

TEST(Groups, ManyAtOnePlaceFollowTheFirstInARow) {
  const Plan plan = PlanFor("An office of 8 m x 6 m with a desk and six lockers beside the door.");
  EXPECT_EQ(plan.Sentences("first locker is near the door."), 1);
  EXPECT_EQ(plan.Sentences("second locker is near the door."), 0);
  EXPECT_EQ(plan.Sentences("lockers stand side by side in a row."), 1);
  EXPECT_EQ(plan.Sentences("locker's back is against a wall."), 6);
}

TEST(Groups, ChairsOfATableDoNotLookAtTheDesksElsewhere) {
  const Plan plan = PlanFor("An office of 9 m x 6 m with eight desks and a conference table with four chairs.");
  EXPECT_EQ(plan.Sentences("surround the conference table"), 1);
  EXPECT_EQ(plan.Sentences("office chair faces the"), plan.Count("desk"));
}

TEST(Groups, ANestOfTablesStandsForTheCoffeeTable) {
  const Plan plan = PlanFor("A living room, 5 m x 4 m, with a corner sofa, an armchair and a nest of tables.");
  EXPECT_EQ(plan.Count("nest of tables"), 1);
  EXPECT_EQ(plan.Count("coffee table"), 0);
}

TEST(Groups, StoolsAtATableForChairsStayStools) {
  const Plan plan = PlanFor("A kitchen of 2.4 m x 3.8 m with two stools at a fold-down table.");
  EXPECT_EQ(plan.Count("bar stool"), 2);
  EXPECT_EQ(plan.Count("dining chair"), 0);
}

TEST(Groups, WhoIsSaidToSitAtAWorkTableHasAStool) {
  const Plan studio = PlanFor("An art studio, 6 m x 6 m, with a work table for six.");
  EXPECT_EQ(studio.Count("work stool"), 6);
  EXPECT_GE(studio.First("work table").width_m(), 1.79);
}

TEST(Groups, PewsStandOnEitherSideOfAnAisle) {
  const Plan plan = PlanFor("A chapel of 7 m x 10 m with twelve pews.");
  EXPECT_EQ(plan.Count("pew", "first_row"), 2);
  EXPECT_EQ(plan.Sentences("The pews stand in a row 1.2 m apart."), 6);
}

TEST(Groups, ManyEasyChairsLeaveRoomForLegsAboutALowTable) {
  const Plan plan = PlanFor("A reading room, 6 x 5 m, with four armchairs around a low table.");
  EXPECT_EQ(plan.Sentences("The armchairs surround the coffee table 0.4 m away."), 1);
  EXPECT_EQ(PlanFor("A dining room with six chairs around the table.").Sentences("m away."), 0);
}

TEST(Groups, RowsOfABriefAreStraightInEveryKindOfRoom) {
  const Plan plan = PlanFor("Meditation room with 16 cushions in rows facing a low altar, 9 x 6 m.");
  EXPECT_EQ(plan.Sentences("The floor cushions stand in a row 0.3 m apart."), 4);
  EXPECT_EQ(plan.Sentences("is at most 1.2 m in front of the"), 3) << "row behind row";
  EXPECT_EQ(plan.Sentences("The altar is at most 2.4 m in front of the"), 1) << "of the middle of the first row";
  EXPECT_EQ(plan.Sentences("faces the altar"), 0) << "outer ones would turn out of their row";
}

TEST(Groups, AnAudienceHasNoTables) {
  const Plan plan = PlanFor("Community hall 10 x 8 m with forty chairs in rows facing a stage.");
  EXPECT_EQ(plan.Count("dining chair"), 40);
  EXPECT_EQ(plan.Count("round dining table"), 0);
}

TEST(Groups, EasyChairsGoWithTheTableTheFireOrEachOther) {
  EXPECT_EQ(PlanFor("Living room 6 x 4.5 m with a sofa, two armchairs and a coffee table.")
                .Sentences("The armchairs surround the coffee table 0.4 m away."),
            1);
  const Plan fire = PlanFor("Library with fireplace and two wing chairs.");
  EXPECT_EQ(fire.Sentences("wing chair faces the fireplace."), 2) << "what is said of armchairs holds for them";
  EXPECT_EQ(PlanFor("Study with a desk, two club chairs, a side table and bookshelves.")
                .Sentences("The side table is between the club chairs."),
            1);
}

TEST(Groups, WhoeverSitsOnWhatIsAskedForHasNoSofaBesides) {
  EXPECT_EQ(PlanFor("Snug with two settles across an oak table by the fire and three low stools.").Count("loveseat"),
            0);
  EXPECT_EQ(PlanFor("Home cinema for eight people.").Count("sofa"), 0);
}

TEST(Groups, HallsHaveMoreOfWhatComesInNumbers) {
  EXPECT_GE(PlanFor("A village library of 8 m x 10 m.").Count("bookshelf"), 14);
  EXPECT_LE(PlanFor("A library of 4 m x 6 m.").Count("bookshelf"), 8);
  EXPECT_EQ(PlanFor("A library of 8 m x 10 m with six bookcases.").Count("bookshelf"), 6);
}

TEST(Groups, WhatEachStationHasStandsTogether) {
  const char* const kBriefs[] = {
      "A nail studio, 6 x 5 m, with two working stations, each with a chair, a stool, a trolley and a floor lamp.",
      "A salon, 6 x 5 m, with two stations; each has a chair, a stool, a trolley and a floor lamp.",
      "A workshop, 6 x 5 m, for two potters, each with a chair, a stool, a trolley and a floor lamp."};
  for (const char* const brief : kBriefs) {
    const Plan plan = PlanFor(brief);
    std::map<std::string, std::multiset<std::string>> stations;
    for (const v1::Object& object : plan.objects.objects()) {
      if (object.category() == "stool" || object.name() == "rolling cart" || object.category() == "floor_lamp")
        stations[object.zone_id()].insert(object.category());
    }
    ASSERT_EQ(stations.size(), 2u) << brief;
    EXPECT_EQ(stations.begin()->second, (std::multiset<std::string>{"cabinet", "floor_lamp", "stool"})) << brief;
    EXPECT_EQ(stations.begin()->second, stations.rbegin()->second) << brief;
  }
}

}  // namespace
}  // namespace flair::language
