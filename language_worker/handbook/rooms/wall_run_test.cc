// SPDX-License-Identifier: GPL-3.0-or-later
// Kitchens of many sizes: their units stand side by side, clear of doors, and each is where it belongs in the run.
#include "language_worker/handbook/rooms/wall_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "language_worker/handbook/objects/list_objects.h"
#include "language_worker/handbook/rooms/describe_room.h"
#include "language_worker/handbook/rooms/walls.h"
#include "language_worker/handbook/testing/test_handbook.h"

namespace flair::language {
namespace {

struct Kitchen {
  v1::Room room;
  v1::ObjectList objects;
  std::vector<RunPlace> run;
};

Kitchen KitchenOf(const std::string& text, std::int64_t seed) {
  v1::Brief brief;
  brief.set_text(text);
  brief.set_seed(seed);
  Kitchen kitchen{*DescribeRoom(brief, TheHandbook()), {}, {}};
  const v1::ZonePlan zones = *PlanZones(brief, kitchen.room, TheHandbook());
  kitchen.objects = *ListFloorObjects(brief, kitchen.room, zones, TheHandbook());
  kitchen.run = PlanRun(kitchen.room, kitchen.objects, FactsOf(text), TheHandbook(), Choice(seed, text));
  return kitchen;
}

// Corners of a unit: on the wall and in the room.
std::vector<v1::Point2> CornersOf(const Kitchen& kitchen, const RunPlace& place) {
  const auto& vertices = kitchen.room.floor().vertices();
  const v1::Point2 &from = vertices[place.wall], &to = vertices[(place.wall + 1) % vertices.size()];
  const double length_m = WallLength(kitchen.room, place.wall);
  const double x = (to.x_m() - from.x_m()) / length_m, y = (to.y_m() - from.y_m()) / length_m;
  std::vector<v1::Point2> corners;
  for (const double along_m : {place.offset_m, place.end_m()}) {
    for (const double in_m : {0.0, place.object->depth_m()}) {
      v1::Point2& corner = corners.emplace_back();
      corner.set_x_m(from.x_m() + along_m * x - in_m * y);
      corner.set_y_m(from.y_m() + along_m * y + in_m * x);
    }
  }
  return corners;
}

bool Overlap(const std::vector<v1::Point2>& a, const std::vector<v1::Point2>& b) {
  const auto apart = [&](double (v1::Point2::*side)() const) {
    const auto less = [side](const v1::Point2& p, const v1::Point2& q) { return (p.*side)() < (q.*side)(); };
    const auto [a_low, a_high] = std::ranges::minmax_element(a, less);
    const auto [b_low, b_high] = std::ranges::minmax_element(b, less);
    return ((*a_high).*side)() <= ((*b_low).*side)() + 1e-6 || ((*b_high).*side)() <= ((*a_low).*side)() + 1e-6;
  };
  return !apart(&v1::Point2::x_m) && !apart(&v1::Point2::y_m);
}

class WallRun : public testing::TestWithParam<const char*> {};

TEST_P(WallRun, UnitsStandSideBySideClearOfEachOtherAndOfDoors) {
  for (std::int64_t seed = 0; seed < 6; ++seed) {
    const Kitchen kitchen = KitchenOf(GetParam(), seed);
    ASSERT_GE(kitchen.run.size(), 4u) << GetParam();
    std::map<int, int> ends;
    for (const RunPlace& place : kitchen.run) {
      SCOPED_TRACE(testing::Message() << GetParam() << " seed " << seed << " " << place.object->id());
      EXPECT_GE(place.offset_m, -1e-9);
      EXPECT_LE(place.end_m(), WallLength(kitchen.room, place.wall) + 1e-6);
      for (const RunPlace& other : kitchen.run) {
        if (&place != &other) EXPECT_FALSE(Overlap(CornersOf(kitchen, place), CornersOf(kitchen, other)));
      }
      for (const v1::Opening& one : kitchen.room.openings()) {
        if (one.kind() != v1::OPENING_KIND_DOOR || one.wall() != kitchen.room.walls(place.wall).name()) continue;
        EXPECT_TRUE(place.end_m() < one.offset_m() || place.offset_m > one.offset_m() + one.width_m());
      }
      const bool joined = std::ranges::any_of(kitchen.run, [&](const RunPlace& other) {
        return other.wall == place.wall && std::abs(other.end_m() - place.offset_m) < 1e-6;
      });
      if (!joined) ++ends[place.wall];
    }
    // One line on each of at most two walls.
    EXPECT_LE(ends.size(), 2u) << GetParam() << " seed " << seed;
    for (const auto& [wall, count] : ends) EXPECT_EQ(count, 1) << GetParam() << " seed " << seed << " wall " << wall;
  }
}

INSTANTIATE_TEST_SUITE_P(Kitchens, WallRun,
                         testing::Values("A kitchen, 3 m x 4 m.", "A kitchen, 2.4 m x 4.5 m.",
                                         "A kitchen, 2.5 m x 3 m.", "A large kitchen, 5 m x 6 m.",
                                         "An L-shaped kitchen, 4 m x 4 m.", "A studio flat, 6 m x 5 m."));

TEST(WallRunWishes, TheRunTakesTheWallThatTheBriefNames) {
  const Kitchen kitchen =
      KitchenOf("A kitchen, 4 m x 5 m, with the cooker along the east wall and the door in the west.", 0);
  ASSERT_FALSE(kitchen.run.empty());
  const auto on_east = std::ranges::count_if(
      kitchen.run, [&](const RunPlace& place) { return kitchen.room.walls(place.wall).name() == "east"; });
  EXPECT_GT(2 * on_east, static_cast<std::ptrdiff_t>(kitchen.run.size()));
}

TEST(WallRunWishes, TheRunGoesRoundTheRoomAsTheBriefSays) {
  const struct {
    const char* text;
    std::size_t walls;
    bool facing;
  } kCases[] = {{"A U-shaped kitchen, 3.5 m x 4 m.", 3, true},
                {"A kitchen, 4 m x 4.5 m, in a U.", 3, true},
                {"A kitchen, 4 m x 3 m, with units in an L.", 2, false},
                {"An L-shaped kitchen, 4 m x 3.5 m.", 2, false},
                {"A galley kitchen, 2.4 m x 4 m.", 2, true},
                {"A kitchen, 5 m x 4 m, everything along one wall.", 1, false}};
  for (const auto& one : kCases) {
    const Kitchen kitchen = KitchenOf(one.text, 0);
    std::set<int> walls;
    for (const RunPlace& place : kitchen.run) walls.insert(place.wall);
    EXPECT_EQ(walls.size(), one.walls) << one.text;
    const bool facing =
        std::ranges::any_of(walls, [&](int wall) { return walls.contains((wall + 2) % kitchen.room.walls_size()); });
    EXPECT_EQ(facing, one.facing) << one.text;
    EXPECT_EQ(kitchen.room.floor().vertices_size(), 4) << one.text;
  }
}

TEST(WallRunWishes, TheSinkOrATableHasTheWindowAsTheBriefSays) {
  for (std::int64_t seed = 0; seed < 6; ++seed) {
    const Kitchen sink = KitchenOf("A kitchen, 5 x 4 m, with the window over the sink.", seed);
    EXPECT_TRUE(std::ranges::any_of(sink.run, &RunPlace::at_window)) << seed;
    const Kitchen table = KitchenOf("A kitchen, 5 x 4 m, with a round table under the window.", seed);
    for (const RunPlace& place : table.run)
      EXPECT_TRUE(IsBlank(table.room, place.wall) || place.wall != *WallOf(table.room, "window")) << seed;
  }
}

TEST(WallRunWishes, TheWallOfOneUnitIsNotThatOfTheSinkUnderItsWindow) {
  const std::string text =
      "A kitchen, 3.8 x 4.5 m, with the window in the north wall and the door in the south wall. The sink under the "
      "window, the cooker on the east wall.";
  for (std::int64_t seed = 0; seed < 6; ++seed) {
    Kitchen kitchen = KitchenOf(text, seed);
    std::set<std::string> fitted;
    for (const v1::Object& object : kitchen.objects.objects()) fitted.insert(object.id());
    kitchen.run = PlanRun(kitchen.room, kitchen.objects, FactsOf(text), TheHandbook(), Choice(seed, text), fitted);
    for (const RunPlace& place : kitchen.run) {
      if (place.part == hb::RUN_PART_BASIN) EXPECT_TRUE(place.at_window) << seed;
      if (place.part == hb::RUN_PART_HOB) EXPECT_EQ(kitchen.room.walls(place.wall).name(), "east") << seed;
    }
  }
}

TEST(WallRunWishes, ASinkAloneIsNoRun) {
  EXPECT_TRUE(KitchenOf("A bathroom.", 0).run.empty());
  EXPECT_TRUE(KitchenOf("A bedroom, 4 m x 4 m.", 0).run.empty());
}

}  // namespace
}  // namespace flair::language
