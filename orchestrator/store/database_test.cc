// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/database.h"

#include <gtest/gtest.h>

#include <latch>
#include <thread>
#include <vector>

#include "orchestrator/store/temporary_folder.h"

namespace flair::orchestrator {
namespace {

TEST(Database, FlushesItsLogForAllWhoAsk) {
  TemporaryFolder folder;
  const auto database = *Database::Open(folder.path() + "/new.db");
  std::vector<absl::Status> statuses(8);
  std::vector<std::thread> threads;
  for (absl::Status& status : statuses) {
    threads.emplace_back([&] {
      for (int i = 0; i < 50 && status.ok(); ++i) status = database->FlushLog();
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const absl::Status& status : statuses) EXPECT_TRUE(status.ok()) << status;
}

TEST(Database, ManyMayOpenANewFileAtOnce) {
  constexpr int kOpeners = 8;
  for (int round = 0; round < 20; ++round) {
    TemporaryFolder folder;
    std::latch together(kOpeners);
    std::vector<absl::Status> statuses(kOpeners);
    std::vector<std::thread> openers;
    for (absl::Status& status : statuses) {
      openers.emplace_back([&] {
        together.arrive_and_wait();
        status = Database::Open(folder.path() + "/new.db").status();
      });
    }
    for (std::thread& opener : openers) opener.join();
    for (const absl::Status& status : statuses) EXPECT_TRUE(status.ok()) << status;
  }
}

}  // namespace
}  // namespace flair::orchestrator
