// SPDX-License-Identifier: GPL-3.0-or-later
// For tests: a furnished room from text, kept alive for its view.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "evaluation/metrics/layout_metrics.h"
#include "room/text_format/scene_text.h"

namespace flair::evaluation {

class Furnished {
 public:
  explicit Furnished(const std::string& text) {
    absl::StatusOr<SceneText> parsed = ParseScene(text);
    EXPECT_TRUE(parsed.ok()) << parsed.status();
    if (parsed.ok()) text_ = *std::move(parsed);
  }
  LayoutView view() const { return {text_.scene, text_.layout}; }

 private:
  SceneText text_;
};

}  // namespace flair::evaluation
