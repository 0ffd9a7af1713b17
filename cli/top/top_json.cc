// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/top/top_json.h"

#include <optional>

#include "absl/strings/ascii.h"
#include "absl/strings/strip.h"
#include "nlohmann/json.hpp"

namespace flair::cli {
namespace {

using Json = nlohmann::ordered_json;

Json OrNull(const std::optional<double>& value) { return value.has_value() ? Json(*value) : Json(nullptr); }

std::string Lower(const std::string& name, const char* prefix) {
  return absl::AsciiStrToLower(absl::StripPrefix(name, prefix));
}

Json TotalsJson(const ClusterTotals& totals) {
  return {{"queued_count", totals.queued_count},
          {"running_count", totals.running_count},
          {"running_limit", totals.running_limit},
          {"succeeded_count", totals.succeeded_count},
          {"failed_count", totals.failed_count},
          {"retried_count", totals.retried_count},
          {"jobs_per_second", OrNull(totals.jobs_per_second)}};
}

Json BatchJson(const BatchRow& row) {
  const v1::Batch& batch = row.batch;
  Json remaining = nullptr;
  if (row.remaining.has_value()) remaining = absl::ToDoubleSeconds(*row.remaining);
  Json failures = Json::object();
  for (const v1::FailureCount& failure : batch.failures()) {
    failures[Lower(v1::FailureKind_Name(failure.kind()), "FAILURE_KIND_")] = failure.job_count();
  }
  return {{"id", batch.id()},
          {"label", batch.label()},
          {"state", Lower(v1::BatchState_Name(batch.state()), "BATCH_STATE_")},
          {"open", batch.open()},
          {"job_count", batch.job_count()},
          {"open_count", batch.open_count()},
          {"running_count", batch.running_count()},
          {"succeeded_count", batch.succeeded_count()},
          {"failed_count", batch.failed_count()},
          {"cancelled_count", batch.cancelled_count()},
          {"failures", failures},
          {"jobs_per_second", OrNull(row.jobs_per_second)},
          {"remaining_s", remaining}};
}

Json OrchestratorJson(const OrchestratorRow& row) {
  const v1::OrchestratorStatus& status = row.status;
  return {{"id", status.id()},
          {"host", status.host()},
          {"build", status.build()},
          {"running_count", status.running_count()},
          {"running_limit", status.running_limit()},
          {"succeeded_count", status.succeeded_count()},
          {"failed_count", status.failed_count()},
          {"retried_count", status.retried_count()},
          {"jobs_per_second", OrNull(row.jobs_per_second)},
          {"seen_s", absl::ToDoubleSeconds(row.age)}};
}

Json WorkerJson(const WorkerRow& row) {
  return {{"stage", row.stage},
          {"address", row.address},
          {"state", Lower(v1::WorkerState_Name(row.state), "WORKER_STATE_")},
          {"in_flight_count", row.in_flight_count},
          {"call_count", row.call_count},
          {"failure_count", row.failure_count},
          {"call_duration_s", row.call_seconds},
          {"calls_per_second", OrNull(row.calls_per_second)}};
}

template <typename Rows, typename ToJson>
Json Array(const Rows& rows, const ToJson& to_json) {
  Json array = Json::array();
  for (const auto& row : rows) array.push_back(to_json(row));
  return array;
}

}  // namespace

std::string TopJson(const ClusterState& state) {
  const Json json = {{"time", absl::FormatTime(absl::RFC3339_full, state.time(), absl::UTCTimeZone())},
                     {"totals", TotalsJson(state.totals())},
                     {"batches", Array(state.batches(), BatchJson)},
                     {"orchestrators", Array(state.orchestrators(), OrchestratorJson)},
                     {"workers", Array(state.workers(), WorkerJson)}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace flair::cli
