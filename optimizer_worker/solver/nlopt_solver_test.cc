// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "optimizer_worker/solver/solver.h"

namespace flair::optimizer {
namespace {

// (1 - x)^2 + 100 (y - x^2)^2, least at (1, 1).
class Banana final : public Objective {
 public:
  int size() const override { return 2; }
  double Evaluate(std::span<const double> x, std::span<double> gradient) override {
    const double a = 1 - x[0], b = x[1] - x[0] * x[0];
    if (!gradient.empty()) {
      gradient[0] = -2 * a - 400 * x[0] * b;
      gradient[1] = 200 * b;
    }
    return a * a + 100 * b * b;
  }
};

// |x - target|^2.
class Distance final : public Objective {
 public:
  explicit Distance(std::vector<double> target) : target_(std::move(target)) {}
  int size() const override { return static_cast<int>(target_.size()); }
  double Evaluate(std::span<const double> x, std::span<double> gradient) override {
    double sum = 0;
    for (size_t i = 0; i < x.size(); ++i) {
      sum += (x[i] - target_[i]) * (x[i] - target_[i]);
      if (!gradient.empty()) gradient[i] = 2 * (x[i] - target_[i]);
    }
    return sum;
  }

 private:
  std::vector<double> target_;
};

TEST(NloptSolver, FindsTheBottomOfACurvedValley) {
  Banana banana;
  std::vector<double> x = {-1.2, 1.0};
  const SolverReport report = NloptSolver().Minimize(
      banana, {}, {.max_evaluations = 500, .relative_tolerance = 1e-12, .absolute_tolerance = 1e-14}, x);
  EXPECT_NEAR(x[0], 1, 1e-3);
  EXPECT_NEAR(x[1], 1, 1e-3);
  EXPECT_LT(report.value, 1e-6);
  EXPECT_GT(report.evaluations, 5);
}

TEST(NloptSolver, KeepsLinearInequalities) {
  Distance objective({2, 2});
  LinearInequality sum;  // x + y <= 2
  sum.Add(0, 1);
  sum.Add(1, 1);
  sum.offset = -2;
  std::vector<double> x = {0, 0};
  const SolverReport report = NloptSolver().Minimize(objective, {{}, {}, {sum}}, {}, x);
  EXPECT_NEAR(x[0], 1, 1e-6);
  EXPECT_NEAR(x[1], 1, 1e-6);
  EXPECT_LE(report.violation, 1e-9);
}

TEST(NloptSolver, AcceptsAStartJustOutsideTheBox) {
  Distance objective({0.5});
  std::vector<double> x = {1 + 1e-12};
  const SolverReport report = NloptSolver().Minimize(objective, {{0}, {1}, {}}, {}, x);
  EXPECT_NEAR(x[0], 0.5, 1e-3);
  EXPECT_EQ(report.violation, 0);
}

TEST(NloptSolver, ReportsTheViolationOfAnInfeasibleProblem) {
  Distance objective({0});
  LinearInequality high, low;  // x >= 1 and x <= 0
  high.Add(0, -1);
  high.offset = 1;
  low.Add(0, 1);
  std::vector<double> x = {0.3};
  EXPECT_GT(NloptSolver().Minimize(objective, {{}, {}, {high, low}}, {}, x).violation, 0.1);
}

TEST(NloptSolver, NeverReturnsAWorsePointThanTheStart) {
  Banana banana;
  std::vector<double> x = {1, 1};
  EXPECT_EQ(NloptSolver().Minimize(banana, {}, {.max_evaluations = 3}, x).value, 0);
  EXPECT_EQ(x[0], 1);
}

TEST(NloptSolver, AnswersAProblemWithoutVariables) {
  Distance objective({});
  std::vector<double> none;
  EXPECT_EQ(NloptSolver().Minimize(objective, {}, {}, none).value, 0);
}

TEST(NloptSolver, AStopEndsARunAtTheBestPointSeen) {
  Banana banana;
  int polls = 0;
  const StopCheck stop = [&] { return ++polls == 3; };
  std::vector<double> x = {-1.2, 1};
  const double before = banana.Evaluate(x, {});
  const SolverReport report = NloptSolver().Minimize(banana, {}, {.stop = &stop}, x);
  EXPECT_EQ(report.evaluations, 3);
  EXPECT_LE(report.value, before);
  EXPECT_EQ(report.value, banana.Evaluate(x, {}));
}

}  // namespace
}  // namespace flair::optimizer
