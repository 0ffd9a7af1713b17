// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>

#include "orchestrator/batch/event_hub.h"
#include "orchestrator/batch/work_queue.h"
#include "orchestrator/store/store_monitor.h"
#include "orchestrator/testing/temporary_folder.h"
#include "worker_runtime/testing/fakes.h"

namespace flair::orchestrator {
namespace {

TEST(JobIdSource, SortsByAgeEvenWhenTheClockStandsStill) {
  runtime::FakeClock clock(absl::FromUnixMicros(1779371101000005));
  JobIdSource ids(clock);
  std::string last = ids.Next();
  EXPECT_EQ(last.substr(0, 22), "20260521T134501000005-");
  for (int i = 0; i < 1000; ++i) {
    const std::string next = ids.Next();
    EXPECT_LT(last, next);
    last = next;
  }
}

TEST(EventHub, TellsWatchersOfTheIdUntilTheyUnsubscribe) {
  std::mutex mutex;
  std::condition_variable wake;
  int first = 0;
  int second = 0;
  const auto counts_to = [&](int& count) {
    return [&] {
      std::lock_guard lock(mutex);
      ++count;
      wake.notify_all();
    };
  };
  EventHub hub;
  const int key = hub.Subscribe("j1", counts_to(first));
  hub.Subscribe("j2", counts_to(second));
  const auto wait_for = [&](int in_first, int in_second) {
    std::unique_lock lock(mutex);
    wake.wait(lock, [&] { return first == in_first && second == in_second; });
  };
  hub.Notify("j1");
  wait_for(1, 0);
  hub.Notify("");
  wait_for(2, 1);
  hub.Unsubscribe(key);
  hub.Notify("j1");
  hub.Notify("");
  wait_for(2, 2);
}

TEST(StoreMonitor, NoticesWritesOfOthersAndTheEndOfOwners) {
  TemporaryFolder folder;
  auto store = *JobStore::Open(folder.path());
  auto other = *JobStore::Open(folder.path());
  runtime::TestGate changed;
  runtime::TestGate owner_gone;
  StoreMonitor monitor(*store, {[&] { changed.Open(); }, [&] { owner_gone.Open(); }});
  v1::Job job;
  job.set_id("j1");
  ASSERT_TRUE(other->jobs().Insert(job, "").ok());
  changed.Wait();
  other = nullptr;
  owner_gone.Wait();
}

}  // namespace
}  // namespace flair::orchestrator
