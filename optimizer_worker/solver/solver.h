// SPDX-License-Identifier: GPL-3.0-or-later
// Finds a local minimum of an Objective near a start.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace flair::optimizer {

// A smooth function of many variables, as a Solver sees it.
class Objective {
 public:
  virtual ~Objective() = default;
  // Number of variables.
  virtual int size() const = 0;
  // The value at `x`. Writes the derivatives into `gradient` unless that is empty. Must return a finite number for
  // every finite `x`. Not const: implementations keep scratch memory, so one object serves one thread at a time.
  virtual double Evaluate(std::span<const double> x, std::span<double> gradient) = 0;
};

// offset + Σ_k factors[k] · x[variables[k]] <= 0. At most four terms: two points are kept apart along one direction.
struct LinearInequality {
  int variables[4] = {0, 0, 0, 0};
  double factors[4] = {0, 0, 0, 0};
  int count = 0;
  double offset = 0;

  void Add(int variable, double factor) {
    if (factor == 0) return;
    variables[count] = variable;
    factors[count] = factor;
    ++count;
  }
  double Violation(std::span<const double> x) const {
    double sum = offset;
    for (int k = 0; k < count; ++k) sum += factors[k] * x[variables[k]];
    return sum;
  }
};

// Box and linear inequalities. Empty `lower` and `upper` mean no box.
struct Bounds {
  std::vector<double> lower;
  std::vector<double> upper;
  std::vector<LinearInequality> inequalities;
};

// True when nobody wants better results any more; asked often, from any thread.
using StopCheck = std::function<bool()>;

// When to stop.
struct SolverLimits {
  int max_evaluations = 200;
  // Stop when a step changes the value by less than this share of it ...
  double relative_tolerance = 1e-5;
  // ... or by less than this.
  double absolute_tolerance = 1e-7;
  // Stop as soon as the value is at most this.
  double good_enough = 1e-9;
  // Asked after every evaluation; borrowed, null for never.
  const StopCheck* stop = nullptr;
};

// Why a solver ended.
enum class SolverEnd {
  kConverged,
  kGoodEnough,
  kEvaluationLimit,
  // Rounding or an internal failure ended it early; the result is the best point it saw.
  kStoppedEarly,
};

struct SolverReport {
  double value = 0;
  // Largest violation of an inequality or of the box at the result; 0 when there are none.
  double violation = 0;
  int64_t evaluations = 0;
  SolverEnd end = SolverEnd::kConverged;
};

class Solver {
 public:
  virtual ~Solver() = default;
  // Improves `x` in place. The start may be slightly outside the bounds. The result is the best point seen: least value
  // among those that keep the bounds to 1e-9, or the least violating one when there is none. Thread-safe as long as the
  // objectives differ.
  virtual SolverReport Minimize(Objective& objective, const Bounds& bounds, const SolverLimits& limits,
                                std::span<double> x) const = 0;
};

// What NLopt 2.7.1 does that callers must not see: it fails on a start 1e-12 outside the box (the start is clamped),
// reports success on infeasible problems (the violation is recomputed), returns "roundoff limited" with a usable point
// (kept), and may return a later, worse point (the best one seen is kept). Deterministic, reentrant.
class NloptSolver final : public Solver {
 public:
  SolverReport Minimize(Objective& objective, const Bounds& bounds, const SolverLimits& limits,
                        std::span<double> x) const override;
};

}  // namespace flair::optimizer
