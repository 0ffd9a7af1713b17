// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/service/solve_metrics.h"

#include <algorithm>

namespace flair::optimizer {
namespace {

using runtime::MetricFamily;
using runtime::MetricKind;

constexpr MetricFamily kRestarts{.kind = MetricKind::kCounter,
                                 .name = "flair_optimizer_restarts_total",
                                 .help =
                                     "Restarts of the solver: of solves that this program drives (own), wherever "
                                     "they were done, and for other optimizers (peer).",
                                 .labels = {"requester"}};
constexpr MetricFamily kEvaluations{.kind = MetricKind::kCounter,
                                    .name = "flair_optimizer_evaluations_total",
                                    .help = "Evaluations of the cost in these restarts.",
                                    .labels = {"requester"}};
constexpr MetricFamily kConstraints{.kind = MetricKind::kCounter,
                                    .name = "flair_optimizer_constraints_total",
                                    .help = "Constraints of solved layouts, by how they came out.",
                                    .labels = {"outcome"}};
constexpr MetricFamily kStageDuration{.kind = MetricKind::kHistogram,
                                      .name = "flair_optimizer_stage_duration_seconds",
                                      .help = "Wall time of a stage of a solve.",
                                      .labels = {"stage"},
                                      .buckets = runtime::kSecondsBuckets};

double Seconds(const google::protobuf::Duration& duration) {
  return static_cast<double>(duration.seconds()) + 1e-9 * duration.nanos();
}

}  // namespace

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

}  // namespace flair::optimizer
