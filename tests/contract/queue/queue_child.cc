// SPDX-License-Identifier: GPL-3.0-or-later
// A process that takes one job, says so, and holds it until it is killed: flair_queue_child (folder PATH | jetstream
// ADDRESS)
#include <unistd.h>

#include <cstdio>
#include <string>

#include "orchestrator/jetstream/open.h"
#include "orchestrator/store/sqlite_work_queue.h"
#include "tests/contract/queue/watched_queue.h"
#include "worker_runtime/clock/clock.h"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  flair::config::v1::QueueConfig config;
  config.set_address(argv[2]);
  config.set_lease_seconds(1);
  auto queue = std::string(argv[1]) == "folder"
                   ? flair::orchestrator::SqliteWorkQueue::Open(argv[2], flair::runtime::SystemClock())
                   : flair::orchestrator::OpenJetStreamQueue(config, nullptr, flair::runtime::SystemClock());
  if (!queue.ok()) return 1;
  flair::testing::WatchedQueue watched(*std::move(queue));
  const auto lease = watched.Take();
  if (lease == nullptr) return 1;
  if (!lease->Record(flair::testing::StageMade(*lease, "brief", 0, 'a')).ok()) return 1;
  std::printf("took %s\n", lease->job().id().c_str());
  std::fflush(stdout);
  while (true) ::pause();
}
