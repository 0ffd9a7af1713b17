// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/render_flags.h"

#include <gmock/gmock.h>

#include <functional>

namespace flair::cli {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

v1::RenderOptions Good(const RenderFlags& flags, const std::string& out) {
  const auto options = ReadRenderFlags(flags, out);
  EXPECT_TRUE(options.ok()) << options.status();
  return options.ok() ? *options : v1::RenderOptions();
}

TEST(RenderFlags, TheEndingOfTheFileIsTheFormat) {
  EXPECT_EQ(Good({}, "a/plan.png").format(), v1::PREVIEW_FORMAT_PNG);
  EXPECT_EQ(Good({}, "a/Plan.JPEG").format(), v1::PREVIEW_FORMAT_JPEG);
  EXPECT_EQ(Good({}, "a.b/plan.jpg").format(), v1::PREVIEW_FORMAT_JPEG);
  EXPECT_EQ(Good({}, "plan.tif").format(), v1::PREVIEW_FORMAT_TIFF);
  EXPECT_EQ(Good({}, "plan.svg").format(), v1::PREVIEW_FORMAT_SVG);
  EXPECT_EQ(Good({}, "plan.pdf").format(), v1::PREVIEW_FORMAT_PDF);
  EXPECT_EQ(Good({.view = "birdseye"}, "view.exr").format(), v1::PREVIEW_FORMAT_EXR);
}

TEST(RenderFlags, EveryFlagOfAPlanArrives) {
  const v1::RenderOptions options =
      Good({.dpi = 300, .paper = "a4", .scale = "1:50", .layers = "zones,floor-pieces"}, "plan.png");
  EXPECT_EQ(options.dpi(), 300);
  EXPECT_EQ(options.paper(), v1::PAPER_SIZE_A4);
  EXPECT_EQ(options.scale_denominator(), 50);
  EXPECT_THAT(options.layers(), ElementsAre(v1::PLAN_LAYER_ZONES, v1::PLAN_LAYER_FLOOR_PIECES));
  EXPECT_EQ(Good({.scale = "20", .layers = "all"}, "plan.png").layers_size(), 6);
  EXPECT_EQ(Good({.scale = "20"}, "plan.png").scale_denominator(), 20);
}

TEST(RenderFlags, EveryFlagOfAViewArrives) {
  const v1::RenderOptions options = Good({.view = "perspective",
                                          .size_px = 512,
                                          .samples = 4,
                                          .seed = 9,
                                          .camera = "1, -2.5,1.6",
                                          .look_at = "2,3,1",
                                          .field_of_view_deg = 60},
                                         "view.png");
  EXPECT_EQ(options.size_px(), 512);
  EXPECT_EQ(options.sample_count(), 4);
  EXPECT_EQ(options.seed(), 9);
  EXPECT_THAT(options.camera().eye_m(), ElementsAre(1, -2.5, 1.6));
  EXPECT_THAT(options.camera().target_m(), ElementsAre(2, 3, 1));
  EXPECT_NEAR(options.camera().field_of_view_rad(), 1.0471975512, 1e-9);
}

struct Bad {
  const char* name;
  RenderFlags flags;
  const char* out;
  const char* message;
};

class BadRenderFlags : public ::testing::TestWithParam<Bad> {};

TEST_P(BadRenderFlags, AreRefusedWithWhatWouldBeRight) {
  const absl::Status status = ReadRenderFlags(GetParam().flags, GetParam().out).status();
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(status.message()), HasSubstr(GetParam().message));
}

const Bad kBad[] = {
    {"NoEnding", {}, "plan", "--out: plan: its ending says the format: png, jpg, jpeg, tif, tiff, exr, svg, pdf"},
    {"UnknownEnding", {}, "plan.bmp", "--out: plan.bmp: its ending says the format: png"},
    {"AScene", {}, "room.glb", "flair export scene LAYOUT --format glb"},
    {"PlanAsExr", {}, "plan.exr", "--out: EXR is for the ray-traced views"},
    {"ViewAsSvg", {.view = "birdseye"}, "view.svg", "--out: SVG is for plans"},
    {"ViewAsPdf", {.view = "perspective"}, "view.pdf", "--out: PDF is for plans"},
    {"UnknownView", {.view = "side"}, "view.png", "--view: side: is no view; plan, birdseye, perspective"},
    {"DpiWithSize", {.size_px = 800, .dpi = 300}, "plan.png", "--size: 800 and dpi 300 say both"},
    {"DpiOfAnSvg", {.dpi = 300}, "plan.svg", "--dpi: 300 has no meaning for SVG and PDF"},
    {"SizeTooLarge", {.size_px = 9000}, "plan.png", "--size: 9000 is outside [256, 8192]"},
    {"UnknownPaper", {.paper = "letter"}, "plan.pdf", "--paper: letter: is no paper here; a4 or a3"},
    {"ScaleOfWords", {.scale = "1:fifty"}, "plan.pdf", "--scale: 1:fifty: should be 1:N or N"},
    {"ScaleTheWrongWay", {.scale = "50:1"}, "plan.pdf", "--scale: 50:1: should be 1:N or N"},
    {"ScaleTooSmall", {.scale = "1:4"}, "plan.pdf", "--scale: 4 is outside [5, 1000]"},
    {"UnknownLayer", {.layers = "zones,walls"}, "plan.png", "--layers: walls: is no layer; floor_pieces"},
    {"SamplesOfAPlan", {.samples = 9}, "plan.png", "--samples: 9 is for the ray-traced views"},
    {"CameraOfAPlan", {.camera = "0,0,5", .look_at = "1,1,0"}, "plan.png", "--camera: is for the ray-traced views"},
    {"CameraWithoutTarget", {.view = "birdseye", .camera = "0,0,5"}, "v.png", "--camera goes with --look-at"},
    {"TargetWithoutCamera", {.view = "birdseye", .look_at = "0,0,5"}, "v.png", "--look-at goes with --camera"},
    {"CameraOfTwo",
     {.view = "birdseye", .camera = "0,5", .look_at = "1,1,0"},
     "v.png",
     "--camera: 0,5: should be x,y,z in metres"},
    {"CameraOfWords", {.view = "birdseye", .camera = "a,b,c", .look_at = "1,1,0"}, "v.png", "--camera: a,b,c: should"},
    {"CameraAbove",
     {.view = "birdseye", .camera = "1,1,5", .look_at = "1,1,0"},
     "v.png",
     "--look-at: is straight below the eye"},
    {"FieldOfViewAlone", {.view = "birdseye", .field_of_view_deg = 60}, "v.png", "--fov goes with --camera"},
    {"ScaleOfAView", {.view = "birdseye", .scale = "1:50"}, "v.png", "--scale: 50 is for plans"},
    {"LayersOfAView", {.view = "birdseye", .layers = "zones"}, "v.png", "--layers: is for plans"},
    {"PaperOfAView", {.view = "birdseye", .paper = "a4"}, "v.png", "--paper: is for plans"},
};

INSTANTIATE_TEST_SUITE_P(All, BadRenderFlags, ::testing::ValuesIn(kBad),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace flair::cli
