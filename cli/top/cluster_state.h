// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/channel.h>

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/v1/orchestrator_service.grpc.pb.h"
#include "flair/v1/orchestrator_service.pb.h"

namespace flair::cli {

// How fast counts grow, by name, over the last `window`. A count that falls has begun anew.
class RateMeter {
 public:
  explicit RateMeter(absl::Duration window) : window_(window) {}

  // `time` is when it was so many; a look at the same time says nothing new.
  void Add(const std::string& name, absl::Time time, int64_t count) {
    std::deque<Look>& looks = looks_[name];
    if (!looks.empty() && count < looks.back().count) looks.clear();
    if (!looks.empty() && time <= looks.back().time) return;
    looks.push_back({time, count});
    while (looks.size() > 2 && time - looks[1].time >= window_) looks.pop_front();
  }

  // A second; nothing before two looks.
  std::optional<double> PerSecond(const std::string& name) const {
    const auto found = looks_.find(name);
    if (found == looks_.end() || found->second.size() < 2) return std::nullopt;
    const Look& first = found->second.front();
    const Look& last = found->second.back();
    return static_cast<double>(last.count - first.count) / absl::ToDoubleSeconds(last.time - first.time);
  }

 private:
  struct Look {
    absl::Time time;
    int64_t count;
  };
  const absl::Duration window_;
  std::map<std::string, std::deque<Look>> looks_;
};

// What is known of a cluster, from look to look.

// One look. A store that no orchestrator serves has none; processes that work on it say nothing of themselves.
struct ClusterLook {
  absl::Time time;
  v1::GetClusterResponse cluster;
  // Those that have not ended, newest first.
  std::vector<v1::Batch> batches;
};

struct OrchestratorRow {
  v1::OrchestratorStatus status;
  std::optional<double> jobs_per_second;
  // Since it was heard of.
  absl::Duration age;
};

// A worker as all orchestrators together see it.
struct WorkerRow {
  std::string stage;
  std::string address;
  // The worst that an orchestrator says of it, and how many of them say otherwise than ready.
  v1::WorkerState state = v1::WORKER_STATE_UNSPECIFIED;
  int in_flight_count = 0;
  int64_t call_count = 0;
  int64_t failure_count = 0;
  // Mean over the orchestrators' calls.
  double call_seconds = 0;
  std::optional<double> calls_per_second;
};

struct BatchRow {
  v1::Batch batch;
  std::optional<double> jobs_per_second;
  // Until the last of its jobs has ended; unknown while none ends or more may follow.
  std::optional<absl::Duration> remaining;

  int64_t ended_count() const { return int64_t{batch.job_count()} - batch.open_count(); }
};

// Of all orchestrators; without any, of the batches that have not ended.
struct ClusterTotals {
  int64_t queued_count = 0;
  int64_t running_count = 0;
  // Unknown when 0.
  int64_t running_limit = 0;
  int64_t succeeded_count = 0;
  int64_t failed_count = 0;
  int64_t retried_count = 0;
  // Nothing before two looks.
  std::optional<double> jobs_per_second;
};

class ClusterState {
 public:
  void See(const ClusterLook& look);

  absl::Time time() const { return time_; }
  const ClusterTotals& totals() const { return totals_; }
  // In the order of the answer: the one that was asked first.
  const std::vector<OrchestratorRow>& orchestrators() const { return orchestrators_; }
  // By stage, in the order of the pipeline; those in trouble first.
  const std::vector<WorkerRow>& workers() const { return workers_; }
  const std::vector<BatchRow>& batches() const { return batches_; }

 private:
  void SeeOrchestrators(const v1::GetClusterResponse& cluster);
  void SeeWorkers(const v1::GetClusterResponse& cluster);
  void SeeBatches(const std::vector<v1::Batch>& batches);
  void CountBatches();

  absl::Time time_;
  ClusterTotals totals_;
  std::vector<OrchestratorRow> orchestrators_;
  std::vector<WorkerRow> workers_;
  std::vector<BatchRow> batches_;
  RateMeter rates_{absl::Seconds(15)};
};

// Asks an orchestrator how its cluster does.
class ClusterClient {
 public:
  explicit ClusterClient(const std::shared_ptr<grpc::Channel>& channel)
      : stub_(v1::OrchestratorService::NewStub(channel)) {}

  // Waits a few seconds for an answer at most.
  absl::StatusOr<ClusterLook> Look();

 private:
  absl::Status AddBatches(ClusterLook& look);

  const std::unique_ptr<v1::OrchestratorService::StubInterface> stub_;
  // Batches that had ended; asked for again now and then, for those that are retried.
  std::set<std::string> ended_;
  int look_count_ = 0;
};

}  // namespace flair::cli
