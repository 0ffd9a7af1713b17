// SPDX-License-Identifier: GPL-3.0-or-later
// Our measures of recorded layouts against the figures that others' programs gave them (testdata/).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "absl/strings/str_split.h"
#include "evaluation/metrics/layout_metrics.h"
#include "evaluation/metrics/testing/oor_paper.h"
#include "evaluation/metrics/walk_grid.h"
#include "room/text_format/scene_text.h"

namespace flair::evaluation {
namespace {

struct Recorded {
  std::string name;
  double first = 0;
  double second = 0;
  SceneText text;

  LayoutView view() const { return {text.scene, text.layout}; }
};

// Lines "name | number | number | room"; '#' begins a comment.
std::vector<Recorded> ReadRecorded(const std::string& file) {
  std::ifstream in(FLAIR_SOURCE_DIR "/evaluation/metrics/testdata/" + file);
  std::vector<Recorded> all;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    const std::vector<std::string> parts = absl::StrSplit(line, absl::MaxSplits(" | ", 3));
    if (parts.size() != 4) {
      ADD_FAILURE() << line;
      continue;
    }
    absl::StatusOr<SceneText> text = ParseScene(parts[3]);
    EXPECT_TRUE(text.ok()) << parts[0] << ": " << text.status();
    if (text.ok())
      all.push_back({parts[0], std::strtod(parts[1].c_str(), nullptr), std::strtod(parts[2].c_str(), nullptr), *text});
  }
  return all;
}

TEST(RecordedOverlaps, OobIsTheReferencesOwn) {
  const std::vector<Recorded> all = ReadRecorded("recorded_overlaps.txt");
  ASSERT_EQ(all.size(), 41u);
  for (const Recorded& layout : all) EXPECT_NEAR(OobPercent(layout.view()), layout.first, 1e-9) << layout.name;
}

TEST(RecordedOverlaps, OorInThePapersFormIsTheReferencesOwn) {
  for (const Recorded& layout : ReadRecorded("recorded_overlaps.txt")) {
    EXPECT_NEAR(OorPaperPercent(layout.view()), layout.second, 1e-9) << layout.name;
  }
}

TEST(RecordedOverlaps, OurOorDiffersByRugsAndDoorSwingsOnly) {
  int differ = 0;
  for (Recorded& layout : ReadRecorded("recorded_overlaps.txt")) {
    const double ours = OorPercent(layout.view());
    EXPECT_LE(ours, layout.second + 1e-9) << layout.name;
    differ += ours < layout.second - 1e-6;
    layout.text.scene.room.openings.clear();
    for (Object& object : layout.text.scene.objects) object.walk_over = false;
    EXPECT_NEAR(OorPercent(layout.view()), OorPaperPercent(layout.view()), 1e-9) << layout.name;
  }
  EXPECT_GT(differ, 0);
}

TEST(RecordedReach, SharesAreTheJudges) {
  const std::vector<Recorded> all = ReadRecorded("recorded_reach.txt");
  ASSERT_EQ(all.size(), 49u);
  for (const Recorded& layout : all) {
    const Reach reach = MeasureReach(layout.view());
    EXPECT_NEAR(reach.floor_share, layout.first, 0.01) << layout.name;
    EXPECT_NEAR(reach.front_share, layout.second, 1e-4) << layout.name;
  }
}

}  // namespace
}  // namespace flair::evaluation
