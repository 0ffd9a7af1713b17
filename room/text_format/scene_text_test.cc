// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/text_format/scene_text.h"

#include <gtest/gtest.h>

#include "room/geometry/pose.h"

namespace flair {
namespace {

TEST(SceneText, ReadsEveryKindOfItem) {
  const auto read = ParseScene(
      "4x3 room; door south 0.5 0.9 hinge_end outward; window east 1 1.2 sill 0.4 head 2; socket north 2 height 0.5;"
      "zone sleeping at 1,1; bed 1.6x2 at 2,1,90 zone sleeping primary height 0.5; rug 2x1 at 1,1,0 rug tertiary;"
      "lamp 0.2x0.2 at 2,1,0 surface on bed elevation 0.1; art 0.5x0.02 at 1,0.01,0 wall; bulb 0.3x0.3 at 2,1,0 "
      "ceiling");
  ASSERT_TRUE(read.ok()) << read.status();
  const Scene& scene = read->scene;
  ASSERT_EQ(scene.room.openings.size(), 2u);
  EXPECT_EQ(scene.room.openings[0].leaf->hinge, HingeSide::kEnd);
  EXPECT_EQ(scene.room.openings[0].leaf->swing, DoorSwing::kOutward);
  EXPECT_EQ(scene.room.openings[1].sill_height_m, 0.4);
  EXPECT_EQ(scene.room.sockets[0].height_m, 0.5);
  EXPECT_EQ(scene.objects[0].zone, 0);
  EXPECT_EQ(scene.objects[0].role, ObjectRole::kPrimary);
  EXPECT_TRUE(scene.objects[1].walk_over);
  EXPECT_EQ(scene.objects[2].host, 0);
  EXPECT_EQ(scene.BottomOf(2), 0.6);
  EXPECT_EQ(scene.objects[3].kind, ObjectKind::kWall);
  EXPECT_EQ(scene.objects[4].kind, ObjectKind::kCeiling);
  EXPECT_NEAR(read->layout[0].theta_rad, kPi / 2, 1e-15);
}

TEST(SceneText, NamesTheItemThatCannotBeRead) {
  for (const char* text : {"", "desk 1x1 at 0,0,0", "4x3 room; desk 1x at 0,0,0", "4x3 room; door up 0 1", "0x3 room",
                           "room 0,0 1,1 1,0", "4x3 room; desk 1x1 at 0,0,0 quickly", "4x3 room; socket south"}) {
    const auto read = ParseScene(text);
    EXPECT_EQ(read.status().code(), absl::StatusCode::kInvalidArgument) << text;
  }
}

}  // namespace
}  // namespace flair
