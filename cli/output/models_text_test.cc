// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/output/report_text.h"

namespace flair::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

void AddCall(const std::string& step, const std::string& fault, v1::Artifact& artifact) {
  v1::ModelCall& call = *artifact.add_model_calls();
  call.set_step(step);
  call.set_model("gpt-4o-2024");
  call.set_prompt_version("3f9a41c2");
  v1::ModelMessage& message = *call.add_messages();
  message.set_role("user");
  message.set_text("What zones?");
  call.set_answer("{\"zones\":[]}\x1b[2J");
  call.mutable_usage()->set_call_count(1);
  call.mutable_usage()->set_input_token_count(1000);
  call.mutable_usage()->set_output_token_count(200);
  call.mutable_usage()->set_cost_usd(0.01);
  if (!fault.empty()) call.add_faults(fault);
}

ArtifactsByKind Bedroom() {
  ArtifactsByKind artifacts;
  AddCall("zones", "zones: is empty; expected 1 to 8", artifacts[v1::ARTIFACT_KIND_ZONE_PLAN]);
  AddCall("zones/repair", "", artifacts[v1::ARTIFACT_KIND_ZONE_PLAN]);
  AddCall("style", "", artifacts[v1::ARTIFACT_KIND_STYLE_SHEET]);
  artifacts[v1::ARTIFACT_KIND_ROOM];
  return artifacts;
}

TEST(ModelsText, TheReportTellsStageByStageWhatWasAskedConsumedAndMended) {
  v1::Report report;
  report.mutable_model_usage()->set_call_count(3);
  v1::Diagnostic& remark = *report.add_diagnostics();
  remark.set_code("stand_in");
  remark.set_message("The handbook answered instead of the model: it cannot be reached.");
  const std::string text = ModelsSection(report, Bedroom());
  EXPECT_THAT(text, HasSubstr("| zone plan | gpt-4o-2024 | 2 | 1 | 2000 | 400 | 0.0200 USD |\n"));
  EXPECT_THAT(text, HasSubstr("| style sheet | gpt-4o-2024 | 1 | 0 | 1000 | 200 | 0.0100 USD |\n"));
  EXPECT_THAT(text, HasSubstr("| **all** |  | 3 | 1 | 3000 | 600 | 0.0300 USD |\n"));
  EXPECT_THAT(text, HasSubstr("- zones: zones: is empty; expected 1 to 8\n"));
  EXPECT_THAT(text, HasSubstr("Without the model:\n\n- The handbook answered instead of the model"));
  EXPECT_THAT(text, Not(HasSubstr("made for this job")));
}

TEST(ModelsText, TheReportTellsWhichCallsAnEarlierJobPaid) {
  v1::Report report;
  report.mutable_model_usage()->set_call_count(1);
  EXPECT_THAT(ModelsSection(report, Bedroom()), HasSubstr("Made for this job: 1; the others"));
}

TEST(ModelsText, WithoutAModelThereIsNoSection) { EXPECT_EQ(ModelsSection({}, {}), ""); }

TEST(ModelsText, CallsAreShownWithAllThatWasSaidAndNothingThatSteersATerminal) {
  const v1::Artifact plan = Bedroom()[v1::ARTIFACT_KIND_ZONE_PLAN];
  EXPECT_EQ(ModelCallTexts(plan),
            "=== zones: gpt-4o-2024, prompts 3f9a41c2, 1000 tokens asked, 200 answered\n"
            "--- user\nWhat zones?\n--- answer\n{\"zones\":[]} [2J\n--- fault: zones: is empty; expected 1 to 8\n"
            "\n=== zones/repair: gpt-4o-2024, prompts 3f9a41c2, 1000 tokens asked, 200 answered\n"
            "--- user\nWhat zones?\n--- answer\n{\"zones\":[]} [2J\n");
  EXPECT_EQ(ModelCallLines(plan),
            "asked      zones: gpt-4o-2024, 1200 tokens, 0.0100 USD, 1 fault\n"
            "           zones/repair: gpt-4o-2024, 1200 tokens, 0.0100 USD\n");
}

TEST(ModelsText, TextsThatWereLeftOutAreSaidToBe) {
  v1::Artifact artifact;
  AddCall("zones", "", artifact);
  artifact.mutable_model_calls(0)->clear_messages();
  artifact.mutable_model_calls(0)->clear_answer();
  EXPECT_THAT(ModelCallTexts(artifact), HasSubstr("(the texts were left out)\n"));
}

}  // namespace
}  // namespace flair::cli
