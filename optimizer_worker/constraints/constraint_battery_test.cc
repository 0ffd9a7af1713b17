// SPDX-License-Identifier: GPL-3.0-or-later
// What every constraint must do, run over every type of the program and every layout in its facts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <random>
#include <set>

#include "optimizer_worker/constraints/arguments.h"
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/registry.h"
#include "room/geometry/pose.h"
#include "room/text_format/scene_text.h"

namespace flair::optimizer {
namespace {

struct Case {
  const ConstraintFacts* facts;
  LayoutExample example;
  int number;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.facts->name() << ": " << c.example.scene << " | " << c.example.call;
}

// Where a program adds types to ours, only these: ours are tried by themselves.
std::vector<const ConstraintFacts*> TypesToTry() {
  std::set<std::string> ours;
  for (const ConstraintFacts& facts : OurLibrary().types) ours.insert(facts.name());
  const bool adds_some = AllConstraints().size() > ours.size();
  std::vector<const ConstraintFacts*> types;
  for (const ConstraintFacts& facts : AllConstraints()) {
    if (!adds_some || !ours.contains(facts.name())) types.push_back(&facts);
  }
  return types;
}

std::vector<Case> AllCases() {
  std::vector<Case> cases;
  for (const ConstraintFacts* facts : TypesToTry()) {
    int number = 0;
    for (const LayoutExample& example : facts->layouts) cases.push_back({facts, example, ++number});
  }
  return cases;
}

double Uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

class ConstraintBattery : public testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    absl::StatusOr<SceneText> read = ParseScene(GetParam().example.scene);
    ASSERT_TRUE(read.ok()) << read.status();
    text_ = *std::move(read);
    Rebind();
  }

  void Rebind() {
    absl::StatusOr<std::unique_ptr<Cost>> cost =
        Bind(EdgeFromText(GetParam().facts->name(), GetParam().example.call), {text_.scene, text_.zone_centers});
    ASSERT_TRUE(cost.ok()) << cost.status();
    cost_ = *std::move(cost);
  }

  std::vector<Pose<double>> Poses() const {
    std::vector<Pose<double>> poses;
    for (int i : cost_->objects()) poses.push_back(text_.layout[static_cast<size_t>(i)]);
    return poses;
  }

  // The example, moved a little or a lot.
  std::vector<Pose<double>> Disturbed(std::mt19937_64& random, double reach) const {
    std::vector<Pose<double>> poses = Poses();
    for (Pose<double>& pose : poses) {
      pose.x_m += reach * (Uniform(random) - 0.5);
      pose.y_m += reach * (Uniform(random) - 0.5);
      pose.theta_rad += reach * (Uniform(random) - 0.5);
    }
    return poses;
  }

  static double* Variable(std::vector<Pose<double>>& poses, size_t k) {
    Pose<double>& pose = poses[k / 3];
    return k % 3 == 0 ? &pose.x_m : k % 3 == 1 ? &pose.y_m : &pose.theta_rad;
  }

  SceneText text_;
  std::unique_ptr<Cost> cost_;
};

TEST_P(ConstraintBattery, IsZeroExactlyWhereTheSentenceHolds) {
  const double value = cost_->Value(Poses());
  if (GetParam().example.satisfied) {
    EXPECT_NEAR(value, 0, 1e-12);
  } else {
    EXPECT_GT(value, 1e-5);
  }
}

TEST_P(ConstraintBattery, ValueOfGradientIsTheValue) {
  std::mt19937_64 random(11);
  for (int round = 0; round < 50; ++round) {
    const std::vector<Pose<double>> poses = Disturbed(random, round < 25 ? 0.5 : 4);
    std::vector<double> gradient(3 * poses.size(), 1e300);
    const double value = cost_->Value(poses);
    EXPECT_NEAR(cost_->Gradient(poses, gradient), value, 1e-12 * (1 + value));
    EXPECT_GE(value, 0);
    EXPECT_TRUE(std::isfinite(value));
    for (double g : gradient) EXPECT_TRUE(std::isfinite(g) && std::abs(g) < 1e299);
  }
}

TEST_P(ConstraintBattery, GradientIsFiniteWhereEverythingCoincides) {
  std::vector<Pose<double>> poses(cost_->objects().size(), Pose<double>{1, 1, 0});
  for (Pose<double> at : {Pose<double>{1, 1, 0}, {0, 0, 0}, {2, 1.5, kPi / 2}, {500, 400, 3}}) {
    std::fill(poses.begin(), poses.end(), at);
    std::vector<double> gradient(3 * poses.size());
    EXPECT_TRUE(std::isfinite(cost_->Gradient(poses, gradient)));
    for (double g : gradient) EXPECT_TRUE(std::isfinite(g));
  }
}

// Where a minimum over walls or sides changes hands the two one-sided differences disagree; there is no gradient there.
TEST_P(ConstraintBattery, GradientAgreesWithCentralDifferences) {
  std::mt19937_64 random(12);
  constexpr double kStep = 1e-6;
  int compared = 0;
  for (int round = 0; round < 60; ++round) {
    std::vector<Pose<double>> poses = Disturbed(random, round < 30 ? 0.4 : 2.5);
    std::vector<double> gradient(3 * poses.size());
    const double value = cost_->Gradient(poses, gradient);
    for (size_t k = 0; k < gradient.size(); ++k) {
      double* x = Variable(poses, k);
      const double at = *x;
      *x = at + kStep;
      const double above = cost_->Value(poses);
      *x = at - kStep;
      const double below = cost_->Value(poses);
      *x = at;
      const double forward = (above - value) / kStep, backward = (value - below) / kStep;
      if (std::abs(forward - backward) > 1e-3 * (1 + std::abs(forward))) continue;
      ++compared;
      EXPECT_NEAR(gradient[k], (above - below) / (2 * kStep), 2e-5 * (1 + std::abs(gradient[k]) + value))
          << "variable " << k << " round " << round;
    }
  }
  EXPECT_GT(compared, 100);
}

TEST_P(ConstraintBattery, FollowingTheGradientLowersTheCost) {
  std::mt19937_64 random(13);
  for (int round = 0; round < 30; ++round) {
    std::vector<Pose<double>> poses = Disturbed(random, 1);
    std::vector<double> gradient(3 * poses.size());
    const double value = cost_->Gradient(poses, gradient);
    double norm2 = 0;
    for (double g : gradient) norm2 += g * g;
    if (norm2 < 1e-10) continue;
    for (size_t k = 0; k < gradient.size(); ++k) *Variable(poses, k) -= 1e-7 * gradient[k] / std::sqrt(norm2);
    EXPECT_LT(cost_->Value(poses), value + 1e-15) << "round " << round;
  }
}

TEST_P(ConstraintBattery, AFullTurnChangesNothing) {
  std::mt19937_64 random(14);
  for (int round = 0; round < 20; ++round) {
    std::vector<Pose<double>> poses = Disturbed(random, 1);
    const double value = cost_->Value(poses);
    for (Pose<double>& pose : poses) pose.theta_rad += round % 2 == 0 ? kTwoPi : -kTwoPi;
    EXPECT_NEAR(cost_->Value(poses), value, 1e-9 * (1 + value));
  }
}

TEST_P(ConstraintBattery, TurningRoomAndLayoutTogetherChangesNothing) {
  if (!GetParam().facts->tied_to_axes.empty()) GTEST_SKIP() << GetParam().facts->tied_to_axes;
  std::mt19937_64 random(15);
  const std::vector<Pose<double>> poses = Disturbed(random, 1);
  const double value = cost_->Value(poses);
  const double height = BoundsOf(text_.scene.room.floor).max.y;
  const auto turned = [height](const Vec2<double>& p) { return Vec2<double>{height - p.y, p.x}; };
  std::vector<std::string> names;
  for (const Wall& wall : text_.scene.room.walls) names.push_back(wall.name);
  for (Vec2<double>& v : text_.scene.room.floor.vertices) v = turned(v);
  text_.scene.room.walls = WallsOf(text_.scene.room.floor, names);
  for (Vec2<double>& center : text_.zone_centers) center = turned(center);
  Rebind();
  std::vector<Pose<double>> turned_poses;
  for (const Pose<double>& pose : poses) {
    const Vec2<double> p = turned(Center(pose));
    turned_poses.push_back({p.x, p.y, pose.theta_rad + kPi / 2});
  }
  EXPECT_NEAR(cost_->Value(turned_poses), value, 1e-9 * (1 + value));
}

TEST_P(ConstraintBattery, ARoomMayBeginAtAnyCorner) {
  std::mt19937_64 random(16);
  const std::vector<Pose<double>> poses = Disturbed(random, 1);
  const double value = cost_->Value(poses);
  Room& room = text_.scene.room;
  std::vector<std::string> names;
  for (const Wall& wall : room.walls) names.push_back(wall.name);
  const int count = static_cast<int>(names.size());
  for (int turn = 1; turn < count; ++turn) {
    std::rotate(names.begin(), names.begin() + 1, names.end());
    std::rotate(room.floor.vertices.begin(), room.floor.vertices.begin() + 1, room.floor.vertices.end());
    room.walls = WallsOf(room.floor, names);
    for (Opening& opening : room.openings) opening.wall = (opening.wall + count - 1) % count;
    for (Socket& socket : room.sockets) socket.wall = (socket.wall + count - 1) % count;
    Rebind();
    EXPECT_NEAR(cost_->Value(poses), value, 1e-12 * (1 + value)) << "from vertex " << turn;
  }
}

INSTANTIATE_TEST_SUITE_P(Every, ConstraintBattery, testing::ValuesIn(AllCases()), [](const auto& info) {
  return info.param.facts->name() + (info.param.example.satisfied ? "_satisfied_" : "_violated_") +
         std::to_string(info.param.number);
});

TEST(ConstraintFacts, AreComplete) {
  for (const ConstraintFacts& facts : AllConstraints()) {
    int satisfied = 0;
    for (const LayoutExample& example : facts.layouts) satisfied += example.satisfied;
    EXPECT_GT(satisfied, 0) << facts.name();
    EXPECT_LT(satisfied, static_cast<int>(facts.layouts.size())) << facts.name();
    EXPECT_FALSE(facts.type.summary().empty() || facts.type.doc().empty() || facts.type.family().empty())
        << facts.name();
    EXPECT_EQ(facts.type.built_in(), facts.type.examples().empty()) << facts.name();
  }
}

TEST(ConstraintFacts, NamesAndAliasesAreUnique) {
  std::set<std::string> names;
  for (const ConstraintFacts& facts : AllConstraints()) {
    EXPECT_TRUE(names.insert(facts.name()).second) << facts.name();
    for (const std::string& alias : facts.type.aliases()) EXPECT_TRUE(names.insert(alias).second) << alias;
  }
}

}  // namespace
}  // namespace flair::optimizer
