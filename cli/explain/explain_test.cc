// SPDX-License-Identifier: GPL-3.0-or-later
// The words: calls, places.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/explain/call_words.h"
#include "cli/explain/standing.h"
#include "optimizer_worker/constraints/call_text.h"
#include "optimizer_worker/constraints/facts.h"
#include "room/text_format/scene_text.h"

namespace flair::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

std::string Placed(const std::string& text, const std::string& object) {
  const absl::StatusOr<SceneText> scene = ParseScene(text);
  EXPECT_TRUE(scene.ok()) << scene.status();
  if (!scene.ok()) return "";
  const PartialLayout where = {scene->layout, std::vector<bool>(scene->scene.objects.size(), true)};
  return Standing(scene->scene, where, scene->scene.IndexOf(object));
}

TEST(CallInWords, EveryTypeOfCallHasWords) {
  for (const optimizer::ConstraintFacts& facts : optimizer::AllConstraints()) {
    if (facts.type.built_in()) continue;
    for (const optimizer::LayoutExample& example : facts.layouts) {
      const absl::StatusOr<SceneText> scene = ParseScene(example.scene);
      ASSERT_TRUE(scene.ok()) << scene.status();
      const v1::ConstraintEdge edge = optimizer::EdgeFromText(facts.name(), example.call);
      const std::string words = CallInWords(edge, scene->scene);
      EXPECT_THAT(words, Not(StartsWith("meets "))) << facts.name();
      EXPECT_THAT(words, Not(HasSubstr("_m"))) << words;
      EXPECT_THAT(words, Not(HasSubstr("{"))) << words;
      EXPECT_FALSE(SubjectsOf(edge, scene->scene).empty()) << facts.name();
    }
  }
}

TEST(CallInWords, FillsInValuesAndDefaults) {
  const absl::StatusOr<SceneText> scene = ParseScene("6x4 room; desk 1x1 at 1,1,0; bed 1x2 at 4,2,0");
  ASSERT_TRUE(scene.ok());
  const auto words = [&](const char* type, const char* call) {
    return CallInWords(optimizer::EdgeFromText(type, call), scene->scene);
  };
  EXPECT_EQ(words("away_from", "object=desk target=bed min_distance_m=0.5"), "keeps at least 0.50 m from the bed");
  EXPECT_EQ(words("against_wall", "object=bed"), "has its back flush on a wall");
  EXPECT_EQ(words("against_wall", "object=bed side=left wall=north"), "has its left flush on the north wall");
  EXPECT_EQ(words("against_wall", "object=nobody"), "meets against_wall");
  EXPECT_EQ(words("levitate", "object=bed"), "meets levitate");
}

TEST(Standing, NamesWallsCornersAndNeighbours) {
  EXPECT_EQ(Placed("6x4 room; bed 1.6x2 at 2,1,0", "bed"),
            "stands with its back to the south wall, 1.20 m from its west end");
  EXPECT_EQ(Placed("6x4 room; bed 1.6x2 at 0.8,1,0", "bed"),
            "stands in the south-west corner, its back to the south wall");
  EXPECT_EQ(Placed("6x4 room; bed 1.6x2 at 3,1,0", "bed"), "stands with its back to the south wall, in its middle");
  EXPECT_EQ(Placed("6x4 room; bed 1.6x2 at 2,1,0; stool 0.4x0.4 at 3,0.2,0", "bed"),
            "stands with its back to the south wall, 1.20 m from its west end, with the stool at its right");
  EXPECT_EQ(Placed("6x4 room; bed 1.6x2 at 2,1,0; stool 0.4x0.4 at 3.5,0.2,0", "bed"),
            "stands with its back to the south wall, 1.20 m from its west end; 0.50 m to the stool");
}

TEST(Standing, NamesWhatAChairIsDrawnUpTo) {
  const char* const scene = "6x4 room; desk 1.2x0.6 at 3,0.3,0; chair 0.5x0.5 at 3,0.9,180";
  EXPECT_EQ(Placed(scene, "chair"), "stands drawn up to the desk");
  EXPECT_EQ(Placed("6x4 room; desk 1.2x0.6 at 3,0.3,0; table 0.5x0.5 at 3,0.9,180", "table"),
            "stands right before the desk");
}

TEST(Standing, OfARoomThatIsNoRectangleNamesTheWallAndWhereItIs) {
  const absl::StatusOr<SceneText> scene = ParseScene("6x4 room; bed 1x2 at 2,1,0");
  ASSERT_TRUE(scene.ok());
  Wall wall = scene->scene.room.walls[2];
  EXPECT_EQ(WallInWords(wall), "the north wall");
  wall.name = "wall_3";
  EXPECT_EQ(WallInWords(wall), "wall_3 in the north");
}

TEST(Compass, HasEightNames) {
  EXPECT_EQ(Compass({1, 0}), "east");
  EXPECT_EQ(Compass({-1, -1}), "south-west");
  EXPECT_EQ(Compass({0, -1}), "south");
  EXPECT_EQ(Compass({-1, 0}), "west");
}

}  // namespace
}  // namespace flair::cli
