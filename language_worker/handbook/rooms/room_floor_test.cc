// SPDX-License-Identifier: GPL-3.0-or-later
// Rooms that are no rectangles: outline, walls, openings.
#include "language_worker/handbook/rooms/room_floor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "language_worker/handbook/rooms/describe_room.h"
#include "language_worker/handbook/testing/test_handbook.h"
#include "room/validation/validate.h"

namespace flair::language {
namespace {

class RoomFloor : public testing::Test {
 protected:
  static bool Says(const v1::Room& room, const std::string& code) {
    return std::any_of(room.diagnostics().begin(), room.diagnostics().end(), [&](const v1::Diagnostic& diagnostic) {
      return diagnostic.code() == code && diagnostic.severity() == v1::SEVERITY_WARNING;
    });
  }
  static double Extent(const v1::Room& room, bool along_x) {
    double most_m = 0;
    for (const v1::Point2& p : room.floor().vertices()) most_m = std::max(most_m, along_x ? p.x_m() : p.y_m());
    return most_m;
  }
};

TEST_F(RoomFloor, RoundRoomsAreAsWideAsAsked) {
  const struct {
    const char* text;
    int corners;
    double width_m, area_m2;
  } kCases[] = {{"A round bedroom, 6 m across.", 12, 6, 28.9},
                {"A circular study, 3 m across.", 8, 3, 7.5},
                {"An octagonal living room of 5 m x 5 m.", 8, 5, 20.7},
                {"A hexagonal office of 6 m x 5 m.", 6, 6, 22.5}};
  for (const auto& expected : kCases) {
    for (int seed = 0; seed < 8; ++seed) {
      const v1::Room room = RoomOf(expected.text, seed);
      EXPECT_TRUE(Validate(room).ok()) << expected.text << " seed " << seed << ": " << Validate(room);
      EXPECT_EQ(room.floor().vertices_size(), expected.corners) << expected.text;
      EXPECT_NEAR(Extent(room, true), expected.width_m, 1e-5) << expected.text;
      EXPECT_NEAR(FloorArea(room), expected.area_m2, 0.1) << expected.text;
      EXPECT_GE(room.openings_size(), 2) << "a door and a window";
    }
  }
}

TEST_F(RoomFloor, EveryShapeAndSeedIsAValidRoomOfTheSizeAskedFor) {
  const struct {
    const char* text;
    int corners;
    double area_m2;
  } kCases[] = {{"An L-shaped studio of 6 m x 5 m.", 6, 25.2},
                {"A T-shaped living room of 8 m x 6 m.", 8, 36},
                {"A U-shaped office of 9 m x 6 m.", 8, 45}};
  for (const auto& expected : kCases) {
    std::set<std::string> outlines;
    for (int seed = 0; seed < 24; ++seed) {
      const v1::Room room = RoomOf(expected.text, seed);
      EXPECT_TRUE(Validate(room).ok()) << expected.text << " seed " << seed << ": " << Validate(room);
      EXPECT_EQ(room.floor().vertices_size(), expected.corners);
      EXPECT_EQ(room.walls(0).name(), "wall_1");
      EXPECT_NEAR(FloorArea(room), expected.area_m2, 0.5) << expected.text << " seed " << seed;
      EXPECT_DOUBLE_EQ(Extent(room, true), expected.corners == 6                                       ? 6
                                           : std::string(expected.text).find('8') != std::string::npos ? 8
                                                                                                       : 9);
      EXPECT_EQ(std::count_if(room.openings().begin(), room.openings().end(),
                              [](const v1::Opening& o) { return o.kind() == v1::OPENING_KIND_DOOR; }),
                1);
      EXPECT_GE(room.openings_size(), 2) << "a door and a window";
      EXPECT_GE(room.sockets_size(), 2);
      EXPECT_FALSE(Says(room, "shape_unknown") || Says(room, "shape_too_small"));
      outlines.insert(room.floor().SerializeAsString());
    }
    EXPECT_GE(outlines.size(), 4u) << expected.text << ": the seed turns it";
  }
}

TEST_F(RoomFloor, ALegIsAddedToTheMainPart) {
  const struct {
    const char* text;
    double width_m, depth_m, area_m2;
  } kCases[] = {
      {"L shaped living room. The main part is 5.5 by 4.2 metres and the leg on the north east is 2.5 by 2.", 5.5, 6.2,
       28.1},
      {"An L-shaped living room, main part 5 x 4 m, leg to the west 2 x 2.5 m.", 7, 4, 25},
      {"A bedroom, 4 x 4 m, with a 1.5 x 0.7 m alcove in the west wall.", 4.7, 4, 17.05},
      {"A living room of 5 x 4 m with a bay of 2 x 0.8 m in the south wall.", 5, 4.8, 21.6},
  };
  for (const auto& expected : kCases) {
    const v1::Room room = RoomOf(expected.text);
    EXPECT_TRUE(Validate(room).ok()) << expected.text << Validate(room);
    EXPECT_NEAR(Extent(room, true), expected.width_m, 1e-6) << expected.text;
    EXPECT_NEAR(Extent(room, false), expected.depth_m, 1e-6) << expected.text;
    EXPECT_NEAR(FloorArea(room), expected.area_m2, 0.01) << expected.text;
  }
}

TEST_F(RoomFloor, AFloorMayBeNarrowerAtOneEnd) {
  const v1::Room stern = RoomOf("A cabin, 4 x 5 m, the stern end narrower than the other, three stern windows.");
  ASSERT_EQ(stern.floor().vertices_size(), 4);
  EXPECT_EQ(stern.walls(2).name(), "north");
  EXPECT_NEAR(stern.floor().vertices(2).x_m() - stern.floor().vertices(3).x_m(), 3, 1e-6);
  EXPECT_EQ(std::ranges::count(stern.openings(), "north", &v1::Opening::wall), 3);
  const v1::Room east = RoomOf("A trapezoidal living room of 6 x 5 m that is narrower at the east end.");
  EXPECT_LT(east.floor().vertices(2).y_m() - east.floor().vertices(1).y_m(), 4.5);
}

TEST_F(RoomFloor, FacesOfATowerAreThoseThatLookThatWay) {
  const v1::Room tower =
      RoomOf("An octagonal library, 6 m across, door on the south face, a window on the north east face.");
  EXPECT_EQ(tower.openings(0).wall(), "wall_6");
  EXPECT_EQ(tower.openings(1).wall(), "wall_1");
}

TEST_F(RoomFloor, AnAreaIsThatOfTheFloor) {
  EXPECT_NEAR(FloorArea(RoomOf("An L-shaped living room of 30 square metres.")), 30, 0.6);
  EXPECT_NEAR(FloorArea(RoomOf("A T-shaped living room of 30 square metres.")), 30, 0.6);
}

TEST_F(RoomFloor, SaysWhatWasDoneInstead) {
  const v1::Room pointed = RoomOf("A triangular bedroom of 4 m x 4 m.");
  EXPECT_EQ(pointed.floor().vertices_size(), 4);
  EXPECT_TRUE(Says(pointed, "shape_unknown"));
  const v1::Room small = RoomOf("An L-shaped bathroom of 2 m x 2 m.");
  EXPECT_EQ(small.floor().vertices_size(), 4);
  EXPECT_TRUE(Says(small, "shape_too_small"));
}

TEST_F(RoomFloor, APlainBriefGivesARectangleAndNoRemarkOnShape) {
  const v1::Room room = RoomOf("A bedroom that is 4m x 5m with an L-shaped sofa and a round table.");
  EXPECT_EQ(room.floor().vertices_size(), 4);
  EXPECT_EQ(room.walls(0).name(), "south");
  EXPECT_FALSE(Says(room, "shape_unknown") || Says(room, "shape_too_small"));
}

}  // namespace
}  // namespace flair::language
