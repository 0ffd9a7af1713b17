// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/batch/results_file.h"

#include <sqlite3.h>

#include "absl/cleanup/cleanup.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_replace.h"
#include "cli/exit_code.h"
#include "fmt/format.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

constexpr int kBusyTimeoutMs = 20000;
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

int Bind(sqlite3_stmt* statement, int place, const ResultValue& value) {
  if (const auto* number = std::get_if<int64_t>(&value)) return sqlite3_bind_int64(statement, place, *number);
  if (const auto* real = std::get_if<double>(&value)) return sqlite3_bind_double(statement, place, *real);
  if (const auto* text = std::get_if<std::string>(&value)) {
    return sqlite3_bind_text64(statement, place, text->data(), text->size(), SQLITE_TRANSIENT, SQLITE_UTF8);
  }
  return sqlite3_bind_null(statement, place);
}

ResultValue Read(sqlite3_stmt* statement, int column) {
  switch (sqlite3_column_type(statement, column)) {
    case SQLITE_INTEGER:
      return sqlite3_column_int64(statement, column);
    case SQLITE_FLOAT:
      return sqlite3_column_double(statement, column);
    case SQLITE_TEXT:
      return std::string(reinterpret_cast<const char*>(sqlite3_column_text(statement, column)),
                         static_cast<size_t>(sqlite3_column_bytes(statement, column)));
    default:
      return {};
  }
}

std::string TextOf(const ResultValue& value) {
  const auto* const text = std::get_if<std::string>(&value);
  return text == nullptr ? "" : *text;
}

ResultRow ReadRow(sqlite3_stmt* statement) {
  ResultRow row;
  for (size_t i = 0; i < row.values().size(); ++i) row.values()[i] = Read(statement, static_cast<int>(i));
  return row;
}

}  // namespace

absl::StatusOr<std::unique_ptr<ResultsFile>> ResultsFile::Open(const std::filesystem::path& path) {
  sqlite3* connection = nullptr;
  sqlite3_open_v2(path.c_str(), &connection, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX, nullptr);
  std::unique_ptr<ResultsFile> file(new ResultsFile(connection, path.string()));
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

ResultsFile::~ResultsFile() {
  for (auto& [sql, statement] : statements_) sqlite3_finalize(statement);
  sqlite3_close(connection_);
}

absl::Status ResultsFile::Error() const {
  const std::string message = fmt::format("{}: {}", path_, sqlite3_errmsg(connection_));
  const int code = sqlite3_errcode(connection_) & 0xff;
  if (code == SQLITE_CORRUPT) return absl::DataLossError(message + "; move it away to collect the results again");
  if (code == SQLITE_NOTADB) return FileError("{}: is not a database of flair batch", path_);
  return FileError(message);
}

absl::Status ResultsFile::Execute(const std::string& sql) {
  return sqlite3_exec(connection_, sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK ? absl::OkStatus() : Error();
}

absl::Status ResultsFile::Configure() {
  sqlite3_busy_timeout(connection_, kBusyTimeoutMs);
  RETURN_IF_ERROR(Execute("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL"));
  return Change([this]() -> absl::Status {
    ASSIGN_OR_RETURN(const int64_t version, Count("PRAGMA user_version"));
    ASSIGN_OR_RETURN(const int64_t tables, Count("SELECT COUNT(*) FROM sqlite_schema"));
    if (tables == 0) return Execute(SchemaSql());
    ASSIGN_OR_RETURN(const int64_t application, Count("PRAGMA application_id"));
    if (application != kApplicationId) return FileError("{}: is not a database of flair batch", path_);
    if (version == kVersion) return absl::OkStatus();
    return FileError("{}: has version {}, this program knows {}; use the Flair that made it, or another --out", path_,
                     version, kVersion);
  });
}

absl::Status ResultsFile::Run(const std::string& sql, std::span<const ResultValue> values, const RowTaker& see) {
  const std::lock_guard lock(mutex_);
  sqlite3_stmt*& statement = statements_[sql];
  if (statement == nullptr) {
    sqlite3_prepare_v3(connection_, sql.data(), static_cast<int>(sql.size()), SQLITE_PREPARE_PERSISTENT, &statement,
                       nullptr);
  }
  if (statement == nullptr) return Error();
  // So that it holds no lock.
  const absl::Cleanup reset = [used = statement] {
    sqlite3_reset(used);
    sqlite3_clear_bindings(used);
  };
  sqlite3_stmt* const used = statement;
  for (size_t i = 0; i < values.size(); ++i) Bind(used, static_cast<int>(i) + 1, values[i]);
  while (true) {
    const int code = sqlite3_step(used);
    if (code == SQLITE_DONE) return absl::OkStatus();
    if (code != SQLITE_ROW) return Error();
    RETURN_IF_ERROR(see(used));
  }
}

absl::StatusOr<ResultValue> ResultsFile::First(const std::string& sql, std::span<const ResultValue> values) {
  ResultValue first;
  RETURN_IF_ERROR(Run(sql, values, [&first](sqlite3_stmt* row) {
    first = Read(row, 0);
    return absl::OkStatus();
  }));
  return first;
}

absl::Status ResultsFile::Change(const std::function<absl::Status()>& change) {
  const std::lock_guard lock(mutex_);
  RETURN_IF_ERROR(Execute("BEGIN IMMEDIATE"));
  absl::Status status = change();
  if (status.ok()) status = Execute("COMMIT");
  if (!status.ok()) sqlite3_exec(connection_, "ROLLBACK", nullptr, nullptr, nullptr);
  return status;
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
      Run(fmt::format("SELECT {} FROM jobs WHERE batch_index = ?", ColumnNames()), values, [&found](sqlite3_stmt* row) {
        found = ReadRow(row);
        return absl::OkStatus();
      }));
  return found;
}

absl::Status ResultsFile::ForEach(std::string_view where, const std::function<absl::Status(const ResultRow&)>& see) {
  return Run(
      fmt::format("SELECT {} FROM jobs{}{} ORDER BY batch_index", ColumnNames(), where.empty() ? "" : " WHERE ", where),
      {}, [&see](sqlite3_stmt* row) { return see(ReadRow(row)); });
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
  RETURN_IF_ERROR(Run(query, {}, [&numbers](sqlite3_stmt* row) {
    numbers.push_back(sqlite3_column_double(row, 0));
    return absl::OkStatus();
  }));
  return numbers;
}

}  // namespace flair::cli
