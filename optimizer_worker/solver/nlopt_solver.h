// SPDX-License-Identifier: GPL-3.0-or-later
// Solver by NLopt's SLSQP (sequential least-squares quadratic programming), the method of the paper.
#pragma once

#include "optimizer_worker/solver/solver.h"

namespace flair::optimizer {

// What NLopt 2.7.1 does that callers must not see: it fails on a start 1e-12 outside the box (the start is clamped),
// reports success on infeasible problems (the violation is recomputed), returns "roundoff limited" with a usable point
// (kept), and may return a later, worse point (the best one seen is kept). Deterministic, reentrant.
class NloptSolver final : public Solver {
 public:
  SolverReport Minimize(Objective& objective, const Bounds& bounds, const SolverLimits& limits,
                        std::span<double> x) const override;
};

}  // namespace flair::optimizer
