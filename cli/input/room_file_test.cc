// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>
#include <unistd.h>

#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include "cli/input/artifact_file.h"
#include "fmt/format.h"
#include "room/validation/validate.h"

namespace flair::cli {
namespace {

using ::testing::ElementsAre;

v1::Room Completed(const std::string& text) {
  v1::Room room;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &room)) << text;
  CompleteRoom(room);
  return room;
}

std::vector<std::string> WallNames(const v1::Room& room) {
  std::vector<std::string> names;
  for (const v1::Wall& wall : room.walls()) names.push_back(wall.name());
  return names;
}

constexpr char kRectangle[] =
    "room_type: 'bedroom' floor { vertices { x_m: 0 y_m: 0 } vertices { x_m: 4 y_m: 0 } vertices { x_m: 4 y_m: 3 } "
    "vertices { x_m: 0 y_m: 3 } } openings { kind: OPENING_KIND_DOOR wall: 'east' offset_m: 0.2 width_m: 0.9 }";

// The same floor from another corner, clockwise and elsewhere: east runs from (9, 8) down to (9, 5).
constexpr char kClockwise[] =
    "room_type: 'bedroom' floor { vertices { x_m: 5 y_m: 8 } vertices { x_m: 9 y_m: 8 } vertices { x_m: 9 y_m: 5 } "
    "vertices { x_m: 5 y_m: 5 } } openings { kind: OPENING_KIND_DOOR wall: 'east' offset_m: 1.9 width_m: 0.9 "
    "leaf { hinge: HINGE_SIDE_END } } sockets { id: 's' wall: 'north' offset_m: 1 height_m: 0.3 }";

TEST(CompleteRoom, FillsInWhatAHandWrittenRectangleLeavesOut) {
  const v1::Room room = Completed(kRectangle);
  EXPECT_THAT(WallNames(room), ElementsAre("south", "east", "north", "west"));
  EXPECT_EQ(room.height_m(), 3);
  EXPECT_EQ(room.openings(0).id(), "door_1");
  EXPECT_EQ(room.openings(0).head_height_m(), 2.05);
  EXPECT_EQ(room.openings(0).leaf().swing(), v1::DOOR_SWING_INWARD);
  EXPECT_EQ(room.openings(0).leaf().hinge(), v1::HINGE_SIDE_START);
  EXPECT_EQ(room.openings(0).leaf().swing_angle_rad(), std::numbers::pi / 2);
  EXPECT_TRUE(FindProblems(room).empty());
}

TEST(CompleteRoom, TurnsAClockwiseFloorRoundWithAllThatIsInItsWalls) {
  const v1::Room room = Completed(kClockwise);
  EXPECT_TRUE(FindProblems(room).empty());
  // (0, 3), (0, 0), (4, 0), (4, 3): west, south, east, north.
  EXPECT_THAT(WallNames(room), ElementsAre("west", "south", "east", "north"));
  EXPECT_EQ(room.floor().vertices(0).x_m(), 0);
  EXPECT_EQ(room.floor().vertices(0).y_m(), 3);
  EXPECT_EQ(room.floor().vertices(1).y_m(), 0);
  EXPECT_NEAR(room.openings(0).offset_m(), 0.2, 1e-12);
  EXPECT_EQ(room.openings(0).leaf().hinge(), v1::HINGE_SIDE_START);
  EXPECT_EQ(room.sockets(0).offset_m(), 3) << "a metre from the west end, which is the end now";
}

TEST(CompleteRoom, NumbersTheWallsOfOtherFloorsInTheOrderOfTheirCorners) {
  const v1::Room room = Completed(
      "room_type: 'kitchen' floor { vertices { x_m: 0 y_m: 0 } vertices { x_m: 0 y_m: 4 } vertices { x_m: 2 y_m: 4 } "
      "vertices { x_m: 2 y_m: 2 } vertices { x_m: 5 y_m: 2 } vertices { x_m: 5 y_m: 0 } }");
  EXPECT_TRUE(FindProblems(room).empty());
  EXPECT_THAT(WallNames(room), ElementsAre("wall_6", "wall_5", "wall_4", "wall_3", "wall_2", "wall_1"));
}

TEST(CompleteRoom, LeavesACompleteRoomAndFaultsAsTheyAre) {
  const v1::Room room = Completed(kRectangle);
  v1::Room again = room;
  CompleteRoom(again);
  EXPECT_EQ(again.SerializeAsString(), room.SerializeAsString());
  EXPECT_FALSE(FindProblems(Completed("room_type: 'x' floor { vertices { x_m: 1 } vertices { y_m: 1 } }")).empty());
  EXPECT_FALSE(
      FindProblems(Completed("floor { vertices { x_m: nan } vertices { x_m: 1 } vertices { y_m: 1 } }")).empty());
}

// The page for users shows rooms that work.
TEST(ReadRoom, ReadsEveryExampleOfThePage) {
  std::ifstream file(FLAIR_SOURCE_DIR "/docs/rooms.md");
  std::string ending, text;
  int count = 0;
  for (std::string line; std::getline(file, line);) {
    if (line == "```json" || line == "```textproto") {
      ending = line.substr(3);
      text.clear();
    } else if (line == "```" && !ending.empty()) {
      const std::string path = fmt::format("{}/page_{}_{}.{}", ::testing::TempDir(), getpid(), ++count, ending);
      std::ofstream(path) << text;
      const absl::StatusOr<v1::Room> room = ReadRoom(path);
      EXPECT_TRUE(room.ok()) << room.status();
      ending.clear();
    } else {
      text += line + "\n";
    }
  }
  EXPECT_EQ(count, 3);
}

}  // namespace
}  // namespace flair::cli
