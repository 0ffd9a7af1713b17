// SPDX-License-Identifier: GPL-3.0-or-later
// Doors and windows stand where a brief wants them, or the room says that they do not.
#include "language_worker/handbook/rooms/openings.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "language_worker/handbook/rooms/describe_room.h"
#include "language_worker/handbook/rooms/walls.h"
#include "language_worker/handbook/testing/test_handbook.h"
#include "room/validation/validate.h"

namespace flair::language {
namespace {

class AskedOpeningsTest : public testing::Test {
 protected:
  // "door south, window east, window east", in the order of the walls' names.
  static std::string WallsOf(const v1::Room& room) {
    std::vector<std::string> all;
    for (const v1::Opening& one : room.openings()) {
      all.push_back((one.kind() == v1::OPENING_KIND_DOOR ? "door " : "window ") + one.wall());
    }
    std::ranges::sort(all);
    return fmt::format("{}", fmt::join(all, ", "));
  }

  static int Remarks(const v1::Room& room) {
    return static_cast<int>(std::ranges::count_if(
        room.diagnostics(), [](const v1::Diagnostic& one) { return one.code().starts_with("opening_"); }));
  }

  static void ExpectSound(const v1::Room& room, const std::string& text) {
    EXPECT_TRUE(Validate(room).ok()) << text << Validate(room);
    for (const v1::Opening& a : room.openings()) {
      for (const v1::Opening& b : room.openings()) {
        if (&a == &b || a.wall() != b.wall()) continue;
        EXPECT_TRUE(a.offset_m() + a.width_m() <= b.offset_m() || b.offset_m() + b.width_m() <= a.offset_m())
            << text << ": " << a.id() << " and " << b.id() << " overlap";
      }
    }
  }
};

TEST_F(AskedOpeningsTest, LeftAndRightAreThoseOfTheDrawing) {
  for (int seed = 0; seed < 5; ++seed) {
    EXPECT_EQ(WallsOf(RoomOf("A study 4x4 with one window on the left wall.", seed)), "door south, window west");
    const v1::Room room =
        RoomOf("A bookshop, 9 m deep and 6 m wide, with the entrance and a display window at the front.", seed);
    EXPECT_EQ(WallsOf(room), "door south, window south");
    // A screen at the far wall: the windows are in others.
    const v1::Room hall = RoomOf("A lecture room with chairs facing a whiteboard.", seed);
    EXPECT_EQ(WallsOf(hall).find("window north"), std::string::npos) << WallsOf(hall);
  }
}

TEST_F(AskedOpeningsTest, LeaveAnEndOfAMeetingRoomToItsScreen) {
  for (int seed = 0; seed < 5; ++seed) {
    const std::string walls = WallsOf(RoomOf("A meeting room of 7 m x 4 m.", seed));
    EXPECT_NE(walls.find("window"), std::string::npos) << walls;
    EXPECT_EQ(walls.find("window east"), std::string::npos) << walls;
    EXPECT_EQ(walls.find("window west"), std::string::npos) << walls;
  }
}

TEST_F(AskedOpeningsTest, StandInTheWallsThatAreNamed) {
  const struct {
    const char* text;
    const char* walls;
  } kCases[] = {
      {"A living room 5 m x 4 m. The door is on the south wall and there are two windows on the east wall.",
       "door south, window east, window east"},
      {"A bedroom 4x5 m, door in the middle of the west wall, one large window on the north wall.",
       "door west, window north"},
      {"A study 3x3 m, door south. It has no windows.", "door south"},
      {"A living room 5x4, windows on the north and east walls, door on the west.",
       "door west, window east, window north"},
      {"A bedroom 4x4 with the door on the east wall and a window opposite the door.", "door east, window west"},
      {"A 4x4 bedroom, door on the south wall. As you enter the window is on the left.", "door south, window west"},
      {"A 6x4 room with a door in the east wall and a desk under the window on the north wall.",
       "door east, window north"},
      {"A kitchen 4x3, the kitchen door is on the east wall, a back door to the garden on the west wall, a window on "
       "the "
       "south wall.",
       "door east, door west, window south"},
      {"An office 6x5 with two doors, one on the north wall and one on the south wall, and a window on the east wall.",
       "door north, door south, window east"},
  };
  for (const auto& [text, walls] : kCases) {
    for (int seed = 0; seed < 5; ++seed) {
      const v1::Room room = RoomOf(text, seed);
      EXPECT_EQ(WallsOf(room), walls) << text << " seed " << seed;
      EXPECT_EQ(Remarks(room), 0) << text;
      ExpectSound(room, text);
    }
  }
}

TEST_F(AskedOpeningsTest, StandWhereAlongTheWallTheyAreWanted) {
  const auto door = [](const std::string& text) { return RoomOf(text).openings(0); };
  EXPECT_DOUBLE_EQ(door("A bedroom 4x5 m, a 1 m wide door in the middle of the west wall.").offset_m(), 2);
  EXPECT_DOUBLE_EQ(door("A bedroom 4x5 m, a 90 cm door on the south wall, 50 cm from the west wall.").offset_m(), 0.5);
  // As on the plan: walls run counter-clockwise.
  EXPECT_LT(door("A bedroom 4x5 m, door at the left end of the south wall.").offset_m(), 0.5);
  EXPECT_GT(door("A bedroom 4x5 m, door at the left end of the north wall.").offset_m(), 2.5);
  EXPECT_GT(door("A bedroom 4x5 m, door in the south-east corner.").offset_m(), 2.5);
}

TEST_F(AskedOpeningsTest, AreOfTheKindAndSizeThatIsAsked) {
  const v1::Room tall = RoomOf("A bedroom 4x5 m with floor-to-ceiling windows on the south wall.");
  EXPECT_EQ(tall.openings(1).sill_height_m(), 0);
  EXPECT_EQ(tall.openings(1).head_height_m(), tall.height_m());
  EXPECT_DOUBLE_EQ(RoomOf("A study 4x3 with a 1.4 m wide window on the north wall.").openings(1).width_m(), 1.4);
  EXPECT_EQ(RoomOf("A study 4x3 with a sliding door.").openings(0).leaf().swing(), v1::DOOR_SWING_SLIDING);
  EXPECT_EQ(RoomOf("A study 4x3 with no door.").openings(0).leaf().swing(), v1::DOOR_SWING_NONE);
  // The size of a window is none of the room's.
  EXPECT_EQ(RoomOf("A study with a 1.2 m wide window.").floor().vertices(1).x_m(),
            RoomOf("A study with a window.").floor().vertices(1).x_m());
  // One comes in by another door than that to the garden.
  const v1::Room garden = RoomOf("A living room 7x5 with garden doors on the south wall.");
  EXPECT_NE(garden.openings(0).wall(), "south");
  EXPECT_EQ(garden.openings(1).wall(), "south");
}

TEST_F(AskedOpeningsTest, SayInOneRemarkWhatDoesNotFit) {
  for (const char* text :
       {"A 4x4 bedroom with two 3 m windows on the north wall.", "A 2x2 m study with ten windows on the north wall.",
        "A bedroom with a skylight.", "A living room with a bay window on the south wall.",
        "A bedroom 4x4. The door is on the south wall. The door is on the north wall.",
        "A living room with a window behind the sofa.", "A windowless bedroom with a window on the east wall."}) {
    for (int seed = 0; seed < 5; ++seed) {
      const v1::Room room = RoomOf(text, seed);
      EXPECT_EQ(Remarks(room), 1) << text << " seed " << seed;
      ExpectSound(room, text);
    }
  }
}

TEST_F(AskedOpeningsTest, NeverOverlapWhateverIsAsked) {
  for (const char* what :
       {"seven windows and two doors", "windows on all four walls", "french windows to the garden and two windows",
        "a door and two windows on the same wall", "a window either side of the door", "12 windows",
        "double doors in the middle of the north wall and a large window in the middle of the north wall",
        "a garage door, a side door and a window on the short wall",
        "a wall of windows on the south and a south door"}) {
    for (const char* room : {"A 2x2 m room with ", "A room 4x6 with ", "An L-shaped living room of 30 m2 with "}) {
      for (int seed = 0; seed < 4; ++seed) {
        const std::string text = std::string(room) + what + ".";
        ExpectSound(RoomOf(text, seed), text);
      }
    }
  }
}

}  // namespace
}  // namespace flair::language
