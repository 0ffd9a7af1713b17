// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>

#include "session/layouts/lists.h"
#include "session/testing/documents_for_test.h"

namespace flair::session {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class ReplacingTest : public DocumentsTest {};

TEST_F(ReplacingTest, APieceOfAnotherClassKeepsOnlyWhatTheUserSaid) {
  const v1::GetDocumentResponse made = Designed("A bedroom that is 4m x 5m with a desk.", 3);
  const std::string id = IdOf(made.layout(), "wardrobe");
  const auto said = Act(made.document(), [](v1::ActRequest& act) {
    act.mutable_say()->set_text("The wardrobe is against the north wall.");
  });
  ASSERT_TRUE(said.ok()) << said.status();
  for (const bool without_solving : {true, false}) {
    SCOPED_TRACE(without_solving);
    const v1::Document now = Get(made.document().id()).document();
    const v1::SolvedLayout before = Get(made.document().id()).layout();
    const auto replaced = Act(now, [&](v1::ActRequest& act) {
      act.mutable_replace()->set_object_id(id);
      act.mutable_replace()->set_without_solving(without_solving);
      v1::Object& shelf = *act.mutable_replace()->mutable_by();
      shelf.set_name("bookshelf");
      shelf.set_kind(v1::OBJECT_KIND_FLOOR);
      shelf.set_width_m(0.8);
      shelf.set_depth_m(0.3);
      shelf.set_height_m(1.9);
      shelf.set_category("shelf");
    });
    ASSERT_TRUE(replaced.ok()) << replaced.status();
    const v1::SolvedLayout after = Get(made.document().id()).layout();
    bool of_shelf = false, of_user = false;
    const auto& sentences = after.graph().constraint_list().sentences();
    for (const v1::ConstraintEdge& edge : after.graph().edges()) {
      if (!ObjectsOf(edge, after.graph()).contains(id)) continue;
      const auto one = std::ranges::find(sentences, edge.sentence_id(), &v1::Sentence::id);
      ASSERT_TRUE(one != sentences.end());
      const bool user = one->origin() == v1::SENTENCE_ORIGIN_BRIEF;
      of_user = of_user || user;
      of_shelf = of_shelf || one->text().find("bookshelf") != std::string::npos;
      EXPECT_THAT(one->text(), Not(HasSubstr("wardrobe")));
    }
    EXPECT_TRUE(of_user);
    EXPECT_TRUE(of_shelf);
    for (const v1::Placement& at : before.placements()) {
      if (without_solving && at.object_id() != id) {
        EXPECT_EQ(PlacementOf(after, at.object_id()).SerializeAsString(), at.SerializeAsString());
      }
    }
    ASSERT_TRUE(Act(replaced->document(), [](v1::ActRequest& act) { act.mutable_undo(); }).ok());
  }
}

TEST_F(ReplacingTest, WhatTheUserWishedInVainOfThePieceIsGoneWithIt) {
  const v1::GetDocumentResponse made = Designed("A bedroom that is 4m x 5m with a desk.", 3);
  const std::string id = IdOf(made.layout(), "wardrobe"), bed = IdOf(made.layout(), "bed");
  auto last =
      Act(made.document(), [&](v1::ActRequest& act) { act.mutable_edit()->add_edits()->set_pin_object_id(id); });
  ASSERT_TRUE(last.ok()) << last.status();
  last = Act(last->document(),
             [](v1::ActRequest& act) { act.mutable_say()->set_text("The wardrobe is in the middle of the room."); });
  ASSERT_TRUE(last.ok()) << last.status();
  const auto in_vain = [](const v1::SolvedLayout& layout) {
    return std::ranges::any_of(layout.graph().constraint_list().sentences(), [](const v1::Sentence& one) {
      return one.text().find("middle of the room") != std::string::npos;
    });
  };
  ASSERT_TRUE(in_vain(Get(made.document().id()).layout()));
  last = Act(last->document(), [&](v1::ActRequest& act) {
    act.mutable_replace()->set_object_id(id);
    v1::Object& shelf = *act.mutable_replace()->mutable_by();
    shelf.set_name("bookshelf");
    shelf.set_kind(v1::OBJECT_KIND_FLOOR);
    shelf.set_width_m(0.8);
    shelf.set_depth_m(0.3);
    shelf.set_height_m(1.9);
    shelf.set_category("shelf");
  });
  ASSERT_TRUE(last.ok()) << last.status();
  EXPECT_FALSE(in_vain(Get(made.document().id()).layout()));
}

TEST_F(ReplacingTest, APieceThatIsRenamedKeepsWhatIsSaidOfIt) {
  const v1::GetDocumentResponse made = Designed();
  const auto renamed = Act(made.document(), [&](v1::ActRequest& act) {
    act.mutable_replace()->set_object_id(IdOf(made.layout(), "wardrobe"));
    act.mutable_replace()->set_without_solving(true);
    for (const v1::Object& object : made.layout().graph().object_list().objects()) {
      if (object.name() == "wardrobe") *act.mutable_replace()->mutable_by() = object;
    }
    act.mutable_replace()->mutable_by()->set_name("Anna's wardrobe");
  });
  ASSERT_TRUE(renamed.ok()) << renamed.status();
  EXPECT_EQ(renamed->layout().graph().edges_size(), made.layout().graph().edges_size());
}

}  // namespace
}  // namespace flair::session
