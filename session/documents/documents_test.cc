// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <set>

#include "cli/output/artifact_text.h"
#include "room/conversion/conversion.h"
#include "session/testing/documents_for_test.h"

namespace flair::session {
namespace {

using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

TEST_F(DocumentsTest, ADesignBecomesADocumentWithTheLayoutOfItsJob) {
  const v1::GetDocumentResponse made = Designed();
  EXPECT_EQ(made.document().title(), "A bedroom that is 4m x 5m.");
  EXPECT_EQ(made.document().undo_label(), "");
  const v1::Job job = [&] {
    Stages stages({.orchestrator = services_->orchestrator(),
                   .translator = services_->stages().translator.channel,
                   .optimizer = services_->stages().optimizer.channel,
                   .renderer = services_->stages().renderer.channel});
    return *stages.GetJob(made.document().job_id(), call_);
  }();
  std::vector<std::string> ids;
  for (const v1::ArtifactRef& ref : job.artifacts()) ids.push_back(ref.id());
  EXPECT_THAT(ids, ::testing::Contains(made.document().layout_id()));
}

TEST_F(DocumentsTest, UndoToTheStartGivesTheSameBytesAlsoAfterARestart) {
  const v1::GetDocumentResponse made = Designed();
  const std::string before = Export(made.document().id(), v1::DOCUMENT_FORMAT_LAYOUT_PB);
  const std::string bed = IdOf(made.layout(), "bed");
  auto last = Act(made.document(), [&](v1::ActRequest& act) {
    *act.mutable_move()->add_placements() = Inward(PlacementOf(made.layout(), bed));
  });
  ASSERT_TRUE(last.ok()) << last.status();
  last = Act(last->document(), [](v1::ActRequest& act) { act.mutable_settle(); });
  ASSERT_TRUE(last.ok()) << last.status();
  const std::string after = Export(made.document().id(), v1::DOCUMENT_FORMAT_LAYOUT_PB);
  EXPECT_NE(after, before);

  Reopen();
  for (int i = 0; i < 2; ++i) {
    last = Act(last->document(), [](v1::ActRequest& act) { act.mutable_undo(); });
    ASSERT_TRUE(last.ok()) << last.status();
  }
  EXPECT_EQ(Export(made.document().id(), v1::DOCUMENT_FORMAT_LAYOUT_PB), before);
  EXPECT_TRUE(
      absl::IsFailedPrecondition(Act(last->document(), [](v1::ActRequest& act) { act.mutable_undo(); }).status()));
  for (int i = 0; i < 2; ++i) last = Act(last->document(), [](v1::ActRequest& act) { act.mutable_redo(); });
  ASSERT_TRUE(last.ok()) << last.status();
  EXPECT_EQ(Export(made.document().id(), v1::DOCUMENT_FORMAT_LAYOUT_PB), after);
}

TEST_F(DocumentsTest, WhoHasNotSeenTheLatestRevisionChangesNothing) {
  const v1::GetDocumentResponse made = Designed();
  ASSERT_TRUE(Act(made.document(), [](v1::ActRequest& act) { act.set_title("Mine"); }).ok());
  const auto late = Act(made.document(), [](v1::ActRequest& act) { act.set_title("Yours"); });
  EXPECT_TRUE(absl::IsAborted(late.status()));
  EXPECT_THAT(std::string(late.status().message()), HasSubstr("somebody else has changed it"));
  EXPECT_EQ(Get(made.document().id()).document().title(), "Mine");
}

TEST_F(DocumentsTest, AnOwnRoomIsDrawnChangedAndFurnished) {
  v1::CreateDocumentRequest request;
  request.set_request_id("own");
  v1::Room& room = *request.mutable_room();
  room = Designed().layout().graph().room();
  const auto made = documents_->Create(request, call_);
  ASSERT_TRUE(made.ok()) << made.status();
  EXPECT_EQ(Get(made->document().id()).layout().placements_size(), 0);
  v1::DrawDocumentRequest draw;
  draw.set_document_id(made->document().id());
  const auto drawn = documents_->Draw(draw, call_);
  ASSERT_TRUE(drawn.ok()) << drawn.status();
  EXPECT_NE(drawn->parts().walls_svg(), "");
  EXPECT_EQ(drawn->parts().parts_size(), 0);
  v1::ExplainRequest explain;
  explain.set_document_id(made->document().id());
  EXPECT_TRUE(documents_->Explain(explain, call_).ok());
  room.set_height_m(2.6);
  const auto changed = Act(made->document(), [&](v1::ActRequest& act) { *act.mutable_room() = room; });
  ASSERT_TRUE(changed.ok()) << changed.status();
  EXPECT_EQ(changed->layout().graph().room().height_m(), 2.6);
  const v1::Document furnished = After(
      [&] {
        const auto asked = Act(changed->document(), [](v1::ActRequest& act) {
          act.mutable_furnish()->set_text("A study with a desk and a bookcase.");
        });
        ASSERT_TRUE(asked.ok()) << asked.status();
      },
      [](const v1::Document& one) { return one.job_state() == v1::JOB_STATE_SUCCEEDED; });
  EXPECT_EQ(furnished.undo_label(), "furnish the room");
  EXPECT_NE(IdOf(Get(furnished.id()).layout(), "desk"), "");
  EXPECT_EQ(Get(furnished.id()).layout().graph().room().height_m(), 2.6);
  EXPECT_EQ(furnished.brief().text(), "A study with a desk and a bookcase.");
  EXPECT_FALSE(furnished.brief().has_room());

  // Once more, otherwise; undo gives back the layout and what it was asked for.
  const v1::Document again = After(
      [&] {
        const auto act =
            Act(furnished, [](v1::ActRequest& request) { request.mutable_furnish()->set_text("A bedroom."); });
        ASSERT_TRUE(act.ok()) << act.status();
        EXPECT_EQ(act->document().brief().text(), furnished.brief().text());
      },
      [](const v1::Document& document) { return document.job_state() == v1::JOB_STATE_SUCCEEDED; });
  EXPECT_EQ(again.brief().text(), "A bedroom.");
  const auto undone = Act(again, [](v1::ActRequest& request) { request.mutable_undo(); });
  ASSERT_TRUE(undone.ok()) << undone.status();
  EXPECT_EQ(undone->document().layout_id(), furnished.layout_id());
  EXPECT_EQ(undone->document().brief().text(), furnished.brief().text());
  // It was drawn, and not called by a brief.
  EXPECT_EQ(again.title(), made->document().title());
}

TEST_F(DocumentsTest, FilesAreOpenedAndBadOnesRefused) {
  const v1::GetDocumentResponse made = Designed();
  v1::CreateDocumentRequest request;
  request.set_request_id("file");
  request.set_file(Export(made.document().id(), v1::DOCUMENT_FORMAT_LAYOUT_JSON));
  const auto opened = documents_->Create(request, call_);
  ASSERT_TRUE(opened.ok()) << opened.status();
  EXPECT_EQ(opened->document().layout_id(), made.document().layout_id());
  request.set_request_id("bad");
  request.set_file("nothing of ours");
  EXPECT_FALSE(documents_->Create(request, call_).ok());
  const auto listed = documents_->List({});
  std::vector<std::string> ids;
  for (const v1::Document& one : listed->documents()) ids.push_back(one.id());
  EXPECT_THAT(ids, UnorderedElementsAre(made.document().id(), opened->document().id()));
  v1::DeleteDocumentRequest gone;
  gone.set_document_id(opened->document().id());
  EXPECT_TRUE(documents_->Delete(gone).ok());
  EXPECT_TRUE(absl::IsNotFound(documents_->Delete(gone).status()));
}

TEST_F(DocumentsTest, FurnitureIsFoundByItsWordsWithItsSymbol) {
  v1::ListFurnitureRequest request;
  request.set_query("Lamp");
  const auto found = documents_->ListFurniture(request, call_);
  ASSERT_TRUE(found.ok()) << found.status();
  ASSERT_EQ(found->offers_size(), 1);
  EXPECT_THAT(found->offers(0).svg(), HasSubstr("<path"));
  request.set_query("throne");
  EXPECT_EQ(documents_->ListFurniture(request, call_)->offers_size(), 0);
}

TEST_F(DocumentsTest, FurnitureIsFoundByOtherWordsForItAndInThePlural) {
  const auto first = [&](const std::string& query) -> std::string {
    v1::ListFurnitureRequest request;
    request.set_query(query);
    const auto found = documents_->ListFurniture(request, call_);
    return found->offers().empty() ? "" : found->offers(0).object().name();
  };
  EXPECT_EQ(first("Bookcase"), "bookshelf");
  EXPECT_EQ(first("bookcases"), "bookshelf");
  EXPECT_EQ(first("bookc"), "bookshelf");
  EXPECT_EQ(first("floor plants"), "floor plant");
  // Too few letters for a word that is not the name.
  EXPECT_EQ(first("bo"), "bookshelf");
  EXPECT_EQ(first("ca"), "");
}

TEST_F(DocumentsTest, ARoomIsCalledByTheBriefItWasFurnishedForUnlessSomebodyNamedIt) {
  const v1::GetDocumentResponse made = Designed();
  const auto furnished = [&](const v1::Document& before, const std::string& brief) {
    return After(
        [&] { ASSERT_TRUE(Act(before, [&](v1::ActRequest& act) { act.mutable_furnish()->set_text(brief); }).ok()); },
        [&](const v1::Document& one) {
          return one.job_state() == v1::JOB_STATE_SUCCEEDED && one.brief().text() == brief;
        });
  };
  const v1::Document study = furnished(made.document(), "A study.");
  EXPECT_EQ(study.title(), "A study.");
  const auto undone = Act(study, [](v1::ActRequest& act) { act.mutable_undo(); });
  EXPECT_EQ(undone->document().title(), made.document().title());
  const auto named = Act(undone->document(), [](v1::ActRequest& act) { act.set_title("Attic"); });
  EXPECT_EQ(furnished(named->document(), "A library.").title(), "Attic");
}

TEST_F(DocumentsTest, FilesAreCalledByWholeWords) {
  const v1::GetDocumentResponse made = Designed();
  v1::ExportDocumentRequest file;
  file.set_document_id(made.document().id());
  file.set_format(v1::DOCUMENT_FORMAT_LAYOUT_JSON);
  // By the kind of room as long as nobody has given it a name.
  EXPECT_EQ(documents_->Export(file, call_)->file_name(), "bedroom.json");
  v1::ActRequest title;
  title.set_document_id(made.document().id());
  title.set_revision(made.document().revision());
  title.set_title("A living room of five by four metres with a sofa and two bookshelves");
  ASSERT_TRUE(documents_->Act(title, call_).ok());
  const auto named = documents_->Export(file, call_);
  ASSERT_TRUE(named.ok()) << named.status();
  EXPECT_EQ(named->file_name(), "a-living-room-of-five-by-four-metres-with-a-sofa-and-two.json");
}

TEST_F(DocumentsTest, AModelIsChosenOnlyWhereTheProgramCan) {
  EXPECT_FALSE(documents_->GetModel().can_choose());
  EXPECT_TRUE(absl::IsUnimplemented(documents_->ChooseModel({}).status()));
}

TEST_F(DocumentsTest, WhoAwaitsAJobSeesItsStepsAndTheLayoutIsAdoptedOnce) {
  v1::CreateDocumentRequest request;
  request.set_request_id("awaited");
  request.mutable_design()->mutable_brief()->set_text("A study that is 3m x 4m.");
  const auto made = documents_->Create(request, call_);
  ASSERT_TRUE(made.ok()) << made.status();
  std::vector<std::string> stages;
  const auto see = [&](const v1::JobEvent& event) {
    if (event.kind() == v1::JOB_EVENT_KIND_STAGE_FINISHED) stages.push_back(event.stage());
  };
  const auto awaited = documents_->AwaitJob(made->document().id(), see, call_);
  ASSERT_TRUE(awaited.ok()) << awaited.status();
  EXPECT_THAT(stages, ::testing::IsSupersetOf({"brief", "solve", "report"}));
  EXPECT_EQ(awaited->job_state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_EQ(documents_->AwaitJob(made->document().id(), see, call_)->revision(), awaited->revision());
  Reopen();
  EXPECT_EQ(Get(made->document().id()).document().revision(), awaited->revision());
}

TEST_F(DocumentsTest, WhoGivesUpMayCancelTheJob) {
  v1::CreateDocumentRequest request;
  request.set_request_id("given up");
  request.mutable_design()->mutable_brief()->set_text("A bedroom that is 4m x 5m.");
  request.mutable_design()->mutable_solve_options()->set_max_restart_count(10000);
  const auto made = documents_->Create(request, call_);
  ASSERT_TRUE(made.ok()) << made.status();
  runtime::CallContext waiting;
  const auto awaited = documents_->AwaitJob(
      made->document().id(), [&](const v1::JobEvent&) { waiting.cancellation().Cancel(); }, waiting);
  EXPECT_TRUE(absl::IsCancelled(awaited.status())) << awaited.status();
  ASSERT_TRUE(documents_->CancelJob(made->document().id(), call_).ok());
  const auto ended = documents_->AwaitJob(
      made->document().id(), [](const v1::JobEvent&) {}, call_);
  ASSERT_TRUE(ended.ok()) << ended.status();
  EXPECT_EQ(ended->job_state(), v1::JOB_STATE_CANCELLED);
}

}  // namespace
}  // namespace flair::session
