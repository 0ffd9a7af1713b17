// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/time/time.h"
#include "flair/v1/renderer_service.pb.h"
#include "worker_runtime/metrics/metrics.h"

namespace flair::renderer {

// Counts what pictures take, by view. Thread-safe. `metrics` outlives it.
class RenderMetrics {
 public:
  explicit RenderMetrics(runtime::Metrics& metrics);

  // To be told of answers (runtime::ObservedHandler).
  void operator()(const v1::RenderRequest& request, const v1::RenderResponse& response, absl::Duration duration) const;

 private:
  runtime::Metrics& metrics_;
};

}  // namespace flair::renderer
