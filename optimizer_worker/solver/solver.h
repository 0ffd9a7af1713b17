// SPDX-License-Identifier: GPL-3.0-or-later
// Finds a local minimum of an Objective near a start.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "optimizer_worker/solver/objective.h"

namespace flair::optimizer {

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

}  // namespace flair::optimizer
