// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/conversion/conversion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "room/geometry/pose.h"
#include "room/text_format/scene_text.h"

namespace flair {
namespace {

using ::testing::HasSubstr;

SceneText Bedroom() {
  absl::StatusOr<SceneText> text = ParseScene(
      "4x5 room; door south 0.5 0.9 hinge_end; window north 1 1.5 sill 0.9 head 2.1; socket east 2; "
      "bed 1.6x2 at 1,1,90; lamp 0.2x0.2 at 1,1,0 surface tertiary on bed height 0.4");
  EXPECT_TRUE(text.ok()) << text.status();
  return text.ok() ? *text : SceneText();
}

TEST(RoomConversion, ThereAndBackIsTheSame) {
  const v1::Room message = [] {
    v1::Room room = RoomToProto(Bedroom().scene.room);
    room.set_room_type("bedroom");
    return room;
  }();
  const absl::StatusOr<Room> room = RoomFromProto(message);
  ASSERT_TRUE(room.ok()) << room.status();
  v1::Room again = RoomToProto(*room);
  again.set_room_type("bedroom");
  EXPECT_EQ(again.SerializeAsString(), message.SerializeAsString());
  EXPECT_EQ(room->openings[0].leaf->hinge, HingeSide::kEnd);
  EXPECT_EQ(room->walls[static_cast<size_t>(room->openings[1].wall)].name, "north");
}

TEST(RoomConversion, RefusesABadRoomWithItsField) {
  v1::Room message = RoomToProto(Bedroom().scene.room);
  message.set_room_type("bedroom");
  message.mutable_openings(0)->set_wall("nort");
  EXPECT_THAT(std::string(RoomFromProto(message).status().message()), HasSubstr("room.openings[0].wall"));
}

TEST(SceneConversion, PlacementsKeepPosesAndPutThingsOnTheirHosts) {
  const SceneText bedroom = Bedroom();
  Layout layout = bedroom.layout;
  layout[0].theta_rad = -kPi / 2;
  const PlacementList placements = PlacementsFromPoses(bedroom.scene, layout);
  ASSERT_EQ(placements.size(), 2);
  EXPECT_NEAR(placements[0].theta_rad(), 1.5 * kPi, 1e-12) << "headings are in [0, 2 pi)";
  EXPECT_EQ(placements[1].z_m(), bedroom.scene.objects[0].height_m);
  const absl::StatusOr<PartialLayout> poses = PosesFromPlacements(bedroom.scene, placements);
  ASSERT_TRUE(poses.ok()) << poses.status();
  EXPECT_EQ(poses->layout[1], layout[1]);
  EXPECT_TRUE(poses->placed[0] && poses->placed[1]);
}

TEST(SceneConversion, AGraphOfASceneIsTheSceneAgain) {
  const absl::StatusOr<SceneText> text = ParseScene(
      "4x5 room; door south 0.5 0.9; zone sleeping; bed 1.6x2 at 1,1,90 primary zone sleeping height 0.5; "
      "rug 2x1 at 1,1,0 rug tertiary height 0.01; lamp 0.2x0.3 at 1,1,0 surface tertiary on bed height 0.4; "
      "art 0.6x0.04 at 2,0.02,0 wall tertiary height 0.5 elevation 1.2");
  ASSERT_TRUE(text.ok()) << text.status();
  v1::LayoutGraph graph = GraphFromScene(text->scene);
  graph.mutable_room()->set_room_type("bedroom");
  const absl::StatusOr<Scene> again = SceneFromProto(graph);
  ASSERT_TRUE(again.ok()) << again.status();
  v1::LayoutGraph second = GraphFromScene(*again);
  second.mutable_room()->set_room_type("bedroom");
  EXPECT_EQ(second.DebugString(), graph.DebugString());
  EXPECT_EQ(again->objects[2].host, 0);
  EXPECT_EQ(again->objects[0].zone, 0);
}

TEST(SceneConversion, WhatIsNotPlacedStaysSo) {
  const SceneText bedroom = Bedroom();
  const PlacementList placements = PlacementsFromPoses(bedroom.scene, bedroom.layout, {false, true});
  const absl::StatusOr<PartialLayout> poses = PosesFromPlacements(bedroom.scene, placements);
  ASSERT_TRUE(poses.ok());
  EXPECT_FALSE(poses->placed[0]);
  EXPECT_TRUE(poses->placed[1]);
}

TEST(SceneConversion, RefusesUnknownAndRepeatedObjects) {
  const SceneText bedroom = Bedroom();
  PlacementList placements = PlacementsFromPoses(bedroom.scene, bedroom.layout);
  placements[1].set_object_id("bed");
  EXPECT_THAT(std::string(PosesFromPlacements(bedroom.scene, placements).status().message()),
              HasSubstr("placements[1].object_id: \"bed\" is placed twice"));
  placements[1].set_object_id("sofa");
  EXPECT_THAT(std::string(PosesFromPlacements(bedroom.scene, placements).status().message()),
              HasSubstr("placements[1].object_id: \"sofa\" is not an object here"));
}

}  // namespace
}  // namespace flair
