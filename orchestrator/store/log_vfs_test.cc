// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/log_vfs.h"

#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>

#include "orchestrator/store/temporary_folder.h"

namespace flair::orchestrator {
namespace {

// A connection, by name of the way to its files; null for the usual one.
class Connection {
 public:
  Connection(const std::string& path, const char* vfs) {
    constexpr int kFlags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_URI;
    EXPECT_EQ(sqlite3_open_v2(path.c_str(), &connection_, kFlags, vfs), SQLITE_OK);
    EXPECT_EQ(Run("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL"), SQLITE_OK);
  }
  ~Connection() { EXPECT_EQ(sqlite3_close(connection_), SQLITE_OK); }

  int Run(const std::string& sql) { return sqlite3_exec(connection_, sql.c_str(), nullptr, nullptr, nullptr) & 0xff; }

  std::string Ask(const std::string& sql) {
    std::string answer;
    const auto take = [](void* to, int, char** values, char**) {
      *static_cast<std::string*>(to) = values[0] == nullptr ? "" : values[0];
      return 0;
    };
    EXPECT_EQ(sqlite3_exec(connection_, sql.c_str(), take, &answer, nullptr), SQLITE_OK) << sqlite3_errmsg(connection_);
    return answer;
  }

 private:
  sqlite3* connection_ = nullptr;
};

constexpr char kSum[] = "SELECT count(*) || ' ' || total(length(bytes)) || ' ' || total(number) FROM rows";

// Rows on pages of their own.
std::string AddRows(int first, int count) {
  return "WITH RECURSIVE n(i) AS (SELECT " + std::to_string(first) + " UNION ALL SELECT i + 1 FROM n WHERE i < " +
         std::to_string(first + count - 1) + ") INSERT INTO rows SELECT i, randomblob(3000) FROM n;";
}

int64_t WriteCalls() {
  std::ifstream file("/proc/thread-self/io");
  for (std::string word; file >> word;) {
    int64_t value = 0;
    if (word == "syscw:" && file >> value) return value;
  }
  return -1;
}

class LogVfs : public ::testing::Test {
 protected:
  LogVfs() {
    EXPECT_NE(LogVfsName(), nullptr);
    EXPECT_EQ(ours_.Run("CREATE TABLE rows (number INTEGER PRIMARY KEY, bytes BLOB)"), SQLITE_OK);
  }

  // What is found in the files as they are now, as after a crash.
  std::string SumAfterACrash() {
    const std::string copy = folder_.path() + "/copy.db";
    std::filesystem::remove(copy + "-shm");
    for (const char* suffix : {"", "-wal"}) {
      std::filesystem::copy_file(path_ + suffix, copy + suffix, std::filesystem::copy_options::overwrite_existing);
    }
    Connection crashed(copy, nullptr);
    EXPECT_EQ(crashed.Ask("PRAGMA integrity_check"), "ok");
    return crashed.Ask(kSum);
  }

  TemporaryFolder folder_;
  const std::string path_ = folder_.path() + "/new.db";
  Connection ours_{path_, LogVfsName()};
};

TEST_F(LogVfs, WritesATransactionAtOnce) {
  ASSERT_EQ(ours_.Run(AddRows(1, 5)), SQLITE_OK);
  const int64_t before = WriteCalls();
  if (before < 0) GTEST_SKIP() << "the kernel does not count";
  ASSERT_EQ(ours_.Run(AddRows(6, 40)), SQLITE_OK);
  // Of some 170 kB; page by page it would be 80.
  EXPECT_LE(WriteCalls() - before, 5);
}

TEST_F(LogVfs, WhatWasCommittedIsInTheFilesWhenTheCallReturns) {
  for (int i = 0; i < 30; ++i) {
    ASSERT_EQ(ours_.Run(AddRows(1 + 10 * i, 1 + i % 10)), SQLITE_OK);
    EXPECT_EQ(SumAfterACrash(), ours_.Ask(kSum)) << i;
  }
}

// On a disk that may spoil what is beside a write, the last page is repeated up to the end of a sector and flushed in
// the middle.
TEST_F(LogVfs, FlushesInTheMiddleOfAPage) {
  Connection careful("file:" + path_ + "?psow=0", LogVfsName());
  ASSERT_EQ(careful.Run("PRAGMA synchronous = FULL"), SQLITE_OK);
  for (int i = 0; i < 30; ++i) {
    ASSERT_EQ(careful.Run(AddRows(1 + 10 * i, 1 + i % 10)), SQLITE_OK);
    EXPECT_EQ(SumAfterACrash(), careful.Ask(kSum)) << i;
    EXPECT_EQ(ours_.Ask(kSum), careful.Ask(kSum)) << i;
  }
}

TEST_F(LogVfs, TakesTurnsWithTheUsualWay) {
  Connection usual(path_, nullptr);
  for (int i = 0; i < 60; ++i) {
    Connection& writer = i % 3 == 0 ? usual : ours_;
    ASSERT_EQ(writer.Run(AddRows(1 + 10 * i, 5)), SQLITE_OK);
    if (i % 7 == 0) ASSERT_EQ(writer.Run("PRAGMA wal_checkpoint(TRUNCATE)"), SQLITE_OK);
    EXPECT_EQ(usual.Ask(kSum), ours_.Ask(kSum));
  }
  EXPECT_EQ(usual.Ask("SELECT count(*) FROM rows"), "300");
  EXPECT_EQ(usual.Ask("PRAGMA integrity_check"), "ok");
}

// Pages that do not fit in memory are written before the end of the transaction, read again, and written in their place
// once more, after which the sums of all that follow them are.
TEST_F(LogVfs, KeepsTransactionsThatAreLargerThanMemory) {
  ASSERT_EQ(ours_.Run("PRAGMA cache_size = 10"), SQLITE_OK);
  ASSERT_EQ(ours_.Run(AddRows(1, 600)), SQLITE_OK);
  for (int i = 0; i < 5; ++i) {
    const std::string before = ours_.Ask(kSum);
    const std::string change = "BEGIN; UPDATE rows SET bytes = randomblob(2900 + number % 50) WHERE number % 2 = 0; " +
                               AddRows(1000 * (i + 1), 300) +
                               "UPDATE rows SET bytes = randomblob(2800) WHERE number % 3 = 0;";
    ASSERT_EQ(ours_.Run(change + "ROLLBACK"), SQLITE_OK);
    EXPECT_EQ(ours_.Ask(kSum), before);
    EXPECT_EQ(SumAfterACrash(), before);
    ASSERT_EQ(ours_.Run(change + "COMMIT"), SQLITE_OK);
    EXPECT_EQ(SumAfterACrash(), ours_.Ask(kSum));
    EXPECT_NE(ours_.Ask(kSum), before);
  }
  EXPECT_EQ(ours_.Ask("PRAGMA integrity_check"), "ok");
}

TEST_F(LogVfs, TellsOfADiskThatIsFullAndGoesOn) {
  ASSERT_EQ(ours_.Run(AddRows(1, 5)), SQLITE_OK);
  const std::string before = ours_.Ask(kSum);
  rlimit limit = {};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &limit), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit low = {std::filesystem::file_size(path_ + "-wal") + 20000, limit.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &low), 0);
  EXPECT_NE(ours_.Run(AddRows(100, 40)), SQLITE_OK);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(ours_.Ask(kSum), before);
  EXPECT_EQ(SumAfterACrash(), before);
  ASSERT_EQ(ours_.Run(AddRows(200, 40)), SQLITE_OK);
  EXPECT_EQ(SumAfterACrash(), ours_.Ask(kSum));
  EXPECT_EQ(ours_.Ask("SELECT count(*) FROM rows"), "45");
}

}  // namespace
}  // namespace flair::orchestrator
