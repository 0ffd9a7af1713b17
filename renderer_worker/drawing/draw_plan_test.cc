// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/drawing/draw_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "renderer_worker/drawing/layers.h"
#include "renderer_worker/drawing/testdata/read_layout.h"

namespace flair::renderer {
namespace {

using testing::HasSubstr;

v1::RenderOptions Small() {
  v1::RenderOptions options;
  options.set_size_px(400);
  return options;
}

// A 4 m x 3 m room without anything.
v1::SolvedLayout EmptyRoom() {
  v1::SolvedLayout layout;
  v1::Room& room = *layout.mutable_graph()->mutable_room();
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {4.0, 0.0}, {4.0, 3.0}, {0.0, 3.0}}) {
    v1::Point2& vertex = *room.mutable_floor()->add_vertices();
    vertex.set_x_m(x);
    vertex.set_y_m(y);
  }
  for (const char* name : {"south", "east", "north", "west"}) room.add_walls()->set_name(name);
  return layout;
}

void Add(v1::SolvedLayout& layout, const std::string& id, double x, double y, double width = 1, double depth = 1) {
  v1::Object& object = *layout.mutable_graph()->mutable_object_list()->add_objects();
  object.set_id(id);
  object.set_name(id);
  object.set_kind(v1::OBJECT_KIND_FLOOR);
  object.set_width_m(width);
  object.set_depth_m(depth);
  object.set_height_m(1);
  v1::Placement& placement = *layout.add_placements();
  placement.set_object_id(id);
  placement.set_x_m(x);
  placement.set_y_m(y);
}

TEST(DrawPlan, SamplesDrawTheSameTwice) {
  for (const std::string& name : SampleLayouts()) {
    const absl::StatusOr<DrawnPlan> first = DrawPlan(ReadSample(name), Small()),
                                    second = DrawPlan(ReadSample(name), Small());
    ASSERT_TRUE(first.ok()) << name << ": " << first.status();
    ASSERT_TRUE(second.ok());
    EXPECT_EQ(first->pixels.rgb, second->pixels.rgb) << name;
  }
}

TEST(DrawPlan, NoTwoLabelsOfASampleOverlap) {
  for (const std::string& name : SampleLayouts()) {
    const absl::StatusOr<DrawnPlan> plan = DrawPlan(ReadSample(name), Small());
    ASSERT_TRUE(plan.ok());
    EXPECT_GE(plan->labels.size(), static_cast<size_t>(ReadSample(name).placements_size()))
        << name << ": every piece has one";
    for (size_t i = 0; i < plan->labels.size(); ++i) {
      for (size_t j = 0; j < i; ++j) EXPECT_FALSE(plan->labels[i].box_mm.Overlaps(plan->labels[j].box_mm)) << name;
    }
  }
}

TEST(DrawPlan, TheLongerSideIsTheSizeAskedFor) {
  const absl::StatusOr<DrawnPlan> plan = DrawPlan(EmptyRoom(), Small());
  ASSERT_TRUE(plan.ok()) << plan.status();
  EXPECT_EQ(std::max(plan->pixels.width_px, plan->pixels.height_px), 400);
  EXPECT_EQ(plan->pixels.rgb.size(), static_cast<size_t>(plan->pixels.width_px) * plan->pixels.height_px * 3);
}

TEST(DrawPlan, RefusesWhatCannotBeDrawn) {
  EXPECT_EQ(DrawPlan({}, Small()).status().code(), absl::StatusCode::kInvalidArgument);
  v1::SolvedLayout nan = EmptyRoom();
  Add(nan, "bed", std::numeric_limits<double>::quiet_NaN(), 1);
  EXPECT_THAT(std::string(DrawPlan(nan, Small()).status().message()), HasSubstr("objects[0] \"bed\""));
  v1::SolvedLayout flat = EmptyRoom();
  Add(flat, "bed", 1, 1, 0, 1);
  EXPECT_EQ(DrawPlan(flat, Small()).status().code(), absl::StatusCode::kInvalidArgument);
  v1::SolvedLayout no_wall = EmptyRoom();
  no_wall.mutable_graph()->mutable_room()->add_openings()->set_wall("up");
  EXPECT_THAT(std::string(DrawPlan(no_wall, Small()).status().message()), HasSubstr("no wall \"up\""));
  v1::RenderOptions huge;
  huge.set_size_px(100000);
  EXPECT_THAT(std::string(DrawPlan(EmptyRoom(), huge).status().message()), HasSubstr("[256, 8192]"));
}

TEST(DrawPlan, DrawsPiecesOutsideTheRoomTooFarTooLargeAndTooMany) {
  v1::SolvedLayout layout = EmptyRoom();
  Add(layout, "half out", 4, 1.5);
  Add(layout, "far out", 900, -900);
  Add(layout, "huge", 2, 1.5, 20, 20);
  Add(layout, std::string(3000, 'w'), 1, 1, 0.3, 0.3);
  Add(layout, "not \xff utf-8", 1, 2, 0.3, 0.3);
  for (int i = 0; i < 300; ++i)
    Add(layout, "chair " + std::to_string(i), 0.1 + 0.013 * i, 0.5 + 0.2 * (i % 10), 0.4, 0.4);
  EXPECT_TRUE(DrawPlan(layout, Small()).ok());
}

TEST(DrawPlan, ObjectsWithoutAPlacementAreNamed) {
  v1::SolvedLayout layout = EmptyRoom();
  Add(layout, "piano", 1, 1);
  layout.clear_placements();
  const absl::StatusOr<Plan> plan = ReadPlan(layout);
  ASSERT_TRUE(plan.ok());
  EXPECT_THAT(plan->unplaced, testing::ElementsAre("piano"));
}

TEST(Sheet, TakesTheLargestUsualScaleThatFits) {
  const absl::StatusOr<Plan> plan = ReadPlan(EmptyRoom());
  ASSERT_TRUE(plan.ok());
  const Sheet sheet = ChooseSheet(*plan);
  EXPECT_EQ(sheet.scale, 20);
  const Point a = sheet.ToSheet({0, 0}), b = sheet.ToSheet({4, 3});
  EXPECT_DOUBLE_EQ(b.x - a.x, 200);
  EXPECT_DOUBLE_EQ(a.y - b.y, 150);
  EXPECT_TRUE(sheet.plan_mm.Contains({a.x, b.y, b.x, a.y}));
}

TEST(Door, LeafStartsAtItsHingeAndOpensIntoTheRoomOrOut) {
  absl::StatusOr<Plan> plan = ReadPlan(EmptyRoom());
  ASSERT_TRUE(plan.ok());
  PlanOpening door{0, 1.0, 0.9, true, true, v1::DOOR_SWING_INWARD, std::numbers::pi / 2};  // south wall, runs east
  const auto near = [](Point p, double x, double y) { return std::hypot(p.x - x, p.y - y) < 1e-12; };
  DoorLeafGeometry leaf = LeafOf(*plan, door);
  EXPECT_TRUE(near(leaf.hinge_m, 1.0, 0) && near(leaf.open_end_m, 1.0, 0.9) && near(leaf.closed_end_m, 1.9, 0));
  door.hinge_at_start = false;
  leaf = LeafOf(*plan, door);
  EXPECT_TRUE(near(leaf.hinge_m, 1.9, 0) && near(leaf.open_end_m, 1.9, 0.9) && near(leaf.closed_end_m, 1.0, 0));
  door.swing = v1::DOOR_SWING_OUTWARD;
  leaf = LeafOf(*plan, door);
  EXPECT_TRUE(near(leaf.open_end_m, 1.9, -0.9));
  door = {1, 0.5, 0.8, true, true, v1::DOOR_SWING_INWARD, std::numbers::pi / 2};  // east wall, runs north
  leaf = LeafOf(*plan, door);
  EXPECT_TRUE(near(leaf.hinge_m, 4, 0.5) && near(leaf.open_end_m, 3.2, 0.5) && near(leaf.closed_end_m, 4, 1.3));
}

}  // namespace
}  // namespace flair::renderer
