// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/contract/queue/queue_forms.h"

#include <google/protobuf/util/time_util.h>

#include <chrono>
#include <utility>

#include "orchestrator/jetstream/open.h"
#include "orchestrator/store/local_artifacts.h"
#include "orchestrator/store/sqlite_work_queue.h"
#include "worker_runtime/clock/clock.h"

namespace flair::testing {
namespace {

class FolderQueue : public QueueForm {
 public:
  absl::StatusOr<std::unique_ptr<orchestrator::WorkQueue>> Open() override {
    return orchestrator::SqliteWorkQueue::Open(folder_.path(), runtime::SystemClock());
  }
  absl::StatusOr<std::unique_ptr<orchestrator::ArtifactStore>> OpenArtifacts() override {
    return orchestrator::LocalArtifacts::Open(folder_ / "artifacts");
  }
  std::vector<std::string> ChildArguments() const override { return {"folder", folder_.path()}; }

 protected:
  TestFolder folder_;
};

class SharedFolderQueue final : public FolderQueue {
 public:
  absl::StatusOr<std::unique_ptr<orchestrator::ArtifactStore>> OpenArtifacts() override {
    return orchestrator::ArtifactFiles::Open(folder_ / "artifacts");
  }
};

class JetStreamQueue final : public QueueForm {
 public:
  explicit JetStreamQueue(int server_count) : servers_(server_count) {
    config_.set_address(servers_.address());
    config_.set_replica_count(server_count);
    config_.set_lease_seconds(1);
  }
  absl::StatusOr<std::unique_ptr<orchestrator::WorkQueue>> Open() override {
    if (!servers_.ok()) return absl::InternalError(servers_.Log());
    return orchestrator::OpenJetStreamQueue(config_, nullptr, runtime::SystemClock());
  }
  absl::StatusOr<std::unique_ptr<orchestrator::ArtifactStore>> OpenArtifacts() override {
    if (!servers_.ok()) return absl::InternalError(servers_.Log());
    return orchestrator::OpenJetStreamArtifacts(config_, nullptr, runtime::SystemClock());
  }
  NatsServers* servers() override { return &servers_; }
  std::vector<std::string> ChildArguments() const override { return {"jetstream", servers_.address()}; }

 private:
  NatsServers servers_;
  config::v1::QueueConfig config_;
};

constexpr std::chrono::seconds kPatience{60};

}  // namespace

NamedForm FolderForm() {
  return {"folder", [] { return std::make_unique<FolderQueue>(); }};
}

NamedForm SharedFolderForm() {
  return {"shared_folder", [] { return std::make_unique<SharedFolderQueue>(); }};
}

NamedForm JetStreamForm(int server_count) {
  return {server_count == 1 ? "jetstream" : "jetstream_cluster",
          [server_count] { return std::make_unique<JetStreamQueue>(server_count); }};
}

WatchedQueue::WatchedQueue(std::unique_ptr<orchestrator::WorkQueue> queue) : queue_(std::move(queue)) {
  if (queue_ == nullptr) return;
  orchestrator::WorkQueue::Listener listener;
  listener.work = [this] { Happened(); };
  listener.changed = [this](const std::string&) { Happened(); };
  listener.batch_changed = [this](const std::string&) { Happened(); };
  queue_->Listen(std::move(listener));
}

WatchedQueue::~WatchedQueue() {
  if (queue_ != nullptr) queue_->Listen({});
}

void WatchedQueue::Happened() {
  std::lock_guard lock(mutex_);
  ++happened_;
  condition_.notify_all();
}

bool WatchedQueue::WaitUntil(const std::function<bool()>& condition) {
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  while (true) {
    int64_t seen = 0;
    {
      std::lock_guard lock(mutex_);
      seen = happened_;
    }
    if (condition()) return true;
    std::unique_lock lock(mutex_);
    if (!condition_.wait_until(lock, deadline, [&] { return happened_ != seen; })) return false;
  }
}

std::unique_ptr<orchestrator::Lease> WatchedQueue::TakeNow(const orchestrator::TakeFilter& filter) {
  auto lease = queue_->Take(filter);
  return lease.ok() ? *std::move(lease) : nullptr;
}

std::unique_ptr<orchestrator::Lease> WatchedQueue::Take(const orchestrator::TakeFilter& filter) {
  std::unique_ptr<orchestrator::Lease> lease;
  WaitUntil([&] {
    lease = TakeNow(filter);
    return lease != nullptr;
  });
  return lease;
}

v1::Job NewJob(const std::string& id, const std::string& text) {
  v1::Job job;
  job.set_id(id);
  job.set_state(v1::JOB_STATE_QUEUED);
  job.mutable_spec()->mutable_brief()->set_text(text);
  *job.mutable_create_time() = google::protobuf::util::TimeUtil::SecondsToTimestamp(1'800'000'000);
  return job;
}

v1::Job JobOf(const std::string& batch_id, int64_t place, const std::string& text) {
  v1::Job job = NewJob(orchestrator::BatchJobId(batch_id, place), text);
  job.set_batch_id(batch_id);
  job.set_batch_index(place);
  return job;
}

std::vector<v1::Job> JobsOf(const std::string& batch_id, int64_t first, int64_t count) {
  std::vector<v1::Job> jobs;
  for (int64_t i = first; i < first + count; ++i) jobs.push_back(JobOf(batch_id, i));
  return jobs;
}

store::v1::BatchRecord NewBatch(const std::string& id) {
  store::v1::BatchRecord record;
  v1::Batch& batch = *record.mutable_batch();
  batch.set_id(id);
  batch.set_state(v1::BATCH_STATE_ACTIVE);
  batch.set_open(true);
  batch.set_label("briefs.jsonl");
  *batch.mutable_create_time() = google::protobuf::util::TimeUtil::SecondsToTimestamp(1'800'000'000);
  record.set_request_id("request of " + id);
  record.set_specs_digest("digest of " + id);
  return record;
}

absl::Status EndAs(orchestrator::Lease& lease, v1::JobState state, v1::FailureKind kind) {
  orchestrator::JobEnd end;
  end.state = state;
  end.failure_kind = kind;
  if (state == v1::JOB_STATE_FAILED) end.error = absl::InternalError("stage \"solve\": out of wood");
  end.stage = "solve";
  end.time = absl::FromUnixSeconds(1'800'000'100);
  return lease.End(end);
}

std::string ArtifactId(char character) { return std::string(64, character); }

orchestrator::StageRecord StageMade(const orchestrator::Lease& lease, const std::string& stage, int stage_index,
                                    char artifact, const std::string& result_key) {
  orchestrator::StageRecord record;
  record.event.set_job_id(lease.job().id());
  record.event.set_kind(v1::JOB_EVENT_KIND_STAGE_FINISHED);
  record.event.set_stage(stage);
  record.event.set_state(v1::JOB_STATE_RUNNING);
  record.event.mutable_artifact()->set_id(ArtifactId(artifact));
  record.event.mutable_artifact()->set_kind(v1::ARTIFACT_KIND_ROOM);
  record.event.mutable_artifact()->set_size_bytes(7);
  record.stage_index = stage_index;
  record.result_key = result_key;
  return record;
}

}  // namespace flair::testing
