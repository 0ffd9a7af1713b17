// SPDX-License-Identifier: GPL-3.0-or-later
// Words and costs say the same: what is said to be missed costs something, and what costs much is said to be missed.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "optimizer_worker/constraints/arguments.h"
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/constraints/shortfall.h"
#include "room/geometry/pose.h"
#include "room/text_format/scene_text.h"

namespace flair::optimizer {
namespace {

// As in stages/solved_layout.h: up to this a call counts as satisfied.
constexpr double kSatisfiedCost = 1e-3;

double Uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

// The example's objects moved by up to half of `reach` metres and turned by up to half of `turn_rad`.
Layout Disturbed(Layout layout, double reach, double turn_rad, std::mt19937_64& random) {
  for (Pose<double>& pose : layout) {
    pose.x_m += reach * (Uniform(random) - 0.5);
    pose.y_m += reach * (Uniform(random) - 0.5);
    pose.theta_rad += turn_rad * (Uniform(random) - 0.5);
  }
  return layout;
}

struct Judged {
  double cost = 0;
  std::optional<Shortfall> shortfall;
};

Judged Judge(const SceneText& text, const v1::ConstraintEdge& edge, const Layout& layout) {
  const auto cost = Bind(edge, {text.scene, text.zone_centers});
  EXPECT_TRUE(cost.ok()) << cost.status();
  if (!cost.ok()) return {};
  std::vector<Pose<double>> poses;
  for (int i : (*cost)->objects()) poses.push_back(layout[static_cast<size_t>(i)]);
  return {(*cost)->Value(poses), Explain(edge, {text.scene, layout, text.zone_centers})};
}

class Agreement : public testing::TestWithParam<const ConstraintFacts*> {
 protected:
  // Calls check(judged, layout) for each example of the type and for layouts around it.
  template <typename Check>
  static void ForLayouts(const Check& check) {
    std::mt19937_64 random(21);
    for (const LayoutExample& example : GetParam()->layouts) {
      const absl::StatusOr<SceneText> text = ParseScene(example.scene);
      ASSERT_TRUE(text.ok()) << text.status();
      const v1::ConstraintEdge edge = EdgeFromText(GetParam()->name(), example.call);
      for (int round = 0; round < 60; ++round) {
        const double reach = round == 0 ? 0 : round < 30 ? 0.3 : 2;
        const Layout layout = Disturbed(text->layout, reach, round % 3 == 0 ? 0 : reach, random);
        check(Judge(*text, edge, layout), example.scene + " / " + example.call + ", round " + std::to_string(round));
      }
    }
  }
};

TEST_P(Agreement, NothingIsSaidOfACallThatHolds) {
  ForLayouts([](const Judged& judged, const std::string& where) {
    if (judged.cost > 1e-9) return;
    EXPECT_FALSE(judged.shortfall) << judged.shortfall->sentence << "\n" << where;
  });
}

TEST_P(Agreement, SomethingIsSaidOfACallThatDoesNotHold) {
  ForLayouts([](const Judged& judged, const std::string& where) {
    if (judged.cost <= kSatisfiedCost) return;
    EXPECT_TRUE(judged.shortfall) << "cost " << judged.cost << "\n" << where;
  });
}

TEST_P(Agreement, FiguresAreFinite) {
  ForLayouts([](const Judged& judged, const std::string& where) {
    if (!judged.shortfall) return;
    EXPECT_TRUE(std::isfinite(judged.shortfall->missed_by) && judged.shortfall->missed_by > 0) << where;
    EXPECT_EQ(judged.shortfall->sentence.find("nan"), std::string::npos) << where;
  });
}

std::vector<const ConstraintFacts*> TypesOfCalls() {
  std::vector<const ConstraintFacts*> types;
  for (const ConstraintFacts& facts : AllConstraints()) {
    if (!facts.type.built_in()) types.push_back(&facts);
  }
  return types;
}

INSTANTIATE_TEST_SUITE_P(Every, Agreement, testing::ValuesIn(TypesOfCalls()),
                         [](const auto& info) { return info.param->name(); });

}  // namespace
}  // namespace flair::optimizer
