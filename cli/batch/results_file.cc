// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/batch/results_file.h"

#include "absl/strings/match.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_replace.h"
#include "cli/exit_code.h"
#include "fmt/format.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

// "flrb", so that another program's database is not taken for ours.
constexpr int kApplicationId = 0x666c7262;
constexpr int kVersion = 2;

std::string ColumnNames() {
  return absl::StrJoin(ResultColumns(), ", ",
                       [](std::string* out, const ResultColumn& column) { out->append(column.name); });
}

std::string SchemaSql() {
  std::string columns;
  for (const ResultColumn& column : ResultColumns()) {
    columns += fmt::format("{}{} {}", columns.empty() ? "" : ", ", column.name, column.type);
    if (column.name == "batch_index") columns += " PRIMARY KEY";
  }
  std::string meanings;
  for (const ResultColumn& column : ResultColumns()) {
    meanings += fmt::format("{}('{}', '{}')", meanings.empty() ? "" : ", ", column.name,
                            absl::StrReplaceAll(column.meaning, {{"'", "''"}}));
  }
  return fmt::format(
      "CREATE TABLE jobs ({}) STRICT; CREATE TABLE state (name TEXT PRIMARY KEY, value TEXT NOT NULL) STRICT;"
      "CREATE INDEX jobs_by_state ON jobs (state, failure_kind);"
      "CREATE INDEX jobs_not_fetched ON jobs (end_sequence) WHERE fetch_error IS NOT NULL;"
      "CREATE TABLE columns (name TEXT PRIMARY KEY, meaning TEXT NOT NULL) STRICT; INSERT INTO columns VALUES {};"
      "PRAGMA application_id = {}; PRAGMA user_version = {}",
      columns, meanings, kApplicationId, kVersion);
}

std::string TextOf(const ResultValue& value) {
  const auto* const text = std::get_if<std::string>(&value);
  return text == nullptr ? "" : *text;
}

ResultRow ReadRow(const orchestrator::Statement& statement) {
  ResultRow row;
  for (size_t i = 0; i < row.values().size(); ++i) row.values()[i] = statement.Value(static_cast<int>(i));
  return row;
}

}  // namespace

absl::StatusOr<std::unique_ptr<ResultsFile>> ResultsFile::Open(const std::filesystem::path& path) {
  auto database = orchestrator::Database::Open(path.string(), {});
  if (absl::StrContains(database.status().message(), "not a database")) {
    return FileError("{}: is not a database of flair batch", path.string());
  }
  if (absl::IsDataLoss(database.status())) return database.status();
  if (!database.ok()) return FileError(std::string(database.status().message()));
  std::unique_ptr<ResultsFile> file(new ResultsFile(*std::move(database), path.string()));
  RETURN_IF_ERROR(file->Configure());
  return file;
}

absl::StatusOr<std::unique_ptr<ResultsFile>> ResultsFile::OpenToRead(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    return NotFound("{}: no such file; expected results.db of flair batch --out", path.string());
  }
  return Open(path);
}

absl::Status ResultsFile::OfFile(const absl::Status& status) const {
  if (status.ok()) return status;
  if (!absl::IsDataLoss(status)) return FileError("{}: {}", path_, status.message());
  return DataLoss("{}: {}; move it away to collect the results again", path_, status.message());
}

absl::Status ResultsFile::Configure() {
  return Change([this]() -> absl::Status {
    ASSIGN_OR_RETURN(const int64_t version, Count("PRAGMA user_version"));
    ASSIGN_OR_RETURN(const int64_t tables, Count("SELECT COUNT(*) FROM sqlite_schema"));
    if (tables == 0) return OfFile(database_->Execute(SchemaSql()));
    ASSIGN_OR_RETURN(const int64_t application, Count("PRAGMA application_id"));
    if (application != kApplicationId) return FileError("{}: is not a database of flair batch", path_);
    if (version == kVersion) return absl::OkStatus();
    return FileError("{}: has version {}, this program knows {}; use the Flair that made it, or another --out", path_,
                     version, kVersion);
  });
}

absl::Status ResultsFile::Run(const std::string& sql, std::span<const ResultValue> values, const RowTaker& see) {
  const auto held = database_->lock();
  orchestrator::Statement statement = database_->Prepare(sql);
  for (const ResultValue& value : values) statement.BindValue(value);
  while (true) {
    const absl::StatusOr<bool> row = statement.Step();
    if (!row.ok() || !*row) return OfFile(row.status());
    RETURN_IF_ERROR(see(statement));
  }
}

absl::StatusOr<ResultValue> ResultsFile::First(const std::string& sql, std::span<const ResultValue> values) {
  ResultValue first;
  RETURN_IF_ERROR(Run(sql, values, [&first](const auto& row) {
    first = row.Value(0);
    return absl::OkStatus();
  }));
  return first;
}

absl::Status ResultsFile::Change(const std::function<absl::Status()>& change) {
  absl::StatusOr<orchestrator::Transaction> transaction = orchestrator::Transaction::Begin(*database_);
  if (!transaction.ok()) return OfFile(transaction.status());
  RETURN_IF_ERROR(change());
  return OfFile(transaction->Commit());
}

absl::StatusOr<std::string> ResultsFile::State(std::string_view name) {
  const ResultValue values[] = {std::string(name)};
  ASSIGN_OR_RETURN(const ResultValue value, First("SELECT value FROM state WHERE name = ?", values));
  return TextOf(value);
}

absl::StatusOr<int64_t> ResultsFile::IntState(std::string_view name) {
  ASSIGN_OR_RETURN(const std::string text, State(name));
  return std::strtoll(text.c_str(), nullptr, 10);
}

absl::Status ResultsFile::SetState(std::string_view name, std::string_view value) {
  const ResultValue values[] = {std::string(name), std::string(value)};
  return First("INSERT OR REPLACE INTO state (name, value) VALUES (?, ?)", values).status();
}

absl::Status ResultsFile::Put(const ResultRow& row) {
  static const std::string& sql = *new std::string([] {
    std::string places;
    std::string updates;
    for (const ResultColumn& column : ResultColumns()) {
      places += places.empty() ? "?" : ", ?";
      if (column.name == "batch_index") continue;
      updates += fmt::format("{}{} = COALESCE(excluded.{}, {})", updates.empty() ? "" : ", ", column.name, column.name,
                             column.name);
    }
    return fmt::format("INSERT INTO jobs ({}) VALUES ({}) ON CONFLICT (batch_index) DO UPDATE SET {}", ColumnNames(),
                       places, updates);
  }());
  return First(sql, row.values()).status();
}

absl::Status ResultsFile::ForgetEnd(int64_t batch_index) {
  const ResultValue values[] = {batch_index};
  return First(
             "UPDATE jobs SET failure_kind = NULL, stage = NULL, error = NULL, error_code = NULL, fetch_error = NULL, "
             "path = NULL, size_bytes = NULL WHERE batch_index = ?",
             values)
      .status();
}

absl::StatusOr<std::optional<ResultRow>> ResultsFile::Find(int64_t batch_index) {
  const ResultValue values[] = {batch_index};
  std::optional<ResultRow> found;
  RETURN_IF_ERROR(
      Run(fmt::format("SELECT {} FROM jobs WHERE batch_index = ?", ColumnNames()), values, [&found](const auto& row) {
        found = ReadRow(row);
        return absl::OkStatus();
      }));
  return found;
}

absl::Status ResultsFile::ForEach(std::string_view where, const std::function<absl::Status(const ResultRow&)>& see) {
  return Run(
      fmt::format("SELECT {} FROM jobs{}{} ORDER BY batch_index", ColumnNames(), where.empty() ? "" : " WHERE ", where),
      {}, [&see](const auto& row) { return see(ReadRow(row)); });
}

absl::StatusOr<int64_t> ResultsFile::Count(const std::string& query) {
  ASSIGN_OR_RETURN(const ResultValue value, First(query));
  const auto* const count = std::get_if<int64_t>(&value);
  return count == nullptr ? 0 : *count;
}

absl::StatusOr<std::string> ResultsFile::Text(const std::string& query) {
  ASSIGN_OR_RETURN(const ResultValue value, First(query));
  return TextOf(value);
}

absl::StatusOr<std::vector<double>> ResultsFile::Numbers(const std::string& query) {
  std::vector<double> numbers;
  RETURN_IF_ERROR(Run(query, {}, [&numbers](const auto& row) {
    numbers.push_back(std::get<double>(row.Value(0)));  // of columns that are REAL
    return absl::OkStatus();
  }));
  return numbers;
}

}  // namespace flair::cli
