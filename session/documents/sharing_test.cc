// SPDX-License-Identifier: GPL-3.0-or-later
// Two machines with one orchestrator.
#include <gmock/gmock.h>

#include "session/testing/documents_for_test.h"

namespace flair::session {
namespace {

class SharingTest : public DocumentsTest {
 protected:
  absl::StatusOr<std::string> Share(const std::string& document_id) {
    v1::ShareDocumentRequest request;
    request.set_document_id(document_id);
    const auto shared = documents_->Share(request, call_);
    if (!shared.ok()) return shared.status();
    return shared->job_id();
  }

  v1::Document Moved(const v1::GetDocumentResponse& made) {
    const auto moved = Act(made.document(), [&](v1::ActRequest& act) {
      *act.mutable_move()->add_placements() = Inward(PlacementOf(made.layout(), IdOf(made.layout(), "bed")));
    });
    EXPECT_TRUE(moved.ok()) << moved.status();
    return moved->document();
  }

  static v1::CreateDocumentRequest FromJob(const std::string& job_id) {
    v1::CreateDocumentRequest request;
    request.set_request_id("from " + job_id);
    request.set_job_id(job_id);
    return request;
  }
};

TEST_F(SharingTest, WhatOneMachineSharesAnotherOpensToTheByte) {
  const v1::GetDocumentResponse made = Designed();
  const v1::Document moved = Moved(made);
  const absl::StatusOr<std::string> job = Share(moved.id());
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_NE(*job, moved.job_id());
  EXPECT_EQ(*Share(moved.id()), *job);
  const std::string bytes = Export(moved.id(), v1::DOCUMENT_FORMAT_LAYOUT_PB);

  documents_ = OpenIn("elsewhere");
  EXPECT_EQ(documents_->List({})->documents_size(), 0);
  const auto opened = documents_->Create(FromJob(*job), call_);
  ASSERT_TRUE(opened.ok()) << opened.status();
  EXPECT_EQ(opened->document().layout_id(), moved.layout_id());
  EXPECT_EQ(opened->document().brief().text(), made.document().brief().text());
  EXPECT_EQ(Export(opened->document().id(), v1::DOCUMENT_FORMAT_LAYOUT_PB), bytes);
  EXPECT_EQ(*Share(opened->document().id()), *job);
  // From a file it has no brief; it still is the same layout.
  v1::CreateDocumentRequest file;
  file.set_request_id("file");
  file.set_file(bytes);
  const auto from_file = documents_->Create(file, call_);
  ASSERT_TRUE(from_file.ok()) << from_file.status();
  EXPECT_EQ(*Share(from_file->document().id()), *job);
}

TEST_F(SharingTest, AJobThatIsSharedIsDrawn) {
  const v1::Document moved = Moved(Designed());
  v1::Job job;
  Stages stages({.orchestrator = services_->orchestrator(),
                 .translator = services_->stages().translator.channel,
                 .optimizer = services_->stages().optimizer.channel,
                 .renderer = services_->stages().renderer.channel});
  const std::string id = *Share(moved.id());
  ASSERT_TRUE(stages
                  .WatchJob(
                      id, 0, [](const v1::JobEvent&) {}, call_)
                  .ok());
  job = *stages.GetJob(id, call_);
  EXPECT_EQ(job.state(), v1::JOB_STATE_SUCCEEDED) << job.error();
  std::vector<v1::ArtifactKind> kinds;
  for (const v1::ArtifactRef& ref : job.artifacts()) kinds.push_back(ref.kind());
  EXPECT_THAT(kinds, ::testing::ElementsAre(v1::ARTIFACT_KIND_BRIEF, v1::ARTIFACT_KIND_SOLVED_LAYOUT,
                                            v1::ARTIFACT_KIND_PREVIEW));
}

TEST_F(SharingTest, WhatAJobHasDesignedIsSharedAsItIs) {
  const v1::GetDocumentResponse made = Designed();
  EXPECT_EQ(*Share(made.document().id()), made.document().job_id());
}

TEST_F(SharingTest, ARoomWithoutABriefIsListedByItsTitle) {
  v1::CreateDocumentRequest file;
  file.set_request_id("file");
  file.set_file(Export(Moved(Designed()).id(), v1::DOCUMENT_FORMAT_LAYOUT_PB));
  const auto opened = documents_->Create(file, call_);
  ASSERT_TRUE(opened.ok()) << opened.status();
  const auto named = Act(opened->document(), [](v1::ActRequest& act) { act.set_title("Our attic"); });
  ASSERT_TRUE(named.ok()) << named.status();
  const absl::StatusOr<std::string> job = Share(opened->document().id());
  ASSERT_TRUE(job.ok()) << job.status();
  Stages stages({.orchestrator = services_->orchestrator(),
                 .translator = services_->stages().translator.channel,
                 .optimizer = services_->stages().optimizer.channel,
                 .renderer = services_->stages().renderer.channel});
  EXPECT_EQ(stages.GetJob(*job, call_)->spec().brief().text(), "Our attic");
}

TEST_F(SharingTest, AnEmptyRoomIsNotShared) {
  v1::CreateDocumentRequest request;
  request.set_request_id("own");
  *request.mutable_room() = Designed().layout().graph().room();
  const auto made = documents_->Create(request, call_);
  ASSERT_TRUE(made.ok()) << made.status();
  EXPECT_TRUE(absl::IsFailedPrecondition(Share(made->document().id()).status()));
  EXPECT_TRUE(absl::IsNotFound(Share("nothing").status()));
}

}  // namespace
}  // namespace flair::session
