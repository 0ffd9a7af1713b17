// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlopt.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

#include "optimizer_worker/solver/solver.h"

namespace flair::optimizer {
namespace {

constexpr double kFeasible = 1e-9;

double ViolationOf(const Bounds& bounds, std::span<const double> x) {
  double worst = 0;
  for (size_t i = 0; i < bounds.lower.size(); ++i)
    worst = std::max({worst, bounds.lower[i] - x[i], x[i] - bounds.upper[i]});
  for (const LinearInequality& inequality : bounds.inequalities) worst = std::max(worst, inequality.Violation(x));
  return worst;
}

// One run: the objective, its counter and the best point seen.
struct Run {
  Objective& objective;
  const Bounds& bounds;
  std::vector<double> best;
  nlopt_opt handle = nullptr;
  const StopCheck* stop = nullptr;
  double best_value = std::numeric_limits<double>::infinity();
  double best_violation = std::numeric_limits<double>::infinity();
  int64_t evaluations = 0;

  void Offer(std::span<const double> x, double value) {
    const double violation = std::max(0.0, ViolationOf(bounds, x) - kFeasible);
    if (violation > best_violation || (violation == best_violation && !(value < best_value))) return;
    best.assign(x.begin(), x.end());
    best_value = value;
    best_violation = violation;
  }
};

double Callback(unsigned n, const double* x, double* gradient, void* data) {
  Run& run = *static_cast<Run*>(data);
  const std::span<const double> point(x, n);
  const double value = run.objective.Evaluate(point, gradient ? std::span<double>(gradient, n) : std::span<double>());
  ++run.evaluations;
  run.Offer(point, value);
  if (run.stop != nullptr && *run.stop && (*run.stop)()) nlopt_force_stop(run.handle);
  return value;
}

void Inequalities(unsigned m, double* result, unsigned n, const double* x, double* gradient, void* data) {
  const std::vector<LinearInequality>& rows = static_cast<const Bounds*>(data)->inequalities;
  if (gradient) std::fill(gradient, gradient + static_cast<size_t>(m) * n, 0.0);
  for (unsigned i = 0; i < m; ++i) {
    result[i] = rows[i].Violation(std::span<const double>(x, n));
    if (!gradient) continue;
    for (int k = 0; k < rows[i].count; ++k) gradient[i * n + rows[i].variables[k]] += rows[i].factors[k];
  }
}

using Handle = std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)>;

Handle Configure(Run& run, const Bounds& bounds, const SolverLimits& limits, unsigned n) {
  Handle handle(nlopt_create(NLOPT_LD_SLSQP, n), nlopt_destroy);
  nlopt_set_min_objective(handle.get(), Callback, &run);
  if (!bounds.lower.empty()) {
    nlopt_set_lower_bounds(handle.get(), bounds.lower.data());
    nlopt_set_upper_bounds(handle.get(), bounds.upper.data());
  }
  if (!bounds.inequalities.empty()) {
    const std::vector<double> tolerances(bounds.inequalities.size(), kFeasible / 2);
    nlopt_add_inequality_mconstraint(handle.get(), static_cast<unsigned>(tolerances.size()), Inequalities,
                                     const_cast<Bounds*>(&bounds), tolerances.data());
  }
  nlopt_set_maxeval(handle.get(), limits.max_evaluations);
  nlopt_set_ftol_rel(handle.get(), limits.relative_tolerance);
  nlopt_set_ftol_abs(handle.get(), limits.absolute_tolerance);
  nlopt_set_stopval(handle.get(), limits.good_enough);
  return handle;
}

SolverEnd EndOf(nlopt_result result) {
  if (result == NLOPT_STOPVAL_REACHED) return SolverEnd::kGoodEnough;
  if (result == NLOPT_MAXEVAL_REACHED || result == NLOPT_MAXTIME_REACHED) return SolverEnd::kEvaluationLimit;
  return result > 0 ? SolverEnd::kConverged : SolverEnd::kStoppedEarly;
}

}  // namespace

SolverReport NloptSolver::Minimize(Objective& objective, const Bounds& bounds, const SolverLimits& limits,
                                   std::span<double> x) const {
  SolverReport report;
  if (x.empty()) {
    report.value = objective.Evaluate(x, {});
    return report;
  }
  std::vector<double> point(x.begin(), x.end());
  for (size_t i = 0; i < bounds.lower.size(); ++i) point[i] = std::clamp(point[i], bounds.lower[i], bounds.upper[i]);
  Run run{objective, bounds, point};
  const Handle handle = Configure(run, bounds, limits, static_cast<unsigned>(x.size()));
  run.handle = handle.get();
  run.stop = limits.stop;
  double value = 0;
  report.end = EndOf(nlopt_optimize(handle.get(), point.data(), &value));
  std::copy(run.best.begin(), run.best.end(), x.begin());
  report.value = run.best_value;
  report.violation = ViolationOf(bounds, x);
  report.evaluations = run.evaluations;
  return report;
}

}  // namespace flair::optimizer
