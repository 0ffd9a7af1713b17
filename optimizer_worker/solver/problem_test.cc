// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/solver/problem.h"

#include <gtest/gtest.h>

namespace flair::optimizer {
namespace {

// x of the first minus x of the second, squared.
class Spread final : public Cost {
 public:
  explicit Spread(std::vector<int> objects) : objects_(std::move(objects)) {}
  std::span<const int> objects() const override { return objects_; }
  double ValueAt(std::span<const Frame<double>> frames) const override {
    const double d = frames[0].center.x - frames[1].center.x;
    return d * d;
  }
  double GradientAt(std::span<const Frame<double>> frames, std::span<double> gradient) const override {
    std::fill(gradient.begin(), gradient.end(), 0.0);
    gradient[0] = 2 * (frames[0].center.x - frames[1].center.x);
    gradient[3] = -gradient[0];
    return ValueAt(frames);
  }

 private:
  std::vector<int> objects_;
};

std::vector<Term> TwoTerms() {
  std::vector<Term> terms(2);
  terms[0].cost = std::make_unique<Spread>(std::vector<int>{0, 1});
  terms[0].required = {0, 1};
  terms[1].cost = std::make_unique<Spread>(std::vector<int>{1, 2});
  terms[1].required = {1, 2};
  terms[1].weight = 10;
  return terms;
}

TEST(Problem, CountsOnlyTermsWhoseObjectsArePlaced) {
  const std::vector<Term> terms = TwoTerms();
  Problem problem(terms, {0, 1}, 3);
  const std::vector<Pose<double>> poses = {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}};
  EXPECT_EQ(problem.Total(poses), 0);
  problem.SetPlaced(0, true);
  problem.SetPlaced(1, true);
  EXPECT_EQ(problem.Total(poses), 1);
  problem.SetPlaced(2, true);
  EXPECT_EQ(problem.Total(poses), 41);
  EXPECT_EQ(problem.Around(0, poses, 1e9), 1);
  EXPECT_EQ(problem.Around(1, poses, 1e9), 41);
  problem.SetPlaced(2, false);
  EXPECT_EQ(problem.Total(poses), 1);
}

TEST(Problem, AddsGradientsOfTermsThatShareAnObject) {
  const std::vector<Term> terms = TwoTerms();
  Problem problem(terms, {0, 1}, 3);
  for (int i = 0; i < 3; ++i) problem.SetPlaced(i, true);
  const std::vector<Pose<double>> poses = {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}};
  std::vector<double> gradient(9, 0.0);
  EXPECT_EQ(problem.Gradient(poses, gradient), 41);
  EXPECT_EQ(gradient, (std::vector<double>{-2, 0, 0, 2 - 40, 0, 0, 40, 0, 0}));
}

TEST(Problem, ATermCostsNoMoreThanItsMostAndStillPulls) {
  std::vector<Term> terms = TwoTerms();
  terms[1].most = 2;
  Problem problem(terms, {1}, 3);
  for (int i = 0; i < 3; ++i) problem.SetPlaced(i, true);
  const std::vector<Pose<double>> far = {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}};
  EXPECT_NEAR(problem.Total(far), 40 / (1 + 40.0 / 2), 1e-12);
  std::vector<double> gradient(9, 0.0);
  EXPECT_NEAR(problem.Gradient(far, gradient), problem.Total(far), 1e-12);
  const std::vector<Pose<double>> farther = {{0, 0, 0}, {1, 0, 0}, {3 + 1e-6, 0, 0}};
  EXPECT_NEAR(gradient[6], (problem.Total(farther) - problem.Total(far)) / 1e-6, 1e-5);
  EXPECT_GT(gradient[6], 0);
}

}  // namespace
}  // namespace flair::optimizer
