// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "absl/status/statusor.h"
#include "worker_runtime/status/status_macros.h"

struct sqlite3;
struct sqlite3_stmt;

namespace flair::orchestrator {

// A value to be bound as a blob; strings are bound as text.
struct Blob {
  std::string_view bytes;
};

// What a column holds of itself: nothing, a whole number, a number or text.
using SqlValue = std::variant<std::monostate, int64_t, double, std::string>;

// DATA_LOSS with the cure, for a file in which `what` is wrong.
absl::Status Damaged(std::string_view path, std::string_view what);

// One prepared statement in use: bind in order, step, read columns. Errors are kept and come out of Step. When
// destroyed, it goes back to its database for the next use.
class Statement {
 public:
  Statement(sqlite3* connection, sqlite3_stmt* statement) : connection_(connection), statement_(statement) {}
  Statement(Statement&& other) noexcept;
  ~Statement();
  Statement& operator=(Statement&&) = delete;

  Statement& Bind(int64_t value);
  Statement& Bind(std::string_view text);
  Statement& Bind(Blob blob);
  Statement& BindValue(const SqlValue& value);

  // True when there is a row to read, false after the last.
  absl::StatusOr<bool> Step();

  // The first column of every row that is left.
  absl::StatusOr<std::vector<std::string>> Texts();

  // Steps to the end.
  absl::Status Run();

  int64_t Int(int column) const;
  // Of text and blobs alike.
  std::string Text(int column) const;
  SqlValue Value(int column) const;

 private:
  absl::Status Error() const;

  sqlite3* connection_;
  sqlite3_stmt* statement_;
  int next_parameter_ = 1;
  int code_ = 0;
};

// One connection to an SQLite file in WAL mode. Several processes may have the same file open. The queries below take
// lock() themselves; hold it while using statements directly, one thread at a time.
class Database {
 public:
  // Steps of a schema's history, oldest first: each runs once per file, new ones are added at the end.
  using Schema = std::span<const std::string_view>;
  // The schema of jobs.db.
  static Schema JobSchema();

  // Opens or makes the file and brings its schema up to date; of no steps, whatever it has stays. UNAVAILABLE when it
  // cannot be opened or written, FAILED_PRECONDITION when a newer version of Flair made it, DATA_LOSS when it is no
  // database.
  static absl::StatusOr<std::unique_ptr<Database>> Open(const std::string& path, Schema schema = JobSchema());
  ~Database();

  [[nodiscard]] std::unique_lock<std::recursive_mutex> lock() { return std::unique_lock(mutex_); }

  // A prepared statement with the values bound, kept for the next time: `sql` must be one of few texts. A statement
  // that cannot be prepared is an error at its first Step.
  template <typename... Values>
  Statement Prepare(std::string_view sql, const Values&... values) {
    Statement statement = PrepareUnbound(sql);
    (statement.Bind(values), ...);
    return statement;
  }

  // Runs a statement that returns no rows.
  template <typename... Values>
  absl::Status Run(std::string_view sql, const Values&... values) {
    const auto held = lock();
    return Prepare(sql, values...).Run();
  }
  // The same; returns how many rows it changed.
  template <typename... Values>
  absl::StatusOr<int64_t> RunAndCount(std::string_view sql, const Values&... values) {
    const auto held = lock();
    RETURN_IF_ERROR(Prepare(sql, values...).Run());
    return changes();
  }
  // Whether the query has a row.
  template <typename... Values>
  absl::StatusOr<bool> Exists(std::string_view sql, const Values&... values) {
    const auto held = lock();
    return Prepare(sql, values...).Step();
  }
  // The first column of the first row; 0 or empty when there is none.
  template <typename... Values>
  absl::StatusOr<int64_t> FirstInt(std::string_view sql, const Values&... values) {
    const auto held = lock();
    Statement select = Prepare(sql, values...);
    ASSIGN_OR_RETURN(const bool row, select.Step());
    return row ? select.Int(0) : 0;
  }
  template <typename... Values>
  absl::StatusOr<std::string> FirstText(std::string_view sql, const Values&... values) {
    const auto held = lock();
    Statement select = Prepare(sql, values...);
    ASSIGN_OR_RETURN(const bool row, select.Step());
    return row ? select.Text(0) : "";
  }
  // The first column of every row.
  template <typename... Values>
  absl::StatusOr<std::vector<std::string>> Texts(std::string_view sql, const Values&... values) {
    const auto held = lock();
    return Prepare(sql, values...).Texts();
  }

  absl::Status Execute(const std::string& sql);

  // Damaged unless tables and indexes agree; reads the whole file.
  absl::Status CheckWhole();

 private:
  friend class Transaction;
  Database(std::string path, sqlite3* connection) : path_(std::move(path)), connection_(connection) {}
  Statement PrepareUnbound(std::string_view sql);
  int64_t changes() const;
  // Whether the transactions after this one are flushed when they commit; cheap when nothing changes.
  absl::Status SetFlushedAtOnce(bool at_once);
  absl::Status Configure();
  absl::Status EnterWal();
  absl::Status Migrate(Schema schema);

  const std::string path_;
  sqlite3* connection_;
  bool flushed_at_once_ = false;
  std::recursive_mutex mutex_;
  std::map<std::string, sqlite3_stmt*, std::less<>> statements_;
};

// All rows of a query, each read with `read(const Statement&)`, which returns absl::StatusOr<Row>.
template <typename Row, typename Read>
absl::StatusOr<std::vector<Row>> ReadRows(Statement select, const Read& read) {
  std::vector<Row> rows;
  while (true) {
    ASSIGN_OR_RETURN(const bool more, select.Step());
    if (!more) return rows;
    ASSIGN_OR_RETURN(Row row, read(select));
    rows.push_back(std::move(row));
  }
}

// Everything between Begin and Commit happens or does not; destroyed without Commit, it does not. Takes the write lock
// at once, so that what was read is still true when it is written.
class Transaction {
 public:
  // What the committed transaction survives. With kPowerLoss, the commit waits until the write-ahead log, with all that
  // was committed before, is on the disk (PRAGMA synchronous = FULL).
  enum class Durability { kProcessCrash, kPowerLoss };

  static absl::StatusOr<Transaction> Begin(Database& database, Durability durability = Durability::kProcessCrash);
  Transaction(Transaction&& other) noexcept;
  ~Transaction();
  // Then releases the lock, so that listeners which are notified of the change can read it.
  absl::Status Commit();

 private:
  Transaction(Database& database, std::unique_lock<std::recursive_mutex> lock)
      : database_(&database), lock_(std::move(lock)) {}
  Database* database_;
  std::unique_lock<std::recursive_mutex> lock_;
};

}  // namespace flair::orchestrator
