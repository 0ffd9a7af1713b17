// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/shortfall.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

#include "optimizer_worker/constraints/arguments.h"
#include "optimizer_worker/constraints/facts.h"
#include "room/text_format/scene_text.h"

namespace flair::optimizer {
namespace {

using ::testing::HasSubstr;

std::optional<Shortfall> Explained(const std::string& scene, const std::string& type, const std::string& call) {
  const absl::StatusOr<SceneText> text = ParseScene(scene);
  EXPECT_TRUE(text.ok()) << text.status();
  if (!text.ok()) return std::nullopt;
  return Explain(EdgeFromText(type, call), {text->scene, text->layout, text->zone_centers});
}

std::string SentenceOf(const std::string& scene, const std::string& type, const std::string& call) {
  const std::optional<Shortfall> shortfall = Explained(scene, type, call);
  return shortfall ? shortfall->sentence : "";
}

TEST(Explain, EveryTypeHasWordsWithAFigureForItsViolatedExamples) {
  for (const ConstraintFacts& facts : AllConstraints()) {
    if (facts.type.built_in()) continue;
    for (const LayoutExample& example : facts.layouts) {
      if (example.satisfied) continue;
      const std::optional<Shortfall> shortfall = Explained(example.scene, facts.name(), example.call);
      ASSERT_TRUE(shortfall) << facts.name() << ": " << example.scene << " / " << example.call;
      EXPECT_GT(shortfall->missed_by, 0) << shortfall->sentence;
      EXPECT_TRUE(shortfall->unit == "m" || shortfall->unit == "deg") << shortfall->unit;
      EXPECT_TRUE(std::any_of(shortfall->sentence.begin(), shortfall->sentence.end(), [](unsigned char c) {
        return std::isdigit(c) != 0;
      })) << shortfall->sentence;
    }
  }
}

TEST(Explain, SaysWhatWasMeasuredAndWhatWouldBeRight) {
  EXPECT_EQ(SentenceOf("6x4 room; window north 2 1; desk 1.2x0.6 at 3,2.7,0", "close_to_feature",
                       "object=desk feature=window max_distance_m=0.5"),
            "the desk is 1.00 m from the window, at most 0.50 m");
  EXPECT_EQ(SentenceOf("6x4 room; door south 1 1; bed 1x1 at 1.5,1.7,0", "away_from_feature",
                       "object=bed feature=door min_distance_m=2"),
            "the bed is 1.20 m from the door, at least 2.00 m");
  EXPECT_EQ(SentenceOf("6x4 room; bed 1.6x2 at 3,1.3,0", "against_wall", "object=bed"),
            "the back of the bed is 0.30 m off the south wall");
  EXPECT_EQ(SentenceOf("6x4 room; a 1x1 at 1,1,0; b 1x1 at 1,3,90", "parallel", "object=a target=b"),
            "the a is turned 90 degrees from the direction of the b");
}

TEST(Explain, NamesWhatStandsInTheWay) {
  EXPECT_EQ(SentenceOf("6x4 room; wardrobe 1x0.6 at 1,0.3,0; bed 1.6x2 at 1.2,2,0", "accessible", "object=wardrobe"),
            "the bed reaches 0.20 m into the 0.60 m before the front of the wardrobe");
  EXPECT_THAT(SentenceOf("6x4 room; wardrobe 1x0.6 at 1,3.5,0", "accessible", "object=wardrobe"),
              HasSubstr("cut off by the north wall by 0.40 m"));
  // However little of it stands there, to the side.
  EXPECT_EQ(SentenceOf("6x4 room; wardrobe 1x0.6 at 1,0.3,0; bed 1.6x1 at 2.25,1.3,0", "accessible", "object=wardrobe"),
            "the bed reaches 0.40 m into the 0.60 m before the front of the wardrobe");
  // A chair that just touches it is not to blame for the desk that stands there.
  EXPECT_EQ(SentenceOf("6x4 room; bed 1.6x2 at 3,3,180; chair 0.6x0.6 at 2.15,1.45,0; desk 1.2x0.5 at 3,1.7,0",
                       "accessible", "object=bed"),
            "the desk reaches 0.55 m into the 0.60 m before the front of the bed");
  // In an L the line of a wall goes on where the wall does not.
  EXPECT_EQ(SentenceOf("room 0,0 3,0 3,1.5 5,1.5 5,4 0,4; wardrobe 1x0.6 at 4,1.8,0; desk 1x0.6 at 4,2.6,180",
                       "accessible", "object=wardrobe"),
            "the desk reaches 0.40 m into the 0.60 m before the front of the wardrobe");
}

TEST(Explain, MeansTheWallThatIsNearest) {
  EXPECT_EQ(SentenceOf("4x6 room; desk 1.2x0.6 at 2,4.6,165", "against_wall", "object=desk"),
            "the back of the desk is 1.11 m off the north wall");
}

TEST(Explain, SaysHowMuchFloorADoorNeeds) {
  EXPECT_EQ(
      SentenceOf("6x4 room; door south 1 1; crate 1x0.6 at 1.5,1.3,0", "clear_of_feature", "object=crate feature=door"),
      "the crate reaches 0.20 m into the 1.20 m of floor that is to be free before the door");
}

TEST(Explain, NumbersThingsOfOneName) {
  absl::StatusOr<SceneText> text =
      ParseScene("4x4 room; chair_1 1x1 at 1,1,0; chair_2 1x1 at 3,1,0; desk 1x1 at 3,3,0");
  ASSERT_TRUE(text.ok());
  text->scene.objects[0].name = text->scene.objects[1].name = "dining chair";
  EXPECT_EQ(NameForPeople(text->scene, 1), "dining chair 2");
  EXPECT_EQ(NameForPeople(text->scene, 2), "the desk");
}

}  // namespace
}  // namespace flair::optimizer
