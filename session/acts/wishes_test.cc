// SPDX-License-Identifier: GPL-3.0-or-later
// What is said, weighed, dropped, added and taken away.
#include <gmock/gmock.h>

#include <algorithm>

#include "cli/output/artifact_text.h"
#include "google/protobuf/text_format.h"
#include "session/sentences/sentences.h"
#include "session/testing/documents_for_test.h"

namespace flair::session {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// Two beds with their heads at the north wall of a room that is 0.3 m too narrow for what is wished at their sides.
constexpr char kTwoBeds[] = R"pb(
  graph {
    room {
      room_type: "bedroom"
      title: "Two beds"
      floor {
        vertices {}
        vertices { x_m: 3.2 }
        vertices { x_m: 3.2 y_m: 4 }
        vertices { y_m: 4 }
      }
      walls { name: "south" }
      walls { name: "east" }
      walls { name: "north" }
      walls { name: "west" }
      height_m: 2.6
      openings {
        id: "door_1"
        kind: OPENING_KIND_DOOR
        wall: "south"
        offset_m: 1.2
        width_m: 0.8
        head_height_m: 2.1
        leaf { hinge: HINGE_SIDE_START swing: DOOR_SWING_OUTWARD swing_angle_rad: 1.5707963 }
      }
    }
    zone_plan { zones { id: "sleeping" name: "sleeping" } }
    object_list {
      objects {
        id: "bed_1"
        name: "bed"
        role: OBJECT_ROLE_PRIMARY
        kind: OBJECT_KIND_FLOOR
        zone_id: "sleeping"
        width_m: 0.9
        depth_m: 2
        height_m: 0.6
      }
      objects {
        id: "bed_2"
        name: "bed"
        role: OBJECT_ROLE_SECONDARY
        kind: OBJECT_KIND_FLOOR
        zone_id: "sleeping"
        width_m: 0.9
        depth_m: 2
        height_m: 0.6
      }
    }
    constraint_list {
      sentences { id: "s1" text: "The first bed is against the north wall." weight: 2 scope: SENTENCE_SCOPE_INTRA }
      sentences { id: "s2" text: "The second bed is against the north wall." weight: 2 scope: SENTENCE_SCOPE_INTRA }
      sentences { id: "s3" text: "One gets to the first bed from both sides." weight: 2 scope: SENTENCE_SCOPE_INTRA }
      sentences { id: "s4" text: "One gets to the second bed from the wall." weight: 2 scope: SENTENCE_SCOPE_INTRA }
    }
    edges {
      id: "e1"
      type: "against_wall"
      weight: 2
      sentence_id: "s1"
      arguments {
        name: "object"
        value { text: "bed_1" }
      }
      arguments {
        name: "wall"
        value { text: "north" }
      }
    }
    edges {
      id: "e2"
      type: "against_wall"
      weight: 2
      sentence_id: "s2"
      arguments {
        name: "object"
        value { text: "bed_2" }
      }
      arguments {
        name: "wall"
        value { text: "north" }
      }
    }
    edges {
      id: "e3"
      type: "accessible"
      weight: 2
      sentence_id: "s3"
      arguments {
        name: "object"
        value { text: "bed_1" }
      }
      arguments {
        name: "sides"
        value { texts { items: "left" items: "right" } }
      }
      arguments {
        name: "min_clearance_m"
        value { number: 0.55 }
      }
    }
    edges {
      id: "e4"
      type: "accessible"
      weight: 2
      sentence_id: "s4"
      arguments {
        name: "object"
        value { text: "bed_2" }
      }
      arguments {
        name: "sides"
        value { texts { items: "left" } }
      }
      arguments {
        name: "min_clearance_m"
        value { number: 0.6 }
      }
    }
  }
  placements { object_id: "bed_1" x_m: 1.0 y_m: 3 theta_rad: 3.14159265358979 }
  placements { object_id: "bed_2" x_m: 2.15 y_m: 3 theta_rad: 3.14159265358979 }
)pb";

v1::Object Named(const std::string& name, double width_m, double depth_m, double height_m) {
  v1::Object object;
  object.set_name(name);
  object.set_kind(v1::OBJECT_KIND_FLOOR);
  object.set_width_m(width_m);
  object.set_depth_m(depth_m);
  object.set_height_m(height_m);
  return object;
}

class WishesTest : public DocumentsTest {
 protected:
  // Bed 1 has 0.55 m at the west and 0.25 m before bed 2, which has 0.60 m at the east.
  v1::GetDocumentResponse TwoBeds() {
    // Both look south: their left is in the east.
    v1::Artifact artifact;
    EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(kTwoBeds, artifact.mutable_solved_layout()));
    const orchestrator::StageChannels& channels = services_->stages();
    Stages stages({.orchestrator = services_->orchestrator(),
                   .translator = channels.translator.channel,
                   .optimizer = channels.optimizer.channel,
                   .renderer = channels.renderer.channel});
    *artifact.mutable_solved_layout() =
        *LayoutActs(stages, nullptr).Evaluated(std::move(*artifact.mutable_solved_layout()), call_);
    artifact.mutable_producer()->set_program("test");
    artifact.mutable_producer()->set_version("1");
    v1::CreateDocumentRequest request;
    request.set_request_id("two beds");
    request.set_file(cli::ArtifactBytes(artifact));
    const auto made = documents_->Create(request, call_);
    EXPECT_TRUE(made.ok()) << made.status();
    return Get(made->document().id());
  }

  absl::StatusOr<v1::ActResponse> Weigh(const v1::Document& document, const std::string& sentence, double weight) {
    return Act(document, [&](v1::ActRequest& act) {
      act.mutable_weigh()->set_sentence_id(sentence);
      act.mutable_weigh()->set_weight(weight);
    });
  }

  IdSet Unmet(const v1::Document& document) {
    v1::GetDocumentResponse now = Get(document.id());
    return UnmetSentences(now.layout());
  }

  static const v1::Diagnostic* Told(const v1::ActResponse& response, const std::string& code) {
    for (const v1::Diagnostic& one : response.diagnostics()) {
      if (one.code() == code) return &one;
    }
    return nullptr;
  }
};

TEST_F(WishesTest, WhatWeighsMoreTakesItsRoomFromWhatCompetes) {
  const v1::GetDocumentResponse made = TwoBeds();
  ASSERT_THAT(Unmet(made.document()), ::testing::ElementsAre("s3"));
  const auto weighed = Weigh(made.document(), "s3", 32);
  ASSERT_TRUE(weighed.ok()) << weighed.status();
  EXPECT_FALSE(Unmet(weighed->document()).contains("s3")) << weighed->layout().DebugString();
  EXPECT_THAT(weighed->moved_object_ids(), Not(IsEmpty()));
  EXPECT_EQ(Told(*weighed, "weighed_in_vain"), nullptr);
  // What holds already needs nothing.
  const auto again = Weigh(weighed->document(), "s3", 40);
  ASSERT_TRUE(again.ok()) << again.status();
}

TEST_F(WishesTest, WhatIsDroppedLeavesItsRoomToOthers) {
  const v1::GetDocumentResponse made = TwoBeds();
  ASSERT_THAT(Unmet(made.document()), ::testing::ElementsAre("s3"));
  const auto dropped = Weigh(made.document(), "s4", 0);
  ASSERT_TRUE(dropped.ok()) << dropped.status();
  EXPECT_THAT(Unmet(dropped->document()), IsEmpty());
}

TEST_F(WishesTest, WhatIsWeighedInVainSaysWhatStandsAgainstIt) {
  v1::GetDocumentResponse made = TwoBeds();
  const auto locked = Act(made.document(), [](v1::ActRequest& act) {
    act.mutable_edit()->set_without_solving(true);
    act.mutable_edit()->add_edits()->set_pin_object_id("bed_1");
    act.mutable_edit()->add_edits()->set_pin_object_id("bed_2");
  });
  ASSERT_TRUE(locked.ok()) << locked.status();
  const auto weighed = Weigh(locked->document(), "s3", 32);
  ASSERT_TRUE(weighed.ok()) << weighed.status();
  EXPECT_THAT(weighed->moved_object_ids(), IsEmpty());
  ASSERT_NE(Told(*weighed, "weighed_in_vain"), nullptr);
  EXPECT_THAT(Told(*weighed, "weighed_in_vain")->message(), HasSubstr("is locked"));
  const auto less = Weigh(made.document(), "s1", 3);
  EXPECT_FALSE(less.ok()) << "on an older revision";
  const auto held = Weigh(weighed->document(), "s1", 3);
  ASSERT_TRUE(held.ok()) << held.status();
}

TEST_F(WishesTest, WhatIsSaidOutweighsWhatNobodyAskedFor) {
  const v1::GetDocumentResponse made = TwoBeds();
  const auto said = Act(made.document(), [](v1::ActRequest& act) {
    act.mutable_say()->set_text("The first bed is against the south wall.");
  });
  ASSERT_TRUE(said.ok()) << said.status();
  const v1::ConstraintEdge& edge = *said->layout().graph().edges().rbegin();
  EXPECT_GT(edge.weight(), 2);
  EXPECT_FALSE(Unmet(said->document()).contains(edge.sentence_id()));
  EXPECT_LT(PlacementOf(said->layout(), "bed_1").y_m(), 2);
}

TEST_F(WishesTest, AWishThatCannotHoldAnyMoreIsDroppedForALaterOneOfItsKind) {
  const v1::GetDocumentResponse made = TwoBeds();
  const auto say = [&](const v1::Document& document, const char* text) {
    return Act(document, [&](v1::ActRequest& act) { act.mutable_say()->set_text(text); });
  };
  const auto south = say(made.document(), "The first bed is against the south wall.");
  ASSERT_TRUE(south.ok()) << south.status();
  const std::string dropped = south->layout().graph().constraint_list().sentences().rbegin()->id();
  const auto north = say(south->document(), "The first bed is against the north wall.");
  ASSERT_TRUE(north.ok()) << north.status();
  ASSERT_NE(Told(*north, "said_otherwise"), nullptr);
  EXPECT_THAT(Told(*north, "said_otherwise")->message(), HasSubstr("The first bed is against the south wall."));
  EXPECT_GT(PlacementOf(north->layout(), "bed_1").y_m(), 2);
  const v1::LayoutGraph& graph = north->layout().graph();
  EXPECT_EQ(ObjectsOf({dropped}, graph), IdSet()) << "its constraint is gone";
  EXPECT_FALSE(IdsOf(graph.constraint_list().sentences()).contains(dropped));
  EXPECT_EQ(graph.edges_size(), north->layout().edge_outcomes_size());
  // What is said of another piece, or in another respect, stays.
  const auto other = say(north->document(), "The second bed is against the south wall.");
  ASSERT_TRUE(other.ok()) << other.status();
  EXPECT_EQ(Told(*other, "said_otherwise"), nullptr);
}

TEST_F(WishesTest, AUseThatIsDroppedCountsNoMore) {
  const v1::GetDocumentResponse made = Designed();
  const IdSet uses = UsesOf(made.layout().graph());
  const auto& edges = made.layout().graph().edges();
  const auto edge = std::ranges::find_if(edges, [&](const auto& one) { return uses.contains(one.sentence_id()); });
  ASSERT_NE(edge, edges.end());
  const auto dropped = Weigh(made.document(), edge->sentence_id(), 0);
  ASSERT_TRUE(dropped.ok()) << dropped.status();
  EXPECT_EQ(dropped->layout().metrics().use_count(), made.layout().metrics().use_count() - 1);
}

TEST_F(WishesTest, ANameThatSeveralHaveMeansTheSelectedOne) {
  const v1::GetDocumentResponse made = TwoBeds();
  const auto said = Act(made.document(), [](v1::ActRequest& act) {
    act.mutable_say()->set_text("The bed is against the south wall.");
    act.mutable_say()->add_selected_object_ids("bed_2");
  });
  ASSERT_TRUE(said.ok()) << said.status();
  EXPECT_LT(PlacementOf(said->layout(), "bed_2").y_m(), 2);
  EXPECT_GT(PlacementOf(said->layout(), "bed_1").y_m(), 2);
  EXPECT_EQ(said->layout().graph().object_list().objects_size(), 2);
  const auto asked =
      Act(said->document(), [](v1::ActRequest& act) { act.mutable_say()->set_text("The bed faces the door."); });
  if (!asked.ok()) EXPECT_THAT(std::string(asked.status().message()), Not(HasSubstr("bed_1")));
}

TEST_F(WishesTest, WhatHasNoPlaceIsNotMeantWhereItsLikeHasOneAndGoesWhenItIsAdded) {
  v1::GetDocumentResponse made = TwoBeds();
  v1::SolvedLayout layout = made.layout();
  layout.mutable_graph()->mutable_object_list()->mutable_objects(1)->set_name("wardrobe");
  layout.mutable_graph()->mutable_style_sheet()->add_objects()->set_subject_id("bed_2");
  auto& placements = *layout.mutable_placements();
  placements.erase(placements.begin() + 1);
  v1::Artifact artifact;
  *artifact.mutable_solved_layout() = layout;
  artifact.mutable_producer()->set_program("test");
  artifact.mutable_producer()->set_version("1");
  v1::CreateDocumentRequest request;
  request.set_request_id("left out");
  request.set_file(cli::ArtifactBytes(artifact));
  const auto opened = documents_->Create(request, call_);
  ASSERT_TRUE(opened.ok()) << opened.status();
  const auto added = Act(opened->document(), [](v1::ActRequest& act) {
    *act.mutable_edit()->add_edits()->mutable_add_object()->mutable_object() = Named("wardrobe", 1, 0.6, 2);
  });
  ASSERT_TRUE(added.ok()) << added.status();
  ASSERT_EQ(added->layout().graph().object_list().objects_size(), 2) << "one wardrobe, and no number for it";
  const std::string wardrobe = IdOf(added->layout(), "wardrobe");
  const auto said = Act(added->document(), [](v1::ActRequest& act) {
    act.mutable_say()->set_text("The wardrobe is against the south wall.");
  });
  ASSERT_TRUE(said.ok()) << said.status();
  EXPECT_LT(PlacementOf(said->layout(), wardrobe).y_m(), 1);
}

TEST_F(WishesTest, AnAddedPieceStandsWhereItsKindDoes) {
  const v1::GetDocumentResponse made = Designed();
  const auto added = Act(made.document(), [](v1::ActRequest& act) {
    *act.mutable_edit()->add_edits()->mutable_add_object()->mutable_object() = Named("bookshelf", 0.8, 0.3, 1.8);
  });
  ASSERT_TRUE(added.ok()) << added.status();
  const v1::GetDocumentResponse now = Get(made.document().id());
  const v1::Placement at = PlacementOf(now.layout(), "bookshelf");
  const double off_m = std::min({at.x_m(), 4 - at.x_m(), at.y_m(), 5 - at.y_m()}) - 0.15;
  EXPECT_LT(off_m, 0.03);
  EXPECT_EQ(now.layout().metrics().findings_size(), made.layout().metrics().findings_size());
  EXPECT_THAT(added->moved_object_ids(), ::testing::ElementsAre("bookshelf"));
  int said = 0;
  for (const v1::Sentence& one : now.layout().graph().constraint_list().sentences()) {
    said += std::ranges::find(one.subject_ids(), "bookshelf") != one.subject_ids().end();
  }
  EXPECT_GT(said, 0);
  // And so it does when it was dropped in mid-room and is settled.
  const auto undone = Act(added->document(), [](v1::ActRequest& act) { act.mutable_undo(); });
  const auto dropped = Act(undone->document(), [](v1::ActRequest& act) {
    act.mutable_edit()->set_without_solving(true);
    *act.mutable_edit()->add_edits()->mutable_add_object()->mutable_object() = Named("bookshelf", 0.8, 0.3, 1.8);
  });
  ASSERT_TRUE(dropped.ok()) << dropped.status();
  EXPECT_TRUE(dropped->document().unsettled());
  const auto settled = Act(dropped->document(), [](v1::ActRequest& act) { act.mutable_settle(); });
  ASSERT_TRUE(settled.ok()) << settled.status();
}

TEST_F(WishesTest, ACopyStandsFreeBesideItsOriginal) {
  const v1::GetDocumentResponse made = Designed();
  const std::string wardrobe = IdOf(made.layout(), "wardrobe");
  const v1::Placement from = PlacementOf(made.layout(), wardrobe);
  const auto copied = Act(made.document(), [&](v1::ActRequest& act) {
    act.mutable_edit()->set_without_solving(true);
    v1::Object& copy = *act.mutable_edit()->add_edits()->mutable_add_object()->mutable_object();
    for (const v1::Object& object : made.layout().graph().object_list().objects()) {
      if (object.id() == wardrobe) copy = object;
    }
    copy.set_id("copy");
    v1::Placement& at = *act.mutable_edit()->add_edits()->mutable_move_object();
    at = from;
    at.set_object_id("copy");
    at.set_x_m(from.x_m() + 0.2);
  });
  ASSERT_TRUE(copied.ok()) << copied.status();
  const v1::Placement at = PlacementOf(copied->layout(), "copy");
  EXPECT_LT(std::hypot(at.x_m() - from.x_m(), at.y_m() - from.y_m()), 3);
  EXPECT_LT(copied->layout().metrics().deepest_overlap_m(), 1e-6);
}

TEST_F(WishesTest, APieceThatIsLeftWithoutItsUseIsNamed) {
  const v1::GetDocumentResponse made = Designed();
  const std::string desk = IdOf(made.layout(), "desk"), chair = IdOf(made.layout(), "chair");
  const auto removed =
      Act(made.document(), [&](v1::ActRequest& act) { act.mutable_edit()->add_edits()->set_remove_object_id(desk); });
  ASSERT_TRUE(removed.ok()) << removed.status();
  ASSERT_NE(Told(*removed, "left_behind"), nullptr);
  EXPECT_EQ(Told(*removed, "left_behind")->subject_id(), chair);
  std::set<std::string> spoken;
  for (const v1::ConstraintEdge& edge : removed->layout().graph().edges()) spoken.insert(edge.sentence_id());
  for (const v1::Sentence& one : removed->layout().graph().constraint_list().sentences()) {
    EXPECT_TRUE(spoken.contains(one.id())) << one.text();
  }
}

}  // namespace
}  // namespace flair::session
