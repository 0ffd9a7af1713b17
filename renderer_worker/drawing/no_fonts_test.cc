// SPDX-License-Identifier: GPL-3.0-or-later
// A machine without fonts. A program of its own: fonts are looked up once in a process.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <fstream>

#include "renderer_worker/drawing/draw_plan.h"
#include "renderer_worker/drawing/testing/read_drawing.h"

namespace flair::renderer {
namespace {

TEST(WithoutFonts, PlansAreRefusedClearlyAndTilesAreDrawn) {
  const std::string config = testing::TempDir() + "/no_fonts.conf";
  std::ofstream(config) << "<?xml version=\"1.0\"?><!DOCTYPE fontconfig SYSTEM \"fonts.dtd\"><fontconfig></fontconfig>";
  ASSERT_EQ(setenv("FONTCONFIG_FILE", config.c_str(), 1), 0);
  const v1::SolvedLayout layout = ReadSample("cloakroom");
  const absl::Status refused = DrawPlan(layout, {}).status();
  EXPECT_EQ(refused.code(), absl::StatusCode::kFailedPrecondition);
  EXPECT_THAT(std::string(refused.message()), testing::HasSubstr("no font is installed"));
  EXPECT_TRUE(DrawPlanTile(layout, 200, 200).ok());
}

}  // namespace
}  // namespace flair::renderer
