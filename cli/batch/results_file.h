// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/job.pb.h"
#include "flair/v1/report.pb.h"
#include "nlohmann/json_fwd.hpp"
#include "orchestrator/store/database.h"

namespace flair::cli {

// One value of a row.
using ResultValue = orchestrator::SqlValue;

// A column of results.db and of the CSV file.
struct ResultColumn {
  std::string name;
  // As SQLite says it: INTEGER, REAL or TEXT.
  std::string type;
  // What it holds, for people: in the file's table `columns` and in docs/batches.md.
  std::string meaning;
};

// All columns in order. The first one is batch_index, which no two rows share.
std::span<const ResultColumn> ResultColumns();
// Place of the column in ResultColumns(), which must have it.
size_t ColumnPlace(std::string_view name);

// What is known of one job of a batch.
class ResultRow {
 public:
  ResultRow() : values_(ResultColumns().size()) {}
  void Set(std::string_view column, ResultValue value) { values_[ColumnPlace(column)] = std::move(value); }
  const ResultValue& Get(std::string_view column) const { return values_[ColumnPlace(column)]; }
  // The value, or what stands for one that is not there.
  std::string Text(std::string_view column) const;
  int64_t Int(std::string_view column) const;
  const std::vector<ResultValue>& values() const { return values_; }
  std::vector<ResultValue>& values() { return values_; }

 private:
  std::vector<ResultValue> values_;
};

// "worker", "infeasible", ...; empty for a job that has not failed.
std::string FailureKindWord(v1::FailureKind kind);

// Everything that a job says of itself: not what only the submission (line, key) or the collection (path) knows.
ResultRow RowOf(const v1::Job& job);
// Adds what the job's report says.
void AddReport(const v1::Report& report, ResultRow& row);

// results.db: table `jobs` with a row per job and the columns of ResultColumns(), table `columns` with what they mean,
// and table `state` with what a restarted command needs to go on. Others may read it at any time. Thread-safe.
class ResultsFile {
 public:
  // Makes the file when it is missing. FAILED_PRECONDITION when it cannot be read or written or is something else.
  static absl::StatusOr<std::unique_ptr<ResultsFile>> Open(const std::filesystem::path& path);
  // One that is gone when it is closed.
  static absl::StatusOr<std::unique_ptr<ResultsFile>> OpenTemporary() { return Open(""); }
  // One that exists, to read it. NOT_FOUND when there is none.
  static absl::StatusOr<std::unique_ptr<ResultsFile>> OpenToRead(const std::filesystem::path& path);

  // All that `change` does happens, or nothing; survives a kill when this returns.
  absl::Status Change(const std::function<absl::Status()>& change);

  absl::StatusOr<std::string> State(std::string_view name);
  absl::StatusOr<int64_t> IntState(std::string_view name);
  absl::Status SetState(std::string_view name, std::string_view value);
  absl::Status SetState(std::string_view name, int64_t value) { return SetState(name, std::to_string(value)); }

  // Puts the values of the row that are set and leaves its others.
  absl::Status Put(const ResultRow& row);
  // Forgets what earlier ends of the job said.
  absl::Status ForgetEnd(int64_t batch_index);
  // The row of a job; nothing when it has none.
  absl::StatusOr<std::optional<ResultRow>> Find(int64_t batch_index);
  // All rows by their place, until `see` fails. `where` is a literal of ours, such as "fetch_error IS NOT NULL".
  absl::Status ForEach(std::string_view where, const std::function<absl::Status(const ResultRow&)>& see);
  // What a literal query of ours gives: its first value, as a whole number (0 for none) or as text; all its numbers.
  absl::StatusOr<int64_t> Count(const std::string& query);
  absl::StatusOr<std::string> Text(const std::string& query);
  absl::StatusOr<std::vector<double>> Numbers(const std::string& query);

 private:
  ResultsFile(std::unique_ptr<orchestrator::Database> database, std::string path)
      : database_(std::move(database)), path_(std::move(path)) {}
  absl::Status Configure();
  // A status of the database in the words, and with the exit code, of a file.
  absl::Status OfFile(const absl::Status& status) const;
  using RowTaker = std::function<absl::Status(const orchestrator::Statement&)>;
  // Gives every row of what the sql selects to `see`, until that fails.
  absl::Status Run(const std::string& sql, std::span<const ResultValue> values, const RowTaker& see);
  // The first column of the last row; nothing when there is no row.
  absl::StatusOr<ResultValue> First(const std::string& sql, std::span<const ResultValue> values = {});

  const std::unique_ptr<orchestrator::Database> database_;
  const std::string path_;
};

// What became of a batch, made of results.db alone: batch_id, label, counts of jobs, lines, constraints, model calls
// and bytes, first_time and last_time (from the first job's creation to the last one's end; empty when none has ended);
// "failures", a list with an example of each kind: kind, count, batch_index, line (0 when nobody knows), stage, error;
// and "columns" by name, measures and times, how their values are spread: count, mean, p50, p90, p99, most.
using BatchReport = nlohmann::ordered_json;

absl::StatusOr<BatchReport> MakeBatchReport(ResultsFile& results);
int64_t CountIn(const BatchReport& report, const char* name);

// For people.
std::string BatchReportText(const BatchReport& report);
// The lines on which it says how the jobs ended and why some failed.
std::string BatchOutcomeText(const BatchReport& report);

// All rows as RFC 4180 CSV with the names of the columns first, whole or not at all.
absl::Status WriteResultsCsv(ResultsFile& results, const std::string& path);

}  // namespace flair::cli
