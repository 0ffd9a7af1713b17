// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/top/cluster_state.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "absl/time/clock.h"
#include "worker_runtime/bootstrap/call_context.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {

namespace {

absl::Time ToTime(const google::protobuf::Timestamp& time) {
  return absl::FromUnixSeconds(time.seconds()) + absl::Nanoseconds(time.nanos());
}

double Seconds(const google::protobuf::Duration& duration) {
  return static_cast<double>(duration.seconds()) + 1e-9 * duration.nanos();
}

// Where a stage stands in the pipeline; others after it.
int StageOrder(const std::string& stage) {
  constexpr std::string_view kStages[] = {"language", "translator", "optimizer", "renderer"};
  return static_cast<int>(std::find(std::begin(kStages), std::end(kStages), stage) - std::begin(kStages));
}

// From not known yet to the worst.
int Trouble(v1::WorkerState state) {
  switch (state) {
    case v1::WORKER_STATE_READY:
      return 1;
    case v1::WORKER_STATE_GONE:
      return 2;
    case v1::WORKER_STATE_BROKEN:
      return 3;
    default:
      return 0;
  }
}

// Enough to tell a jam from a stop, and no more than people care for.
constexpr absl::Duration kLongestRemaining = absl::Hours(24 * 365);

}  // namespace

void ClusterState::See(const ClusterLook& look) {
  time_ = look.time;
  totals_ = {};
  totals_.queued_count = look.cluster.queued_count();
  SeeOrchestrators(look.cluster);
  SeeWorkers(look.cluster);
  SeeBatches(look.batches);
  if (orchestrators_.empty()) CountBatches();
}

void ClusterState::CountBatches() {
  for (const BatchRow& row : batches_) {
    totals_.running_count += row.batch.running_count();
    totals_.succeeded_count += row.batch.succeeded_count();
    totals_.failed_count += row.batch.failed_count();
    if (row.jobs_per_second.has_value()) {
      totals_.jobs_per_second = totals_.jobs_per_second.value_or(0) + *row.jobs_per_second;
    }
  }
}

void ClusterState::SeeOrchestrators(const v1::GetClusterResponse& cluster) {
  orchestrators_.clear();
  for (const v1::OrchestratorStatus& status : cluster.orchestrators()) {
    const absl::Time reported = ToTime(status.report_time());
    const std::string name = "orchestrator " + status.id();
    rates_.Add(name, reported, status.succeeded_count() + status.failed_count());
    const std::optional<double> rate = rates_.PerSecond(name);
    totals_.running_count += status.running_count();
    totals_.running_limit += status.running_limit();
    totals_.succeeded_count += status.succeeded_count();
    totals_.failed_count += status.failed_count();
    totals_.retried_count += status.retried_count();
    if (rate.has_value()) totals_.jobs_per_second = totals_.jobs_per_second.value_or(0) + *rate;
    orchestrators_.push_back({status, rate, std::max(absl::ZeroDuration(), time_ - reported)});
  }
}

void ClusterState::SeeWorkers(const v1::GetClusterResponse& cluster) {
  std::map<std::pair<std::string, std::string>, WorkerRow> rows;
  for (const v1::OrchestratorStatus& status : cluster.orchestrators()) {
    for (const v1::WorkerStatus& worker : status.workers()) {
      WorkerRow& row = rows[{worker.stage(), worker.address()}];
      row.stage = worker.stage();
      row.address = worker.address();
      if (Trouble(worker.state()) >= Trouble(row.state)) row.state = worker.state();
      row.in_flight_count += worker.in_flight_count();
      row.call_count += worker.call_count();
      row.failure_count += worker.failure_count();
      row.call_seconds += static_cast<double>(worker.call_count()) * Seconds(worker.call_duration());
    }
  }
  workers_.clear();
  for (auto& [key, row] : rows) {
    if (row.call_count > 0) row.call_seconds /= static_cast<double>(row.call_count);
    const std::string name = "worker " + row.stage + " " + row.address;
    rates_.Add(name, time_, row.call_count);
    row.calls_per_second = rates_.PerSecond(name);
    workers_.push_back(std::move(row));
  }
  std::stable_sort(workers_.begin(), workers_.end(), [](const WorkerRow& a, const WorkerRow& b) {
    return std::make_tuple(StageOrder(a.stage), -Trouble(a.state)) <
           std::make_tuple(StageOrder(b.stage), -Trouble(b.state));
  });
}

void ClusterState::SeeBatches(const std::vector<v1::Batch>& batches) {
  batches_.clear();
  for (const v1::Batch& batch : batches) {
    BatchRow row{batch, std::nullopt, std::nullopt};
    const std::string name = "batch " + batch.id();
    rates_.Add(name, time_, row.ended_count());
    row.jobs_per_second = rates_.PerSecond(name);
    if (!batch.open() && batch.state() == v1::BATCH_STATE_ACTIVE && row.jobs_per_second.value_or(0) > 0) {
      row.remaining = std::min(absl::Seconds(batch.open_count() / *row.jobs_per_second), kLongestRemaining);
    }
    batches_.push_back(std::move(row));
  }
}

namespace {

using Stub = v1::OrchestratorService::StubInterface;

constexpr absl::Duration kAnswerWithin = absl::Seconds(4);
// Newest batches that are looked at.
constexpr int kBatchLimit = 50;
// Looks after which ended batches are asked for again.
constexpr int kForgetAfter = 8;

}  // namespace

absl::StatusOr<ClusterLook> ClusterClient::Look() {
  runtime::CallContext call("", absl::Now() + kAnswerWithin, runtime::SystemClock());
  absl::StatusOr<v1::GetClusterResponse> cluster =
      runtime::UnaryRequest(*stub_, &Stub::GetCluster, v1::GetClusterRequest(), call);
  if (!cluster.ok()) return cluster.status();
  ClusterLook look{absl::Now(), *std::move(cluster), {}};
  RETURN_IF_ERROR(AddBatches(look));
  return look;
}

absl::Status ClusterClient::AddBatches(ClusterLook& look) {
  runtime::CallContext call("", absl::Now() + kAnswerWithin, runtime::SystemClock());
  v1::ListBatchesRequest list;
  list.set_page_size(kBatchLimit);
  ASSIGN_OR_RETURN(const v1::ListBatchesResponse listed, runtime::UnaryRequest(*stub_, &Stub::ListBatches, list, call));
  if (++look_count_ % kForgetAfter == 0) ended_.clear();
  for (const v1::Batch& known : listed.batches()) {
    if (ended_.contains(known.id())) continue;
    v1::GetBatchRequest get;
    get.set_batch_id(known.id());
    ASSIGN_OR_RETURN(v1::GetBatchResponse got, runtime::UnaryRequest(*stub_, &Stub::GetBatch, get, call));
    if (got.batch().open() || got.batch().open_count() > 0) {
      look.batches.push_back(std::move(*got.mutable_batch()));
    } else {
      ended_.insert(known.id());
    }
  }
  return absl::OkStatus();
}

}  // namespace flair::cli
