// SPDX-License-Identifier: GPL-3.0-or-later
// Every prompt of the paper through the real program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/input/artifact_file.h"
#include "tests/end_to_end/layout_checks.h"
#include "tests/fixtures/programs.h"

namespace flair::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Prompt {
  std::string name;
  std::string text;
};

class PaperPrompts : public ::testing::TestWithParam<Prompt> {};

TEST_P(PaperPrompts, GiveAGoodRoom) {
  const TestFolder folder;
  const Finished run =
      RunProgram("flair", {"design", GetParam().text, "--out", folder / "out"}, {{"FLAIR_HOME", folder / "home"}});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  for (const char* stem : {"brief", "room", "zones", "objects", "style", "constraints", "graph", "layout"}) {
    const absl::StatusOr<v1::Artifact> artifact = cli::ReadArtifact(folder / "out" / (std::string(stem) + ".pb"));
    ASSERT_TRUE(artifact.ok()) << artifact.status();
    EXPECT_TRUE(cli::CheckArtifactId(*artifact, stem).ok());
    const absl::StatusOr<v1::Artifact> json = cli::ReadArtifact(folder / "out" / (std::string(stem) + ".json"));
    ASSERT_TRUE(json.ok()) << json.status();
    EXPECT_TRUE(cli::CheckArtifactId(*json, stem).ok()) << "JSON must hold all of the artifact";
  }
  EXPECT_THAT(ReadAll(folder / "out" / "plan.png"), ::testing::StartsWith("\x89PNG"));
  EXPECT_THAT(ReadAll(folder / "out" / "report.md"), HasSubstr("## Reasons, sentence by sentence"));
  const absl::StatusOr<v1::Artifact> layout = cli::ReadArtifact(folder / "out" / "layout.pb");
  ASSERT_TRUE(layout.ok());
  EXPECT_THAT(FindFaults(layout->solved_layout()), IsEmpty());
  EXPECT_GE(layout->solved_layout().placements_size(), 5);
}

INSTANTIATE_TEST_SUITE_P(
    Paper, PaperPrompts,
    ::testing::Values(
        Prompt{"Bedroom4x5", "A bedroom that is 4m x 5m."}, Prompt{"Bedroom3x4", "A bedroom that is 3m x 4m."},
        Prompt{"LivingRoom4x4", "A living room that is 4m x 4m."},
        Prompt{"LivingDining6x3", "A living/dining room that is 6m x 3m."}, Prompt{"SewingRoom", "A sewing room."},
        Prompt{"HomeGym", "A small home gym."}, Prompt{"BohoDining", "A small green boho dining room."},
        Prompt{"TraditionalLiving", "A traditional living room."},
        Prompt{"WritersOffice", "An office for a bestselling writer in New York who likes to write Fantasy books."},
        Prompt{"YoungArtist",
               "A bedroom that is 5x5 for a young girl who likes to paint whilst looking out of her window."},
        Prompt{"Vampire", "A bedroom for a vampire."}, Prompt{"Wizard", "A small workroom for a wizard."},
        Prompt{"Ogre", "A kitchen for an ogre."}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace flair::testing
