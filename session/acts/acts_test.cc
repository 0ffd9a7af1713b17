// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "session/testing/documents_for_test.h"

namespace flair::session {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class ActsTest : public DocumentsTest {};

TEST_F(ActsTest, WhatIsMovedStaysJustThereUntilItIsSettled) {
  const v1::GetDocumentResponse made = Designed();
  const std::string desk = IdOf(made.layout(), "wardrobe");
  const v1::Placement to = Inward(PlacementOf(made.layout(), desk));
  const auto moved = Act(made.document(), [&](v1::ActRequest& act) { *act.mutable_move()->add_placements() = to; });
  ASSERT_TRUE(moved.ok()) << moved.status();
  EXPECT_FALSE(moved->layout().has_graph());
  EXPECT_EQ(PlacementOf(moved->layout(), desk).SerializeAsString(), to.SerializeAsString());
  EXPECT_EQ(moved->document().undo_label(), "move the wardrobe");
  for (const v1::Placement& other : made.layout().placements()) {
    if (other.object_id() == desk) continue;
    EXPECT_EQ(PlacementOf(moved->layout(), other.object_id()).SerializeAsString(), other.SerializeAsString());
  }

  const auto settled = Act(moved->document(), [](v1::ActRequest& act) { act.mutable_settle(); });
  ASSERT_TRUE(settled.ok()) << settled.status();
  EXPECT_EQ(PlacementOf(settled->layout(), desk).x_m(), to.x_m());
  EXPECT_LT(settled->layout().metrics().deepest_overlap_m(), 1e-6);
  EXPECT_THAT(Get(made.document().id()).layout().graph().pinned_placements(), IsEmpty());
}

TEST_F(ActsTest, ADocumentIsUnsettledFromAMoveUntilItIsSolved) {
  const v1::GetDocumentResponse made = Designed();
  EXPECT_FALSE(made.document().unsettled());
  const std::string bed = IdOf(made.layout(), "bed");
  auto last = Act(made.document(), [&](v1::ActRequest& act) {
    v1::EditLayout& edit = *act.mutable_edit();
    edit.set_without_solving(true);
    edit.add_edits()->set_pin_object_id(bed);
  });
  ASSERT_TRUE(last.ok()) << last.status();
  EXPECT_FALSE(last->document().unsettled()) << "what is locked stands where it was solved";
  last = Act(last->document(), [&](v1::ActRequest& act) {
    *act.mutable_move()->add_placements() = Inward(PlacementOf(made.layout(), bed));
  });
  ASSERT_TRUE(last.ok()) << last.status();
  EXPECT_TRUE(last->document().unsettled());
  last = Act(last->document(), [](v1::ActRequest& act) { act.mutable_settle(); });
  ASSERT_TRUE(last.ok()) << last.status();
  EXPECT_FALSE(last->document().unsettled());
  last = Act(last->document(), [](v1::ActRequest& act) { act.mutable_undo(); });
  ASSERT_TRUE(last.ok()) << last.status();
  EXPECT_TRUE(last->document().unsettled());
  Reopen();
  EXPECT_TRUE(Get(last->document().id()).document().unsettled());
}

TEST_F(ActsTest, WhatStandsOnAPieceOrLiesUnderItGoesWithIt) {
  const v1::GetDocumentResponse made = Designed();
  std::map<std::string, v1::Object> objects;
  for (const v1::Object& object : made.layout().graph().object_list().objects()) objects[object.id()] = object;
  std::set<std::string> hosts;
  for (const v1::Placement& at : made.layout().placements()) hosts.insert(objects[at.object_id()].host_id());
  hosts.erase("");
  v1::Document document = made.document();
  int carried = 0;
  for (const std::string& host : hosts) {
    const v1::Placement to = Inward(PlacementOf(made.layout(), host));
    const auto moved = Act(document, [&](v1::ActRequest& act) { *act.mutable_move()->add_placements() = to; });
    ASSERT_TRUE(moved.ok()) << moved.status();
    document = moved->document();
    for (const v1::Placement& at : made.layout().placements()) {
      const v1::Object& object = objects[at.object_id()];
      if (object.host_id() != host) continue;
      // What hangs above it is of another test.
      if (object.kind() == v1::OBJECT_KIND_WALL) continue;
      const bool goes = object.kind() == v1::OBJECT_KIND_SURFACE || object.walk_over();
      EXPECT_EQ(PlacementOf(moved->layout(), object.id()).x_m() != at.x_m(), goes) << object.id();
      carried += goes ? 1 : 0;
    }
  }
  EXPECT_GT(carried, 0);
}

TEST_F(ActsTest, WhatHangsAboveAPieceGoesAlongItsWallWithIt) {
  const v1::GetDocumentResponse made = Designed();
  int hung = 0;
  v1::Document document = made.document();
  for (const v1::ConstraintEdge& edge : made.layout().graph().edges()) {
    if (edge.type() != "on_wall_above") continue;
    std::map<std::string, std::string> named;
    for (const v1::Argument& argument : edge.arguments()) named[argument.name()] = argument.value().text();
    const v1::Placement picture = PlacementOf(made.layout(), named["object"]);
    const v1::Placement from = PlacementOf(made.layout(), named["target"]);
    v1::Placement to = from;
    to.set_x_m(from.x_m() + 0.2 * std::cos(picture.theta_rad()));
    to.set_y_m(from.y_m() + 0.2 * std::sin(picture.theta_rad()));
    const auto moved = Act(document, [&](v1::ActRequest& act) { *act.mutable_move()->add_placements() = to; });
    ASSERT_TRUE(moved.ok()) << moved.status();
    const v1::Placement along = PlacementOf(moved->layout(), named["object"]);
    EXPECT_NEAR(along.x_m() - picture.x_m(), to.x_m() - from.x_m(), 1e-9);
    EXPECT_NEAR(along.y_m() - picture.y_m(), to.y_m() - from.y_m(), 1e-9);
    // Away from the wall it stays.
    to.set_x_m(to.x_m() - 0.3 * std::sin(picture.theta_rad()));
    to.set_y_m(to.y_m() + 0.3 * std::cos(picture.theta_rad()));
    const auto off = Act(moved->document(), [&](v1::ActRequest& act) { *act.mutable_move()->add_placements() = to; });
    ASSERT_TRUE(off.ok()) << off.status();
    EXPECT_EQ(PlacementOf(off->layout(), named["object"]).SerializeAsString(), along.SerializeAsString());
    document = off->document();
    ++hung;
  }
  EXPECT_GT(hung, 0);
}

TEST_F(ActsTest, APictureThatIsDroppedOnAWallFacesIntoTheRoom) {
  const v1::GetDocumentResponse made = Designed();
  constexpr double kPi = 3.14159265358979323846;
  struct Drop {
    double x_m, y_m, faces_rad;
  };
  // The walls of 4 m x 5 m: north, south, west, east.
  v1::Document document = made.document();
  for (const Drop& drop : {Drop{1.0, 4.9, kPi}, {1.0, 0.1, 0}, {0.1, 1.3, -kPi / 2}, {3.9, 1.3, kPi / 2}}) {
    const auto added = Act(document, [&](v1::ActRequest& act) {
      act.mutable_edit()->set_without_solving(true);
      v1::Object& picture = *act.mutable_edit()->add_edits()->mutable_add_object()->mutable_object();
      picture.set_name("picture");
      picture.set_kind(v1::OBJECT_KIND_WALL);
      picture.set_width_m(0.6);
      picture.set_depth_m(0.04);
      picture.set_height_m(0.5);
      picture.set_elevation_m(1.3);
      v1::Placement& at = *act.mutable_edit()->add_edits()->mutable_move_object();
      at.set_x_m(drop.x_m);
      at.set_y_m(drop.y_m);
      at.set_z_m(1.3);
    });
    ASSERT_TRUE(added.ok()) << added.status();
    document = added->document();
    ASSERT_EQ(added->moved_object_ids_size(), 1);
    const v1::Placement hangs = PlacementOf(added->layout(), added->moved_object_ids(0));
    EXPECT_NEAR(std::remainder(hangs.theta_rad() - drop.faces_rad, 2 * kPi), 0, 1e-9) << drop.x_m << " " << drop.y_m;
    const double depth = std::min({hangs.x_m(), 4 - hangs.x_m(), hangs.y_m(), 5 - hangs.y_m()});
    EXPECT_NEAR(depth, 0.02, 1e-9);
    EXPECT_EQ(hangs.z_m(), 1.3);
  }
}

TEST_F(ActsTest, JudgingSaysWhatMovingWouldAndChangesNothing) {
  const v1::GetDocumentResponse made = Designed();
  const std::string bed = IdOf(made.layout(), "bed");
  v1::JudgeRequest judge;
  judge.set_document_id(made.document().id());
  judge.set_revision(made.document().revision());
  *judge.add_placements() = Inward(PlacementOf(made.layout(), bed));
  const auto judged = documents_->Judge(judge, call_);
  ASSERT_TRUE(judged.ok()) << judged.status();
  EXPECT_THAT(judged->edge_outcomes(), Not(IsEmpty()));
  EXPECT_EQ(Get(made.document().id()).document().revision(), made.document().revision());

  const auto moved =
      Act(made.document(), [&](v1::ActRequest& act) { *act.mutable_move()->add_placements() = judge.placements(0); });
  ASSERT_TRUE(moved.ok());
  for (const v1::EdgeOutcome& outcome : judged->edge_outcomes()) {
    for (const v1::EdgeOutcome& then : moved->layout().edge_outcomes()) {
      if (then.edge_id() != outcome.edge_id()) continue;
      EXPECT_EQ(then.status(), outcome.status()) << outcome.edge_id();
    }
  }
}

TEST_F(ActsTest, ASentenceIsTranslatedSolvedAndKeptOrRefusedInWords) {
  const v1::GetDocumentResponse made = Designed();
  const auto said = Act(made.document(), [](v1::ActRequest& act) {
    act.mutable_say()->set_text("The wardrobe is against the west wall.");
  });
  ASSERT_TRUE(said.ok()) << said.status();
  const v1::LayoutGraph& graph = said->layout().graph();
  EXPECT_EQ(graph.constraint_list().sentences_size(), made.layout().graph().constraint_list().sentences_size() + 1);
  EXPECT_EQ(said->document().undo_label(), "say \"The wardrobe is against the west wall.\"");
  const auto refused =
      Act(said->document(), [](v1::ActRequest& act) { act.mutable_say()->set_text("Green ideas sleep furiously."); });
  EXPECT_TRUE(absl::IsInvalidArgument(refused.status()));
  EXPECT_THAT(std::string(refused.status().message()), HasSubstr("is not understood"));

  const std::string sentence = graph.constraint_list().sentences().rbegin()->id();
  const auto dropped =
      Act(said->document(), [&](v1::ActRequest& act) { act.mutable_weigh()->set_sentence_id(sentence); });
  ASSERT_TRUE(dropped.ok()) << dropped.status();
  for (const v1::ConstraintEdge& edge : dropped->layout().graph().edges()) EXPECT_NE(edge.sentence_id(), sentence);
}

TEST_F(ActsTest, APieceIsAddedWhereItIsDroppedAndGoesAgain) {
  const v1::GetDocumentResponse made = Designed();
  const auto added = Act(made.document(), [](v1::ActRequest& act) {
    act.mutable_edit()->set_without_solving(true);
    v1::Object& lamp = *act.mutable_edit()->add_edits()->mutable_add_object()->mutable_object();
    lamp.set_name("floor lamp");
    lamp.set_width_m(0.4);
    lamp.set_depth_m(0.4);
    lamp.set_height_m(1.6);
    v1::Placement& at = *act.mutable_edit()->add_edits()->mutable_move_object();
    at.set_x_m(2);
    at.set_y_m(2.5);
  });
  ASSERT_TRUE(added.ok()) << added.status();
  EXPECT_THAT(added->moved_object_ids(), ElementsAre("floor_lamp"));
  EXPECT_EQ(PlacementOf(added->layout(), "floor_lamp").y_m(), 2.5);
  EXPECT_EQ(added->document().undo_label(), "add a floor lamp");
  const auto settled = Act(added->document(), [](v1::ActRequest& act) { act.mutable_settle(); });
  ASSERT_TRUE(settled.ok()) << settled.status();
  EXPECT_EQ(PlacementOf(settled->layout(), "floor_lamp").y_m(), 2.5);
  const auto removed = Act(settled->document(), [](v1::ActRequest& act) {
    act.mutable_edit()->add_edits()->set_remove_object_id("floor_lamp");
  });
  ASSERT_TRUE(removed.ok()) << removed.status();
  EXPECT_EQ(IdOf(removed->layout(), "floor lamp"), "");
}

TEST_F(ActsTest, APieceIsAddedNearAnotherWithoutKnowingItsId) {
  const v1::GetDocumentResponse made = Designed();
  const std::string bed = IdOf(made.layout(), "bed");
  const auto added = Act(made.document(), [&](v1::ActRequest& act) {
    v1::AddObject& add = *act.mutable_edit()->add_edits()->mutable_add_object();
    add.mutable_object()->set_name("ottoman");
    add.mutable_object()->set_width_m(0.4);
    add.mutable_object()->set_depth_m(0.4);
    add.mutable_object()->set_height_m(0.4);
    v1::ConstraintEdge& near = *add.add_edges();
    near.set_type("near");
    near.set_weight(1);
    for (const auto& [name, id] : {std::pair("object", std::string()), {"target", bed}}) {
      v1::Argument& argument = *near.add_arguments();
      argument.set_name(name);
      argument.mutable_value()->set_text(id);
    }
  });
  ASSERT_TRUE(added.ok()) << added.status();
  EXPECT_EQ(added->document().undo_label(), "add an ottoman");
  const v1::ConstraintEdge& near = *added->layout().graph().edges().rbegin();
  EXPECT_EQ(near.arguments(0).value().text(), "ottoman");
  EXPECT_EQ(added->layout().edge_outcomes().rbegin()->status(), v1::OUTCOME_STATUS_SATISFIED);
}

TEST_F(ActsTest, TheChairGoesWithItsDesk) {
  const v1::GetDocumentResponse made = Designed();
  const std::string desk = IdOf(made.layout(), "desk"), chair = IdOf(made.layout(), "chair");
  const v1::Placement from = PlacementOf(made.layout(), desk), seat = PlacementOf(made.layout(), chair);
  const auto moved = Act(made.document(), [&](v1::ActRequest& act) {
    v1::Placement& to = *act.mutable_move()->add_placements();
    to = from;
    to.set_y_m(from.y_m() + 0.4);
  });
  ASSERT_TRUE(moved.ok()) << moved.status();
  EXPECT_NEAR(PlacementOf(moved->layout(), chair).y_m(), seat.y_m() + 0.4, 1e-9);
  EXPECT_NEAR(PlacementOf(moved->layout(), chair).x_m(), seat.x_m(), 1e-9);
}

TEST_F(ActsTest, WhatIsSaidOfAPieceThatWasMovedMovesIt) {
  const v1::GetDocumentResponse made = Designed();
  const std::string wardrobe = IdOf(made.layout(), "wardrobe");
  const auto moved = Act(made.document(), [&](v1::ActRequest& act) {
    *act.mutable_move()->add_placements() = Inward(PlacementOf(made.layout(), wardrobe));
  });
  ASSERT_TRUE(moved.ok()) << moved.status();
  const auto said = Act(moved->document(),
                        [](v1::ActRequest& act) { act.mutable_say()->set_text("The wardrobe is against a wall."); });
  ASSERT_TRUE(said.ok()) << said.status();
  const std::string sentence = said->layout().graph().constraint_list().sentences().rbegin()->id();
  for (int i = 0; i < said->layout().edge_outcomes_size(); ++i) {
    if (said->layout().graph().edges(i).sentence_id() != sentence) continue;
    EXPECT_EQ(said->layout().edge_outcomes(i).status(), v1::OUTCOME_STATUS_SATISFIED);
  }
}

TEST_F(ActsTest, WrongPlacesAreRefusedByField) {
  const v1::GetDocumentResponse made = Designed();
  const auto unknown =
      Act(made.document(), [](v1::ActRequest& act) { act.mutable_move()->add_placements()->set_object_id("throne"); });
  EXPECT_THAT(std::string(unknown.status().message()), HasSubstr("move.placements[0].object_id: \"throne\""));
  const auto far = Act(made.document(), [&](v1::ActRequest& act) {
    v1::Placement& at = *act.mutable_move()->add_placements();
    at.set_object_id(IdOf(made.layout(), "bed"));
    at.set_x_m(NAN);
  });
  EXPECT_THAT(std::string(far.status().message()), HasSubstr("move.placements[0].x_m"));
  EXPECT_TRUE(absl::IsInvalidArgument(Act(made.document(), [](v1::ActRequest&) {}).status()));
}

TEST_F(ActsTest, SettlingTriesAgainForWhatDoesNotHoldAndIsRefusedInAnEmptyRoom) {
  const v1::GetDocumentResponse made = Designed();
  v1::CreateDocumentRequest empty;
  empty.set_request_id("empty");
  *empty.mutable_room() = made.layout().graph().room();
  const auto bare = documents_->Create(empty, call_);
  ASSERT_TRUE(bare.ok()) << bare.status();
  EXPECT_TRUE(
      absl::IsFailedPrecondition(Act(bare->document(), [](v1::ActRequest& act) { act.mutable_settle(); }).status()));
  v1::Room room = made.layout().graph().room();
  for (v1::Point2& corner : *room.mutable_floor()->mutable_vertices()) {
    if (corner.x_m() > 1) corner.set_x_m(corner.x_m() + 0.5);
  }
  const auto wider = Act(made.document(), [&](v1::ActRequest& act) { *act.mutable_room() = room; });
  ASSERT_TRUE(wider.ok()) << wider.status();
  const auto violated = [](const v1::SolvedLayout& layout) {
    return std::ranges::count(layout.edge_outcomes(), v1::OUTCOME_STATUS_VIOLATED, &v1::EdgeOutcome::status);
  };
  ASSERT_GT(violated(wider->layout()), 0);
  EXPECT_TRUE(wider->document().unsettled());
  const auto settled = Act(wider->document(), [](v1::ActRequest& act) { act.mutable_settle(); });
  ASSERT_TRUE(settled.ok()) << settled.status();
  EXPECT_LT(violated(settled->layout()), violated(wider->layout()));
  EXPECT_FALSE(settled->document().unsettled());
}

TEST_F(ActsTest, DroppingASentenceAddsNoPieceThatHadNoPlace) {
  // A picture that would have to hang above a sofa that stands free.
  const v1::GetDocumentResponse made = Designed("A living room that is 5m x 6m.", 3);
  const std::string painting = IdOf(made.layout(), "painting");
  const auto is_placed = [&](const v1::SolvedLayout& layout) {
    return std::ranges::count(layout.placements(), painting, &v1::Placement::object_id) > 0;
  };
  ASSERT_FALSE(is_placed(made.layout()));
  v1::Document document = made.document();
  std::set<std::string> sentences;
  for (const v1::ConstraintEdge& edge : made.layout().graph().edges()) sentences.insert(edge.sentence_id());
  for (const std::string& sentence : sentences) {
    const auto dropped = Act(document, [&](v1::ActRequest& act) { act.mutable_weigh()->set_sentence_id(sentence); });
    ASSERT_TRUE(dropped.ok()) << dropped.status();
    EXPECT_EQ(dropped->layout().placements_size(), made.layout().placements_size()) << sentence;
    document = Act(dropped->document(), [](v1::ActRequest& act) { act.mutable_undo(); })->document();
  }
}

}  // namespace
}  // namespace flair::session
