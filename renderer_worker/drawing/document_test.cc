// SPDX-License-Identifier: GPL-3.0-or-later
// Documents read back: SVG, PDF and pixels show the same geometry, and it is that of the layout.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "renderer_worker/drawing/draw_plan.h"
#include "renderer_worker/drawing/sheet.h"
#include "renderer_worker/drawing/testing/read_drawing.h"

namespace flair::renderer {
namespace {

constexpr double kToleranceMm = 0.1;       // what is promised
constexpr double kRoundingMm = 1.0 / 128;  // what two roundings to 1/256 of a unit may make of one point

v1::RenderOptions As(v1::PreviewFormat format, v1::PaperSize paper = v1::PAPER_SIZE_A3) {
  v1::RenderOptions options;
  options.set_format(format);
  options.set_paper(paper);
  return options;
}

std::string MustDraw(const v1::SolvedLayout& layout, const v1::RenderOptions& options) {
  absl::StatusOr<std::string> file = DrawPlanDocument(layout, options, {});
  EXPECT_TRUE(file.ok()) << file.status();
  return file.ok() ? *std::move(file) : std::string();
}

double Distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }

// Whether some painted path has these corners, in this order or against it, starting anywhere.
bool HasPolygon(const Document& document, std::vector<Point> corners) {
  const auto matches = [&corners](PaintedPath path) {
    if (path.size() == corners.size() + 1 && Distance(path.front(), path.back()) < kRoundingMm) path.pop_back();
    if (path.size() != corners.size()) return false;
    for (const bool reverse : {false, true}) {
      if (reverse) std::reverse(path.begin(), path.end());
      for (size_t shift = 0; shift < path.size(); ++shift) {
        bool all = true;
        for (size_t i = 0; i < corners.size() && all; ++i)
          all = Distance(path[(i + shift) % path.size()], corners[i]) <= kToleranceMm;
        if (all) return true;
      }
    }
    return false;
  };
  return std::any_of(document.paths.begin(), document.paths.end(), matches);
}

// Two boxes of no known class, one of them turned, in an irregular room.
v1::SolvedLayout BoxesInAnIrregularRoom() {
  v1::SolvedLayout layout;
  v1::Room& room = *layout.mutable_graph()->mutable_room();
  int wall = 0;
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {5.3, 0.0}, {5.3, 2.2}, {3.1, 3.7}, {0.0, 3.7}}) {
    v1::Point2& vertex = *room.mutable_floor()->add_vertices();
    vertex.set_x_m(x);
    vertex.set_y_m(y);
    room.add_walls()->set_name("wall_" + std::to_string(++wall));
  }
  for (const auto& [id, x, y, theta] : {std::tuple{"thing_a", 1.37, 1.21, 0.0}, {"thing_b", 3.41, 1.93, 0.7}}) {
    v1::Object& object = *layout.mutable_graph()->mutable_object_list()->add_objects();
    object.set_id(id);
    object.set_name("xyzzy");
    object.set_kind(v1::OBJECT_KIND_FLOOR);
    object.set_width_m(1.23);
    object.set_depth_m(0.57);
    object.set_height_m(0.8);
    v1::Placement& placement = *layout.add_placements();
    placement.set_object_id(id);
    placement.set_x_m(x);
    placement.set_y_m(y);
    placement.set_theta_rad(theta);
  }
  return layout;
}

class DocumentOfPaper : public testing::TestWithParam<v1::PaperSize> {};

TEST_P(DocumentOfPaper, WallsAndFurnitureStandWhereTheLayoutHasThem) {
  const v1::SolvedLayout layout = BoxesInAnIrregularRoom();
  const absl::StatusOr<PlanSheet> made = MakePlanSheet(layout, As(v1::PREVIEW_FORMAT_SVG, GetParam()));
  ASSERT_TRUE(made.ok()) << made.status();
  const Document svg = ReadSvg(MustDraw(layout, As(v1::PREVIEW_FORMAT_SVG, GetParam())));
  const Document pdf = ReadPdf(MustDraw(layout, As(v1::PREVIEW_FORMAT_PDF, GetParam())));
  for (const Document* document : {&svg, &pdf}) {
    SCOPED_TRACE(document == &svg ? "SVG" : "PDF");
    EXPECT_NEAR(document->page_mm.width, made->sheet.size_mm.width, 1e-4);
    EXPECT_NEAR(document->page_mm.height, made->sheet.size_mm.height, 1e-4);
    std::vector<Point> floor;
    for (Point vertex : made->plan.floor) floor.push_back(made->sheet.ToSheet(vertex));
    EXPECT_TRUE(HasPolygon(*document, floor));
    for (const PlanObject& object : made->plan.objects) {
      std::vector<Point> corners;
      for (Point corner : object.Corners()) corners.push_back(made->sheet.ToSheet(corner));
      EXPECT_TRUE(HasPolygon(*document, corners)) << object.id;
      // Nobody could confuse it with a neighbour half a millimetre away.
      for (Point& corner : corners) corner.x += 0.5;
      EXPECT_FALSE(HasPolygon(*document, corners)) << object.id;
    }
  }
}

// Whether every point of one has its like in the other: where a rectangle starts and which way it runs is each
// format's own business.
bool Covers(const PaintedPath& a, const PaintedPath& b) {
  return std::all_of(a.begin(), a.end(), [&b](Point point) {
    return std::any_of(b.begin(), b.end(), [point](Point other) { return Distance(point, other) <= kRoundingMm; });
  });
}

// Without what has no extent (a move in one format, a line in the other) and without repeats: what is filled and then
// drawn along is one path or two.
std::vector<PaintedPath> Visible(const std::vector<PaintedPath>& paths) {
  std::vector<PaintedPath> visible;
  for (const PaintedPath& path : paths) {
    const Box box = BoundsOf(path);
    if (std::max(box.width(), box.height()) <= kRoundingMm) continue;
    if (!visible.empty() && Covers(path, visible.back()) && Covers(visible.back(), path)) continue;
    visible.push_back(path);
  }
  return visible;
}

TEST_P(DocumentOfPaper, SvgAndPdfPaintTheSamePaths) {
  for (const std::string& name : SampleLayouts()) {
    SCOPED_TRACE(name);
    const v1::SolvedLayout layout = ReadSample(name);
    const auto svg = Visible(ReadSvg(MustDraw(layout, As(v1::PREVIEW_FORMAT_SVG, GetParam()))).paths);
    const auto pdf = Visible(ReadPdf(MustDraw(layout, As(v1::PREVIEW_FORMAT_PDF, GetParam()))).paths);
    ASSERT_GT(svg.size(), 100u);
    for (size_t i = 0; i < std::min(svg.size(), pdf.size()); ++i) {
      ASSERT_TRUE(Covers(svg[i], pdf[i]) && Covers(pdf[i], svg[i]))
          << "path " << i << ": " << svg[i].size() << " points from " << svg[i][0].x << ", " << svg[i][0].y << " and "
          << pdf[i].size() << " from " << pdf[i][0].x << ", " << pdf[i][0].y;
    }
    EXPECT_EQ(svg.size(), pdf.size());
  }
}

INSTANTIATE_TEST_SUITE_P(Paper, DocumentOfPaper, testing::Values(v1::PAPER_SIZE_A3, v1::PAPER_SIZE_A4),
                         [](const auto& info) { return v1::PaperSize_Name(info.param); });

TEST(Document, AreTheSameBytesTwiceAndSayWhatTheyAre) {
  const v1::SolvedLayout layout = ReadSample("vampire_bedroom");
  const DrawingMetadata metadata = {{"Software", "flair-renderer plan 9"},
                                    {"Description", "A bedroom for a <vampire> & friends"},
                                    {"flair:job_id", "sha256:abc"}};
  for (v1::PreviewFormat format : {v1::PREVIEW_FORMAT_SVG, v1::PREVIEW_FORMAT_PDF}) {
    const absl::StatusOr<std::string> first = DrawPlanDocument(layout, As(format), metadata),
                                      second = DrawPlanDocument(layout, As(format), metadata);
    ASSERT_TRUE(first.ok()) << first.status();
    EXPECT_TRUE(*first == *second);
    EXPECT_THAT(*first, testing::HasSubstr("A bedroom for a vampire."));
    EXPECT_THAT(*first, testing::HasSubstr("flair:job_id: sha256:abc; flair:scale: 1:25 at A3"));
    EXPECT_THAT(*first, testing::HasSubstr("flair-renderer plan 9"));
  }
  EXPECT_THAT(*DrawPlanDocument(layout, As(v1::PREVIEW_FORMAT_SVG), metadata),
              testing::HasSubstr("<desc>A bedroom for a &lt;vampire&gt; &amp; friends</desc>"));
}

// Where along a row of pixels the picture turns from light to dark or back, in millimetres from the left.
std::vector<double> Edges(const Pixels& pixels, int row, double px_per_mm) {
  std::vector<double> edges;
  const auto dark = [&](int x) {
    const uint8_t* rgb = &pixels.rgb[(static_cast<size_t>(row) * pixels.width_px + x) * 3];
    return rgb[0] + rgb[1] + rgb[2] < 3 * 110;
  };
  for (int x = 1; x < pixels.width_px; ++x) {
    if (dark(x) != dark(x - 1)) edges.push_back(x / px_per_mm);
  }
  return edges;
}

TEST(Document, PixelsShowWallsWhereTheDocumentsHaveThem) {
  const v1::SolvedLayout layout = BoxesInAnIrregularRoom();
  v1::RenderOptions options;
  options.set_dpi(508);  // 20 pixels a millimetre
  const absl::StatusOr<PlanSheet> made = MakePlanSheet(layout, options);
  ASSERT_TRUE(made.ok());
  const absl::StatusOr<DrawnPlan> drawn = DrawPlan(layout, options);
  ASSERT_TRUE(drawn.ok()) << drawn.status();
  EXPECT_EQ(drawn->pixels.width_px, std::lround(made->sheet.size_mm.width * 20));
  const Point west = made->sheet.ToSheet({0, 0.3}), east = made->sheet.ToSheet({5.3, 0.3});
  const std::vector<double> edges = Edges(drawn->pixels, static_cast<int>(std::lround(west.y * 20)), 20);
  // The wall's line is 0.45 mm wide, its middle on the wall's face.
  EXPECT_THAT(edges, testing::Contains(testing::DoubleNear(west.x + 0.225, kToleranceMm)));
  EXPECT_THAT(edges, testing::Contains(testing::DoubleNear(east.x - 0.225, kToleranceMm)));
}

TEST(Document, RefusesOptionsThatDoNotGoTogether) {
  const v1::SolvedLayout layout = ReadSample("cloakroom");
  const auto refusal = [&layout](v1::RenderOptions options) {
    return std::string(DrawPlanDocument(layout, options, {}).status().message());
  };
  EXPECT_THAT(refusal(As(v1::PREVIEW_FORMAT_PNG)), testing::HasSubstr("options.format"));
  v1::RenderOptions sized = As(v1::PREVIEW_FORMAT_PDF);
  sized.set_size_px(800);
  EXPECT_THAT(refusal(sized), testing::HasSubstr("options.size_px"));
  v1::RenderOptions dotted = As(v1::PREVIEW_FORMAT_SVG);
  dotted.set_dpi(300);
  EXPECT_THAT(refusal(dotted), testing::HasSubstr("options.dpi"));
  v1::RenderOptions large = As(v1::PREVIEW_FORMAT_PDF, v1::PAPER_SIZE_A4);
  large.set_scale_denominator(5);
  EXPECT_THAT(refusal(large), testing::HasSubstr("does not fit A4 at 1:5; it does at 1:20"));
}

}  // namespace
}  // namespace flair::renderer
