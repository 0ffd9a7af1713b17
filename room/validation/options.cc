// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "room/validation/checks.h"

namespace flair::validation {
namespace {

constexpr Range kSeed{.least = 0, .most = 9007199254740992.0, .open_most = true};
constexpr Range kFactor{.least = 0, .most = 1e9};

void CheckLambdas(const v1::Lambdas& lambdas, const Field& at) {
  if (lambdas.has_door_overlap()) at["door_overlap"].InRange(lambdas.door_overlap(), kFactor);
  if (lambdas.has_wall_attraction_divisor()) {
    at["wall_attraction_divisor"].InRange(lambdas.wall_attraction_divisor(),
                                          {.least = 0, .most = 1e9, .open_least = true});
  }
  if (lambdas.has_no_overlap()) at["no_overlap"].InRange(lambdas.no_overlap(), kFactor);
  if (lambdas.has_balanced()) at["balanced"].InRange(lambdas.balanced(), kFactor);
  if (lambdas.has_in_bounds()) at["in_bounds"].InRange(lambdas.in_bounds(), kFactor);
  if (lambdas.has_zone()) at["zone"].InRange(lambdas.zone(), kFactor);
  if (lambdas.has_tertiary_in_bounds()) at["tertiary_in_bounds"].InRange(lambdas.tertiary_in_bounds(), kFactor);
  if (lambdas.has_on_wall()) at["on_wall"].InRange(lambdas.on_wall(), kFactor);
}

void CheckTolerances(const v1::Tolerances& tolerances, const Field& at) {
  constexpr Range kTolerance{.least = 0, .most = 1e9, .open_least = true};
  if (tolerances.has_relative()) at["relative"].InRange(tolerances.relative(), kTolerance);
  if (tolerances.has_absolute()) at["absolute"].InRange(tolerances.absolute(), kTolerance);
  if (tolerances.has_max_evaluation_count()) {
    at["max_evaluation_count"].InRange(tolerances.max_evaluation_count(), {.least = 1, .most = 100000});
  }
}

}  // namespace

void Check(const v1::SolveOptions& options, const Field& at) {
  if (options.has_seed()) at["seed"].InRange(static_cast<double>(options.seed()), kSeed);
  if (options.has_max_restart_count()) {
    at["max_restart_count"].InRange(options.max_restart_count(), {.least = 1, .most = 10000});
  }
  if (options.has_thread_count()) at["thread_count"].InRange(options.thread_count(), {.least = 1, .most = 256});
  if (options.has_path_width_m()) at["path_width_m"].InRange(options.path_width_m(), {.least = 0, .most = 2});
  CheckLambdas(options.lambdas(), at["lambdas"]);
  CheckTolerances(options.tolerances(), at["tolerances"]);
  if (options.has_variant_count()) at["variant_count"].InRange(options.variant_count(), {.least = 1, .most = 32});
  if (!v1::MisfitPolicy_IsValid(options.misfit_policy())) {
    at["misfit_policy"].Reject("{} is no known value", int{options.misfit_policy()});
  }
  if (options.has_time_limit()) {
    const double seconds = static_cast<double>(options.time_limit().seconds()) + 1e-9 * options.time_limit().nanos();
    at["time_limit"].InRange(seconds, {.least = 0, .most = 315576000000.0, .open_least = true});
  }
}

void Check(const v1::ModelOptions& options, const Field& at) {
  const v1::ModelBudget& budget = options.budget();
  const Field limits = at["budget"];
  if (budget.has_call_count()) limits["call_count"].InRange(budget.call_count(), {.least = 0, .most = 100000});
  if (budget.has_token_count()) {
    limits["token_count"].InRange(static_cast<double>(budget.token_count()), {.least = 0, .most = 1e9});
  }
  if (budget.has_cost_usd()) limits["cost_usd"].InRange(budget.cost_usd(), {.least = 0, .most = 1e6});
}

void Check(const v1::JobSpec& spec, const Field& at) {
  Check(spec.brief(), at["brief"]);
  Check(spec.solve_options(), at["solve_options"]);
  Check(spec.render_options(), at["render_options"]);
  Check(spec.model_options(), at["model_options"]);
  if (!at["further_views"].Count(spec.further_views_size(), 0, 4, "views")) return;
  for (int i = 0; i < spec.further_views_size(); ++i) Check(spec.further_views(i), at["further_views"][i]);
}

}  // namespace flair::validation
