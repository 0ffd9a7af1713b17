// SPDX-License-Identifier: GPL-3.0-or-later
// What every form of an artifact store promises.
#include <gtest/gtest.h>

#include "orchestrator/store/artifact_id.h"
#include "tests/contract/queue/queue_test.h"
#include "worker_runtime/files/files.h"

namespace flair::testing {
namespace {

class ArtifactsContract : public QueueTest {
 protected:
  std::unique_ptr<orchestrator::ArtifactStore> OpenStore() {
    auto store = form_->OpenArtifacts();
    EXPECT_TRUE(store.ok()) << store.status();
    return store.ok() ? *std::move(store) : nullptr;
  }
  static v1::Artifact Brief(const std::string& text) {
    v1::Artifact artifact;
    artifact.mutable_brief()->set_text(text);
    return artifact;
  }
};
INSTANTIATE_TEST_SUITE_P(, ArtifactsContract, ::testing::Values(FolderForm(), SharedFolderForm(), JetStreamForm(1)),
                         [](const ::testing::TestParamInfo<NamedForm>& form) { return form.param.name; });

TEST_P(ArtifactsContract, WhatIsPutIsThereForAll) {
  const auto one = OpenStore();
  const auto other = OpenStore();
  v1::Artifact brief = Brief("a bedroom");
  const auto ref = one->Put(brief);
  ASSERT_TRUE(ref.ok()) << ref.status();
  EXPECT_EQ(ref->id(), orchestrator::ComputeArtifactId(brief));
  EXPECT_EQ(ref->kind(), v1::ARTIFACT_KIND_BRIEF);
  EXPECT_EQ(ref->size_bytes(), static_cast<int64_t>(brief.ByteSizeLong()));
  const auto got = other->Get(ref->id());
  ASSERT_TRUE(got.ok()) << got.status();
  EXPECT_EQ(runtime::CanonicalBytes(*got), runtime::CanonicalBytes(brief));
  EXPECT_TRUE(one->Flush(std::span(&*ref, 1)).ok());
}

TEST_P(ArtifactsContract, PuttingTwiceIsPuttingOnce) {
  const auto one = OpenStore();
  const auto other = OpenStore();
  v1::Artifact first = Brief("a bedroom");
  v1::Artifact second = Brief("a bedroom");
  ASSERT_TRUE(one->Put(first).ok());
  const auto ref = other->Put(second);
  ASSERT_TRUE(ref.ok()) << ref.status();
  EXPECT_EQ(ref->id(), first.id());
  EXPECT_TRUE(one->Get(ref->id()).ok());
}

TEST_P(ArtifactsContract, LargeOnesAreWhole) {
  const auto store = OpenStore();
  // Above what a message of a queue may have, and not a multiple of anything.
  std::string text(5'000'001, 'x');
  for (size_t i = 0; i < text.size(); i += 7919) text[i] = static_cast<char>('a' + i % 26);
  v1::Artifact large = Brief(text);
  const auto ref = store->Put(large);
  ASSERT_TRUE(ref.ok()) << ref.status();
  const auto got = store->Get(ref->id());
  ASSERT_TRUE(got.ok()) << got.status();
  EXPECT_EQ(got->brief().text(), text);
  EXPECT_TRUE(store->Put(large).ok());
}

TEST_P(ArtifactsContract, WhatIsNotThereIsSaidSo) {
  const auto store = OpenStore();
  EXPECT_TRUE(absl::IsNotFound(store->Get(std::string(64, 'a')).status()));
  for (const char* id : {"", "*", "../../etc/passwd", ">"}) {
    EXPECT_TRUE(absl::IsInvalidArgument(store->Get(id).status())) << id;
  }
  v1::ArtifactRef gone;
  gone.set_id(std::string(64, 'a'));
  EXPECT_TRUE(store->Flush(std::span(&gone, 1)).ok());
}

}  // namespace
}  // namespace flair::testing
