// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/time/time.h"
#include "flair/v1/optimizer_service.pb.h"
#include "worker_runtime/metrics/metrics.h"

namespace flair::optimizer {

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

}  // namespace flair::optimizer
