// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/service/make_optimizer_service.h"

#include <algorithm>

#include "flair/v1/optimizer_service.grpc.pb.h"
#include "flair/v1/worker_service.pb.h"
#include "fmt/format.h"
#include "optimizer_worker/fanout/fan_out.h"
#include "optimizer_worker/service/optimizer_handlers.h"
#include "optimizer_worker/solver/solver.h"
#include "worker_runtime/grpc/channel.h"
#include "worker_runtime/grpc/server_call.h"
#include "worker_runtime/logging/log.h"
#include "worker_runtime/metrics/metrics.h"

namespace flair::optimizer {
namespace {

using runtime::MetricFamily;
using runtime::MetricKind;

constexpr MetricFamily kRestarts{
    .kind = MetricKind::kCounter,
    .name = "flair_optimizer_restarts_total",
    .help = "Restarts of the solver: of this program's own solves, wherever they ran, or for a peer.",
    .labels = {"requester"}};
constexpr MetricFamily kEvaluations{.kind = MetricKind::kCounter,
                                    .name = "flair_optimizer_evaluations_total",
                                    .help = "Evaluations of the cost in these restarts.",
                                    .labels = {"requester"}};
constexpr MetricFamily kConstraints{.kind = MetricKind::kCounter,
                                    .name = "flair_optimizer_constraints_total",
                                    .help = "Constraints of solved layouts, by outcome.",
                                    .labels = {"outcome"}};
constexpr MetricFamily kStageDuration{.kind = MetricKind::kHistogram,
                                      .name = "flair_optimizer_stage_duration_seconds",
                                      .help = "Wall time of a stage of a solve.",
                                      .labels = {"stage"},
                                      .buckets = runtime::kSecondsBuckets};

double Seconds(const google::protobuf::Duration& duration) {
  return static_cast<double>(duration.seconds()) + 1e-9 * duration.nanos();
}

// Counts what solving took, from the answers: nothing is counted while a solver runs. Thread-safe. `metrics` outlives
// it.
class SolveMetrics {
 public:
  explicit SolveMetrics(runtime::Metrics& metrics);

  // To be told of answers (runtime::ObservedHandler).
  void operator()(const v1::SolveRequest& request, const v1::SolveResponse& response, absl::Duration duration) const;
  // Of restarts done for another optimizer.
  void operator()(const v1::SolveRestartsRequest& request, const v1::SolveRestartsResponse& response,
                  absl::Duration duration) const;

 private:
  runtime::Metrics& metrics_;
  runtime::Counter& own_restarts_;
  runtime::Counter& peer_restarts_;
  runtime::Counter& own_evaluations_;
  runtime::Counter& peer_evaluations_;
  runtime::Counter& satisfied_;
  runtime::Counter& violated_;
  runtime::Counter& dropped_;
};

SolveMetrics::SolveMetrics(runtime::Metrics& metrics)
    : metrics_(metrics),
      own_restarts_(metrics.GetCounter(kRestarts, {"own"})),
      peer_restarts_(metrics.GetCounter(kRestarts, {"peer"})),
      own_evaluations_(metrics.GetCounter(kEvaluations, {"own"})),
      peer_evaluations_(metrics.GetCounter(kEvaluations, {"peer"})),
      satisfied_(metrics.GetCounter(kConstraints, {"satisfied"})),
      violated_(metrics.GetCounter(kConstraints, {"violated"})),
      dropped_(metrics.GetCounter(kConstraints, {"dropped"})) {
  metrics.Declare(kStageDuration);
}

void SolveMetrics::operator()(const v1::SolveRequest&, const v1::SolveResponse& response, absl::Duration) const {
  const v1::SolvedLayout& layout = response.solved_layout();
  for (const v1::StageOutcome& stage : layout.stage_outcomes()) {
    own_restarts_.Add(stage.restart_count());
    own_evaluations_.Add(static_cast<double>(stage.evaluation_count()));
  }
  const int stage_count = std::min(layout.stage_outcomes_size(), response.stage_durations_size());
  for (int i = 0; i < stage_count; ++i) {
    metrics_.GetHistogram(kStageDuration, {layout.stage_outcomes(i).stage()})
        .Observe(Seconds(response.stage_durations(i)));
  }
  for (const v1::EdgeOutcome& edge : layout.edge_outcomes()) {
    if (edge.status() == v1::OUTCOME_STATUS_SATISFIED) satisfied_.Add();
    if (edge.status() == v1::OUTCOME_STATUS_VIOLATED) violated_.Add();
    if (edge.status() == v1::OUTCOME_STATUS_DROPPED) dropped_.Add();
  }
}

void SolveMetrics::operator()(const v1::SolveRestartsRequest&, const v1::SolveRestartsResponse& response,
                              absl::Duration) const {
  peer_restarts_.Add(response.outcomes_size());
  for (const v1::RestartOutcome& outcome : response.outcomes()) {
    peer_evaluations_.Add(static_cast<double>(outcome.evaluation_count()));
  }
}

class Service final : public runtime::Service {
 public:
  Service(runtime::WorkerContext& worker, std::vector<std::unique_ptr<PeerOptimizer>> peers)
      : runtime::Service(worker, v1::OptimizerService::service_full_name()),
        identity_(PeerIdentity(worker.build)),
        peers_(std::move(peers), worker.clock,
               [&worker](const std::string& remark) { worker.logger->warn("{}", remark); }) {
    Unary<v1::ListConstraintTypesRequest>("ListConstraintTypes", handlers_);
    Unary<v1::SolveRequest>("Solve", counted_);
    Unary<v1::SolveRestartsRequest>("SolveRestarts", counted_);
    Unary<v1::ResolveRequest>("Resolve", handlers_);
    Unary<v1::EvaluateRequest>("Evaluate", handlers_);
  }

 private:
  // Peers look whose restarts they get before these have come.
  absl::Status Admit(grpc::CallbackServerContext& context, runtime::CallContext& call) override {
    context.AddInitialMetadata(kProducerMetadata, identity_);
    return runtime::Service::Admit(context, call);
  }

  const std::string identity_;
  const NloptSolver solver_;
  PeerPool peers_;
  const OptimizerHandlers handlers_{solver_, peers_};
  const SolveMetrics metrics_{worker_.metrics};
  runtime::ObservedHandler<const OptimizerHandlers, const SolveMetrics&> counted_{handlers_, worker_.clock, metrics_};
};

}  // namespace

absl::StatusOr<std::unique_ptr<grpc::Service>> MakeOptimizerService(const config::v1::OptimizerWorkerConfig& config,
                                                                    runtime::WorkerContext& worker) {
  std::vector<std::unique_ptr<PeerOptimizer>> peers;
  for (int i = 0; i < config.peer_addresses_size(); ++i) {
    absl::StatusOr<std::unique_ptr<PeerOptimizer>> peer =
        MakeGrpcPeer(config.peer_addresses(i), PeerIdentity(worker.build), worker.clock,
                     runtime::ChannelOptionsOf(config.runtime()));
    if (!peer.ok()) {
      return absl::InvalidArgumentError(fmt::format("peer_addresses[{}]: {}", i, std::string(peer.status().message())));
    }
    peers.push_back(*std::move(peer));
  }
  worker.capabilities = {v1::CAPABILITY_DETERMINISTIC, v1::CAPABILITY_EVALUATE, v1::CAPABILITY_RESOLVE,
                         v1::CAPABILITY_SOLVE_RESTARTS, v1::CAPABILITY_VARIANTS};
  return std::make_unique<Service>(worker, std::move(peers));
}

}  // namespace flair::optimizer
