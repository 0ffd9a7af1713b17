// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <map>
#include <tuple>

#include "absl/time/time.h"
#include "cli/batch/results_file.h"
#include "cli/output/artifact_text.h"
#include "cli/output/message_view.h"
#include "cli/output/report_text.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "nlohmann/json.hpp"

namespace flair {
std::string_view ResultColumnTable();  // result_columns.json, embedded: name, type and meaning of each
}

namespace flair::cli {
namespace {

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
