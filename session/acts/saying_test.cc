// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "session/sentences/piece_wishes.h"
#include "session/testing/documents_for_test.h"

namespace flair::session {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// The names of the pieces and what is to be true, of a room with a sofa and a desk.
std::string Read(const std::string& text) {
  const auto object = [](const std::string& name) -> std::optional<v1::Object> {
    static const std::set<std::string> known = {"desk", "chair", "plant", "bookcase", "table lamp", "lamp", "sofa"};
    if (!known.contains(name)) return std::nullopt;
    v1::Object found;
    found.set_name(name);
    return found;
  };
  const Wishes wishes =
      ReadWishes(text, object, [](const std::string& name) { return name == "sofa" || name == "desk"; });
  std::string read;
  for (const PieceWish& piece : wishes.pieces) {
    read += "+" + piece.object.name() + (piece.goes_with < 0 ? "" : "@" + std::to_string(piece.goes_with)) + " ";
  }
  for (const WishedSentence& one : wishes.sentences) read += "[" + std::to_string(one.piece) + " " + one.text + "] ";
  for (const std::string& name : wishes.unknown) read += "?" + name + " ";
  if (!read.empty()) read.pop_back();
  return read;
}

TEST(PieceWishesTest, PiecesAndTheirPlacesAreReadFromWhatPeopleWrite) {
  EXPECT_EQ(Read("Add a desk"), "+desk");
  EXPECT_EQ(Read("please add another big desk."), "+desk");
  EXPECT_EQ(Read("Add a desk with a chair. The desk faces a window."), "+desk +chair@0 [-1 The desk faces a window.]");
  EXPECT_EQ(Read("put a plant in the corner"), "+plant [0 The {} is in the corner]");
  EXPECT_EQ(Read("I want a bookcase next to the sofa"), "+bookcase [0 The {} is next to the sofa]");
  EXPECT_EQ(Read("I'd like two chairs and a table lamp, please"), "+chair +chair +table lamp");
  EXPECT_EQ(Read("We need a chair that faces the sofa; add plants"), "+chair +plant [0 The {} faces the sofa]");
  EXPECT_EQ(Read("Add a chair and put it by the window"), "+chair [0 The {} is by the window]");
  EXPECT_EQ(Read("Add a bookcase. Place it 0.5 m from the door."), "+bookcase [0 The {} is 0.5 m from the door.]");
  EXPECT_EQ(Read("Add a gizmo"), "?gizmo");
}

TEST(PieceWishesTest, WhatIsSaidOfThePiecesOfTheRoomIsNoWishForMore) {
  EXPECT_EQ(Read("The desk faces a window."), "[-1 The desk faces a window.]");
  EXPECT_EQ(Read("Put the sofa against the north wall"), "[-1 Put the sofa against the north wall]");
  EXPECT_EQ(Read("I want the desk to face the window"), "[-1 I want the desk to face the window]");
  // What is not there is added, whichever article it has.
  EXPECT_EQ(Read("Put the plant behind the sofa"), "+plant [0 The {} is behind the sofa]");
  EXPECT_EQ(Read(""), "");
  EXPECT_EQ(Read("add"), "[-1 add]");
}

class SayingTest : public DocumentsTest {
 protected:
  v1::Document OwnRoom(const v1::GetDocumentResponse& like) {
    v1::CreateDocumentRequest request;
    request.set_request_id("own");
    *request.mutable_room() = like.layout().graph().room();
    return documents_->Create(request, call_)->document();
  }
  absl::StatusOr<v1::ActResponse> Say(const v1::Document& document, const std::string& text) {
    return Act(document, [&](v1::ActRequest& act) { act.mutable_say()->set_text(text); });
  }
  // What does not hold of all that was said.
  static std::vector<std::string> Unmet(const v1::SolvedLayout& layout) {
    std::vector<std::string> unmet;
    for (int i = 0; i < layout.edge_outcomes_size(); ++i) {
      const v1::ConstraintEdge& edge = layout.graph().edges(i);
      if (!edge.sentence_id().starts_with("said_")) continue;
      if (layout.edge_outcomes(i).status() != v1::OUTCOME_STATUS_SATISFIED) unmet.push_back(edge.ShortDebugString());
    }
    return unmet;
  }
};

TEST_F(SayingTest, PiecesThatTheRoomHasNotAreAddedAndPlacedInOneAct) {
  const v1::Document room = OwnRoom(Designed());
  const auto said = Say(room, "Add a desk with a chair. The desk faces a window.");
  ASSERT_TRUE(said.ok()) << said.status();
  EXPECT_EQ(said->document().undo_label(),
            "say \"Add a desk with a chair. The desk faces a window.\"; added: desk, desk chair");
  EXPECT_THAT(said->layout().graph().object_list().objects(), SizeIs(2));
  EXPECT_THAT(said->layout().placements(), SizeIs(2));
  EXPECT_EQ(std::ranges::count_if(said->layout().graph().constraint_list().sentences(),
                                  [](const v1::Sentence& one) { return one.id().starts_with("said_"); }),
            2);
  EXPECT_THAT(Unmet(said->layout()), IsEmpty());
  for (const v1::Diagnostic& remark : said->diagnostics())
    EXPECT_LT(remark.severity(), v1::SEVERITY_WARNING) << remark.message();
  const auto undone = Act(said->document(), [](v1::ActRequest& act) { act.mutable_undo(); });
  ASSERT_TRUE(undone.ok()) << undone.status();
  EXPECT_EQ(undone->document().undo_label(), "");
}

TEST_F(SayingTest, ASecondPieceOfANameAndOthersFindTheirPlacesInAFurnishedRoom) {
  const v1::GetDocumentResponse made = Designed();
  auto said = Say(made.document(), "put a plant in the corner");
  ASSERT_TRUE(said.ok()) << said.status();
  EXPECT_THAT(Unmet(said->layout()), IsEmpty());
  EXPECT_EQ(PlacementOf(said->layout(), "floor_plant").object_id(), "floor_plant");
  EXPECT_EQ(std::ranges::count(said->layout().graph().constraint_list().sentences(), "The floor plant is in the corner",
                               &v1::Sentence::text),
            1);
  said = Say(said->document(), "Add a plant next to the wardrobe");
  ASSERT_TRUE(said.ok()) << said.status();
  const v1::ConstraintEdge& edge = *said->layout().graph().edges().rbegin();
  EXPECT_THAT(edge.ShortDebugString(), HasSubstr("floor_plant_2"));
  said = Say(said->document(), "Add a vase on the desk. Hang a picture above the desk.");
  ASSERT_TRUE(said.ok()) << said.status();
  EXPECT_EQ(PlacementOf(said->layout(), "vase").object_id(), "vase");
  EXPECT_EQ(PlacementOf(said->layout(), "picture").object_id(), "picture");
}

TEST_F(SayingTest, WhatIsNoFurnitureIsAnsweredPlainlyAndTheRestIsDone) {
  const v1::GetDocumentResponse made = Designed();
  const v1::Document room = OwnRoom(made);
  const auto none = Say(room, "Add a xyz");
  EXPECT_TRUE(absl::IsInvalidArgument(none.status()));
  EXPECT_EQ(none.status().message(),
            "say.text: I know no \"xyz\"; the furniture list has a floor lamp, a desk, a desk chair, 7 pieces in all");
  const auto missing = Say(made.document(), "The bookcase is against a wall.");
  EXPECT_THAT(std::string(missing.status().message()),
              HasSubstr("say \"add a bookcase\" or take one from the furniture list"));
  const auto some = Say(room, "Add a bookcase. Add a xyz.");
  ASSERT_TRUE(some.ok()) << some.status();
  EXPECT_EQ(IdOf(some->layout(), "bookshelf"), "bookshelf");
  ASSERT_THAT(some->diagnostics(), ::testing::Not(IsEmpty()));
  EXPECT_THAT(some->diagnostics().rbegin()->message(), HasSubstr("I know no \"xyz\""));
}

TEST_F(SayingTest, WhatIsSaidAgainReplacesWhatWasSaid) {
  const v1::GetDocumentResponse made = Designed();
  const int before = made.layout().graph().constraint_list().sentences_size();
  auto said = Say(made.document(), "The wardrobe is against the west wall.");
  ASSERT_TRUE(said.ok()) << said.status();
  const std::string first = said->document().undo_label();
  EXPECT_THAT(first, ::testing::StartsWith("say \"The wardrobe is against the west wall.\""));
  EXPECT_EQ(first.find("; moved: ") != std::string::npos, !said->moved_object_ids().empty());
  said = Say(said->document(), "the wardrobe is against the west wall");
  ASSERT_TRUE(said.ok()) << said.status();
  EXPECT_EQ(Get(made.document().id()).layout().graph().constraint_list().sentences_size(), before + 1);
}

}  // namespace
}  // namespace flair::session
