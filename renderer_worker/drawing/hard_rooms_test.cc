// SPDX-License-Identifier: GPL-3.0-or-later
// Rooms that are hard to draw: tiny, huge, irregular, crowded, with names in any script.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "renderer_worker/drawing/draw_plan.h"
#include "renderer_worker/drawing/plan.h"
#include "renderer_worker/drawing/testing/read_drawing.h"

namespace flair::renderer {
namespace {

v1::RenderOptions Small() {
  v1::RenderOptions options;
  options.set_size_px(500);
  return options;
}

v1::SolvedLayout RoomOf(const std::vector<std::pair<double, double>>& corners) {
  v1::SolvedLayout layout;
  v1::Room& room = *layout.mutable_graph()->mutable_room();
  int wall = 0;
  for (const auto& [x, y] : corners) {
    v1::Point2& vertex = *room.mutable_floor()->add_vertices();
    vertex.set_x_m(x);
    vertex.set_y_m(y);
    room.add_walls()->set_name("wall_" + std::to_string(++wall));
  }
  return layout;
}

void Add(v1::SolvedLayout& layout, const std::string& name, double x, double y, double width, double depth) {
  const std::string id = "o" + std::to_string(layout.placements_size());
  v1::Object& object = *layout.mutable_graph()->mutable_object_list()->add_objects();
  object.set_id(id);
  object.set_name(name);
  object.set_kind(v1::OBJECT_KIND_FLOOR);
  object.set_width_m(width);
  object.set_depth_m(depth);
  object.set_height_m(1);
  v1::Placement& placement = *layout.add_placements();
  placement.set_object_id(id);
  placement.set_x_m(x);
  placement.set_y_m(y);
}

void AddOpening(v1::SolvedLayout& layout, const std::string& wall, double offset, double width, v1::DoorSwing swing) {
  v1::Opening& opening = *layout.mutable_graph()->mutable_room()->add_openings();
  opening.set_id("opening_" + std::to_string(layout.graph().room().openings_size()));
  opening.set_kind(swing == v1::DOOR_SWING_UNSPECIFIED ? v1::OPENING_KIND_WINDOW : v1::OPENING_KIND_DOOR);
  opening.set_wall(wall);
  opening.set_offset_m(offset);
  opening.set_width_m(width);
  if (swing != v1::DOOR_SWING_UNSPECIFIED) opening.mutable_leaf()->set_swing(swing);
}

void ExpectNoLabelsOverlap(const DrawnPlan& plan) {
  for (size_t i = 0; i < plan.labels.size(); ++i) {
    for (size_t j = 0; j < i; ++j) ASSERT_FALSE(plan.labels[i].box_mm.Overlaps(plan.labels[j].box_mm));
  }
}

TEST(HardRooms, FloorsOfAnyShapeWithOpeningsInAnyWallAreDrawn) {
  const std::vector<std::vector<std::pair<double, double>>> floors = {
      {{0, 0}, {1.5, 0}, {1.5, 1.5}, {0, 1.5}},                                                         // a cupboard
      {{0, 0}, {30, 0}, {30, 30}, {0, 30}},                                                             // a hall
      {{0, 0}, {20, 0}, {20, 1.2}, {0, 1.2}},                                                           // a corridor
      {{0, 0}, {4, 0}, {2, 3.4}},                                                                       // a triangle
      {{0, 0}, {8, 0}, {8, 2}, {3, 2}, {3, 5}, {8, 5}, {8, 7}, {0, 7}},                                 // a C
      {{2, 0}, {4, 0}, {4, 2}, {6, 2}, {6, 4}, {4, 4}, {4, 6}, {2, 6}, {2, 4}, {0, 4}, {0, 2}, {2, 2}}  // a cross
  };
  for (const auto& floor : floors) {
    v1::SolvedLayout layout = RoomOf(floor);
    for (size_t i = 0; i < floor.size(); ++i) {
      const auto [x0, y0] = floor[i];
      const auto [x1, y1] = floor[(i + 1) % floor.size()];
      const double length = std::hypot(x1 - x0, y1 - y0);
      constexpr v1::DoorSwing kSwings[] = {v1::DOOR_SWING_INWARD, v1::DOOR_SWING_UNSPECIFIED, v1::DOOR_SWING_OUTWARD,
                                           v1::DOOR_SWING_SLIDING, v1::DOOR_SWING_NONE};
      AddOpening(layout, "wall_" + std::to_string(i + 1), 0.2 * length, 0.5 * length, kSwings[i % 5]);
    }
    Add(layout, "chair", floor[0].first + 0.7, 0.6, 0.45, 0.45);
    const absl::StatusOr<DrawnPlan> drawn = DrawPlan(layout, Small());
    ASSERT_TRUE(drawn.ok()) << drawn.status();
    ExpectNoLabelsOverlap(*drawn);
  }
}

TEST(HardRooms, ARoundRoomOfManyWallsIsDrawnWithoutDimensions) {
  std::vector<std::pair<double, double>> circle;
  for (int i = 0; i < 90; ++i) {
    const double angle = 2 * std::numbers::pi * i / 90;
    circle.emplace_back(3 + 3 * std::cos(angle), 3 + 3 * std::sin(angle));
  }
  EXPECT_TRUE(DrawPlan(RoomOf(circle), Small()).ok());
}

TEST(HardRooms, SixtyPiecesAllCarryTheirNumber) {
  v1::SolvedLayout layout = RoomOf({{0, 0}, {6, 0}, {6, 5}, {0, 5}});
  for (int i = 0; i < 60; ++i)
    Add(layout, "chair " + std::to_string(i), 0.4 + 0.56 * (i % 10), 0.4 + 0.8 * (i / 10), 0.4, 0.4);
  for (const v1::PaperSize paper : {v1::PAPER_SIZE_A3, v1::PAPER_SIZE_A4}) {
    v1::RenderOptions options = Small();
    options.set_paper(paper);
    const absl::StatusOr<DrawnPlan> drawn = DrawPlan(layout, options);
    ASSERT_TRUE(drawn.ok()) << drawn.status();
    ExpectNoLabelsOverlap(*drawn);
    EXPECT_GE(drawn->labels.size(), 60u);
  }
}

TEST(HardRooms, FiveThousandPiecesAreDrawnWithAsManyLabelsAsFit) {
  v1::SolvedLayout layout = RoomOf({{0, 0}, {30, 0}, {30, 30}, {0, 30}});
  for (int i = 0; i < 5000; ++i)
    Add(layout, "piece " + std::to_string(i), 0.3 + 0.4 * (i % 72), 0.3 + 0.4 * (i / 72), 0.35, 0.35);
  const absl::StatusOr<DrawnPlan> drawn = DrawPlan(layout, Small());
  ASSERT_TRUE(drawn.ok()) << drawn.status();
  EXPECT_GT(drawn->labels.size(), 50u);
  ExpectNoLabelsOverlap(*drawn);
}

TEST(HardRooms, NamesInAnyScriptAndOfAnyLengthAreDrawn) {
  v1::SolvedLayout layout = RoomOf({{0, 0}, {5, 0}, {5, 4}, {0, 4}});
  const std::vector<std::string> names = {
      "本棚と机",
      "سرير مزدوج كبير",
      "🛏️🪑🧸",
      "Кровать с ящиками",
      "ที่นอน",
      "é\u0301\u0301\u0301 zalgo \u0337\u0338",
      std::string(5000, 'W'),
      "a very long name of many words that goes on and on and on until nobody reads it any more",
      "\xff\xfe broken",
      "tab\tand\nnewline",
      "",
      "   ",
      "<b>&amp;</b>",
      "\u202e reversed",
      std::string("nul\0inside", 10)};
  for (size_t i = 0; i < names.size(); ++i)
    Add(layout, names[i], 0.6 + 0.95 * static_cast<double>(i % 5), 0.6 + 1.2 * static_cast<double>(i / 5), 0.9, 0.9);
  layout.mutable_graph()->mutable_room()->set_title("部屋 " + std::string(400, 'x') + " غرفة");
  const absl::StatusOr<DrawnPlan> drawn = DrawPlan(layout, Small());
  ASSERT_TRUE(drawn.ok()) << drawn.status();
  ExpectNoLabelsOverlap(*drawn);
  EXPECT_GE(drawn->labels.size(), names.size());
  v1::RenderOptions svg;
  svg.set_format(v1::PREVIEW_FORMAT_SVG);
  const absl::StatusOr<std::string> file = DrawPlanDocument(layout, svg, {{"Description", "\x01 \xff < ü"}});
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->find('\x01'), std::string::npos);
  // Nothing is written beyond the paper, however long its name.
  const Document document = ReadSvg(*file);
  for (const PaintedPath& path : document.paths) {
    for (Point point : path) {
      ASSERT_GE(point.x, -1) << path.size();
      ASSERT_LE(point.x, document.page_mm.width + 1);
    }
  }
}

}  // namespace
}  // namespace flair::renderer
