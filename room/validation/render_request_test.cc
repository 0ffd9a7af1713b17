// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <string>

#include "flair/v1/renderer_service.pb.h"
#include "room/validation/validate.h"
#include "tests/fixtures/bedroom.h"

namespace flair {
namespace {

struct Case {
  const char* name;
  const char* options;
  const char* error;  // empty: good
};

v1::RenderOptions Options(const std::string& text) {
  v1::RenderOptions options;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &options)) << text;
  return options;
}

class RenderOptionsCase : public ::testing::TestWithParam<Case> {};

TEST_P(RenderOptionsCase, IsAsItShouldBe) {
  EXPECT_EQ(std::string(Validate(Options(GetParam().options)).message()), GetParam().error);
}

const Case kCases[] = {
    {"Nothing", "", ""},
    {"PlanAsPdf", "format: PREVIEW_FORMAT_PDF paper: PAPER_SIZE_A4 scale_denominator: 50", ""},
    {"PlanByDpi", "dpi: 300 layers: [PLAN_LAYER_ZONES, PLAN_LAYER_CONSTRAINTS]", ""},
    {"ViewAsExr", "view: PREVIEW_VIEW_PERSPECTIVE format: PREVIEW_FORMAT_EXR size_px: 512 sample_count: 4 seed: 9", ""},
    {"ViewWithCamera",
     "view: PREVIEW_VIEW_BIRDSEYE camera { eye_m: [1, -3, 5] target_m: [1, 1, 0] field_of_view_rad: 0.8 }", ""},
    {"SizeTooSmall", "size_px: 100", "options.size_px: 100 is outside [256, 8192]"},
    {"DpiTooHigh", "dpi: 2400", "options.dpi: 2400 is outside [36, 1200]"},
    {"SizeAndDpi", "size_px: 800 dpi: 300",
     "options.size_px: 800 and dpi 300 say both how large the picture is; one of them"},
    {"SizeOfAnSvg", "size_px: 800 format: PREVIEW_FORMAT_SVG",
     "options.size_px: 800 has no meaning for SVG and PDF, whose size is that of the paper; leave it out"},
    {"DpiOfAPdf", "dpi: 300 format: PREVIEW_FORMAT_PDF",
     "options.dpi: 300 has no meaning for SVG and PDF, which have no dots; leave it out"},
    {"PlanAsExr", "format: PREVIEW_FORMAT_EXR",
     "options.format: EXR is for the ray-traced views; a plan is PNG, JPEG, TIFF, SVG or PDF"},
    {"ViewAsSvg", "view: PREVIEW_VIEW_BIRDSEYE format: PREVIEW_FORMAT_SVG",
     "options.format: SVG is for plans; a ray-traced view is PNG, JPEG, TIFF or EXR"},
    {"ScaleTooLarge", "scale_denominator: 4", "options.scale_denominator: 4 is outside [5, 1000]"},
    {"LayerTwice", "layers: [PLAN_LAYER_ZONES, PLAN_LAYER_ZONES]",
     "options.layers[1]: PLAN_LAYER_ZONES stands there twice"},
    {"LayerOfNoKind", "layers: PLAN_LAYER_UNSPECIFIED", "options.layers[0]: is not set"},
    {"SamplesOfAPlan", "sample_count: 16",
     "options.sample_count: 16 is for the ray-traced views; leave it out for a plan"},
    {"SeedOfAPlan", "seed: 3", "options.seed: 3 is for the ray-traced views; leave it out for a plan"},
    {"CameraOfAPlan", "camera { eye_m: [0, 0, 5] target_m: [1, 1, 0] }",
     "options.camera: is for the ray-traced views; leave it out for a plan"},
    {"TooManySamples", "view: PREVIEW_VIEW_BIRDSEYE sample_count: 5000",
     "options.sample_count: 5000 is outside [1, 4096]"},
    {"DpiOfAView", "view: PREVIEW_VIEW_BIRDSEYE dpi: 300",
     "options.dpi: 300 is for plans; leave it out for a ray-traced view; size_px says its pixels"},
    {"PaperOfAView", "view: PREVIEW_VIEW_BIRDSEYE paper: PAPER_SIZE_A4",
     "options.paper: is for plans; leave it out for a ray-traced view"},
    {"ScaleOfAView", "view: PREVIEW_VIEW_BIRDSEYE scale_denominator: 50",
     "options.scale_denominator: 50 is for plans; leave it out for a ray-traced view"},
    {"LayersOfAView", "view: PREVIEW_VIEW_PERSPECTIVE layers: PLAN_LAYER_ZONES",
     "options.layers: is for plans; leave it out for a ray-traced view"},
    {"CameraOfTwoNumbers", "view: PREVIEW_VIEW_BIRDSEYE camera { eye_m: [1, 2] target_m: [1, 1, 0] }",
     "options.camera.eye_m: has 2 numbers; x, y and z in metres"},
    {"CameraWithNoTarget", "view: PREVIEW_VIEW_BIRDSEYE camera { eye_m: [1, 2, 3] }",
     "options.camera.target_m: has 0 numbers; x, y and z in metres"},
    {"CameraNowhere", "view: PREVIEW_VIEW_BIRDSEYE camera { eye_m: [1, nan, 3] target_m: [1, 1, 0] }",
     "options.camera.eye_m[1]: nan is not a number; must be in [-1000, 1000]"},
    {"CameraFarAway", "view: PREVIEW_VIEW_BIRDSEYE camera { eye_m: [1, 5000, 2] target_m: [1, 1, 0] }",
     "options.camera.eye_m[1]: 5000 is outside [-1000, 1000]"},
    {"CameraAtItsTarget", "view: PREVIEW_VIEW_BIRDSEYE camera { eye_m: [1, 1, 1] target_m: [1, 1, 1] }",
     "options.camera.target_m: is at the eye; at least 0.01 m away"},
    {"CameraStraightDown", "view: PREVIEW_VIEW_BIRDSEYE camera { eye_m: [1, 1, 5] target_m: [1, 1, 0] }",
     "options.camera.target_m: is straight below the eye; at least 0.05 m aside"},
    {"CameraTooWide",
     "view: PREVIEW_VIEW_BIRDSEYE camera { eye_m: [0, 0, 5] target_m: [1, 1, 0] field_of_view_rad: 3 }",
     "options.camera.field_of_view_rad: 3 is outside [0.1, 2.6]"},
};

INSTANTIATE_TEST_SUITE_P(All, RenderOptionsCase, ::testing::ValuesIn(kCases),
                         [](const auto& info) { return info.param.name; });

v1::ComposeContactSheetRequest Sheet(const std::string& text) {
  v1::ComposeContactSheetRequest request;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &request)) << text;
  return request;
}

std::string WhyNot(const std::string& text, int index) { return std::string(Validate(Sheet(text), index).message()); }

TEST(ContactSheet, TheFirstMessageHoldsTheOptionsTheOthersTiles) {
  EXPECT_EQ(WhyNot("options { tile_count: 2 }", 0), "");
  EXPECT_EQ(WhyNot("tile { caption: 'a' image: 'x' }", 1), "");
  EXPECT_EQ(WhyNot("tile { caption: 'a' image: 'x' }", 0), "options: is not set; the first message holds it");
  EXPECT_EQ(WhyNot("options { tile_count: 2 }", 1), "tile: is not set; every message after the first holds one");
}

TEST(ContactSheet, SaysWhatIsWrongWithOptionsAndTiles) {
  EXPECT_EQ(WhyNot("options { }", 0), "options.tile_count: 0 is outside [1, 10000]");
  EXPECT_EQ(WhyNot("options { tile_count: 9 tile_px: 2000 }", 0), "options.tile_px: 2000 is outside [64, 1024]");
  EXPECT_EQ(WhyNot("options { tile_count: 9 format: PREVIEW_FORMAT_SVG }", 0),
            "options.format: PREVIEW_FORMAT_SVG; a contact sheet is PNG, JPEG or TIFF");
  EXPECT_EQ(WhyNot("tile { caption: 'a' }", 1),
            "tile.picture: is not set; solved_layout or image, or a remark that says why there is none");
}

TEST(LayoutsBeside, AreForPlansFewAndNamedByTheirPlace) {
  v1::RenderRequest request;
  *request.mutable_solved_layout()->mutable_graph() = testing::BedroomGraph();
  *request.add_beside()->mutable_solved_layout() = request.solved_layout();
  EXPECT_TRUE(Validate(request).ok()) << Validate(request);
  request.mutable_beside(0)->mutable_solved_layout()->mutable_graph()->mutable_room()->set_height_m(0);
  EXPECT_THAT(std::string(Validate(request).message()),
              ::testing::StartsWith("beside[0].solved_layout.graph.room.height_m: 0 is outside [2, 12]"));
  *request.mutable_beside(0)->mutable_solved_layout() = request.solved_layout();
  request.mutable_options()->set_view(v1::PREVIEW_VIEW_BIRDSEYE);
  EXPECT_EQ(Validate(request).message(), "beside: is for plans; leave it out for a ray-traced view");
  while (request.beside_size() < 8) request.add_beside();
  EXPECT_EQ(std::string(Validate(request).message()).find("beside[1]"), std::string::npos) << "too many are not read";
}

// The problem of a plan whose floor is this; empty when there is none.
std::string ProblemOfDrawing(const std::string& svg) {
  v1::PlanParts parts;
  parts.set_floor_svg(svg);
  return std::string(Validate(parts, "parts").message());
}

TEST(PlanParts, AreElementsThatDoNothingButDraw) {
  EXPECT_EQ(ProblemOfDrawing(""), "");
  EXPECT_EQ(ProblemOfDrawing("<path d=\"m0 0l1 1\"/>\n"), "");
  EXPECT_EQ(ProblemOfDrawing("<g fill=\"none\">\n<rect\n x=\"1\" /><g><circle r=\"1\"></circle></g> </g>"), "");
}

TEST(PlanParts, ThatDoMoreAreRefused) {
  for (const char* svg : {"<script>alert(1)</script>",
                          "<g><script/></g>",
                          "<g onclick=\"alert(1)\"/>",
                          "<g id=\"a\"/>",
                          "<g style=\"fill:red\"/>",
                          "<g href=\"x\"/>",
                          "<g xlink:href=\"x\"/>",
                          "<g fill=\"url(#a)\"/>",
                          "<use/>",
                          "<g><image/></g>",
                          "<g>words</g>",
                          "<g",
                          "<g>",
                          "<g></path>",
                          "<g/",
                          "<g fill=\"none/>",
                          "<g fill=none/>",
                          "words",
                          "<!-- -->",
                          "<g d=\"<\"/>",
                          "</g>",
                          "<G/>"}) {
    EXPECT_THAT(ProblemOfDrawing(svg), ::testing::StartsWith("parts.floor_svg: \"")) << svg;
  }
  EXPECT_EQ(ProblemOfDrawing("<g/><g/>"), "parts.floor_svg: is more than one element");
  v1::PlanParts parts;
  parts.add_parts()->set_shadow_svg("<a/>");
  EXPECT_THAT(std::string(Validate(parts, "").message()),
              ::testing::AllOf(::testing::HasSubstr("parts[0].svg: "), ::testing::HasSubstr("parts[0].shadow_svg: ")));
}

}  // namespace
}  // namespace flair
