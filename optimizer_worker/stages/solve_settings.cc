// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/solve_settings.h"

#include <algorithm>
#include <thread>

#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::optimizer {

absl::StatusOr<SolveSettings> ReadSettings(const v1::SolveOptions& options) {
  RETURN_IF_ERROR(Validate(options));
  SolveSettings settings;
  const auto take = [](bool given, auto value, auto& target) {
    if (given) target = value;
  };
  settings.seed = static_cast<uint64_t>(options.seed());
  const auto cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  settings.threads = options.thread_count() > 0 ? options.thread_count() : cores;
  take(options.has_max_restart_count(), options.max_restart_count(), settings.max_restarts);
  take(options.has_path_width_m(), options.path_width_m(), settings.path_width_m);
  take(options.has_variant_count(), options.variant_count(), settings.variant_count);
  const v1::Lambdas& lambdas = options.lambdas();
  take(lambdas.has_door_overlap(), lambdas.door_overlap(), settings.lambdas.door_overlap);
  take(lambdas.has_wall_attraction_divisor(), lambdas.wall_attraction_divisor(),
       settings.lambdas.wall_attraction_divisor);
  take(lambdas.has_no_overlap(), lambdas.no_overlap(), settings.lambdas.no_overlap);
  take(lambdas.has_balanced(), lambdas.balanced(), settings.lambdas.balanced);
  take(lambdas.has_in_bounds(), lambdas.in_bounds(), settings.lambdas.in_bounds);
  take(lambdas.has_zone(), lambdas.zone(), settings.lambdas.zone);
  take(lambdas.has_tertiary_in_bounds(), lambdas.tertiary_in_bounds(), settings.lambdas.tertiary_in_bounds);
  take(lambdas.has_on_wall(), lambdas.on_wall(), settings.lambdas.on_wall);
  const v1::Tolerances& tolerances = options.tolerances();
  take(tolerances.has_relative(), tolerances.relative(), settings.tolerances.relative);
  take(tolerances.has_absolute(), tolerances.absolute(), settings.tolerances.absolute);
  take(tolerances.has_max_evaluation_count(), tolerances.max_evaluation_count(), settings.tolerances.max_evaluations);
  if (options.has_time_limit()) {
    settings.time_limit =
        absl::Seconds(options.time_limit().seconds()) + absl::Nanoseconds(options.time_limit().nanos());
  }
  settings.leave_out_misfits = options.misfit_policy() == v1::MISFIT_POLICY_LEAVE_OUT;
  settings.find_contradictions = options.find_contradictions();
  settings.groups = options.groups() != v1::GROUP_POLICY_OFF;
  return settings;
}

}  // namespace flair::optimizer
