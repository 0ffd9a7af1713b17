// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstdlib>
#include <map>

#include "absl/time/time.h"
#include "cli/batch/results_file.h"
#include "cli/output/artifact_text.h"
#include "cli/output/message_view.h"
#include "cli/output/report_text.h"
#include "fmt/format.h"
#include "fmt/ranges.h"

namespace flair::cli {
namespace {

constexpr std::array<const char*, 16> kStages = {
    "brief",       "room",  "zones",  "objects", "style",  "constraints", "cleaning", "completion",
    "translation", "solve", "render", "view_1",  "view_2", "view_3",      "view_4",   "report"};

constexpr size_t kListedFindings = 20;

constexpr char kInteger[] = "INTEGER";
constexpr char kReal[] = "REAL";
constexpr char kText[] = "TEXT";

std::vector<ResultColumn> MakeColumns() {
  std::vector<ResultColumn> columns = {
      {"batch_index", kInteger, "place in the batch, from 0; names the job's folder"},
      {"line", kInteger, "line of the file, from 1"},
      {"key", kText, "the line's \"id\""},
      {"job_id", kText, "id of the job, for `flair jobs show` and `flair inspect JOB/STAGE`"},
      {"state", kText, "waiting, succeeded, failed or cancelled"},
      {"failure_kind", kText, "input, language, translation, infeasible, worker, timeout or store"},
      {"stage", kText, "the stage that failed"},
      {"error", kText, "what happened, in one sentence"},
      {"error_code", kInteger, "the gRPC status code of the error"},
      {"attempts", kInteger, "runs started"},
      {"seed", kInteger, "the brief's seed"},
      {"text", kText, "the brief's text"},
      {"create_time", kText, "when it was queued, UTC"},
      {"end_time", kText, "when it ended, UTC"},
      {"oob_percent", kReal, "[Paper] OOB: area outside the room, percent"},
      {"oor_percent", kReal, "[Paper] OOR: area of overlaps, percent"},
      {"reachable_floor_share", kReal, "share of the free floor that can be reached"},
      {"reachable_front_share", kReal, "share of the objects whose front can be reached"},
      {"pathway_cost_m3", kReal, "[Paper] pathway cost"},
      {"deepest_overlap_m", kReal, "deepest overlap, metres"},
      {"oob_3d_percent", kReal, "volume outside the room, percent of its volume"},
      {"oor_3d_percent", kReal, "volume of all overlaps, percent of the room's volume"},
      {"deepest_overlap_3d_m", kReal, "the deepest of these, metres"},
      {"unsupported_count", kInteger, "pieces that nothing holds"},
      {"use_count", kInteger, "sentences that say how a piece is used"},
      {"met_use_count", kInteger, "of these, those that hold"},
      {"findings", kText, "physical faults and uses that are not met, in words"},
      {"satisfied_count", kInteger, "constraints that hold"},
      {"violated_count", kInteger, "constraints that do not"},
      {"dropped_count", kInteger, "constraints left out of the problem"},
      {"untranslated_count", kInteger, "sentences that did not become constraints"},
      {"time_s", kReal, "time of all stages, seconds; reused artifacts count 0"},
  };
  for (const char* stage : kStages) {
    columns.push_back({fmt::format("{}_s", stage), kReal, "time of this stage, seconds"});
  }
  columns.insert(columns.end(), {{"model_calls", kInteger, "calls of language models"},
                                 {"input_tokens", kInteger, "tokens of the prompts"},
                                 {"output_tokens", kInteger, "tokens of the answers"},
                                 {"cost_usd", kReal, "US dollars"}});
  for (const char* artifact :
       {"brief", "room", "zones", "objects", "style", "constraints_raw", "constraints", "constraints_completed",
        "graph", "layout", "picture", "picture_2", "picture_3", "picture_4", "picture_5", "report"}) {
    columns.push_back({fmt::format("{}_sha256", artifact), kText, "digest of this artifact, which is its id"});
  }
  columns.insert(columns.end(), {{"path", kText, "folder or tar file with the job's files, relative to DIR"},
                                 {"size_bytes", kInteger, "size of the kept files"},
                                 {"fetch_error", kText, "why its results could not be fetched"},
                                 {"end_sequence", kInteger, "order in which jobs ended; used by the collector"}});
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
    if (std::ranges::find(kStages, timing.stage()) != kStages.end()) {
      row.Set(timing.stage() + "_s", SecondsOf(timing.duration()));
    }
  }
  row.Set("time_s", time_s);
  row.Set("model_calls", int64_t{report.model_usage().call_count()});
  row.Set("input_tokens", report.model_usage().input_token_count());
  row.Set("output_tokens", report.model_usage().output_token_count());
  row.Set("cost_usd", report.model_usage().cost_usd());
}

}  // namespace flair::cli
