// SPDX-License-Identifier: GPL-3.0-or-later
// The forms of a work queue, as the contract meets them: each can be opened any number of times, as if by as many
// processes.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <ostream>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "orchestrator/batch/work_queue.h"
#include "tests/fixtures/nats_server.h"

namespace flair::testing {

// One queue, empty at first.
class QueueForm {
 public:
  virtual ~QueueForm() = default;
  virtual absl::StatusOr<std::unique_ptr<orchestrator::WorkQueue>> Open() = 0;
  virtual absl::StatusOr<std::unique_ptr<orchestrator::ArtifactStore>> OpenArtifacts() = 0;
  // Those that keep it; null when none do.
  virtual NatsServers* servers() { return nullptr; }
  // Arguments with which flair_queue_child opens it in another process.
  virtual std::vector<std::string> ChildArguments() const = 0;
};

struct NamedForm {
  std::string name;
  std::function<std::unique_ptr<QueueForm>()> make;
};
inline std::ostream& operator<<(std::ostream& out, const NamedForm& form) { return out << form.name; }

// In a folder; the same with artifacts as those of several machines would share them; on one server with a lease of a
// second; on three of them.
NamedForm FolderForm();
NamedForm SharedFolderForm();
NamedForm JetStreamForm(int server_count);

// A process's view of a queue, with waiting for what other views do.

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
