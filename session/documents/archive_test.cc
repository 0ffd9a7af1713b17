// SPDX-License-Identifier: GPL-3.0-or-later
#include <archive.h>
#include <archive_entry.h>
#include <gmock/gmock.h>

#include <map>

#include "flair/v1/orchestrator_service.grpc.pb.h"
#include "orchestrator/store/artifact_id.h"
#include "session/testing/documents_for_test.h"

namespace flair::session {
namespace {

using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Key;
using ::testing::UnorderedElementsAre;

std::map<std::string, std::string> FilesIn(const std::string& tar) {
  std::map<std::string, std::string> files;
  const std::unique_ptr<archive, decltype(&archive_read_free)> read(archive_read_new(), archive_read_free);
  archive_read_support_format_all(read.get());
  EXPECT_EQ(archive_read_open_memory(read.get(), tar.data(), tar.size()), ARCHIVE_OK);
  archive_entry* entry = nullptr;
  while (archive_read_next_header(read.get(), &entry) == ARCHIVE_OK) {
    std::string content(static_cast<size_t>(archive_entry_size(entry)), '\0');
    EXPECT_EQ(archive_read_data(read.get(), content.data(), content.size()), archive_entry_size(entry));
    EXPECT_TRUE(files.emplace(archive_entry_pathname(entry), std::move(content)).second);
  }
  return files;
}

TEST_F(DocumentsTest, AnArchiveHoldsTheLayoutAndAllThatLedToIt) {
  const v1::GetDocumentResponse made = Designed();
  const std::string& id = made.document().id();
  const std::string designed = Export(id, v1::DOCUMENT_FORMAT_LAYOUT_PB);
  ASSERT_TRUE(Act(made.document(), [&](v1::ActRequest& act) {
                *act.mutable_move()->add_placements() = Inward(PlacementOf(made.layout(), IdOf(made.layout(), "bed")));
              }).ok());
  const std::string tar = Export(id, v1::DOCUMENT_FORMAT_ARTIFACTS_TAR);
  EXPECT_EQ(tar, Export(id, v1::DOCUMENT_FORMAT_ARTIFACTS_TAR));
  std::map<std::string, std::string> files = FilesIn(tar);
  EXPECT_EQ(files["layout.pb"], Export(id, v1::DOCUMENT_FORMAT_LAYOUT_PB));
  EXPECT_EQ(files["layout.json"], Export(id, v1::DOCUMENT_FORMAT_LAYOUT_JSON));
  EXPECT_EQ(files["layout_2.pb"], designed);
  std::vector<std::string> stages;
  for (const char* stem : {"brief", "room", "zones", "objects", "style", "constraints_raw", "constraints",
                           "constraints_completed", "graph"}) {
    stages.push_back(std::string(stem) + ".pb");
    stages.push_back(std::string(stem) + ".json");
  }
  std::vector<std::string> names;
  for (const auto& [name, content] : files) {
    names.push_back(name);
    if (!name.ends_with(".pb")) continue;
    v1::Artifact artifact;
    ASSERT_TRUE(artifact.ParseFromString(content)) << name;
    EXPECT_EQ(artifact.id(), orchestrator::ComputeArtifactId(artifact)) << name;
  }
  EXPECT_THAT(names, IsSupersetOf(stages));
  EXPECT_EQ(names.size(), stages.size() + 4);
}

TEST_F(DocumentsTest, AnArchiveOfManyLargeLayoutsKeepsTheNewestAndWhatTheStagesMade) {
  v1::Artifact large;
  ASSERT_TRUE(large.ParseFromString(Export(Designed().document().id(), v1::DOCUMENT_FORMAT_LAYOUT_PB)));
  for (int i = 0; i < 1000; ++i) {
    v1::Diagnostic& remark = *large.mutable_solved_layout()->add_diagnostics();
    remark.set_severity(v1::SEVERITY_NOTE);
    remark.set_code("left_out");
    // Of nothing that is placed: acts leave it there.
    remark.set_subject_id("gone");
    remark.set_message(std::string(2000, 'x'));
  }
  large.set_id(orchestrator::ComputeArtifactId(large));
  v1::CreateDocumentRequest request;
  request.set_request_id("large");
  request.set_file(large.SerializeAsString());
  const auto made = documents_->Create(request, call_);
  ASSERT_TRUE(made.ok()) << made.status();
  v1::Document document = made->document();
  for (int i = 0; i < 10; ++i) {
    const v1::Placement bed = PlacementOf(Get(document.id()).layout(), IdOf(large.solved_layout(), "bed"));
    const auto moved = Act(document, [&](v1::ActRequest& act) {
      v1::Placement& to = *act.mutable_move()->add_placements();
      to = bed;
      to.set_y_m(bed.y_m() + 0.01);
    });
    ASSERT_TRUE(moved.ok()) << moved.status();
    document = moved->document();
  }
  const std::string tar = Export(document.id(), v1::DOCUMENT_FORMAT_ARTIFACTS_TAR);
  EXPECT_LT(tar.size(), 17 << 20);
  const std::map<std::string, std::string> files = FilesIn(tar);
  for (const char* name : {"layout.pb", "layout_2.json", "graph.pb", "brief.json"}) EXPECT_TRUE(files.contains(name));
  EXPECT_FALSE(files.contains("layout_8.pb"));
}

TEST_F(DocumentsTest, AnArchiveLeavesOutWhatIsGone) {
  const v1::GetDocumentResponse made = Designed();
  const auto stub = v1::OrchestratorService::NewStub(services_->orchestrator());
  v1::DeleteJobRequest gone;
  gone.set_job_id(made.document().job_id());
  grpc::ClientContext context;
  v1::DeleteJobResponse response;
  ASSERT_TRUE(stub->DeleteJob(&context, gone, &response).ok());
  EXPECT_THAT(FilesIn(Export(made.document().id(), v1::DOCUMENT_FORMAT_ARTIFACTS_TAR)),
              UnorderedElementsAre(Key("layout.pb"), Key("layout.json")));
}

TEST_F(DocumentsTest, EverythingIsOneArchiveWithPicturesListAndArtifacts) {
  const v1::GetDocumentResponse made = Designed();
  const std::map<std::string, std::string> files =
      FilesIn(Export(made.document().id(), v1::DOCUMENT_FORMAT_EVERYTHING_ZIP));
  std::vector<std::string> names;
  for (const auto& [name, content] : files) {
    names.push_back(name);
    EXPECT_NE(content, "") << name;
  }
  EXPECT_THAT(names, IsSupersetOf({"plan.png", "plan.svg", "plan.pdf", "view-from-above.png", "view-at-eye-level.png",
                                   "report.md", "furniture.csv", "room-to-open-again.json", "artifacts/layout.pb",
                                   "artifacts/brief.json"}));
  EXPECT_EQ(files.at("room-to-open-again.json"), Export(made.document().id(), v1::DOCUMENT_FORMAT_LAYOUT_JSON));
  EXPECT_TRUE(files.at("plan.pdf").starts_with("%PDF"));
  EXPECT_THAT(files.at("plan.pdf"), HasSubstr("MediaBox [ 0 0 1190."));
}

TEST_F(DocumentsTest, TheSheetsOfAnArchiveAreOfThePaperThatIsAskedFor) {
  const v1::GetDocumentResponse made = Designed();
  const std::map<std::string, std::string> files =
      FilesIn(Export(made.document().id(), v1::DOCUMENT_FORMAT_EVERYTHING_ZIP, v1::PAPER_SIZE_A4));
  EXPECT_THAT(files.at("plan.pdf"), HasSubstr("MediaBox [ 0 0 841."));
  EXPECT_TRUE(files.contains("view-from-above.png"));
}

}  // namespace
}  // namespace flair::session
