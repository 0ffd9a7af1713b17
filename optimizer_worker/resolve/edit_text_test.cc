// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "optimizer_worker/resolve/resolve_layout.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {
namespace {

v1::SolvedLayout SmallLayout() {
  v1::SolvedLayout layout;
  v1::Object* sofa = layout.mutable_graph()->mutable_object_list()->add_objects();
  sofa->set_id("sofa");
  sofa->set_zone_id("sitting");
  layout.mutable_graph()->mutable_zone_plan()->add_zones()->set_id("eating");
  layout.mutable_graph()->mutable_zone_plan()->add_zones()->set_id("sitting");
  v1::Placement* placement = layout.add_placements();
  placement->set_object_id("sofa");
  placement->set_theta_rad(1.25);
  return layout;
}

v1::LayoutEdit Read(const char* line) {
  absl::StatusOr<v1::LayoutEdit> edit = EditFromText(line, SmallLayout());
  EXPECT_TRUE(edit.ok()) << edit.status();
  return edit.ok() ? *std::move(edit) : v1::LayoutEdit();
}

TEST(EditFromText, AMoveKeepsTheHeadingThatItDoesNotName) {
  EXPECT_EQ(Read("move sofa 1.2 0.5").move_object().theta_rad(), 1.25);
  const v1::LayoutEdit turned = Read("move sofa 1.2 0.5 -90");
  EXPECT_EQ(turned.move_object().x_m(), 1.2);
  EXPECT_EQ(turned.move_object().y_m(), 0.5);
  EXPECT_NEAR(turned.move_object().theta_rad(), 1.5 * kPi, 1e-12);
}

TEST(EditFromText, ReadsEveryVerb) {
  EXPECT_EQ(Read("pin bed").pin_object_id(), "bed");
  EXPECT_EQ(Read("unpin bed").unpin_object_id(), "bed");
  EXPECT_EQ(Read("remove plant_1").remove_object_id(), "plant_1");
  EXPECT_EQ(Read("drop e17").remove_edge_id(), "e17");
  EXPECT_EQ(Read("weight e17 3").set_edge_weight().weight(), 3);
  const v1::LayoutEdit flat = Read("resize wardrobe 1.5x0.6");
  EXPECT_EQ(flat.resize_object().depth_m(), 0.6);
  EXPECT_FALSE(flat.resize_object().has_height_m());
  EXPECT_EQ(Read("resize wardrobe 1.5x0.6x2.1").resize_object().height_m(), 2.1);
}

TEST(EditFromText, AnAddedObjectJoinsTheZoneOfWhatItIsNear) {
  const v1::AddObject add = Read("add lamp 0.4x0.3x1.5 near sofa").add_object();
  EXPECT_EQ(add.object().zone_id(), "sitting");
  EXPECT_EQ(add.object().height_m(), 1.5);
  ASSERT_EQ(add.edges_size(), 1);
  EXPECT_EQ(add.edges(0).type(), "near");
  EXPECT_TRUE(add.edges(0).id().empty());
  EXPECT_EQ(Read("add lamp 0.4x0.3x1.5").add_object().object().zone_id(), "eating");
}

TEST(EditFromText, AnEdgeHasTypedArguments) {
  const v1::ConstraintEdge edge = Read("edge near object=desk target=bed max_distance_m=0.5 weight=2").add_edge();
  EXPECT_EQ(edge.type(), "near");
  EXPECT_EQ(edge.weight(), 2);
  EXPECT_EQ(edge.arguments_size(), 3);
}

TEST(EditFromText, SaysWhatTheLineShouldLookLike) {
  for (const char* line : {"", "shove desk", "move desk", "move desk a b", "move desk 1 nan", "pin", "pin a b",
                           "resize bed 1.5", "resize bed 1x2x3x4", "add lamp 0.4x0.4", "add lamp 1x1x1 by bed",
                           "weight e1", "weight e1 heavy", "edge near"}) {
    const absl::Status status = EditFromText(line, SmallLayout()).status();
    EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument) << line;
    EXPECT_NE(status.message().find("should"), absl::string_view::npos) << status;
  }
}

}  // namespace
}  // namespace flair::optimizer
