// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/batch/result_row.h"

#include <array>
#include <cstdlib>
#include <map>

#include "absl/strings/ascii.h"
#include "absl/time/time.h"
#include "cli/output/artifact_text.h"
#include "fmt/format.h"

namespace flair::cli {
namespace {

constexpr std::array<const char*, 16> kStages = {
    "brief",       "room",  "zones",  "objects", "style",  "constraints", "cleaning", "completion",
    "translation", "solve", "render", "view_1",  "view_2", "view_3",      "view_4",   "report"};

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
    columns.push_back({fmt::format("{}_sha256", artifact), kText, "digest, which is the id, of this artifact"});
  }
  columns.insert(columns.end(), {{"path", kText, "folder or tar file with the job's files, relative to DIR"},
                                 {"size_bytes", kInteger, "size of the kept files"},
                                 {"fetch_error", kText, "why its results could not be fetched"},
                                 {"end_sequence", kInteger, "order in which jobs ended; used by the collector"}});
  return columns;
}

double Seconds(const google::protobuf::Duration& duration) {
  return static_cast<double>(duration.seconds()) + 1e-9 * duration.nanos();
}

std::string TimeText(const google::protobuf::Timestamp& time) {
  const absl::Time value = absl::FromUnixSeconds(time.seconds()) + absl::Nanoseconds(time.nanos());
  return absl::FormatTime("%Y-%m-%d %H:%M:%E3S", value, absl::UTCTimeZone());
}

template <typename Word>
std::string LowerWithout(const Word& name, std::string_view prefix) {
  return absl::AsciiStrToLower(std::string(name).substr(prefix.size()));
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

std::string JobStateWord(v1::JobState state) {
  if (state == v1::JOB_STATE_QUEUED) return "waiting";
  return v1::JobState_IsValid(state) ? LowerWithout(v1::JobState_Name(state), "JOB_STATE_") : "unknown";
}

std::string FailureKindWord(v1::FailureKind kind) {
  if (kind == v1::FAILURE_KIND_UNSPECIFIED) return "";
  return v1::FailureKind_IsValid(kind) ? LowerWithout(v1::FailureKind_Name(kind), "FAILURE_KIND_") : "unknown";
}

v1::FailureKind FailureKindOf(std::string_view word) {
  for (int kind = v1::FAILURE_KIND_INPUT; kind < v1::FailureKind_ARRAYSIZE; ++kind) {
    if (FailureKindWord(static_cast<v1::FailureKind>(kind)) == word) return static_cast<v1::FailureKind>(kind);
  }
  return v1::FAILURE_KIND_UNSPECIFIED;
}

std::vector<std::string> FailureKindWords() {
  std::vector<std::string> words;
  for (int kind = v1::FAILURE_KIND_INPUT; kind < v1::FailureKind_ARRAYSIZE; ++kind) {
    words.push_back(FailureKindWord(static_cast<v1::FailureKind>(kind)));
  }
  return words;
}

ResultRow RowOf(const v1::Job& job) {
  ResultRow row;
  row.Set("batch_index", job.batch_index());
  row.Set("job_id", job.id());
  row.Set("state", JobStateWord(job.state()));
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
  const v1::LayoutMetrics& metrics = report.metrics();
  row.Set("oob_percent", metrics.oob_percent());
  row.Set("oor_percent", metrics.oor_percent());
  row.Set("reachable_floor_share", metrics.reachable_floor_share());
  row.Set("reachable_front_share", metrics.reachable_front_share());
  row.Set("pathway_cost_m3", metrics.pathway_cost_m3());
  row.Set("deepest_overlap_m", metrics.deepest_overlap_m());
  const v1::ConstraintSummary& constraints = report.constraints();
  row.Set("satisfied_count", int64_t{constraints.satisfied_count()});
  row.Set("violated_count", int64_t{constraints.violated_count()});
  row.Set("dropped_count", int64_t{constraints.dropped_count()});
  row.Set("untranslated_count", int64_t{constraints.untranslated_count()});
  double time_s = 0;
  for (const v1::StageTiming& timing : report.stage_timings()) {
    if (timing.reused()) continue;
    time_s += Seconds(timing.duration());
    if (std::ranges::find(kStages, timing.stage()) != kStages.end()) {
      row.Set(timing.stage() + "_s", Seconds(timing.duration()));
    }
  }
  row.Set("time_s", time_s);
  row.Set("model_calls", int64_t{report.model_usage().call_count()});
  row.Set("input_tokens", report.model_usage().input_token_count());
  row.Set("output_tokens", report.model_usage().output_token_count());
  row.Set("cost_usd", report.model_usage().cost_usd());
}

}  // namespace flair::cli
