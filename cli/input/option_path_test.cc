// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/option_path.h"

#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>

#include <fstream>
#include <iterator>

namespace flair::cli {
namespace {

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
  EXPECT_THAT(After("optimizer.restart=5"), HasSubstr("--set optimizer.restart: there is no such option; one of "
                                                      "optimizer.seed, optimizer.restarts, optimizer.threads"));
  EXPECT_THAT(After("solver.seed=5"), HasSubstr("brief.seed"));
  EXPECT_THAT(After("solver.seed=5"), HasSubstr("renderer.view"));
  for (const char* option : {"brief.text=A kitchen.", "optimizer=3", "optimizer.=3", "optimizer.lambdas=3",
                             "optimizer.lambdas.balanced.x=3", "=3", "brief=1", "optimizer..seed=1"}) {
    EXPECT_THAT(After(option), HasSubstr("there is no such option")) << option;
  }
  EXPECT_THAT(After("optimizer.seed"), HasSubstr("should be NAME=VALUE"));
}

TEST(SetOption, SaysWhatAValueShouldBe) {
  EXPECT_EQ(After("optimizer.restarts=many"), "--set optimizer.restarts: many: should be whole number");
  EXPECT_EQ(After("optimizer.restarts=1.5"), "--set optimizer.restarts: 1.5: should be whole number");
  EXPECT_EQ(After("optimizer.restarts=99999999999"), "--set optimizer.restarts: 99999999999: should be whole number");
  EXPECT_EQ(After("optimizer.path_width=nan"), "--set optimizer.path_width: nan: should be number");
  EXPECT_EQ(After("optimizer.time_limit=-1"), "--set optimizer.time_limit: -1: should be seconds");
  EXPECT_EQ(After("renderer.view=side"), "--set renderer.view: side: should be plan, birdseye or perspective");
  EXPECT_EQ(After("renderer.view=unspecified"),
            "--set renderer.view: unspecified: should be plan, birdseye or perspective");
  EXPECT_THAT(After("renderer.layers=zones,"), HasSubstr("several, with commas between, of: floor_pieces"));
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

}  // namespace
}  // namespace flair::cli
