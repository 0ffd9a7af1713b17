// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "session/layouts/placing.h"
#include "session/testing/documents_for_test.h"

namespace flair::session {
namespace {

TEST(PlaceTest, HeadingsOfWhatIsTurnedAndOfWhatStandsOnItAreWithinOneTurn) {
  v1::SolvedLayout layout;
  auto& objects = *layout.mutable_graph()->mutable_object_list();
  objects.add_objects()->set_id("desk");
  v1::Object& lamp = *objects.add_objects();
  lamp.set_id("lamp");
  lamp.set_host_id("desk");
  lamp.set_kind(v1::OBJECT_KIND_SURFACE);
  for (const auto& [id, theta_rad] : {std::pair{"desk", 0.0}, {"lamp", 1.5 * M_PI}}) {
    v1::Placement& at = *layout.add_placements();
    at.set_object_id(id);
    at.set_theta_rad(theta_rad);
  }
  google::protobuf::RepeatedPtrField<v1::Placement> turned;
  *turned.Add() = layout.placements(0);
  turned[0].set_theta_rad(3 * M_PI);
  ASSERT_TRUE(Place(layout, turned, "move").ok());
  EXPECT_NEAR(layout.placements(0).theta_rad(), M_PI, 1e-12);
  EXPECT_NEAR(layout.placements(1).theta_rad(), M_PI / 2, 1e-12);
}

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class HandPlacedTest : public DocumentsTest {
 protected:
  // As it is stored for what is shown.
  std::vector<std::string> PlacedByHand(const v1::Document& document) {
    const auto record = (*DocumentStore::Open(folder_.path() + "/documents"))->Get(document.id());
    const auto& ids = record->states(record->position()).placed_by_hand_ids();
    return {ids.begin(), ids.end()};
  }

  absl::StatusOr<v1::ActResponse> Move(const v1::Document& document, const v1::Placement& to) {
    return Act(document, [&](v1::ActRequest& act) { *act.mutable_move()->add_placements() = to; });
  }
  absl::StatusOr<v1::ActResponse> Settle(const v1::Document& document) {
    return Act(document, [](v1::ActRequest& act) { act.mutable_settle(); });
  }

  static void AddLamp(double x_m, double y_m, v1::EditLayout& edit) {
    edit.set_without_solving(true);
    v1::Object& lamp = *edit.add_edits()->mutable_add_object()->mutable_object();
    lamp.set_name("floor lamp");
    for (const auto set : {&v1::Object::set_width_m, &v1::Object::set_depth_m, &v1::Object::set_height_m})
      (lamp.*set)(0.4);
    v1::Placement& at = *edit.add_edits()->mutable_move_object();
    at.set_x_m(x_m);
    at.set_y_m(y_m);
  }
};

TEST_F(HandPlacedTest, WhatWasPutSomewhereStaysThereInLaterSolvesUntilUndone) {
  const v1::GetDocumentResponse made = Designed();
  const std::string wardrobe = IdOf(made.layout(), "wardrobe"), bed = IdOf(made.layout(), "bed");
  const v1::Placement to = Inward(PlacementOf(made.layout(), wardrobe));
  auto last = Move(made.document(), to);
  ASSERT_TRUE(last.ok()) << last.status();
  last = Settle(last->document());
  ASSERT_TRUE(last.ok()) << last.status();
  EXPECT_THAT(PlacedByHand(last->document()), ElementsAre(wardrobe));
  // Both would bring it back to its wall.
  std::string sentence;
  for (int i = 0; i < made.layout().graph().edges_size(); ++i) {
    const v1::ConstraintEdge& edge = made.layout().graph().edges(i);
    if (edge.type() == "against_wall" && edge.arguments(0).value().text() == wardrobe) sentence = edge.sentence_id();
  }
  ASSERT_NE(sentence, "");
  last = Act(last->document(), [&](v1::ActRequest& act) {
    act.mutable_weigh()->set_sentence_id(sentence);
    act.mutable_weigh()->set_weight(9);
  });
  ASSERT_TRUE(last.ok()) << last.status();
  EXPECT_EQ(PlacementOf(last->layout(), wardrobe).x_m(), to.x_m());
  last = Move(last->document(), Inward(PlacementOf(last->layout(), bed)));
  ASSERT_TRUE(last.ok()) << last.status();
  last = Settle(last->document());
  ASSERT_TRUE(last.ok()) << last.status();
  EXPECT_EQ(PlacementOf(last->layout(), wardrobe).x_m(), to.x_m());
  EXPECT_THAT(Get(made.document().id()).layout().graph().pinned_placements(), IsEmpty());
  EXPECT_THAT(PlacedByHand(last->document()), ElementsAre(wardrobe, bed));

  v1::Document document = last->document();
  while (!document.undo_label().empty()) {
    document = Act(document, [](v1::ActRequest& act) { act.mutable_undo(); })->document();
  }
  EXPECT_THAT(PlacedByHand(document), IsEmpty());
  document = Act(document, [](v1::ActRequest& act) { act.mutable_redo(); })->document();
  EXPECT_THAT(PlacedByHand(document), ElementsAre(wardrobe));
  const auto found = documents_->FindAlternatives(document.id(), document.revision(), 1, 0, call_);
  ASSERT_TRUE(found.ok()) << found.status();
  last = Act(found->document(), [](v1::ActRequest& act) { act.mutable_take_variant(); });
  ASSERT_TRUE(last.ok()) << last.status();
  EXPECT_THAT(PlacedByHand(last->document()), IsEmpty());
}

TEST_F(HandPlacedTest, WhatIsInTheWayOfALaterMoveIsFreedAndTold) {
  const v1::GetDocumentResponse made = Designed();
  const std::string wardrobe = IdOf(made.layout(), "wardrobe"), bed = IdOf(made.layout(), "bed");
  auto last = Move(made.document(), Inward(PlacementOf(made.layout(), wardrobe)));
  ASSERT_TRUE(last.ok()) << last.status();
  v1::Placement over = PlacementOf(made.layout(), bed);
  const v1::Placement at = PlacementOf(last->layout(), wardrobe);
  over.set_x_m(std::clamp(at.x_m(), 1.1, 2.9));
  over.set_y_m(std::clamp(at.y_m(), 1.1, 3.9));
  last = Move(last->document(), over);
  ASSERT_TRUE(last.ok()) << last.status();
  last = Settle(last->document());
  ASSERT_TRUE(last.ok()) << last.status();
  EXPECT_LT(last->layout().metrics().deepest_overlap_m(), 1e-6);
  EXPECT_EQ(PlacementOf(last->layout(), bed).x_m(), over.x_m());
  EXPECT_THAT(PlacedByHand(last->document()), ElementsAre(bed));
  const auto told = std::ranges::find(last->diagnostics(), "hand_placed_moved", &v1::Diagnostic::code);
  ASSERT_NE(told, last->diagnostics().end());
  EXPECT_EQ(told->subject_id(), wardrobe);
  EXPECT_THAT(told->message(), HasSubstr("could not stay where it was put by hand: "));
}

TEST_F(HandPlacedTest, WhatWasNotPlacedByHandGivesWayToWhatWas) {
  const struct {
    const char* brief;
    int seed;
    const char* piece;
    int most_moved;
  } cases[] = {
      {"A living room that is 3.5m x 4.5m with two armchairs and two floor lamps.", 4, "side table", 6},
      {"A bedroom that is 3m x 4m with an armchair, a floor lamp and a desk.", 4, "nightstand", 4},
      {"A home office that is 3.5m x 4m.", 2, "bookshelf", 4},
      // Its knees are under the desk as before.
      {"A home office that is 3.5m x 4m.", 3, "office chair", 1},
  };
  for (const auto& one : cases) {
    SCOPED_TRACE(one.piece);
    const v1::GetDocumentResponse made = Designed(one.brief, one.seed);
    const std::string id = IdOf(made.layout(), one.piece);
    v1::Placement turned = PlacementOf(made.layout(), id);
    turned.set_theta_rad(turned.theta_rad() + M_PI / 12);
    const v1::Object& object = *std::ranges::find(made.layout().graph().object_list().objects(), id, &v1::Object::id);
    // As the page turns it: not into the walls.
    const auto& opposite = made.layout().graph().room().floor().vertices(2);
    const double cos = std::abs(std::cos(turned.theta_rad())), sin = std::abs(std::sin(turned.theta_rad()));
    const double x_m = (object.width_m() * cos + object.depth_m() * sin) / 2;
    const double y_m = (object.width_m() * sin + object.depth_m() * cos) / 2;
    turned.set_x_m(std::clamp(turned.x_m(), x_m, opposite.x_m() - x_m));
    turned.set_y_m(std::clamp(turned.y_m(), y_m, opposite.y_m() - y_m));
    auto last = Move(made.document(), turned);
    ASSERT_TRUE(last.ok()) << last.status();
    last = Settle(last->document());
    ASSERT_TRUE(last.ok()) << last.status();
    EXPECT_THAT(PlacedByHand(last->document()), ElementsAre(id));
    EXPECT_NEAR(std::remainder(PlacementOf(last->layout(), id).theta_rad() - turned.theta_rad(), 2 * M_PI), 0, 1e-9);
    for (const v1::Finding& found : last->layout().metrics().findings()) {
      EXPECT_EQ(found.kind(), v1::FINDING_KIND_USE_NOT_MET) << found.message();
    }
    EXPECT_LE(last->moved_object_ids_size(), one.most_moved);
  }
}

TEST_F(HandPlacedTest, WhatIsToldOfLockedPiecesCallsThemByNameAndEndsWithThem) {
  const v1::GetDocumentResponse made = Designed("A living room that is 5m x 6m.", 3);
  const std::string table = IdOf(made.layout(), "side table"), chair = IdOf(made.layout(), "armchair");
  v1::Placement over = PlacementOf(made.layout(), table);
  over.set_x_m(PlacementOf(made.layout(), chair).x_m());
  auto last = Move(made.document(), over);
  ASSERT_TRUE(last.ok()) << last.status();
  last = Act(last->document(), [&](v1::ActRequest& act) {
    for (const std::string& id : {chair, table}) act.mutable_edit()->add_edits()->set_pin_object_id(id);
  });
  ASSERT_TRUE(last.ok()) << last.status();
  std::string told;
  for (const v1::Diagnostic& one : last->diagnostics()) told += one.code() + " " + one.message() + "\n";
  EXPECT_THAT(told, HasSubstr("armchair 1 (0.80 m x 0.80 m) overlaps the side table (0.50 m x 0.50 m)"));
  last =
      Act(last->document(), [&](v1::ActRequest& act) { act.mutable_edit()->add_edits()->set_remove_object_id(table); });
  ASSERT_TRUE(last.ok()) << last.status();
  const v1::GetDocumentResponse left = Get(made.document().id());
  for (const v1::Diagnostic& one : left.layout().diagnostics()) {
    EXPECT_THAT(one.message(), ::testing::Not(HasSubstr("side_table")));
    EXPECT_NE(one.code(), "pinned_collides");
  }
}

TEST_F(HandPlacedTest, InARoomThatWasNeverSolvedPiecesStayWhereTheyWereDropped) {
  v1::CreateDocumentRequest request;
  request.set_request_id("own");
  *request.mutable_room() = Designed().layout().graph().room();
  const auto made = documents_->Create(request, call_);
  ASSERT_TRUE(made.ok()) << made.status();
  auto last = Act(made->document(), [](v1::ActRequest& act) { AddLamp(1.2, 1.7, *act.mutable_edit()); });
  ASSERT_TRUE(last.ok()) << last.status();
  last = Act(last->document(), [](v1::ActRequest& act) { AddLamp(2.7, 3.1, *act.mutable_edit()); });
  ASSERT_TRUE(last.ok()) << last.status();
  last = Settle(last->document());
  ASSERT_TRUE(last.ok()) << last.status();
  const v1::SolvedLayout layout = Get(made->document().id()).layout();
  EXPECT_EQ(PlacementOf(layout, "floor_lamp").x_m(), 1.2);
  EXPECT_EQ(PlacementOf(layout, "floor_lamp_2").y_m(), 3.1);
  EXPECT_THAT(layout.graph().pinned_placements(), IsEmpty());
}

TEST_F(HandPlacedTest, AnActThatChangesNothingAddsNoStepAndSaysSo) {
  const v1::GetDocumentResponse made = Designed();
  const std::string wardrobe = IdOf(made.layout(), "wardrobe");
  const auto same = Move(made.document(), PlacementOf(made.layout(), wardrobe));
  ASSERT_TRUE(same.ok()) << same.status();
  EXPECT_EQ(same->document().undo_label(), "");
  ASSERT_EQ(same->diagnostics_size(), 1);
  EXPECT_THAT(same->diagnostics(0).message(), HasSubstr("Nothing was changed"));
  // What was put into the middle of the room keeps a wish unmet; settled, it stays so.
  auto last = Move(same->document(), Inward(PlacementOf(made.layout(), wardrobe)));
  ASSERT_TRUE(last.ok()) << last.status();
  for (int i = 0; i < 3; ++i) {
    const std::string before = last->document().undo_label();
    const std::string layout = last->document().layout_id();
    const auto again = Settle(last->document());
    if (absl::IsFailedPrecondition(again.status())) return;
    ASSERT_TRUE(again.ok()) << again.status();
    EXPECT_FALSE(again->document().unsettled());
    last = again;
    if (again->document().layout_id() != layout) continue;
    EXPECT_EQ(again->document().undo_label(), before);
    EXPECT_THAT(again->diagnostics().rbegin()->message(), HasSubstr("Nothing moved"));
    EXPECT_THAT(again->diagnostics().rbegin()->message(), HasSubstr("the wardrobe stays where you put it"));
    return;
  }
  FAIL() << "settling never comes to an end";
}

TEST_F(HandPlacedTest, WhatFollowsAPieceStaysWhereThereIsNoRoomForItBesideIt) {
  const v1::GetDocumentResponse made = Designed("A home office that is 3.5m x 4m.", 3);
  const std::string desk = IdOf(made.layout(), "desk"), chair = IdOf(made.layout(), "chair");
  v1::Placement turned = PlacementOf(made.layout(), desk);
  turned.set_theta_rad(turned.theta_rad() + M_PI);
  const auto last = Move(made.document(), turned);
  ASSERT_TRUE(last.ok()) << last.status();
  EXPECT_EQ(PlacementOf(last->layout(), chair).SerializeAsString(),
            PlacementOf(made.layout(), chair).SerializeAsString())
      << "it would be in the wall that the desk stands at";
  const std::string lamp = IdOf(made.layout(), "desk lamp");
  EXPECT_NE(PlacementOf(last->layout(), lamp).x_m(), PlacementOf(made.layout(), lamp).x_m());
  for (const v1::Finding& one : last->layout().metrics().findings()) EXPECT_NE(one.kind(), v1::FINDING_KIND_OUTSIDE);
  const auto undone = Act(last->document(), [](v1::ActRequest& act) { act.mutable_undo(); });
  ASSERT_TRUE(undone.ok()) << undone.status();
  v1::Placement off_wall = PlacementOf(made.layout(), desk);
  off_wall.set_x_m(off_wall.x_m() +
                   0.3 * (made.layout().graph().room().floor().vertices(2).x_m() / 2 > off_wall.x_m() ? 1 : -1));
  const auto aside = Move(undone->document(), off_wall);
  ASSERT_TRUE(aside.ok()) << aside.status();
  EXPECT_NEAR(PlacementOf(aside->layout(), chair).x_m() - PlacementOf(made.layout(), chair).x_m(),
              off_wall.x_m() - PlacementOf(made.layout(), desk).x_m(), 1e-9)
      << "there is room for it";
}

}  // namespace
}  // namespace flair::session
