// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/drawing/draw_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "renderer_worker/drawing/layers.h"
#include "renderer_worker/drawing/testing/read_drawing.h"

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

TEST(DrawPlan, ARemarkStandsBelowTheTitleAndMovesNothingOfThePlan) {
  const v1::SolvedLayout layout = ReadSample("l_shaped_studio");
  const DrawnPlan plain = *DrawPlan(layout, Small()), remarked = *DrawPlan(layout, Small(), "Asked: “A studio.”");
  ASSERT_EQ(plain.pixels.rgb.size(), remarked.pixels.rgb.size());
  EXPECT_NE(plain.pixels.rgb, remarked.pixels.rgb);
  // The left half is the room's.
  const size_t row = size_t{3} * plain.pixels.width_px;
  for (size_t at = 0; at < plain.pixels.rgb.size(); at += row) {
    ASSERT_TRUE(std::equal(plain.pixels.rgb.begin() + at, plain.pixels.rgb.begin() + at + row / 2,
                           remarked.pixels.rgb.begin() + at));
  }
}

TEST(DrawPlan, NoTwoLabelsOfASampleOverlap) {
  for (const std::string& name : SampleLayouts()) {
    const absl::StatusOr<DrawnPlan> plan = DrawPlan(ReadSample(name), Small());
    ASSERT_TRUE(plan.ok());
    const absl::StatusOr<Plan> shown = ReadPlan(ReadSample(name));
    std::set<int> keys;
    for (const PlacedLabel& label : plan->labels) {
      if (label.item >= static_cast<int>(shown->objects.size())) continue;
      EXPECT_TRUE(keys.insert(shown->objects[label.item].key).second) << name << ": what looks alike has one label";
    }
    EXPECT_EQ(keys.size(), shown->keys.size()) << name << ": every line of the key is on the plan";
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

TEST(DrawPlan, ObjectsWithoutAPlacementAreNamedButForSpareOnes) {
  v1::SolvedLayout layout = EmptyRoom();
  Add(layout, "piano", 1, 1);
  Add(layout, "basket", 2, 1);
  layout.clear_placements();
  layout.mutable_graph()->mutable_object_list()->mutable_objects(1)->set_spare(true);
  const absl::StatusOr<Plan> plan = ReadPlan(layout);
  ASSERT_TRUE(plan.ok());
  EXPECT_THAT(plan->unplaced, testing::ElementsAre("piano"));
}

TEST(Sheet, TakesTheLargestUsualScaleThatFits) {
  const absl::StatusOr<Plan> plan = ReadPlan(EmptyRoom());
  ASSERT_TRUE(plan.ok());
  const absl::StatusOr<Sheet> chosen = ChooseSheet(*plan);
  ASSERT_TRUE(chosen.ok()) << chosen.status();
  const Sheet& sheet = *chosen;
  EXPECT_EQ(sheet.scale, 20);
  const Point a = sheet.ToSheet({0, 0}), b = sheet.ToSheet({4, 3});
  EXPECT_DOUBLE_EQ(b.x - a.x, 200);
  EXPECT_DOUBLE_EQ(a.y - b.y, 150);
  EXPECT_TRUE(sheet.plan_mm.Contains({a.x, b.y, b.x, a.y}));
}

TEST(Sheet, TakesTheScaleAskedForOrSaysWhichOneWouldFit) {
  const absl::StatusOr<Plan> plan = ReadPlan(EmptyRoom());
  ASSERT_TRUE(plan.ok());
  v1::RenderOptions options;
  options.set_scale_denominator(33);
  ASSERT_TRUE(ChooseSheet(*plan, options).ok());
  EXPECT_EQ(ChooseSheet(*plan, options)->scale, 33);
  options.set_paper(v1::PAPER_SIZE_A4);
  options.set_scale_denominator(12);
  EXPECT_EQ(ChooseSheet(*plan, options).status().code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(ChooseSheet(*plan, options).status().message()), HasSubstr("A4 at 1:12; it does at 1:25"));
  options.set_scale_denominator(4);
  EXPECT_THAT(std::string(ChooseSheet(*plan, options).status().message()), HasSubstr("[5, 1000]"));
}

TEST(Sheet, RoomsFromOneAndAHalfMetresToAHundredFitSomeScale) {
  for (const v1::PaperSize paper : {v1::PAPER_SIZE_A3, v1::PAPER_SIZE_A4}) {
    int before = 0;
    for (const double side : {1.5, 3.0, 6.0, 12.0, 30.0, 100.0}) {
      v1::SolvedLayout layout = EmptyRoom();
      for (v1::Point2& vertex : *layout.mutable_graph()->mutable_room()->mutable_floor()->mutable_vertices()) {
        vertex.set_x_m(vertex.x_m() > 0 ? side : 0);
        vertex.set_y_m(vertex.y_m() > 0 ? side : 0);
      }
      v1::RenderOptions options = Small();
      options.set_paper(paper);
      const absl::StatusOr<DrawnPlan> drawn = DrawPlan(layout, options);
      ASSERT_TRUE(drawn.ok()) << drawn.status();
      EXPECT_GE(drawn->scale, before);
      before = drawn->scale;
    }
    EXPECT_GE(before, 400);
  }
  v1::SolvedLayout huge = EmptyRoom();
  huge.mutable_graph()->mutable_room()->mutable_floor()->mutable_vertices(1)->set_x_m(9000);
  EXPECT_THAT(std::string(DrawPlan(huge, Small()).status().message()), HasSubstr("do not fit A3 even at 1:1000"));
}

TEST(DrawPlan, DotsPerInchGiveThePapersPixelsWithinBounds) {
  v1::RenderOptions options;
  options.set_dpi(100);
  options.set_paper(v1::PAPER_SIZE_A4);
  const absl::StatusOr<DrawnPlan> drawn = DrawPlan(EmptyRoom(), options);
  ASSERT_TRUE(drawn.ok()) << drawn.status();
  EXPECT_EQ(drawn->pixels.width_px, 1169);  // 297 mm
  EXPECT_EQ(drawn->pixels.height_px, 827);
  options.set_paper(v1::PAPER_SIZE_A3);
  options.set_dpi(1200);
  EXPECT_THAT(std::string(DrawPlan(EmptyRoom(), options).status().message()), HasSubstr("options.dpi: 1200"));
  options.set_size_px(800);
  EXPECT_THAT(std::string(DrawPlan(EmptyRoom(), options).status().message()), HasSubstr("not together"));
}

TEST(DrawPlan, WallsOfANotchAreMeasuredBesideTheRoom) {
  const PlanSheet made = *MakePlanSheet(ReadSample("l_shaped_studio"), {});
  Box room;
  for (Point vertex : made.plan.floor) room.Include(made.sheet.ToSheet(vertex));
  std::set<std::string> lengths;
  for (const DimensionString& string : LayOutDimensions(made.plan, made.sheet)) {
    for (Point tick : string.ticks_mm) {
      EXPECT_TRUE(tick.x < room.x0 || tick.x > room.x1 || tick.y < room.y0 || tick.y > room.y1) << string.texts[0];
    }
    if (string.texts.size() == 1) lengths.insert(string.texts[0]);
  }
  EXPECT_THAT(lengths, testing::IsSupersetOf({"6.40", "3.20", "2.80", "2.40", "3.60", "5.60"}));
}

TEST(DrawPlan, LayersThatAreLeftOutAreNotDrawnNorInTheKey) {
  v1::SolvedLayout layout = EmptyRoom();
  Add(layout, "bed", 1, 1);
  Add(layout, "rug", 2, 1);
  layout.mutable_graph()->mutable_object_list()->mutable_objects(1)->set_walk_over(true);
  const auto names = [&layout](const PlanLayers& layers) {
    std::vector<std::string> drawn;
    const absl::StatusOr<Plan> plan = ReadPlan(layout, layers);
    for (const PlanKey& key : plan->keys) drawn.push_back(key.name);
    return drawn;
  };
  EXPECT_THAT(names({}), testing::ElementsAre("bed", "rug"));
  EXPECT_THAT(names({.tertiary = false}), testing::ElementsAre("bed"));
  EXPECT_THAT(names({.floor_pieces = false}), testing::ElementsAre("rug"));
  v1::RenderOptions options = Small();
  options.add_layers(v1::PLAN_LAYER_UNSPECIFIED);
  EXPECT_THAT(std::string(DrawPlan(layout, options).status().message()), HasSubstr("options.layers[0]"));
}

TEST(DrawPlanTile, FillsItsBoxWithTheRoomWhateverItsShape) {
  for (const std::string& name : SampleLayouts()) {
    for (const auto& [width, height] : {std::pair{480, 480}, {300, 120}, {64, 200}, {64, 64}}) {
      const absl::StatusOr<Pixels> tile = DrawPlanTile(ReadSample(name), width, height);
      ASSERT_TRUE(tile.ok()) << tile.status();
      ASSERT_EQ(tile->rgb.size(), static_cast<size_t>(width) * height * 3);
      // Something in the middle, nothing but paper in the corners.
      const auto at = [&tile](int x, int y) {
        return tile->rgb[(static_cast<size_t>(y) * tile->width_px + x) * 3 + 2];
      };
      EXPECT_EQ(at(0, 0), 255) << name;
      EXPECT_EQ(at(width - 1, height - 1), 255) << name;
      EXPECT_NE(at(width / 2, height / 2), 255) << name;
    }
  }
  EXPECT_TRUE(DrawPlanTile(EmptyRoom(), 16, 16).ok());
  EXPECT_EQ(DrawPlanTile(EmptyRoom(), 5000, 100).status().code(), absl::StatusCode::kInvalidArgument);
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
