// SPDX-License-Identifier: GPL-3.0-or-later
// How to solve, with every default filled in.
#pragma once

#include <cstdint>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/v1/optimizer_service.pb.h"

namespace flair::optimizer {

// The paper's factors of the whole-room terms; names as in flair.v1.Lambdas.
struct LambdaValues {
  double door_overlap = 100;
  double wall_attraction_divisor = 20;
  double no_overlap = 5;
  double balanced = 10;
  double in_bounds = 10;
  double zone = 10;
  double tertiary_in_bounds = 500;
  double on_wall = 500;
};

// When a descent along the gradient ends; names as in flair.v1.Tolerances.
struct ToleranceValues {
  double relative = 1e-4;
  double absolute = 1e-5;
  int max_evaluations = 60;
};

struct SolveSettings {
  uint64_t seed = 0;
  // 0: each stage's own number.
  int max_restarts = 0;
  int threads = 1;
  double path_width_m = 0.6;
  LambdaValues lambdas;
  ToleranceValues tolerances;
  int variant_count = 1;
  // Objects that do not fit are left out instead of kept where they are least bad.
  bool leave_out_misfits = false;
  // Search for groups of constraints that cannot hold together.
  bool find_contradictions = false;
  // What is used together is placed as one piece first; else in the paper's order.
  bool groups = true;
  // Of wall time; infinite when the result may depend on no clock.
  absl::Duration time_limit = absl::InfiniteDuration();
};

// The settings with defaults filled in. INVALID_ARGUMENT names the field, its value and what would be right.
absl::StatusOr<SolveSettings> ReadSettings(const v1::SolveOptions& options);

}  // namespace flair::optimizer
