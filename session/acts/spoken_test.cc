// SPDX-License-Identifier: GPL-3.0-or-later
// What is typed is done, and answered.
#include <gmock/gmock.h>

#include <algorithm>

#include "session/testing/documents_for_test.h"

namespace flair::session {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

class SpokenActsTest : public DocumentsTest {
 protected:
  void SetUp() override {
    DocumentsTest::SetUp();
    room_ = Designed();
  }

  absl::StatusOr<v1::ActResponse> Say(const std::string& text, const std::vector<std::string>& selected = {}) {
    auto said = Act(room_.document(), [&](v1::ActRequest& act) {
      act.mutable_say()->set_text(text);
      for (const std::string& id : selected) act.mutable_say()->add_selected_object_ids(id);
    });
    if (said.ok()) *room_.mutable_document() = said->document();
    return said;
  }

  static const v1::Object& ObjectIn(const v1::SolvedLayout& layout, const std::string& id) {
    for (const v1::Object& object : layout.graph().object_list().objects()) {
      if (object.id() == id) return object;
    }
    return v1::Object::default_instance();
  }

  v1::GetDocumentResponse room_;
};

TEST_F(SpokenActsTest, WhatIsAskedToGoGoesAndTheAnswerSaysSo) {
  const auto said = Say("get rid of the wardrobe");
  ASSERT_TRUE(said.ok()) << said.status();
  EXPECT_THAT(said->answer(), StartsWith("Removed the wardrobe."));
  EXPECT_EQ(IdOf(said->layout(), "wardrobe"), "");
  EXPECT_EQ(said->left_over(), "");
  const auto none = Say("no wardrobe");
  EXPECT_EQ(none.status().message(), "say.text: \"no wardrobe\" is not done: the room has no wardrobe");
  const auto undone = Say("undo that please");
  ASSERT_TRUE(undone.ok()) << undone.status();
  EXPECT_THAT(undone->answer(), StartsWith("Taken back: say \"get rid of the wardrobe\""));
  EXPECT_EQ(IdOf(undone->layout(), "wardrobe"), "wardrobe");
}

TEST_F(SpokenActsTest, ASizeIsSetAndToldWithTheOneBefore) {
  const double before_m = ObjectIn(room_.layout(), "wardrobe").width_m();
  const auto said = Say("make the wardrobe 10 cm wider");
  ASSERT_TRUE(said.ok()) << said.status();
  EXPECT_NEAR(ObjectIn(said->layout(), "wardrobe").width_m(), before_m + 0.1, 1e-9);
  EXPECT_THAT(said->answer(), StartsWith("The wardrobe is "));
  EXPECT_THAT(said->answer(), HasSubstr("m wide now (was "));
}

TEST_F(SpokenActsTest, EveryClauseIsDoneOrToldApart) {
  const auto said = Say("make the wardrobe 5 cm lower, remove the piano and lock the bed");
  ASSERT_TRUE(said.ok()) << said.status();
  EXPECT_THAT(said->answer(), HasSubstr("m high now"));
  EXPECT_THAT(said->answer(), HasSubstr("Locked the "));
  EXPECT_EQ(said->left_over(), "remove the piano");
  ASSERT_THAT(said->diagnostics(), Not(IsEmpty()));
  EXPECT_EQ(said->diagnostics().rbegin()->message(), "\"remove the piano\" is not done: the room has no piano");
  // It is one act.
  const auto undone = Say("undo");
  ASSERT_TRUE(undone.ok()) << undone.status();
  EXPECT_EQ(undone->document().undo_label(), "");
}

TEST_F(SpokenActsTest, MoreOfWhatIsThereIsLikeIt) {
  auto said = Say("make the wardrobe 10 cm narrower");
  ASSERT_TRUE(said.ok()) << said.status();
  const v1::Object wardrobe = ObjectIn(said->layout(), "wardrobe");
  said = Say("one more wardrobe please");
  ASSERT_TRUE(said.ok()) << said.status();
  EXPECT_THAT(said->answer(), StartsWith("Added a wardrobe."));
  EXPECT_EQ(ObjectIn(said->layout(), "wardrobe_2").width_m(), wardrobe.width_m());
  EXPECT_EQ(ObjectIn(said->layout(), "wardrobe_2").category(), wardrobe.category());
}

TEST_F(SpokenActsTest, TooManyAreToldOfAndAnEmptyRoomIsAllInReach) {
  const auto many = Say("add 500 chairs");
  EXPECT_THAT(many.status().message(), HasSubstr("at most 12 pieces are added at once"));
  EXPECT_FALSE(Say("8 more chairs and 5 more lamps").ok());
  auto said = Say("remove everything");
  ASSERT_TRUE(said.ok()) << said.status();
  EXPECT_EQ(said->answer(), "Removed everything.");
  EXPECT_EQ(said->layout().metrics().reachable_floor_share(), 1);
  said = Say("add 3 chairs");
  ASSERT_TRUE(said.ok()) << said.status();
  EXPECT_THAT(said->answer(), StartsWith("Added 3 "));
}

TEST_F(SpokenActsTest, PiecesMoveByWhatIsSaidAndAsFarAsTheyCan) {
  const v1::Placement before = PlacementOf(room_.layout(), "wardrobe");
  const auto middle = Act(room_.document(), [&](v1::ActRequest& act) {
    v1::Placement& to = *act.mutable_move()->add_placements();
    to = before;
    to.set_x_m(2);
    to.set_y_m(2.5);
  });
  ASSERT_TRUE(middle.ok()) << middle.status();
  *room_.mutable_document() = middle->document();
  auto said = Say("move it 12 cm to the right", {"wardrobe"});
  ASSERT_TRUE(said.ok()) << said.status();
  EXPECT_NEAR(PlacementOf(said->layout(), "wardrobe").x_m(), 2.12, 1e-9);
  EXPECT_THAT(said->answer(), StartsWith("Moved the wardrobe 12 cm to the east."));
  said = Say("rotate the wardrobe by 90 degrees");
  ASSERT_TRUE(said.ok()) << said.status();
  EXPECT_THAT(said->answer(), StartsWith("Turned the wardrobe by 90 degrees."));
  EXPECT_NEAR(std::abs(std::remainder(PlacementOf(said->layout(), "wardrobe").theta_rad() - before.theta_rad(), M_PI)),
              M_PI / 2, 1e-6);
}

TEST_F(SpokenActsTest, AWordThatFailedIsNamedAndExamplesAreOthersEachTime) {
  const auto first = Say("blorp the wardrobe"), second = Say("blorp the wardrobe");
  EXPECT_THAT(std::string(first.status().message()), HasSubstr("I do not know \"blorp\"; say for example \""));
  EXPECT_NE(first.status().message(), second.status().message());
}

TEST_F(SpokenActsTest, WhatAsksForAChangeIsNeverAWish) {
  const int before = room_.layout().graph().edges_size();
  for (const char* const text :
       {"Please remove the thing above the bed", "the thing at the left end of the bed should go",
        "get rid of that thing next to the bed", "swap places of whatever is near the window"}) {
    const auto said = Say(text);
    EXPECT_FALSE(said.ok()) << text << ": " << said->answer();
    EXPECT_THAT(std::string(said.status().message()), HasSubstr(" is not ")) << text;
  }
  EXPECT_EQ(Get(room_.document().id()).layout().graph().edges_size(), before);
}

TEST_F(SpokenActsTest, APieceIsFoundByItsPlace) {
  const auto said = Say("remove the nightstand on the left of the bed");
  ASSERT_TRUE(said.ok()) << said.status();
  EXPECT_THAT(said->answer(), StartsWith("Removed nightstand "));
  const auto which = Say("remove the thing near the wardrobe");
  EXPECT_FALSE(which.ok());
}

TEST_F(SpokenActsTest, SwappedPiecesStandSquareAtTheWallsThatTheyComeTo) {
  // Askew in its corner.
  const auto askew = Act(room_.document(), [&](v1::ActRequest& act) {
    v1::Placement& to = *act.mutable_move()->add_placements();
    to = PlacementOf(room_.layout(), "wardrobe");
    to.set_theta_rad(to.theta_rad() + 0.26);
  });
  ASSERT_TRUE(askew.ok()) << askew.status();
  *room_.mutable_document() = askew->document();
  const auto said = Say("swap the wardrobe and the dresser");
  if (!said.ok()) {
    EXPECT_THAT(std::string(said.status().message()), HasSubstr("cannot swap places"));
    return;
  }
  for (const char* const id : {"wardrobe", "dresser"}) {
    const double turn = std::remainder(PlacementOf(said->layout(), id).theta_rad(), M_PI / 2);
    EXPECT_NEAR(turn, 0, 0.03) << id;
  }
}

TEST_F(SpokenActsTest, ReasonsAndOtherBusinessAreNoWishes) {
  auto said = Say("get rid of the wardrobe, I do not like it");
  ASSERT_TRUE(said.ok()) << said.status();
  EXPECT_EQ(said->left_over(), "");
  EXPECT_THAT(said->diagnostics(),
              Not(::testing::Contains(::testing::Property(&v1::Diagnostic::message, HasSubstr("like it")))));
  said = Say("add a bookshelf for my books");
  ASSERT_TRUE(said.ok()) << said.status();
  EXPECT_EQ(said->left_over(), "");
  const auto paint = Say("Paint the walls dark blue and make the door lockable");
  EXPECT_EQ(
      paint.status().message(),
      "say.text: \"Paint the walls dark blue\" is not done: I only choose and place furniture, colours and surfaces "
      "are not mine to change; \"make the door lockable\" is not done: I only choose and place furniture, doors, "
      "windows, walls and their locks are not mine to change");
}

TEST_F(SpokenActsTest, ExamplesAreOfTheVerbAndThePiece) {
  EXPECT_THAT(std::string(Say("swap the wardrobe blorp").status().message()),
              HasSubstr("say for example \"swap the wardrobe and "));
  EXPECT_THAT(std::string(Say("turn the wardrobe blorpwise").status().message()),
              HasSubstr("say for example \"rotate the wardrobe by 90 degrees\""));
}

TEST_F(SpokenActsTest, WhatIsLockedStaysAtWords) {
  ASSERT_TRUE(Say("lock the wardrobe").ok());
  const auto moved = Say("move the wardrobe 10 cm to the left");
  EXPECT_EQ(moved.status().message(),
            "say.text: \"move the wardrobe 10 cm to the left\" is not done: the wardrobe is locked; say \"unlock the "
            "wardrobe\" first");
}

TEST_F(SpokenActsTest, AnotherLayoutIsShown) {
  const auto said = Say("show me another layout");
  ASSERT_TRUE(said.ok()) << said.status();
  EXPECT_THAT(said->answer(), StartsWith("Here is another layout: "));
  EXPECT_THAT(said->moved_object_ids(), Not(IsEmpty()));
}

}  // namespace
}  // namespace flair::session
