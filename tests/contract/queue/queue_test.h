// SPDX-License-Identifier: GPL-3.0-or-later
// A test that is put to every form of the queue.
#pragma once

#include <google/protobuf/util/time_util.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <memory>
#include <string>
#include <vector>

#include "orchestrator/store/artifact_id.h"
#include "tests/contract/queue/queue_forms.h"
#include "tests/fixtures/programs.h"

namespace flair::testing {

class QueueTest : public ::testing::TestWithParam<NamedForm> {
 protected:
  // One more process's view.
  WatchedQueue Open() {
    auto queue = form_->Open();
    EXPECT_TRUE(queue.ok()) << queue.status();
    return WatchedQueue(queue.ok() ? *std::move(queue) : nullptr);
  }
  const std::unique_ptr<QueueForm> form_ = GetParam().make();
};

#define FLAIR_EVERY_FORM(suite)                                                        \
  INSTANTIATE_TEST_SUITE_P(, suite, ::testing::Values(FolderForm(), JetStreamForm(1)), \
                           [](const ::testing::TestParamInfo<NamedForm>& form) { return form.param.name; })

// Jobs with artifacts that are really stored, to be deleted.

class DeletionContract : public QueueTest {
 protected:
  DeletionContract() {
    auto store = form_->OpenArtifacts();
    EXPECT_TRUE(store.ok()) << store.status();
    if (store.ok()) artifacts_ = *std::move(store);
  }

  // The artifact that says this.
  static orchestrator::SealedArtifact Seal(const std::string& text);
  static std::string IdOf(const std::string& text) { return Seal(text).ref.id(); }

  // A stage of the run made it.
  static orchestrator::StageRecord Record(const orchestrator::Lease& lease, const v1::ArtifactRef& artifact,
                                          const std::string& result_key);
  // Stores it and records it under "key-of-TEXT".
  absl::Status Store(orchestrator::Lease& lease, const std::string& text, int stage_index = 0);

  // Makes a job, "request of ID", and runs it to its end; it has these artifacts. Returns their ids.
  std::vector<std::string> RunAlone(WatchedQueue& queue, const std::string& id, const std::vector<std::string>& texts);
  // A closed batch whose jobs ended. Of these artifacts, each job has one of its own instead of "own": "own-of-JOB".
  void RunBatch(WatchedQueue& queue, const std::string& id, int64_t job_count, const std::vector<std::string>& texts,
                v1::JobState state = v1::JOB_STATE_SUCCEEDED);

  // What is left of a batch is a batch, and its jobs have what they say.
  void ExpectWhole(WatchedQueue& queue, const std::string& id, int64_t job_count);

  std::unique_ptr<orchestrator::ArtifactStore> artifacts_;
};

}  // namespace flair::testing
