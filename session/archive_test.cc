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

using ::testing::IsSupersetOf;
using ::testing::Key;
using ::testing::UnorderedElementsAre;

std::map<std::string, std::string> FilesIn(const std::string& tar) {
  std::map<std::string, std::string> files;
  const std::unique_ptr<archive, decltype(&archive_read_free)> read(archive_read_new(), archive_read_free);
  archive_read_support_format_tar(read.get());
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

}  // namespace
}  // namespace flair::session
