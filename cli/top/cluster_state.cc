// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/top/cluster_state.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "absl/time/clock.h"
#include "cli/output/artifact_text.h"
#include "cli/output/message_view.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

// A year: enough to tell a jam from a stop, and no more than people care for.
constexpr double kLongestRemaining_s = 24 * 365 * 3600.0;

// Where a stage stands in the pipeline; others after it.
int StageOrder(const std::string& stage) {
  constexpr std::string_view kStages[] = {"language", "translator", "optimizer", "renderer"};
  return static_cast<int>(std::find(std::begin(kStages), std::end(kStages), stage) - std::begin(kStages));
}

// From not known yet to the worst.
int Trouble(v1::WorkerState state) {
  constexpr v1::WorkerState kStates[] = {v1::WORKER_STATE_READY, v1::WORKER_STATE_GONE, v1::WORKER_STATE_BROKEN};
  const auto* found = std::find(std::begin(kStates), std::end(kStates), state);
  return found == std::end(kStates) ? 0 : static_cast<int>(found - std::begin(kStates)) + 1;
}

// Newest batches that are looked at.
constexpr int kBatchLimit = 50;
// Looks after which ended batches are asked for again.
constexpr int kForgetAfter = 8;

}  // namespace

void ClusterState::See(const ClusterLook& look) {
  time_ = look.time;
  json_ = {{"time", absl::FormatTime(absl::RFC3339_full, time_, absl::UTCTimeZone())},
           {"totals", {{"queued_count", look.cluster.queued_count()}}},
           {"batches", Batches(look.batches)},
           {"orchestrators", Orchestrators(look.cluster)},
           {"workers", Workers(look.cluster)},
           {"away", StagesAway(look.cluster)}};
  Json& totals = json_["totals"];
  const Json& counted = json_[json_["orchestrators"].empty() ? "batches" : "orchestrators"];
  for (const char* field : {"running_count", "running_limit", "succeeded_count", "failed_count", "retried_count"}) {
    int64_t total = 0;
    for (const Json& row : counted) total += row.value(field, int64_t{0});
    totals[field] = total;
  }
  totals["jobs_per_second"] = nullptr;
  for (const Json& row : counted) {
    const Json &sum = totals["jobs_per_second"], &rate = row["jobs_per_second"];
    if (!rate.is_null()) totals["jobs_per_second"] = (sum.is_null() ? 0.0 : sum.get<double>()) + rate.get<double>();
  }
}

ClusterState::Json ClusterState::Rate(const std::string& name, absl::Time time, int64_t count) {
  rates_.Add(name, time, count);
  const std::optional<double> rate = rates_.PerSecond(name);
  return rate.has_value() ? Json(*rate) : Json(nullptr);
}

ClusterState::Json ClusterState::Orchestrators(const v1::GetClusterResponse& cluster) {
  Json rows = Json::array();
  for (const v1::OrchestratorStatus& status : cluster.orchestrators()) {
    const absl::Time reported =
        absl::FromUnixSeconds(status.report_time().seconds()) + absl::Nanoseconds(status.report_time().nanos());
    const int64_t ended = status.succeeded_count() + status.failed_count();
    rows.push_back({{"id", status.id()},
                    {"host", status.host()},
                    {"build", status.build()},
                    {"running_count", status.running_count()},
                    {"running_limit", status.running_limit()},
                    {"succeeded_count", status.succeeded_count()},
                    {"failed_count", status.failed_count()},
                    {"retried_count", status.retried_count()},
                    {"jobs_per_second", Rate("orchestrator " + status.id(), reported, ended)},
                    {"seen_s", std::max(0.0, absl::ToDoubleSeconds(time_ - reported))}});
  }
  return rows;
}

ClusterState::Json ClusterState::Workers(const v1::GetClusterResponse& cluster) {
  // A worker as all orchestrators see it: the worst that one says of it, the sum of their calls and of the time.
  struct Seen {
    v1::WorkerStatus worker;
    double seconds = 0;
  };
  std::map<std::pair<std::string, std::string>, Seen> by_address;
  for (const v1::OrchestratorStatus& status : cluster.orchestrators()) {
    for (const v1::WorkerStatus& one : status.workers()) {
      Seen& seen = by_address[{one.stage(), one.address()}];
      if (Trouble(one.state()) >= Trouble(seen.worker.state())) seen.worker.set_state(one.state());
      seen.worker.set_in_flight_count(seen.worker.in_flight_count() + one.in_flight_count());
      seen.worker.set_call_count(seen.worker.call_count() + one.call_count());
      seen.worker.set_failure_count(seen.worker.failure_count() + one.failure_count());
      seen.seconds += static_cast<double>(one.call_count()) * SecondsOf(one.call_duration());
    }
  }
  std::vector<std::pair<std::tuple<int, int>, Json>> rows;
  for (const auto& [key, seen] : by_address) {
    const auto& [stage, address] = key;
    const int64_t calls = seen.worker.call_count();
    rows.push_back({{StageOrder(stage), -Trouble(seen.worker.state())},
                    {{"stage", stage},
                     {"address", address},
                     {"state", EnumInWords(seen.worker.state())},
                     {"in_flight_count", seen.worker.in_flight_count()},
                     {"call_count", calls},
                     {"failure_count", seen.worker.failure_count()},
                     {"call_duration_s", calls > 0 ? seen.seconds / static_cast<double>(calls) : 0.0},
                     {"calls_per_second", Rate("worker " + stage + " " + address, time_, calls)}}});
  }
  std::ranges::stable_sort(rows, {}, [](const auto& row) { return row.first; });
  Json sorted = Json::array();
  for (auto& [order, row] : rows) sorted.push_back(std::move(row));
  return sorted;
}

ClusterState::Json ClusterState::Batches(const std::vector<v1::Batch>& batches) {
  Json rows = Json::array();
  for (const v1::Batch& batch : batches) {
    const Json rate = Rate("batch " + batch.id(), time_, int64_t{batch.job_count()} - batch.open_count());
    // Until the last of its jobs has ended; unknown while none ends or more may follow.
    Json remaining = nullptr;
    if (!batch.open() && batch.state() == v1::BATCH_STATE_ACTIVE && !rate.is_null() && rate > 0.0) {
      remaining = std::min(batch.open_count() / rate.get<double>(), kLongestRemaining_s);
    }
    Json failures = Json::object();
    for (const v1::FailureCount& failure : batch.failures()) {
      failures[EnumInWords(failure.kind())] = failure.job_count();
    }
    rows.push_back({{"id", batch.id()},
                    {"label", batch.label()},
                    {"state", EnumInWords(batch.state())},
                    {"open", batch.open()},
                    {"job_count", batch.job_count()},
                    {"open_count", batch.open_count()},
                    {"running_count", batch.running_count()},
                    {"succeeded_count", batch.succeeded_count()},
                    {"failed_count", batch.failed_count()},
                    {"cancelled_count", batch.cancelled_count()},
                    {"failures", failures},
                    {"jobs_per_second", rate},
                    {"remaining_s", remaining}});
  }
  return rows;
}

absl::StatusOr<ClusterLook> ClusterClient::Look() {
  ASSIGN_OR_RETURN(v1::GetClusterResponse cluster, session_.GetCluster());
  ClusterLook look{absl::Now(), std::move(cluster), {}};
  ASSIGN_OR_RETURN(const std::vector<v1::Batch> listed, session_.ListBatches(kBatchLimit));
  if (++look_count_ % kForgetAfter == 0) ended_.clear();
  for (const v1::Batch& known : listed) {
    if (ended_.contains(known.id())) continue;
    ASSIGN_OR_RETURN(v1::Batch batch, session_.GetBatch(known.id()));
    if (batch.open() || batch.open_count() > 0) {
      look.batches.push_back(std::move(batch));
    } else {
      ended_.insert(known.id());
    }
  }
  return look;
}

}  // namespace flair::cli
