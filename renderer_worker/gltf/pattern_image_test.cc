// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "renderer_worker/gltf/mesh_book.h"

namespace flair::renderer::gltf {
namespace {

constexpr Figure kFigures[] = {Figure::kWood,      Figure::kPlanks, Figure::kHerringbone, Figure::kTiles,
                               Figure::kBricks,    Figure::kStone,  Figure::kCarpet,      Figure::kFabric,
                               Figure::kWallpaper, Figure::kStones};

TEST(PatternTone, StaysWithinItsBounds) {
  for (const Figure figure : kFigures) {
    const Vec2 period = PeriodOf(figure);
    float least = 1, most = 0;
    for (int i = 0; i < 4000; ++i) {
      const float u = period.x * static_cast<float>(i % 63) / 63;
      const float v = period.y * static_cast<float>(i) / 4000;
      const Tone tone = ToneAt(figure, u, v);
      least = std::min(least, tone.mix);
      most = std::max(most, tone.mix);
      ASSERT_GE(tone.shade, kDarkestShade);
      ASSERT_LE(tone.shade, kLightestShade);
    }
    EXPECT_GE(least, 0) << static_cast<int>(figure);
    EXPECT_LE(most, 1) << static_cast<int>(figure);
    EXPECT_GT(most - least, 0.2F) << static_cast<int>(figure);
  }
}

// Mean difference between neighbouring columns or rows: across the seam it may not be much more than within.
TEST(PatternTone, TilesWithoutASeam) {
  constexpr int kSteps = 256;
  for (const Figure figure : kFigures) {
    const Vec2 period = PeriodOf(figure);
    const auto at = [&](int x, int y) {
      return ToneAt(figure, period.x * (static_cast<float>(x) + 0.5F) / kSteps,
                    period.y * (static_cast<float>(y) + 0.5F) / kSteps);
    };
    const auto step = [&](Tone a, Tone b) { return std::abs(a.mix - b.mix) + std::abs(a.shade - b.shade); };
    float worst_column = 0, worst_row = 0, seam_column = 0, seam_row = 0;
    for (int i = 0; i < kSteps; ++i) {
      float column = 0, row = 0;
      const int next = (i + 1) % kSteps;
      for (int j = 0; j < kSteps; ++j) {
        column += step(at(i, j), at(next, j));
        row += step(at(j, i), at(j, next));
      }
      (next == 0 ? seam_column : worst_column) = std::max(next == 0 ? seam_column : worst_column, column);
      (next == 0 ? seam_row : worst_row) = std::max(next == 0 ? seam_row : worst_row, row);
    }
    EXPECT_LE(seam_column, worst_column * 1.05F) << static_cast<int>(figure);
    EXPECT_LE(seam_row, worst_row * 1.05F) << static_cast<int>(figure);
  }
}

TEST(PatternPng, IsNothingForPlainMaterialsAndAPngForOthers) {
  EXPECT_EQ(PatternPng({}), "");
  const Material planks{.pattern = Pattern::kPlanks};
  EXPECT_EQ(PatternPng(planks).substr(0, 8), "\x89PNG\r\n\x1A\n");
  EXPECT_EQ(PatternPng(planks), PatternPng(planks));
  const Material red{.colour = {1, 0, 0}, .pattern = Pattern::kPlanks};
  EXPECT_NE(PatternPng(planks), PatternPng(red));
  EXPECT_EQ(PatternPng(planks).size(), PatternPng(red).size()) << "only the palette differs";
}

}  // namespace
}  // namespace flair::renderer::gltf
