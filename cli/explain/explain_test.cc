// SPDX-License-Identifier: GPL-3.0-or-later
// The words: calls, places.
#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include "cli/explain/hindrance.h"
#include "cli/explain/layout_note.h"
#include "optimizer_worker/constraints/arguments.h"
#include "optimizer_worker/constraints/facts.h"
#include "room/conversion/conversion.h"
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

TEST(CallWords, EveryTypeOfOursHasWords) {
  for (const optimizer::ConstraintFacts& facts : optimizer::AllConstraints()) {
    if (facts.type.built_in()) continue;
    for (const optimizer::LayoutExample& example : facts.layouts) {
      const absl::StatusOr<SceneText> scene = ParseScene(example.scene);
      ASSERT_TRUE(scene.ok()) << scene.status();
      const v1::ConstraintEdge edge = optimizer::EdgeFromText(facts.name(), example.call);
      const CallWords calls(optimizer::MakeCatalog(), scene->scene);
      const std::string words = calls.Asked(edge);
      EXPECT_THAT(words, Not(StartsWith("meets "))) << facts.name();
      EXPECT_THAT(words, Not(HasSubstr("_m"))) << words;
      EXPECT_THAT(words, Not(HasSubstr("{"))) << words;
      EXPECT_FALSE(calls.Subjects(edge).empty()) << facts.name();
      v1::EdgeOutcome outcome;
      outcome.set_missed_by(0.12);
      outcome.set_unit("m");
      const std::string missed = calls.Missed(edge, outcome);
      EXPECT_THAT(missed, HasSubstr(" 0.12 m ")) << facts.name();
      EXPECT_THAT(missed, Not(HasSubstr("{"))) << facts.name();
    }
  }
}

TEST(CallWords, FillsInValuesAndDefaults) {
  const absl::StatusOr<SceneText> scene = ParseScene("6x4 room; desk 1x1 at 1,1,0; bed 1x2 at 4,2,0");
  ASSERT_TRUE(scene.ok());
  const auto words = [&](const char* type, const char* call) {
    return CallWords(optimizer::MakeCatalog(), scene->scene).Asked(optimizer::EdgeFromText(type, call));
  };
  EXPECT_EQ(words("away_from", "object=desk target=bed min_distance_m=0.5"), "keeps at least 0.50 m from the bed");
  EXPECT_EQ(words("against_wall", "object=bed"), "has its back flush on a wall");
  EXPECT_EQ(words("against_wall", "object=bed side=left wall=north"), "has its left flush on the north wall");
  EXPECT_EQ(words("against_wall", "object=bed wall=north|east"),
            "has its back flush on the north wall or the east wall");
  EXPECT_EQ(words("against_wall", "object=nobody"), "meets against_wall");
  EXPECT_EQ(words("levitate", "object=bed"), "meets levitate");
}

TEST(CallWords, SpeakOfTheTypesOfAnotherOptimizer) {
  constexpr char kFloating[] = R"pb(
    library: "another 1"
    types {
      name: "levitate"
      aliases: "float"
      summary: "`object` floats above `ground`."
      parameters { name: "object" kind: PARAMETER_KIND_OBJECT required: true }
      parameters { name: "ground" kind: PARAMETER_KIND_OBJECT required: true }
      parameters { name: "tilt_rad" kind: PARAMETER_KIND_NUMBER unit: "rad" }
      phrase: "floats above {ground}, {tilt_rad|not} tilted"
      shortfall: "floats {missed_by} too low"
      anchors: "ground"
    }
    types {
      name: "glow"
      summary: "A light falls on `object`."
      parameters { name: "object" kind: PARAMETER_KIND_OBJECT required: true }
    }
  )pb";
  v1::ConstraintCatalog catalog;
  ASSERT_TRUE(google::protobuf::TextFormat::ParseFromString(kFloating, &catalog));
  const absl::StatusOr<SceneText> scene = ParseScene("6x4 room; desk 1x1 at 1,1,0; bed 1x2 at 4,2,0");
  ASSERT_TRUE(scene.ok());
  const CallWords calls(catalog, scene->scene);
  v1::ConstraintEdge call = optimizer::EdgeFromText("float", "object=bed ground=desk");
  EXPECT_EQ(calls.Asked(call), "floats above the desk, not tilted");
  EXPECT_EQ(calls.Subjects(call), std::vector<int>{1});
  EXPECT_EQ(calls.Anchors(call), std::vector<int>{0});
  v1::EdgeOutcome outcome;
  EXPECT_EQ(calls.Missed(call, outcome), "");
  outcome.set_missed_by(14);
  outcome.set_unit("deg");
  EXPECT_EQ(calls.Missed(call, outcome), "the bed floats 14 degrees too low");
  call = optimizer::EdgeFromText("levitate", "object=bed ground=desk tilt_rad=0.5");
  EXPECT_EQ(calls.Asked(call), "floats above the desk, 29 degrees tilted");
  EXPECT_EQ(calls.Asked(optimizer::EdgeFromText("glow", "object=bed")), "is so that a light falls on the bed");
  EXPECT_EQ(calls.Asked(optimizer::EdgeFromText("near", "object=bed target=desk")), "meets near");
}

TEST(Note, SaysWhyNobodyUnderstoodAWishWithoutTheWishAgain) {
  constexpr char kLayout[] = R"pb(
    graph {
      room {
        room_type: "study"
        floor {
          vertices {}
          vertices { x_m: 4 }
          vertices { x_m: 4 y_m: 3 }
          vertices { y_m: 3 }
        }
        walls { name: "south" }
        walls { name: "east" }
        walls { name: "north" }
        walls { name: "west" }
        height_m: 3
      }
      zone_plan { zones { id: "work" name: "work" purpose: "work" } }
      object_list {
        objects {
          id: "desk"
          name: "desk"
          role: OBJECT_ROLE_PRIMARY
          kind: OBJECT_KIND_FLOOR
          zone_id: "work"
          category: "desk"
          description: "A desk."
          width_m: 1
          depth_m: 1
          height_m: 1
        }
      }
      constraint_list {
        sentences {
          id: "s1"
          text: "The desk is near a socket."
          subject_ids: "desk"
          scope: SENTENCE_SCOPE_INTRA
          weight: 1
        }
      }
      diagnostics {
        severity: SEVERITY_WARNING
        code: "no_socket"
        subject_id: "s1"
        message: "\"The desk is near a socket.\": the room has no socket"
      }
    }
    placements { object_id: "desk" x_m: 1 y_m: 1 }
  )pb";
  v1::SolvedLayout layout;
  ASSERT_TRUE(google::protobuf::TextFormat::ParseFromString(kLayout, &layout));
  const absl::StatusOr<Note> note = MakeLayoutNote(layout, optimizer::MakeCatalog());
  ASSERT_TRUE(note.ok()) << note.status();
  const Note& demand = (*note)["zones"][0]["objects"][0]["demands"][0];
  EXPECT_EQ(demand["fate"], "not understood");
  EXPECT_EQ(demand["shortfall"], "the room has no socket");
}

TEST(Standing, NamesWallsCornersAndNeighbours) {
  EXPECT_EQ(Placed("6x4 room; bed 1.6x2 at 2,1,0", "bed"),
            "stands with its back to the south wall, 1.20 m from its west end");
  EXPECT_EQ(Placed("6x4 room; bed 1.6x2 at 0.8,1,0", "bed"),
            "stands in the south-west corner, its back to the south wall");
  EXPECT_EQ(Placed("6x4 room; bed 1.6x2 at 3,1,0", "bed"), "stands with its back to the south wall, in its middle");
  EXPECT_EQ(Placed("6x4 room; bed 1.6x2 at 2,1,0; stool 0.4x0.4 at 3,0.2,0", "bed"),
            "stands with its back to the south wall, 1.20 m from its west end, with the stool to its east");
  EXPECT_EQ(Placed("6x4 room; bed 1.6x2 at 2,1,0; stool 0.4x0.4 at 3.5,0.2,0", "bed"),
            "stands with its back to the south wall, 1.20 m from its west end; 0.50 m to the stool");
}

TEST(Standing, NamesWhatAChairIsDrawnUpTo) {
  const char* const scene = "6x4 room; desk 1.2x0.6 at 3,0.3,0; chair 0.5x0.5 at 3,0.9,180";
  EXPECT_EQ(Placed(scene, "chair"), "stands drawn up to the desk");
  EXPECT_EQ(Placed("6x4 room; desk 1.2x0.6 at 3,0.3,0; table 0.5x0.5 at 3,0.9,180", "table"),
            "stands right in front of the desk");
}

TEST(Standing, IsUnderAWindowAsSentencesMeasureIt) {
  const std::string room = "6x4 room; window south 2 1.4 sill 0.9; ";
  const auto desk = [&](const char* x) { return Placed(room + "desk 1.2x0.6 at " + x + ",0.3,0 height 0.75", "desk"); };
  EXPECT_THAT(desk("2.75"), HasSubstr(", under a window"));
  EXPECT_THAT(desk("2.3"), HasSubstr(", partly under a window"));
}

TEST(Hindrances, NameWhatIsInTheWayOrWouldNotHold) {
  const absl::StatusOr<SceneText> text = ParseScene(
      "5x4 room; window south 2 1.4 sill 0.9; desk 1.2x0.6 at 1,0.3,0 height 0.75; chest 1.4x0.5 at 2.7,0.25,0 height "
      "0.5");
  ASSERT_TRUE(text.ok()) << text.status();
  v1::SolvedLayout layout;
  *layout.mutable_graph() = GraphFromScene(text->scene);
  *layout.mutable_graph()->add_edges() = optimizer::EdgeFromText("under_window", "object=desk");
  layout.add_edge_outcomes()->set_status(v1::OUTCOME_STATUS_VIOLATED);
  PartialLayout where = {text->layout, std::vector<bool>(2, true)};
  EXPECT_EQ(Hindrances(layout, text->scene, where).Of(0, 0), "the chest is in the way where it would hold");
  where.layout[1] = {4.5, 3.5, 0};
  EXPECT_EQ(Hindrances(layout, text->scene, where).Of(0, 0), "");
  *layout.mutable_graph()->add_edges() = optimizer::EdgeFromText("near", "object=desk target=chest max_distance_m=0.5");
  where.layout[1] = {0.7, 1.5, 0};
  layout.add_edge_outcomes()->set_status(v1::OUTCOME_STATUS_SATISFIED);
  EXPECT_EQ(Hindrances(layout, text->scene, where).Of(0, 0), "where it would hold, something that holds now would not");
}

TEST(CallWords, SayWhatMayStandOnTheFreeFloor) {
  const absl::StatusOr<SceneText> text =
      ParseScene("6x4 room; sofa 2x0.9 at 3,0.45,0; coffee_table 1x0.6 at 3,1.6,0; chest 1x0.5 at 3,3,0");
  ASSERT_TRUE(text.ok()) << text.status();
  optimizer::LinkedPairs linked;
  linked.Link(0, 1);
  const PartialLayout where = {text->layout, std::vector<bool>(3, true)};
  const CallWords calls(optimizer::MakeCatalog(), text->scene);
  const auto excused = [&](const char* depth) {
    const std::string call = std::string("object=sofa sides=front min_clearance_m=") + depth;
    return calls.Excused(optimizer::EdgeFromText("accessible", call), where, linked);
  };
  EXPECT_EQ(excused("0.9"), "but for the coffee_table");
  EXPECT_EQ(excused("0.3"), "");
}

TEST(Compass, HasEightNames) {
  EXPECT_EQ(Compass({1, 0}), "east");
  EXPECT_EQ(Compass({-1, -1}), "south-west");
  EXPECT_EQ(Compass({0, -1}), "south");
  EXPECT_EQ(Compass({-1, 0}), "west");
}

}  // namespace
}  // namespace flair::cli
