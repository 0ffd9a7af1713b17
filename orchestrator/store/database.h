// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

struct sqlite3;
struct sqlite3_stmt;

namespace flair::orchestrator {

// One prepared statement in use: bind in order, step, read columns. Errors are kept and come out of Step. Goes back to
// its database when destroyed, ready for the next use.
class Statement {
 public:
  Statement(sqlite3* connection, sqlite3_stmt* statement) : connection_(connection), statement_(statement) {}
  Statement(Statement&& other) noexcept;
  ~Statement();
  Statement& operator=(Statement&&) = delete;

  Statement& Bind(int64_t value);
  Statement& Bind(std::string_view text);
  Statement& BindBytes(std::string_view bytes);
  Statement& BindNull();
  // For statements with numbered parameters ("?1").
  Statement& BindAt(int parameter, int64_t value);
  Statement& BindAt(int parameter, std::string_view text);

  // True when there is a row to read, false after the last.
  absl::StatusOr<bool> Step();

  // The first column of every row that is left.
  absl::StatusOr<std::vector<std::string>> Texts();

  // For statements without rows: steps to the end.
  absl::Status Run();

  int64_t Int(int column) const;
  std::string Text(int column) const;
  std::string Bytes(int column) const { return Text(column); }

 private:
  absl::Status Error() const;

  sqlite3* connection_;
  sqlite3_stmt* statement_;
  int next_parameter_ = 1;
  int code_ = 0;
};

// One connection to an SQLite file in WAL mode. Used by one thread at a time: hold lock() while using it. Several
// processes may have the same file open.
class Database {
 public:
  // Steps of a schema's history, oldest first: each runs once per file, a new one is added at the end, old ones never
  // change.
  using Schema = std::span<const std::string_view>;
  // That of jobs.db.
  static Schema JobSchema();

  // Opens or makes the file and brings its schema up to date. UNAVAILABLE when it cannot be opened or written,
  // FAILED_PRECONDITION when a newer version of Flair made it, DATA_LOSS when it is no database.
  static absl::StatusOr<std::unique_ptr<Database>> Open(const std::string& path, Schema schema = JobSchema());
  ~Database();

  [[nodiscard]] std::unique_lock<std::recursive_mutex> lock() { return std::unique_lock(mutex_); }

  // A prepared statement, kept for the next time: `sql` must be one of few texts. A statement that cannot be prepared
  // is an error at its first Step.
  Statement Prepare(std::string_view sql);

  // Rows changed by the last statement.
  int64_t changes() const;

  absl::Status Execute(const std::string& sql);

  // Returns when all that was committed before, by whatever process, survives a loss of power. Needs no lock; several
  // who wait share one flush.
  absl::Status FlushLog();

 private:
  friend class Transaction;
  // How much the transactions after it survive; cheap when nothing changes.
  absl::Status SetFlushedAtOnce(bool at_once);
  Database(std::string path, sqlite3* connection) : path_(std::move(path)), connection_(connection) {}
  absl::Status Configure();
  absl::Status EnterWal();
  absl::Status Migrate(Schema schema);
  absl::Status OpenLog();

  const std::string path_;
  sqlite3* connection_;
  bool flushed_at_once_ = false;
  std::recursive_mutex mutex_;
  std::map<std::string, sqlite3_stmt*, std::less<>> statements_;

  // The write-ahead log, which stays the same file while a connection is open.
  int log_file_ = -1;
  std::atomic<int64_t> flushes_asked_ = 0;
  std::mutex flush_mutex_;
  int64_t flushes_answered_ = 0;
};

// Everything between Begin and Commit happens or does not; destroyed without Commit, it does not. Takes the write lock
// at once, so that what was read is still true when it is written.
class Transaction {
 public:
  enum class Durability { kProcessCrash, kPowerLoss };

  static absl::StatusOr<Transaction> Begin(Database& database, Durability durability = Durability::kProcessCrash);
  Transaction(Transaction&& other) noexcept;
  ~Transaction();
  // Then lets the database go, so that those who are told of the change can read it.
  absl::Status Commit();

 private:
  Transaction(Database& database, std::unique_lock<std::recursive_mutex> lock)
      : database_(&database), lock_(std::move(lock)) {}
  Database* database_;
  std::unique_lock<std::recursive_mutex> lock_;
};

}  // namespace flair::orchestrator
