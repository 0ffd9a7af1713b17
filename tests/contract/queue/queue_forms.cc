// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/contract/queue/queue_forms.h"

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

}  // namespace flair::testing
