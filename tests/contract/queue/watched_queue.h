// SPDX-License-Identifier: GPL-3.0-or-later
// A process's view of a queue, with waiting for what other views do.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "orchestrator/batch/work_queue.h"

namespace flair::testing {

class WatchedQueue {
 public:
  explicit WatchedQueue(std::unique_ptr<orchestrator::WorkQueue> queue);
  ~WatchedQueue();
  orchestrator::WorkQueue* operator->() { return queue_.get(); }

  // The next job, which must come within a minute; null otherwise.
  std::unique_ptr<orchestrator::Lease> Take(const orchestrator::TakeFilter& filter = {});
  // What Take gives at once; a failure counts as nothing.
  std::unique_ptr<orchestrator::Lease> TakeNow(const orchestrator::TakeFilter& filter = {});
  // Looks again whenever the queue says that something happened; false when it is not so within a minute.
  bool WaitUntil(const std::function<bool()>& condition);

 private:
  void Happened();

  std::mutex mutex_;
  std::condition_variable condition_;
  int64_t happened_ = 0;
  std::unique_ptr<orchestrator::WorkQueue> queue_;
};

// A job that asks for a room of that name.
v1::Job NewJob(const std::string& id, const std::string& text = "a bedroom");
// A job at a place of a batch.
v1::Job JobOf(const std::string& batch_id, int64_t place, const std::string& text = "a bedroom");
std::vector<v1::Job> JobsOf(const std::string& batch_id, int64_t first, int64_t count);
store::v1::BatchRecord NewBatch(const std::string& id);

// Ends a run.
absl::Status EndAs(orchestrator::Lease& lease, v1::JobState state, v1::FailureKind kind = v1::FAILURE_KIND_UNSPECIFIED);
// A stage that made something.
orchestrator::StageRecord StageMade(const orchestrator::Lease& lease, const std::string& stage, int stage_index,
                                    char artifact, const std::string& result_key = "");
// The id of an artifact that consists of one character.
std::string ArtifactId(char character);

}  // namespace flair::testing
