// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/batch/batch_input.h"
#include "cli/output/artifact_text.h"

namespace flair::cli {
namespace {

using ::testing::HasSubstr;

v1::JobSpec Defaults() {
  v1::JobSpec spec;
  spec.mutable_brief()->set_seed(9);
  spec.mutable_solve_options()->set_thread_count(1);
  spec.mutable_solve_options()->mutable_lambdas()->set_balanced(3);
  spec.mutable_solve_options()->set_find_contradictions(true);
  spec.mutable_render_options()->set_size_px(512);
  return spec;
}

v1::JobSpec Read(const std::string& line) {
  const absl::StatusOr<BriefLine> read = ReadBriefLine(line, Defaults());
  EXPECT_TRUE(read.ok()) << read.status();
  return read.ok() ? read->spec : v1::JobSpec();
}

TEST(ReadBriefLine, TakesASentenceAsItIs) {
  v1::JobSpec wanted = Defaults();
  wanted.mutable_brief()->set_text("A bedroom, \"cosy\": 4m x 5m.");
  EXPECT_EQ(ToText(Read("  A bedroom, \"cosy\": 4m x 5m. ")), ToText(wanted));
}

TEST(ReadBriefLine, TakesAJsonString) {
  EXPECT_EQ(Read(R"("A \"cosy\" room\nwith a desk.")").brief().text(), "A \"cosy\" room with a desk.");
}

TEST(ReadBriefLine, TakesTheFieldsOfABriefOverTheDefaults) {
  const v1::JobSpec spec = Read(R"({"text": "A room.", "seed": 0, "room": null, "zone_plan": {"zones": [
      {"id": "rest", "name": "rest"}]}})");
  EXPECT_EQ(spec.brief().seed(), 0);
  EXPECT_EQ(spec.brief().zone_plan().zones(0).id(), "rest");
  EXPECT_EQ(Read(R"({"text": "A room."})").brief().seed(), 9);
}

TEST(ReadBriefLine, TakesOptionsFieldByField) {
  const v1::SolveOptions options =
      Read(R"({"text": "A room.", "variants": 4, "solve": {"max_restart_count": 8, "find_contradictions": false,
               "misfitPolicy": "leave-out", "lambdas": {"zone": 2}}})")
          .solve_options();
  EXPECT_EQ(options.variant_count(), 4);
  EXPECT_EQ(options.max_restart_count(), 8);
  EXPECT_EQ(options.misfit_policy(), v1::MISFIT_POLICY_LEAVE_OUT);
  EXPECT_FALSE(options.find_contradictions());
  EXPECT_EQ(options.lambdas().balanced(), 3);
  EXPECT_EQ(options.lambdas().zone(), 2);
  EXPECT_EQ(options.thread_count(), 1);
}

TEST(ReadBriefLine, PutsTheFirstViewBeforeTheOthers) {
  const v1::JobSpec spec = Read(
      R"({"text": "A room.", "views": ["birdseye", {"view": "perspective", "format": "exr", "size_px": 256}, "plan"]})");
  EXPECT_EQ(spec.render_options().view(), v1::PREVIEW_VIEW_BIRDSEYE);
  EXPECT_EQ(spec.render_options().size_px(), 512);
  ASSERT_EQ(spec.further_views_size(), 2);
  EXPECT_EQ(spec.further_views(0).format(), v1::PREVIEW_FORMAT_EXR);
  EXPECT_EQ(spec.further_views(0).size_px(), 256);
  EXPECT_EQ(spec.further_views(1).view(), v1::PREVIEW_VIEW_PLAN);
}

TEST(ReadBriefLine, TakesAWholeJobSpecInBothSpellings) {
  v1::JobSpec wanted = Defaults();
  wanted.mutable_brief()->set_text("A room.");
  wanted.mutable_solve_options()->set_variant_count(2);
  wanted.add_further_views()->set_view(v1::PREVIEW_VIEW_BIRDSEYE);
  EXPECT_EQ(ToText(Read(ToJsonLine(wanted))), ToText(wanted));
  EXPECT_EQ(ToText(Read(R"({"brief": {"text": "A room."}, "solveOptions": {"variantCount": 2},
                            "furtherViews": [{"view": "PREVIEW_VIEW_BIRDSEYE"}]})")),
            ToText(wanted));
}

TEST(ReadBriefLine, KeepsWhatTheUserCallsIt) {
  EXPECT_EQ(ReadBriefLine(R"({"id": "k-17", "text": "A room."})", {})->key, "k-17");
  EXPECT_EQ(ReadBriefLine(R"({"id": 17, "text": "A room."})", {})->key, "17");
  EXPECT_EQ(ReadBriefLine("A room.", {})->key, "");
}

struct Wrong {
  const char* name;
  std::string line;
  std::vector<std::string> words;
};

class WrongLine : public ::testing::TestWithParam<Wrong> {};

TEST_P(WrongLine, IsRefusedWithFieldAndWhatWouldBeRight) {
  const absl::Status status = ReadBriefLine(GetParam().line, Defaults()).status();
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
  for (const std::string& words : GetParam().words) EXPECT_THAT(std::string(status.message()), HasSubstr(words));
  EXPECT_EQ(status.message().find('\n'), absl::string_view::npos) << status;
}

INSTANTIATE_TEST_SUITE_P(
    All, WrongLine,
    ::testing::Values(
        Wrong{"CutOff", R"({"text": "A room.")", {"is not JSON", "ends too early"}},
        Wrong{"BrokenString", R"("A room)", {"is not JSON"}},
        Wrong{"Array", R"(["A room."])", {"array", "one brief per line"}}, Wrong{"NoText", R"({"seed": 3})", {"text"}},
        Wrong{"UnknownField",
              R"({"txt": "A room."})",
              {"txt", "did you mean text?", "constraint_list; and a line may have id, variants"}},
        Wrong{"SeedOfAnotherType", R"({"text": "A room.", "seed": "x"})", {"seed: is \"x\"", "whole number"}},
        Wrong{"SeedOutOfRange", R"({"text": "A room.", "seed": -1})", {"brief.seed: -1"}},
        Wrong{"ManyVariants", R"({"text": "A room.", "variants": 99})", {"variants: is 99", "1 to 32"}},
        Wrong{"NoView", R"({"text": "A room.", "views": []})", {"views: is []", "birdseye"}},
        Wrong{"UnknownView", R"({"text": "A room.", "views": ["top"]})", {"views[0].view", "\"top\""}},
        Wrong{"UnknownOption", R"({"text": "A room.", "solve": {"restarts": 3}})", {"solve.restarts", "no field"}},
        Wrong{"OptionOutOfRange",
              R"({"text": "A room.", "solve": {"max_restart_count": 0}})",
              {"solve.max_restart_count: 0"}},
        Wrong{"OptionsOfAnotherType", R"({"text": "A room.", "render": "plan"})", {"render: is \"plan\"", "object"}},
        Wrong{"BriefAndItsFields", R"({"brief": {"text": "A room."}, "seed": 3})", {"seed: not beside \"brief\""}},
        Wrong{"RepeatedKey", R"({"text": "A room.", "solve": {"seed": 1, "seed": 2}})", {"\"seed\" stands twice"}},
        Wrong{"EmptyId", R"({"text": "A room.", "id": ""})", {"id: is \"\""}},
        Wrong{"Deep", "{\"room\":" + std::string(100000, '['), {"nests deeper than 64"}},
        Wrong{"TooLongText", std::string(4001, 'a'), {"brief.text", "4000"}}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace flair::cli
