// SPDX-License-Identifier: GPL-3.0-or-later
// A smooth function of many variables, as a Solver sees it.
#pragma once

#include <span>
#include <vector>

namespace flair::optimizer {

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

}  // namespace flair::optimizer
