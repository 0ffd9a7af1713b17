// SPDX-License-Identifier: GPL-3.0-or-later
// For tests: the cost of a call in a scene written as text.
#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "optimizer_worker/constraints/arguments.h"
#include "optimizer_worker/constraints/registry.h"
#include "room/text_format/scene_text.h"

namespace flair::optimizer {

// NaN, and a failure, when the text or the call is not valid.
inline double CostAt(std::string_view scene, std::string_view type, std::string_view call,
                     const LinkedPairs* linked = nullptr) {
  const absl::StatusOr<SceneText> text = ParseScene(scene);
  EXPECT_TRUE(text.ok()) << text.status();
  if (!text.ok()) return std::numeric_limits<double>::quiet_NaN();
  const auto cost = Bind(EdgeFromText(type, call), {text->scene, text->zone_centers, linked});
  EXPECT_TRUE(cost.ok()) << cost.status();
  if (!cost.ok()) return std::numeric_limits<double>::quiet_NaN();
  std::vector<Pose<double>> poses;
  for (int i : (*cost)->objects()) poses.push_back(text->layout[static_cast<size_t>(i)]);
  return (*cost)->Value(poses);
}

}  // namespace flair::optimizer
