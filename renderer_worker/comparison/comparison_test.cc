// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "renderer_worker/comparison/draw_comparison.h"
#include "renderer_worker/drawing/testing/read_drawing.h"

namespace flair::renderer {
namespace {

using ::testing::HasSubstr;

// A room twice; in the second its first object is 0.3 m further east.
v1::RenderRequest MovedRequest(const std::string& room) {
  v1::RenderRequest request;
  *request.mutable_solved_layout() = ReadSample(room);
  v1::ComparedLayout& other = *request.add_beside();
  *other.mutable_solved_layout() = request.solved_layout();
  v1::Placement& place = *other.mutable_solved_layout()->mutable_placements(0);
  place.set_x_m(place.x_m() + 0.3);
  v1::ObjectChange& change = *other.add_changes();
  change.set_before_object_id(place.object_id());
  change.set_after_object_id(place.object_id());
  change.set_words("moved 0.30 m east");
  return request;
}

TEST(Comparison, ChangesHaveTheKindThatTheirIdsAndSizesSay) {
  v1::RenderRequest request = MovedRequest("nursery");
  v1::ComparedLayout& other = *request.mutable_beside(0);
  const auto& objects = request.solved_layout().graph().object_list().objects();
  other.mutable_solved_layout()->mutable_graph()->mutable_object_list()->mutable_objects(1)->set_width_m(
      objects[1].width_m() + 0.1);
  v1::ObjectChange& resized = *other.add_changes();
  resized.set_before_object_id(objects[1].id());
  resized.set_after_object_id(objects[1].id());
  other.add_changes()->set_before_object_id(objects[2].id());
  other.add_changes()->set_after_object_id(objects[2].id());
  const absl::StatusOr<Comparison> comparison = ReadComparison(request);
  ASSERT_TRUE(comparison.ok()) << comparison.status();
  std::vector<ChangeKind> kinds;
  for (const PlanChange& change : comparison->panels[1].changes) kinds.push_back(change.kind);
  EXPECT_THAT(kinds, ::testing::ElementsAre(ChangeKind::kMoved, ChangeKind::kResized, ChangeKind::kRemoved,
                                            ChangeKind::kAdded));
  EXPECT_EQ(comparison->panels[0].removed.size(), 1u);
  EXPECT_EQ(comparison->change_count, 4);
}

TEST(Comparison, AChangeOfNoObjectIsNamed) {
  v1::RenderRequest request = MovedRequest("nursery");
  request.mutable_beside(0)->mutable_changes(0)->set_after_object_id("ghost");
  EXPECT_THAT(std::string(DrawComparison(request).status().message()),
              HasSubstr("beside[0].changes[0].after_object_id: \"ghost\" is not an object of its layout"));
  request.mutable_beside(0)->mutable_changes(0)->Clear();
  EXPECT_THAT(std::string(DrawComparison(request).status().message()),
              HasSubstr("beside[0].changes[0]: names no object"));
}

TEST(Comparison, PlansHaveOneScaleAndStayInTheirPanels) {
  for (const char* room : {"nursery", "l_shaped_studio", "long_corridor"}) {
    for (int count = 2; count <= 8; ++count) {
      v1::RenderRequest request;
      *request.mutable_solved_layout() = ReadSample("vampire_bedroom");
      while (request.beside_size() + 1 < count) *request.add_beside()->mutable_solved_layout() = ReadSample(room);
      const absl::StatusOr<Comparison> comparison = ReadComparison(request);
      ASSERT_TRUE(comparison.ok()) << comparison.status();
      const absl::StatusOr<ComparisonSheet> sheet = ArrangeComparison(*comparison, {});
      ASSERT_TRUE(sheet.ok()) << sheet.status();
      const Box paper{0, 0, sheet->paper.size_mm.width, sheet->paper.size_mm.height};
      for (size_t i = 0; i < sheet->panels.size(); ++i) {
        const Sheet& panel = sheet->panels[i];
        EXPECT_EQ(panel.scale, sheet->paper.scale);
        EXPECT_TRUE(paper.Contains(panel.plan_mm));
        for (const Point corner : comparison->panels[i].plan.floor) {
          const Point at = panel.ToSheet(corner);
          EXPECT_TRUE(panel.plan_mm.Contains({at.x, at.y, at.x, at.y})) << room << " of " << count;
        }
        for (size_t j = 0; j < i; ++j) EXPECT_FALSE(panel.plan_mm.Overlaps(sheet->panels[j].plan_mm));
      }
    }
  }
}

TEST(Comparison, TheSameRequestGivesTheSamePixelsAndAMarkChangesThem) {
  v1::RenderRequest request = MovedRequest("nursery");
  request.mutable_options()->set_size_px(800);
  const auto once = DrawComparison(request), again = DrawComparison(request);
  ASSERT_TRUE(once.ok()) << once.status();
  EXPECT_TRUE(once->pixels.rgb == again->pixels.rgb);
  EXPECT_EQ(std::max(once->pixels.width_px, once->pixels.height_px), 800);
  request.mutable_beside(0)->clear_changes();
  const auto unmarked = DrawComparison(request);
  ASSERT_TRUE(unmarked.ok());
  EXPECT_FALSE(once->pixels.rgb == unmarked->pixels.rgb);
}

TEST(Comparison, ADocumentSaysWhatChanged) {
  v1::RenderRequest request = MovedRequest("nursery");
  request.mutable_options()->set_format(v1::PREVIEW_FORMAT_SVG);
  const absl::StatusOr<std::string> svg = DrawComparisonDocument(request, {});
  ASSERT_TRUE(svg.ok()) << svg.status();
  EXPECT_THAT(*svg, HasSubstr("<svg"));
  // The colour of what moved.
  EXPECT_TRUE(svg->find("12.156863%") != std::string::npos || svg->find("rgb(12.1") != std::string::npos);
}

TEST(Comparison, AScaleThatDoesNotFitIsRefused) {
  v1::RenderRequest request = MovedRequest("nursery");
  request.mutable_options()->set_scale_denominator(5);
  EXPECT_THAT(std::string(DrawComparison(request).status().message()),
              HasSubstr("options.scale_denominator: 2 plans do not fit A3 at 1:5"));
}

}  // namespace
}  // namespace flair::renderer
