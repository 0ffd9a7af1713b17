// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "session/layouts/lists.h"
#include "session/testing/documents_for_test.h"

namespace flair::session {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class SettlingTest : public DocumentsTest {
 protected:
  absl::StatusOr<v1::ActResponse> Move(const v1::Document& document, const v1::Placement& to) {
    return Act(document, [&](v1::ActRequest& act) { *act.mutable_move()->add_placements() = to; });
  }
  absl::StatusOr<v1::ActResponse> Settle(const v1::Document& document) {
    return Act(document, [](v1::ActRequest& act) { act.mutable_settle(); });
  }

  // Where a piece is in everybody's way.
  static v1::Placement BeforeTheDoor(const v1::Room& room, v1::Placement at) {
    constexpr double kInto_m = 0.5;
    const auto door = std::ranges::find(room.openings(), v1::OPENING_KIND_DOOR, &v1::Opening::kind);
    const auto wall = std::ranges::find(room.walls(), door->wall(), &v1::Wall::name);
    const int i = static_cast<int>(wall - room.walls().begin());
    const v1::Point2& a = room.floor().vertices(i);
    const v1::Point2& b = room.floor().vertices((i + 1) % room.floor().vertices_size());
    const double length_m = std::hypot(b.x_m() - a.x_m(), b.y_m() - a.y_m());
    const double x = (b.x_m() - a.x_m()) / length_m, y = (b.y_m() - a.y_m()) / length_m;
    const double along_m = door->offset_m() + door->width_m() / 2;
    at.set_x_m(a.x_m() + x * along_m - y * kInto_m);
    at.set_y_m(a.y_m() + y * along_m + x * kInto_m);
    at.set_theta_rad(std::atan2(y, x));
    return at;
  }
};

TEST_F(SettlingTest, WhatIsInTheDoorsWayGivesWayUnlessItWasPutThere) {
  const v1::GetDocumentResponse made = Designed("A bedroom that is 4m x 5m with a wardrobe.");
  const v1::Room& room = made.layout().graph().room();
  const std::string wardrobe = IdOf(made.layout(), "wardrobe");
  const auto moved = Move(made.document(), BeforeTheDoor(room, PlacementOf(made.layout(), wardrobe)));
  ASSERT_TRUE(moved.ok()) << moved.status();
  const v1::LayoutMetrics& blocked = moved->layout().metrics();
  ASSERT_GT(blocked.findings_size(), 0);
  EXPECT_EQ(blocked.findings(0).message(), "nobody gets into the room: the wardrobe is in the way of the door");
  EXPECT_LT(blocked.met_use_count(), made.layout().metrics().met_use_count() - 1);
  auto last = Settle(moved->document());
  ASSERT_TRUE(last.ok()) << last.status();
  EXPECT_THAT(last->answer(), HasSubstr("nobody gets into the room: the wardrobe is in the way of the door (the "
                                        "wardrobe stays where you put it)"));
  // Nothing moves since, but it is not held any more.
  for (const bool locks : {true, false}) {
    last = Act(last->document(), [&](v1::ActRequest& act) {
      act.mutable_edit()->set_without_solving(true);
      v1::LayoutEdit& edit = *act.mutable_edit()->add_edits();
      locks ? edit.set_pin_object_id(wardrobe) : edit.set_unpin_object_id(wardrobe);
    });
    ASSERT_TRUE(last.ok()) << last.status();
  }
  last = Settle(last->document());
  ASSERT_TRUE(last.ok()) << last.status();
  EXPECT_THAT(last->answer(), StartsWith("Moved "));
  EXPECT_THAT(last->answer(), HasSubstr("wardrobe"));
  for (const v1::Finding& one : last->layout().metrics().findings()) {
    EXPECT_THAT(one.message(), Not(HasSubstr("nobody gets")));
  }
}

TEST_F(SettlingTest, NothingMovesForNothing) {
  const v1::GetDocumentResponse made = Designed("A living room that is 5m x 6m.", 3);
  v1::Document document = made.document();
  for (const char* name : {"armchair", "coffee table", "side table"}) {
    v1::Placement at = PlacementOf(Get(document.id()).layout(), IdOf(made.layout(), name));
    at.set_x_m(at.x_m() + (at.x_m() < 2.5 ? 0.4 : -0.4));
    const auto moved = Move(document, at);
    ASSERT_TRUE(moved.ok()) << moved.status();
    const auto settled = Settle(moved->document());
    ASSERT_TRUE(settled.ok() || absl::IsFailedPrecondition(settled.status())) << settled.status();
    document = Get(document.id()).document();
    if (!settled.ok()) continue;
    EXPECT_NE(settled->answer(), "");
    const auto unmet = [](const v1::SolvedLayout& layout) {
      return std::ranges::count_if(layout.edge_outcomes(), [](const v1::EdgeOutcome& outcome) {
        return outcome.status() != v1::OUTCOME_STATUS_SATISFIED;
      });
    };
    if (settled->moved_object_ids_size() > 0) {
      EXPECT_LE(settled->layout().metrics().findings_size(), moved->layout().metrics().findings_size()) << name;
    } else {
      EXPECT_EQ(unmet(settled->layout()), unmet(moved->layout())) << name;
      EXPECT_THAT(settled->answer(), StartsWith("Nothing moved: ")) << name;
    }
  }
}

TEST_F(SettlingTest, WhatIsDroppedMovesNothingForNothing) {
  constexpr size_t kTried = 8;
  const v1::GetDocumentResponse made = Designed("A living room that is 5m x 6m.", 3);
  std::set<std::string> sentences;
  for (const v1::ConstraintEdge& edge : made.layout().graph().edges()) {
    if (sentences.size() < kTried) sentences.insert(edge.sentence_id());
  }
  const auto unmet = [](const v1::SolvedLayout& layout, const std::string& but) {
    int count = 0;
    for (int i = 0; i < layout.edge_outcomes_size(); ++i) {
      count += layout.edge_outcomes(i).status() != v1::OUTCOME_STATUS_SATISFIED &&
               layout.graph().edges(i).sentence_id() != but;
    }
    return count;
  };
  v1::Document document = made.document();
  for (const std::string& sentence : sentences) {
    const auto dropped = Act(document, [&](v1::ActRequest& act) { act.mutable_weigh()->set_sentence_id(sentence); });
    ASSERT_TRUE(dropped.ok()) << dropped.status();
    EXPECT_FALSE(dropped->document().unsettled());
    const v1::SolvedLayout now = Get(document.id()).layout();
    if (dropped->moved_object_ids_size() > 0) {
      EXPECT_LT(unmet(now, ""), unmet(made.layout(), sentence)) << sentence;
    }
    document = Act(dropped->document(), [](v1::ActRequest& act) { act.mutable_undo(); })->document();
  }
}

TEST_F(SettlingTest, WordsMoveNothingThatIsLocked) {
  const v1::GetDocumentResponse made = Designed();
  const std::string wardrobe = IdOf(made.layout(), "wardrobe");
  const auto locked =
      Act(made.document(), [&](v1::ActRequest& act) { act.mutable_edit()->add_edits()->set_pin_object_id(wardrobe); });
  ASSERT_TRUE(locked.ok()) << locked.status();
  const auto moved = Act(locked->document(), [](v1::ActRequest& act) {
    act.mutable_say()->set_text("Move the wardrobe 30 cm to the left.");
  });
  EXPECT_THAT(moved.status().message(), HasSubstr("the wardrobe is locked"));
}

TEST_F(SettlingTest, AHandOvertakesWhatWasSaidOfAPieceBefore) {
  const v1::GetDocumentResponse made = Designed("A bedroom that is 4m x 5m with an armchair.");
  const std::string chair = IdOf(made.layout(), "armchair");
  const auto said = Act(made.document(), [](v1::ActRequest& act) {
    act.mutable_say()->set_text("The armchair is against the west wall.");
  });
  ASSERT_TRUE(said.ok()) << said.status();
  const auto is_said = [](const v1::SolvedLayout& layout) {
    return std::ranges::any_of(layout.graph().constraint_list().sentences(), [](const v1::Sentence& one) {
      return one.text().find("west wall") != std::string::npos && one.reason().starts_with("you said");
    });
  };
  ASSERT_TRUE(is_said(Get(made.document().id()).layout()));
  v1::Placement to = PlacementOf(said->layout(), chair);
  to.set_x_m(to.x_m() + 0.8);
  for (const bool solving : {false, true}) {
    SCOPED_TRACE(solving);
    const v1::Document now = Get(made.document().id()).document();
    auto last =
        solving ? Act(now, [&](v1::ActRequest& act) { *act.mutable_edit()->add_edits()->mutable_move_object() = to; })
                : Move(now, to);
    ASSERT_TRUE(last.ok()) << last.status();
    EXPECT_FALSE(is_said(Get(made.document().id()).layout()));
    if (!solving) {
      last = Settle(last->document());
      ASSERT_TRUE(last.ok()) << last.status();
      EXPECT_FALSE(is_said(Get(made.document().id()).layout()));
    }
    EXPECT_EQ(PlacementOf(Get(made.document().id()).layout(), chair).x_m(), to.x_m());
    v1::Document document = Get(made.document().id()).document();
    while (document.undo_label() != said->document().undo_label()) {
      document = Act(document, [](v1::ActRequest& act) { act.mutable_undo(); })->document();
    }
    EXPECT_TRUE(is_said(Get(made.document().id()).layout())) << "and comes back with an undo";
  }
}

TEST_F(SettlingTest, ARugGoesAlongWithWhatItLiesUnder) {
  const v1::GetDocumentResponse made = Designed("A bedroom that is 5m x 6m with a rug under the bed.", 3);
  const std::string bed = IdOf(made.layout(), "bed"), rug = IdOf(made.layout(), "rug");
  const v1::Placement was = PlacementOf(made.layout(), rug), from = PlacementOf(made.layout(), bed);
  v1::Placement to = from;
  to.set_x_m(to.x_m() + (to.x_m() < 2.5 ? 0.3 : -0.3));
  auto last = Move(made.document(), to);
  ASSERT_TRUE(last.ok()) << last.status();
  EXPECT_NEAR(PlacementOf(last->layout(), rug).x_m() - was.x_m(), to.x_m() - from.x_m(), 1e-9);
  EXPECT_EQ(PlacementOf(last->layout(), rug).y_m(), was.y_m());
  last = Settle(last->document());
  ASSERT_TRUE(last.ok()) << last.status();
  EXPECT_NEAR(PlacementOf(last->layout(), rug).x_m() - was.x_m(), to.x_m() - from.x_m(), 0.1);
}

}  // namespace
}  // namespace flair::session
