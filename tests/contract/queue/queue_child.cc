// SPDX-License-Identifier: GPL-3.0-or-later
// A process that takes one job, says so, and holds it until it is killed, or deletes a batch and says when it begins
// each step: flair_queue_child (folder PATH | jetstream ADDRESS) [BATCH]
#include <unistd.h>

#include <cstdio>
#include <string>

#include "orchestrator/jetstream/open.h"
#include "orchestrator/store/local_artifacts.h"
#include "orchestrator/store/sqlite_work_queue.h"
#include "tests/contract/queue/queue_forms.h"
#include "worker_runtime/clock/clock.h"

namespace {

int Delete(flair::testing::WatchedQueue& queue, flair::orchestrator::ArtifactStore& artifacts, const char* batch_id) {
  for (int step = 0;; ++step) {
    std::printf("step %d\n", step);
    std::fflush(stdout);
    const auto deleted = queue->DeleteBatch(batch_id, 50, artifacts);
    if (!deleted.ok()) return 1;
    if (deleted->done) return 0;
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3 && argc != 4) return 2;
  const bool in_folder = std::string(argv[1]) == "folder";
  flair::config::v1::QueueConfig config;
  config.set_address(argv[2]);
  config.set_lease_seconds(1);
  auto queue = in_folder ? flair::orchestrator::SqliteWorkQueue::Open(argv[2], flair::runtime::SystemClock())
                         : flair::orchestrator::OpenJetStreamQueue(config, nullptr, flair::runtime::SystemClock());
  if (!queue.ok()) return 1;
  flair::testing::WatchedQueue watched(*std::move(queue));
  if (argc == 4) {
    absl::StatusOr<std::unique_ptr<flair::orchestrator::ArtifactStore>> artifacts;
    if (in_folder) {
      artifacts = flair::orchestrator::LocalArtifacts::Open(std::string(argv[2]) + "/artifacts");
    } else {
      artifacts = flair::orchestrator::OpenJetStreamArtifacts(config, nullptr, flair::runtime::SystemClock());
    }
    return artifacts.ok() ? Delete(watched, **artifacts, argv[3]) : 1;
  }
  const auto lease = watched.Take();
  if (lease == nullptr) return 1;
  if (!lease->Record(flair::testing::StageMade(*lease, "brief", 0, 'a')).ok()) return 1;
  std::printf("took %s\n", lease->job().id().c_str());
  std::fflush(stdout);
  while (true) ::pause();
}
