// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/batch/results_file.h"

#include <cstdlib>
#include <map>
#include <tuple>

#include "absl/strings/match.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_replace.h"
#include "absl/time/time.h"
#include "cli/exit_code.h"
#include "cli/output/artifact_text.h"
#include "cli/output/message_view.h"
#include "cli/output/report_text.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "nlohmann/json.hpp"
#include "worker_runtime/status/status_macros.h"

namespace flair {
std::string_view ResultColumnTable();  // result_columns.json, embedded: name, type and meaning of each
}

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

constexpr size_t kListedFindings = 20;

std::vector<ResultColumn> MakeColumns() {
  std::vector<ResultColumn> columns;
  for (const auto& [name, type, meaning] : nlohmann::json::parse(ResultColumnTable())
                                               .get<std::vector<std::tuple<std::string, std::string, std::string>>>()) {
    columns.push_back({name, type, meaning});
  }
  return columns;
}

std::string TimeText(const google::protobuf::Timestamp& time) {
  const absl::Time value = absl::FromUnixSeconds(time.seconds()) + absl::Nanoseconds(time.nanos());
  return absl::FormatTime("%Y-%m-%d %H:%M:%E3S", value, absl::UTCTimeZone());
}

// The fields of a message that have a column of their name.
void AddFields(const google::protobuf::Message& message, ResultRow& row) {
  using google::protobuf::FieldDescriptor;
  for (const ResultColumn& column : ResultColumns()) {
    const FieldDescriptor* const field = message.GetDescriptor()->FindFieldByName(column.name);
    if (field == nullptr || field->is_repeated()) continue;
    if (field->has_presence() && !message.GetReflection()->HasField(message, field)) continue;
    if (field->cpp_type() == FieldDescriptor::CPPTYPE_DOUBLE) {
      row.Set(column.name, message.GetReflection()->GetDouble(message, field));
    } else {
      row.Set(column.name, int64_t{message.GetReflection()->GetInt32(message, field)});
    }
  }
}

void AddArtifacts(const v1::Job& job, ResultRow& row) {
  int picture_count = 0;
  for (const v1::ArtifactRef& ref : job.artifacts()) {
    std::string name = FileStem(ref.kind());
    if (ref.kind() == v1::ARTIFACT_KIND_REPORT) name = "report";
    if (ref.kind() == v1::ARTIFACT_KIND_PREVIEW) {
      if (++picture_count > 5) continue;
      name = picture_count == 1 ? "picture" : fmt::format("picture_{}", picture_count);
    }
    if (!name.empty()) row.Set(name + "_sha256", ref.id());
  }
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
  return status.ok() || absl::IsDataLoss(status) ? status : FileError("{}: {}", path_, status.message());
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

std::span<const ResultColumn> ResultColumns() {
  static const std::vector<ResultColumn>& columns = *new std::vector<ResultColumn>(MakeColumns());
  return columns;
}

size_t ColumnPlace(std::string_view name) {
  static const auto& places = *[] {
    auto* made = new std::map<std::string, size_t, std::less<>>;
    for (const ResultColumn& column : ResultColumns()) made->emplace(column.name, made->size());
    return made;
  }();
  const auto found = places.find(name);
  if (found == places.end()) std::abort();  // a name in our own code
  return found->second;
}

std::string ResultRow::Text(std::string_view column) const {
  const auto* text = std::get_if<std::string>(&Get(column));
  return text == nullptr ? "" : *text;
}

int64_t ResultRow::Int(std::string_view column) const {
  const auto* number = std::get_if<int64_t>(&Get(column));
  return number == nullptr ? 0 : *number;
}

std::string FailureKindWord(v1::FailureKind kind) {
  return kind == v1::FAILURE_KIND_UNSPECIFIED ? "" : EnumInWords(kind);
}

ResultRow RowOf(const v1::Job& job) {
  ResultRow row;
  row.Set("batch_index", job.batch_index());
  row.Set("job_id", job.id());
  row.Set("state", job.state() == v1::JOB_STATE_QUEUED ? "waiting" : EnumInWords(job.state()));
  if (job.state() == v1::JOB_STATE_FAILED) {
    row.Set("failure_kind", FailureKindWord(job.failure_kind()));
    row.Set("stage", job.stage());
    row.Set("error", job.error());
    row.Set("error_code", int64_t{job.error_code()});
  }
  row.Set("attempts", int64_t{job.attempt_count()});
  row.Set("seed", job.spec().brief().seed());
  row.Set("text", job.spec().brief().text());
  if (job.has_create_time()) row.Set("create_time", TimeText(job.create_time()));
  if (job.has_end_time()) row.Set("end_time", TimeText(job.end_time()));
  AddArtifacts(job, row);
  return row;
}

void AddReport(const v1::Report& report, ResultRow& row) {
  AddFields(report.metrics(), row);
  row.Set("findings", fmt::format("{}", fmt::join(WrongInWords(report.metrics(), kListedFindings), "; ")));
  AddFields(report.constraints(), row);
  double time_s = 0;
  for (const v1::StageTiming& timing : report.stage_timings()) {
    if (timing.reused()) continue;
    time_s += SecondsOf(timing.duration());
    const std::string column = timing.stage() + "_s";
    if (std::ranges::find(ResultColumns(), column, &ResultColumn::name) == ResultColumns().end()) continue;
    row.Set(column, SecondsOf(timing.duration()));
  }
  row.Set("time_s", time_s);
  row.Set("model_calls", int64_t{report.model_usage().call_count()});
  row.Set("input_tokens", report.model_usage().input_token_count());
  row.Set("output_tokens", report.model_usage().output_token_count());
  row.Set("cost_usd", report.model_usage().cost_usd());
}

}  // namespace flair::cli
