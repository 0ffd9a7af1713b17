// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/job_options.h"

#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <utility>

#include "cli/input/command_line.h"
#include "fmt/format.h"

namespace flair::cli {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// The spec after one option, as text; the error when it was refused.
std::string After(const std::string& option, v1::JobSpec spec = {}) {
  const absl::StatusOr<std::string_view> stage = SetOption(option, spec);
  if (!stage.ok()) return std::string(stage.status().message());
  std::string text;
  google::protobuf::TextFormat::Printer printer;
  printer.SetSingleLineMode(true);
  printer.PrintToString(spec, &text);
  return std::string(*stage) + ": " + text;
}

TEST(SetOption, SetsFieldsByTheirNamesAndByShortOnes) {
  EXPECT_EQ(After("optimizer.restarts=500"), "solve: solve_options { max_restart_count: 500 } ");
  EXPECT_EQ(After("optimizer.max_restart_count = 500"), "solve: solve_options { max_restart_count: 500 } ");
  EXPECT_EQ(After("optimizer.lambdas.balanced=0.5"), "solve: solve_options { lambdas { balanced: 0.5 } } ");
  EXPECT_EQ(After("optimizer.time_limit=2.5"), "solve: solve_options { time_limit { seconds: 2 nanos: 500000000 } } ");
  EXPECT_EQ(After("optimizer.misfits=leave-out"), "solve: solve_options { misfit_policy: MISFIT_POLICY_LEAVE_OUT } ");
  EXPECT_EQ(After("optimizer.contradictions=true"), "solve: solve_options { find_contradictions: true } ");
  EXPECT_EQ(After("renderer.view=birdseye"), "render: render_options { view: PREVIEW_VIEW_BIRDSEYE } ");
  EXPECT_EQ(After("renderer.layers=zones, PLAN_LAYER_TERTIARY"),
            "render: render_options { layers: PLAN_LAYER_ZONES layers: PLAN_LAYER_TERTIARY } ");
  EXPECT_EQ(After("renderer.camera.eye_m=1,-2.5,3"),
            "render: render_options { camera { eye_m: 1 eye_m: -2.5 eye_m: 3 } } ");
  EXPECT_EQ(After("models.max_calls=3"), "room: model_options { budget { call_count: 3 } } ");
  EXPECT_EQ(After("brief.seed=9007199254740991"), "brief: brief { seed: 9007199254740991 } ");
}

TEST(SetOption, GivesAnOptionBackWithoutAValue) {
  v1::JobSpec spec;
  spec.mutable_solve_options()->set_max_restart_count(3);
  EXPECT_EQ(After("optimizer.restarts=", spec), "solve: solve_options { } ");
}

TEST(SetOption, ReplacesLists) {
  v1::JobSpec spec;
  spec.mutable_render_options()->add_layers(v1::PLAN_LAYER_ZONES);
  EXPECT_EQ(After("renderer.layers=tertiary", spec), "render: render_options { layers: PLAN_LAYER_TERTIARY } ");
}

TEST(SetOption, SaysWhatThereIs) {
  EXPECT_EQ(After("renderer.layers=all"), After("renderer.layers=floor_pieces,tertiary,zones,dimensions,constraints,"
                                                "circulation"));
  EXPECT_THAT(After("optimizer.restart=5"), HasSubstr("--set optimizer.restart: no such option; expected one of "
                                                      "optimizer.seed, optimizer.restarts, optimizer.threads"));
  EXPECT_THAT(After("solver.seed=5"), HasSubstr("brief.seed"));
  EXPECT_THAT(After("solver.seed=5"), HasSubstr("renderer.view"));
  for (const char* option : {"brief.text=A kitchen.", "optimizer=3", "optimizer.=3", "optimizer.lambdas=3",
                             "optimizer.lambdas.balanced.x=3", "=3", "brief=1", "optimizer..seed=1"}) {
    EXPECT_THAT(After(option), HasSubstr("no such option")) << option;
  }
  EXPECT_THAT(After("optimizer.seed"), HasSubstr("expected NAME=VALUE"));
}

TEST(SetOption, SaysWhatAValueShouldBe) {
  EXPECT_EQ(After("optimizer.restarts=many"), "--set optimizer.restarts: many: expected a whole number");
  EXPECT_EQ(After("optimizer.restarts=1.5"), "--set optimizer.restarts: 1.5: expected a whole number");
  EXPECT_EQ(After("optimizer.restarts=99999999999"), "--set optimizer.restarts: 99999999999: expected a whole number");
  EXPECT_EQ(After("optimizer.path_width=nan"), "--set optimizer.path_width: nan: expected a number");
  EXPECT_EQ(After("optimizer.time_limit=-1"), "--set optimizer.time_limit: -1: expected seconds");
  EXPECT_EQ(After("renderer.view=side"), "--set renderer.view: side: expected plan, birdseye or perspective");
  EXPECT_EQ(After("renderer.view=unspecified"),
            "--set renderer.view: unspecified: expected plan, birdseye or perspective");
  EXPECT_THAT(After("renderer.layers=zones,"), HasSubstr("several, separated by commas, of: floor_pieces"));
}

TEST(SetOption, ChangesNothingWhenItFails) {
  v1::JobSpec spec;
  EXPECT_FALSE(SetOption("optimizer.lambdas.none=3", spec).ok());
  EXPECT_FALSE(SetOption("renderer.layers=zones,none", spec).ok());
  EXPECT_EQ(spec.ByteSizeLong(), 0u);
}

TEST(OptionNames, AreAllOnThePage) {
  std::ifstream file(FLAIR_SOURCE_DIR "/docs/replay.md");
  const std::string page((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  for (const OptionName& option : OptionNames()) {
    EXPECT_THAT(page, HasSubstr("`" + option.name + "`"));
    v1::JobSpec spec;
    EXPECT_TRUE(SetOption(option.name + "=", spec).ok()) << option.name;
  }
}

// What a command with these flags takes from a line.
template <typename Flags, typename Read>
auto Parsed(const std::string& line, const Read& read) -> decltype(read(std::declval<const Flags&>())) {
  CLI::App app("Solves.", "solve");
  const Flags flags(app);
  try {
    app.parse(line);
  } catch (const CLI::ParseError& error) {
    return UsageError(app, error);
  }
  return read(flags);
}

absl::StatusOr<v1::SolveOptions> Solve(const std::string& line) { return Parsed<SolveFlags>(line, ReadSolveFlags); }

std::string OptionsFile(const std::string& text) {
  const std::string path = fmt::format("{}/options_{}.txt", ::testing::TempDir(), getpid());
  std::ofstream(path) << text;
  return path;
}

std::string ErrorOf(const std::string& line) {
  const absl::StatusOr<v1::SolveOptions> options = Solve(line);
  EXPECT_EQ(options.status().code(), absl::StatusCode::kInvalidArgument);
  return std::string(options.status().message());
}

TEST(SolveFlags, WithoutFlagsOnlyTheSeedIsSet) {
  const absl::StatusOr<v1::SolveOptions> options = Solve("");
  ASSERT_TRUE(options.ok()) << options.status();
  EXPECT_EQ(options->ShortDebugString(), "seed: 0");
}

TEST(SolveFlags, FlagsGoBeforeTheFile) {
  const std::string file =
      OptionsFile("seed: 3 max_restart_count: 5 lambdas { zone: 1 balanced: 2 } tolerances { absolute: 1e-6 }");
  const absl::StatusOr<v1::SolveOptions> options =
      Solve("--options " + file + " --restarts 9 --lambda balanced=0.5 --tolerance max_evaluation_count=80");
  ASSERT_TRUE(options.ok()) << options.status();
  EXPECT_EQ(options->seed(), 3);
  EXPECT_EQ(options->max_restart_count(), 9);
  EXPECT_EQ(options->lambdas().zone(), 1);
  EXPECT_EQ(options->lambdas().balanced(), 0.5);
  EXPECT_EQ(options->tolerances().absolute(), 1e-6);
  EXPECT_EQ(options->tolerances().max_evaluation_count(), 80);
}

TEST(SolveFlags, EveryFlagArrives) {
  const absl::StatusOr<v1::SolveOptions> options =
      Solve("--seed 7 --threads 2 --variants 3 --path-width 0.7 --misfits leave-out --contradictions");
  ASSERT_TRUE(options.ok()) << options.status();
  EXPECT_EQ(options->ShortDebugString(),
            "seed: 7 thread_count: 2 path_width_m: 0.7 variant_count: 3 misfit_policy: MISFIT_POLICY_LEAVE_OUT "
            "find_contradictions: true");
  EXPECT_EQ(ErrorOf("--misfits drop"), "--misfits: drop: expected keep or leave_out");
  EXPECT_EQ(ErrorOf("--threads 0"), "--threads: 0: expected a whole number, 1 to 256");
}

TEST(SolveFlags, TheTimeLimitKeepsItsFraction) {
  const absl::StatusOr<v1::SolveOptions> options = Solve("--time-limit 1.25");
  ASSERT_TRUE(options.ok()) << options.status();
  EXPECT_EQ(options->time_limit().seconds(), 1);
  EXPECT_EQ(options->time_limit().nanos(), 250000000);
}

TEST(SolveFlags, AnUnknownFactorIsToldTheKnownOnes) {
  EXPECT_THAT(ErrorOf("--lambda balance=3"),
              HasSubstr("--lambda: balance=3: expected NAME=VALUE, a number for one of door_overlap, "));
}

TEST(SolveFlags, ValuesThatAreNoNumbersAreNamed) {
  for (const std::string text : {"balanced", "balanced=", "balanced=much", "balanced=nan", "balanced=inf"}) {
    EXPECT_THAT(ErrorOf("--lambda " + text), HasSubstr("--lambda: " + text + ": expected NAME=VALUE, a number"));
  }
  EXPECT_THAT(ErrorOf("--tolerance max_evaluation_count=1.5"), HasSubstr("--tolerance: max_evaluation_count=1.5: "));
}

TEST(SolveFlags, AFileThatDoesNotParseIsToldWhere) {
  EXPECT_THAT(ErrorOf("--options " + OptionsFile("seed: 3\nlambdas { balance: 2 }")), HasSubstr(":2: column 18"));
}

absl::StatusOr<v1::RenderOptions> Render(const std::string& line, const std::string& out) {
  return Parsed<RenderFlags>(line, [&out](const RenderFlags& flags) { return ReadRenderFlags(flags, out); });
}

v1::RenderOptions Good(const std::string& line, const std::string& out) {
  const absl::StatusOr<v1::RenderOptions> options = Render(line, out);
  EXPECT_TRUE(options.ok()) << options.status();
  return options.ok() ? *options : v1::RenderOptions();
}

TEST(RenderFlags, TheEndingOfTheFileIsTheFormat) {
  EXPECT_EQ(Good("", "a/plan.png").format(), v1::PREVIEW_FORMAT_PNG);
  EXPECT_EQ(Good("", "a/Plan.JPEG").format(), v1::PREVIEW_FORMAT_JPEG);
  EXPECT_EQ(Good("", "a.b/plan.jpg").format(), v1::PREVIEW_FORMAT_JPEG);
  EXPECT_EQ(Good("", "plan.tif").format(), v1::PREVIEW_FORMAT_TIFF);
  EXPECT_EQ(Good("", "plan.svg").format(), v1::PREVIEW_FORMAT_SVG);
  EXPECT_EQ(Good("", "plan.pdf").format(), v1::PREVIEW_FORMAT_PDF);
  EXPECT_EQ(Good("--view birdseye", "view.exr").format(), v1::PREVIEW_FORMAT_EXR);
}

TEST(RenderFlags, EveryFlagOfAPlanArrives) {
  const v1::RenderOptions options = Good("--dpi 300 --paper a4 --scale 1:50 --layers zones,floor-pieces", "plan.png");
  EXPECT_EQ(options.dpi(), 300);
  EXPECT_EQ(options.paper(), v1::PAPER_SIZE_A4);
  EXPECT_EQ(options.scale_denominator(), 50);
  EXPECT_THAT(options.layers(), ElementsAre(v1::PLAN_LAYER_ZONES, v1::PLAN_LAYER_FLOOR_PIECES));
  EXPECT_EQ(Good("--scale 20 --layers all", "plan.png").layers_size(), 6);
  EXPECT_EQ(Good("--scale 20", "plan.png").scale_denominator(), 20);
}

TEST(RenderFlags, EveryFlagOfAViewArrives) {
  const v1::RenderOptions options = Good(
      "--view perspective --size 512 --samples 4 --seed 9 --camera '1, -2.5,1.6' --look-at 2,3,1 --fov 60", "view.png");
  EXPECT_EQ(options.size_px(), 512);
  EXPECT_EQ(options.sample_count(), 4);
  EXPECT_EQ(options.seed(), 9);
  EXPECT_THAT(options.camera().eye_m(), ElementsAre(1, -2.5, 1.6));
  EXPECT_THAT(options.camera().target_m(), ElementsAre(2, 3, 1));
  EXPECT_NEAR(options.camera().field_of_view_rad(), 1.0471975512, 1e-9);
}

struct Bad {
  const char* name;
  const char* flags;
  const char* out;
  const char* message;
};

class BadRenderFlags : public ::testing::TestWithParam<Bad> {};

TEST_P(BadRenderFlags, AreRefusedWithWhatWouldBeRight) {
  const absl::Status status = Render(GetParam().flags, GetParam().out).status();
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(status.message()), HasSubstr(GetParam().message));
}

const Bad kBad[] = {
    {"NoEnding", "", "plan", "--out: plan: its extension chooses the format: png, jpg, jpeg, tif, tiff, exr, svg, pdf"},
    {"UnknownEnding", "", "plan.bmp", "--out: plan.bmp: its extension chooses the format: png"},
    {"AScene", "", "room.glb", "flair export scene LAYOUT --format glb"},
    {"PlanAsExr", "", "plan.exr", "--out: EXR is for the ray-traced views"},
    {"ViewAsSvg", "--view birdseye", "view.svg", "--out: SVG is for plans"},
    {"ViewAsPdf", "--view perspective", "view.pdf", "--out: PDF is for plans"},
    {"UnknownView", "--view side", "view.png", "--view: side: expected plan, birdseye or perspective"},
    {"DpiWithSize", "--size 800 --dpi 300", "plan.png", "--size: 800 and dpi 300 say both"},
    {"DpiOfAnSvg", "--dpi 300", "plan.svg", "--dpi: 300 has no meaning for SVG and PDF"},
    {"SizeTooLarge", "--size 9000", "plan.png", "--size: 9000: expected a whole number, 256 to 8192"},
    {"UnknownPaper", "--paper letter", "plan.pdf", "--paper: letter: expected a4 or a3"},
    {"ScaleOfWords", "--scale 1:fifty", "plan.pdf", "--scale: 1:fifty: expected a whole number"},
    {"ScaleTheWrongWay", "--scale 50:1", "plan.pdf", "--scale: 50:1: expected a whole number"},
    {"ScaleTooSmall", "--scale 1:4", "plan.pdf", "--scale: 4 is outside [5, 1000]"},
    {"UnknownLayer", "--layers zones,walls", "plan.png",
     "--layers: zones,walls: expected several, separated by commas, of: floor_pieces"},
    {"SamplesOfAPlan", "--samples 9", "plan.png", "--samples: 9 is for the ray-traced views"},
    {"CameraOfAPlan", "--camera 0,0,5 --look-at 1,1,0", "plan.png", "--camera: is for the ray-traced views"},
    {"CameraWithoutTarget", "--view birdseye --camera 0,0,5", "v.png",
     "--look-at: has 0 numbers; x, y and z in metres"},
    {"TargetWithoutCamera", "--view birdseye --look-at 0,0,5", "v.png",
     "--camera: has 0 numbers; x, y and z in metres"},
    {"CameraOfTwo", "--view birdseye --camera 0,5 --look-at 1,1,0", "v.png",
     "--camera: has 2 numbers; x, y and z in metres"},
    {"CameraOfWords", "--view birdseye --camera a,b,c --look-at 1,1,0", "v.png", "--camera: a,b,c: expected"},
    {"CameraAbove", "--view birdseye --camera 1,1,5 --look-at 1,1,0", "v.png", "--look-at: is straight below the eye"},
    {"FieldOfViewAlone", "--view birdseye --fov 60", "v.png", "--camera: has 0 numbers; x, y and z in metres"},
    {"ScaleOfAView", "--view birdseye --scale 1:50", "v.png", "--scale: 50 is for plans"},
    {"LayersOfAView", "--view birdseye --layers zones", "v.png", "--layers: is for plans"},
    {"PaperOfAView", "--view birdseye --paper a4", "v.png", "--paper: is for plans"},
};

INSTANTIATE_TEST_SUITE_P(All, BadRenderFlags, ::testing::ValuesIn(kBad),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace flair::cli
