// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/local_artifacts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "orchestrator/testing/temporary_folder.h"

namespace flair::orchestrator {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr int64_t kWheneverStored = std::numeric_limits<int64_t>::max();

class LocalArtifactsTest : public ::testing::Test {
 protected:
  static v1::Artifact TextOf(size_t size, char what) {
    v1::Artifact artifact;
    artifact.mutable_brief()->set_text(std::string(size, what));
    return artifact;
  }
  std::unique_ptr<LocalArtifacts> Open() const { return *LocalArtifacts::Open(folder_.path()); }
  std::string Put(v1::Artifact artifact) { return artifacts_->Put(artifact)->id(); }
  bool IsFile(const std::string& id) const { return std::filesystem::exists(ArtifactFiles(folder_.path()).PathOf(id)); }

  TemporaryFolder folder_;
  std::unique_ptr<LocalArtifacts> artifacts_ = Open();
};

TEST_F(LocalArtifactsTest, OnlyLargeOnesAreFiles) {
  const std::string small = Put(TextOf(1000, 's'));
  const std::string large = Put(TextOf(100'000, 'l'));
  EXPECT_FALSE(IsFile(small));
  EXPECT_TRUE(IsFile(large));
  v1::ArtifactRef refs[2];
  refs[0].set_id(small);
  refs[1].set_id(large);
  EXPECT_TRUE(artifacts_->Flush(refs).ok());
  const auto other = Open();
  EXPECT_EQ(other->Get(small)->brief().text(), std::string(1000, 's'));
  EXPECT_EQ(other->Get(large)->brief().text(), std::string(100'000, 'l'));
}

TEST_F(LocalArtifactsTest, SmallFilesOfBeforeAreFoundAndDeleted) {
  v1::Artifact artifact = TextOf(10, 'a');
  const std::string id = ArtifactFiles(folder_.path()).Put(artifact)->id();
  EXPECT_TRUE(artifacts_->Get(id).ok());
  EXPECT_THAT(*artifacts_->FindIds(id.substr(0, 6)), ElementsAre(id));
  // In both forms it is still one.
  EXPECT_EQ(Put(artifact), id);
  EXPECT_THAT(*artifacts_->FindIds(id.substr(0, 6)), ElementsAre(id));
  EXPECT_EQ(*artifacts_->Delete(std::span(&id, 1), kWheneverStored), 1);
  EXPECT_TRUE(absl::IsNotFound(artifacts_->Get(id).status()));
  EXPECT_THAT(*artifacts_->FindIds(id.substr(0, 6)), IsEmpty());
  EXPECT_EQ(*artifacts_->Delete(std::span(&id, 1), kWheneverStored), 0);
}

TEST_F(LocalArtifactsTest, WhatIsStoredAfterAMarkStaysWhateverItsSize) {
  const std::vector<std::string> before = {Put(TextOf(10, 'a')), Put(TextOf(100'000, 'a'))};
  const std::vector<std::string> again = {Put(TextOf(10, 'b')), Put(TextOf(100'000, 'b'))};
  const int64_t mark = *Open()->Mark();
  const std::vector<std::string> after = {Put(TextOf(10, 'c')), Put(TextOf(100'000, 'c'))};
  ASSERT_EQ(Put(TextOf(10, 'b')), again[0]);
  ASSERT_EQ(Put(TextOf(100'000, 'b')), again[1]);
  for (const auto& ids : {before, again, after}) {
    EXPECT_EQ(*artifacts_->Delete(ids, mark), ids == before ? 2 : 0);
    for (const std::string& id : ids) EXPECT_EQ(artifacts_->Get(id).ok(), ids != before);
  }
  EXPECT_GT(*artifacts_->Mark(), mark);
}

TEST_F(LocalArtifactsTest, ARowThatIsDamagedIsNoticedAndMendedWhenPutAgain) {
  v1::Artifact artifact = TextOf(10, 'a');
  SealedArtifact sealed = SealArtifact(artifact);
  const std::string good = sealed.bytes;
  for (size_t at = 0; at < good.size(); ++at) {
    sealed.bytes = good;
    sealed.bytes[at] ^= 0x21;
    ASSERT_TRUE(artifacts_->PutAll(std::span(&sealed, 1)).ok());
    EXPECT_TRUE(absl::IsDataLoss(artifacts_->Get(artifact.id()).status())) << "byte " << at;
  }
  Put(artifact);
  EXPECT_TRUE(artifacts_->Get(artifact.id()).ok());
}

TEST_F(LocalArtifactsTest, AFileThatIsNoDatabaseIsNamedWithWhatToDo) {
  artifacts_ = nullptr;
  std::ofstream(folder_.path() + "/small.db") << std::string(5000, 'x');
  const absl::Status status = LocalArtifacts::Open(folder_.path()).status();
  EXPECT_TRUE(absl::IsDataLoss(status)) << status;
  EXPECT_THAT(std::string(status.message()), AllOf(HasSubstr("/small.db: "), HasSubstr("move it away")));
}

}  // namespace
}  // namespace flair::orchestrator
