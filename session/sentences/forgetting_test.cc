// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <set>

#include "session/sentences/sentences.h"
#include "session/testing/documents_for_test.h"

namespace flair::session {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

class RemarksTest : public DocumentsTest {
 protected:
  std::vector<std::string> NotAsAsked(const std::string& id) {
    v1::ExplainRequest explain;
    explain.set_document_id(id);
    const auto note = documents_->Explain(explain, call_);
    return {note->not_as_asked().begin(), note->not_as_asked().end()};
  }
};

v1::Diagnostic Remark(const std::string& code, const std::string& subject, const std::string& message) {
  v1::Diagnostic remark;
  remark.set_severity(v1::SEVERITY_WARNING);
  remark.set_code(code);
  remark.set_subject_id(subject);
  remark.set_message(message);
  return remark;
}

TEST_F(RemarksTest, AWishThatIsDroppedIsForgottenAndUndoBringsItBack) {
  const v1::GetDocumentResponse made = Designed();
  const auto said = Act(made.document(), [](v1::ActRequest& act) {
    act.mutable_say()->set_text("The wardrobe is against the west wall.");
  });
  ASSERT_TRUE(said.ok()) << said.status();
  const std::string sentence = said->layout().graph().constraint_list().sentences().rbegin()->id();
  const auto dropped =
      Act(said->document(), [&](v1::ActRequest& act) { act.mutable_weigh()->set_sentence_id(sentence); });
  ASSERT_TRUE(dropped.ok()) << dropped.status();
  EXPECT_THAT(NotAsAsked(made.document().id()), Not(Contains(HasSubstr("west wall"))));
  const v1::SolvedLayout layout = Get(made.document().id()).layout();
  for (const v1::Sentence& one : layout.graph().constraint_list().sentences()) EXPECT_NE(one.id(), sentence);
  const auto back = Act(dropped->document(), [](v1::ActRequest& act) { act.mutable_undo(); });
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(back->layout().graph().constraint_list().sentences().rbegin()->id(), sentence);
}

TEST_F(RemarksTest, TheWishesOfAPieceGoWithItAlsoWhenTheRoomIsSolvedLater) {
  const v1::GetDocumentResponse made = Designed();
  const std::string wardrobe = IdOf(made.layout(), "wardrobe"), bed = IdOf(made.layout(), "bed");
  auto last = Act(made.document(), [&](v1::ActRequest& act) {
    act.mutable_edit()->set_without_solving(true);
    act.mutable_edit()->add_edits()->set_remove_object_id(wardrobe);
  });
  ASSERT_TRUE(last.ok()) << last.status();
  const auto silent = [&] {
    const v1::LayoutGraph graph = Get(made.document().id()).layout().graph();
    std::set<std::string> asking, before;
    for (const v1::ConstraintEdge& edge : graph.edges()) asking.insert(edge.sentence_id());
    for (const v1::ConstraintEdge& edge : made.layout().graph().edges()) before.insert(edge.sentence_id());
    int count = 0;
    for (const v1::Sentence& one : graph.constraint_list().sentences()) {
      count += before.contains(one.id()) && !asking.contains(one.id());
    }
    return count;
  };
  EXPECT_EQ(silent(), 0);
  last = Act(last->document(), [&](v1::ActRequest& act) {
    *act.mutable_edit()->add_edits()->mutable_move_object() = Inward(PlacementOf(made.layout(), bed));
  });
  ASSERT_TRUE(last.ok()) << last.status();
  EXPECT_EQ(silent(), 0);
}

TEST(ForgetWhatIsAnsweredTest, ARemarkGoesWhenWhatItMissesIsThereAndWhenItsSentenceHolds) {
  v1::LayoutGraph before;
  v1::Sentence& sentence = *before.mutable_constraint_list()->add_sentences();
  sentence.set_id("s1");
  v1::ConstraintEdge& edge = *before.add_edges();
  edge.set_id("e1");
  edge.set_sentence_id("s1");
  *before.add_diagnostics() = Remark("names_absent_object", "s9", "\"Add a desk\": the room has no \"desk\"");
  *before.add_diagnostics() = Remark("names_absent_object", "s9", "\"Add a desktop\": the room has no \"desktop\"");
  *before.add_diagnostics() = Remark("unknown_sentence", "s1", "it is not understood");
  *before.add_diagnostics() = Remark("partial", "s1", "not understood: sideways");
  v1::Omission& left_out = *before.mutable_object_list()->add_omissions();
  left_out.set_name("desk");
  left_out.set_requested(true);
  v1::SolvedLayout layout;
  *layout.mutable_graph() = before;
  layout.add_edge_outcomes()->set_status(v1::OUTCOME_STATUS_VIOLATED);
  ForgetWhatIsAnswered(before, layout);
  EXPECT_THAT(layout.graph().diagnostics(), SizeIs(4));

  v1::Object& desk = *layout.mutable_graph()->mutable_object_list()->add_objects();
  desk.set_id("desk");
  desk.set_name("desk");
  layout.mutable_edge_outcomes(0)->set_status(v1::OUTCOME_STATUS_SATISFIED);
  ForgetWhatIsAnswered(before, layout);
  ASSERT_THAT(layout.graph().diagnostics(), SizeIs(2));
  EXPECT_THAT(layout.graph().diagnostics(0).message(), HasSubstr("desktop"));
  EXPECT_EQ(layout.graph().diagnostics(1).code(), "partial");
  EXPECT_THAT(layout.graph().object_list().omissions(), IsEmpty());
}

}  // namespace
}  // namespace flair::session
