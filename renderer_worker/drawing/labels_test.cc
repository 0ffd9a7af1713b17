// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/drawing/labels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace flair::renderer {
namespace {

const std::vector<Point> kFloor = {{0, 0}, {200, 0}, {200, 150}, {0, 150}};

LabelItem Piece(Point centre, double half_width, double half_depth, double theta = 0) {
  LabelItem item;
  item.centre_mm = centre;
  item.half_width_mm = half_width;
  item.half_depth_mm = half_depth;
  item.theta_rad = theta;
  item.badge_mm = {4.5, 4.5};
  item.forms_mm = {{22, 4.5}, {14, 8}};
  return item;
}

// A room with `count` pieces anywhere, of any size and turn, many on top of each other.
std::vector<LabelItem> RandomPieces(int count, uint32_t seed) {
  std::mt19937 random(seed);
  const auto upto = [&random](double most) { return most * (random() / 4294967296.0); };
  std::vector<LabelItem> items;
  for (int i = 0; i < count; ++i) {
    items.push_back(Piece({upto(200), upto(150)}, 1 + upto(25), 1 + upto(20), upto(6.28)));
    items.back().ellipse = random() % 4 == 0;
  }
  return items;
}

TEST(Labels, NeverOverlapAndNeverLeaveTheFloor) {
  for (uint32_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const std::vector<LabelItem> items = RandomPieces(1 + static_cast<int>(seed) * 4, seed);
    const std::vector<PlacedLabel> placed = PlaceLabels(items, {}, kFloor);
    for (size_t i = 0; i < placed.size(); ++i) {
      EXPECT_TRUE((Box{0, 0, 200, 150}.Contains(placed[i].box_mm)));
      for (size_t j = 0; j < i; ++j) EXPECT_FALSE(placed[i].box_mm.Overlaps(placed[j].box_mm));
    }
  }
}

TEST(Labels, NobodyHasTwo) {
  const std::vector<PlacedLabel> placed = PlaceLabels(RandomPieces(60, 7), {}, kFloor);
  std::vector<int> count(60, 0);
  for (const PlacedLabel& label : placed) ++count[label.item];
  EXPECT_THAT(count, testing::Each(testing::Le(1)));
}

TEST(Labels, AGroupHasOneWhereItFitsBest) {
  std::vector<LabelItem> items = {Piece({40, 40}, 6, 6), Piece({100, 75}, 6, 6), Piece({150, 75}, 30, 20)};
  for (LabelItem& item : items) item.group = 4;
  const std::vector<PlacedLabel> placed = PlaceLabels(items, {}, kFloor);
  ASSERT_EQ(placed.size(), 1u);
  EXPECT_EQ(placed[0].item, 2);
  EXPECT_EQ(placed[0].form, 0);
}

TEST(Labels, ANameStandsBesideItsPieceButNotOverOthers) {
  LabelItem lamp = Piece({100, 75}, 2, 2);
  lamp.named_beside = true;
  const std::vector<PlacedLabel> free = PlaceLabels({lamp}, {}, kFloor);
  ASSERT_EQ(free.size(), 1u);
  EXPECT_EQ(free[0].form, 0);
  EXPECT_TRUE(free[0].leader);
  const std::vector<PlacedLabel> crowded = PlaceLabels({lamp}, {{{0, 0, 200, 150}, 1, -1}}, kFloor);
  ASSERT_EQ(crowded.size(), 1u);
  EXPECT_EQ(crowded[0].form, kBadgeForm);
}

TEST(Labels, SixtyPiecesInOneRoomAllGetOne) { EXPECT_EQ(PlaceLabels(RandomPieces(60, 3), {}, kFloor).size(), 60u); }

TEST(Labels, ANameThatFitsStandsInsideItsPiece) {
  const std::vector<PlacedLabel> placed = PlaceLabels({Piece({100, 75}, 30, 20)}, {}, kFloor);
  ASSERT_EQ(placed.size(), 1u);
  EXPECT_EQ(placed[0].form, 0);
  EXPECT_FALSE(placed[0].leader);
  EXPECT_TRUE((Box{70, 55, 130, 95}.Contains(placed[0].box_mm)));
}

TEST(Labels, ATinyPieceGetsItsNumberBesideItWithALeader) {
  const std::vector<PlacedLabel> placed = PlaceLabels({Piece({100, 75}, 1, 1)}, {}, kFloor);
  ASSERT_EQ(placed.size(), 1u);
  EXPECT_EQ(placed[0].form, kBadgeForm);
  EXPECT_TRUE(placed[0].leader);
  EXPECT_FALSE((placed[0].box_mm.Overlaps({99, 74, 101, 76})));
}

TEST(Labels, NoPlaceMeansNoLabel) {
  const std::vector<Point> closet = {{0, 0}, {3, 0}, {3, 3}, {0, 3}};
  EXPECT_TRUE(PlaceLabels({Piece({1.5, 1.5}, 1, 1)}, {}, closet).empty());
  EXPECT_TRUE(PlaceLabels({}, {}, closet).empty());
}

}  // namespace
}  // namespace flair::renderer
