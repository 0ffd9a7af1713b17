// SPDX-License-Identifier: GPL-3.0-or-later
// From what a model wrote for a room to a plan, through the real program and without a network.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "cli/input/artifact_file.h"
#include "tests/end_to_end/layout_checks.h"
#include "tests/fixtures/programs.h"

namespace flair::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

Finished ImportAnswers(const std::filesystem::path& room, const std::filesystem::path& out) {
  return RunProgram("flair-dev", {"import", "answers", room, "--out", out});
}

std::filesystem::path RoomFile(const std::string& name) {
  return FLAIR_SOURCE_DIR "/evaluation/recorded/testdata/" + name + ".json";
}

class RecordedAnswers : public ::testing::TestWithParam<std::string> {
 protected:
  Finished Import() const { return ImportAnswers(RoomFile(GetParam()), folder_ / "answers"); }
  Finished Design(const std::string& out) const {
    return RunProgram("flair",
                      {"design", "--brief", folder_ / "answers" / "brief.json", "--replay", folder_ / "answers",
                       "--out", folder_ / out},
                      {{"FLAIR_HOME", folder_ / "home"}});
  }
  v1::Artifact Layout(const std::string& out) const {
    const absl::StatusOr<v1::Artifact> layout = cli::ReadArtifact(folder_ / out / "layout.pb");
    EXPECT_TRUE(layout.ok()) << layout.status();
    return layout.ok() ? *layout : v1::Artifact();
  }

  const TestFolder folder_;
};

TEST_P(RecordedAnswers, EndInAPlan) {
  const Finished import = Import();
  ASSERT_EQ(import.exit_code, 0) << import.err;
  EXPECT_THAT(import.err, AllOf(HasSubstr("lines converted"), HasSubstr(" questions, about "), HasSubstr("--replay")));
  const Finished design = Design("out");
  ASSERT_EQ(design.exit_code, 0) << design.err;
  EXPECT_THAT(ReadAll(folder_ / "out" / "plan.png"), ::testing::StartsWith("\x89PNG"));
  const v1::Artifact layout = Layout("out");
  EXPECT_THAT(FindFaults(layout.solved_layout()), IsEmpty());
  const v1::LayoutGraph& graph = layout.solved_layout().graph();
  EXPECT_EQ(layout.solved_layout().placements_size(), graph.object_list().objects_size());
  EXPECT_GE(graph.object_list().objects_size(), 9);
  EXPECT_GE(graph.edges_size(), 3) << "the recorded calls";
}

TEST_P(RecordedAnswers, GiveTheSameBytesAgainAndSayWhatIsMissing) {
  ASSERT_EQ(Import().exit_code, 0);
  ASSERT_EQ(Design("first").exit_code, 0);
  std::filesystem::remove_all(folder_ / "home");  // nothing is taken from the store
  ASSERT_EQ(Design("second").exit_code, 0);
  for (const char* stem : {"room", "zones", "objects", "style", "constraints", "graph", "layout"}) {
    const std::string file = std::string(stem) + ".pb";
    EXPECT_EQ(ReadAll(folder_ / "first" / file), ReadAll(folder_ / "second" / file)) << file;
  }
  std::string removed;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "answers")) {
    if (entry.path().filename().string().starts_with("zones-")) removed = entry.path();
  }
  ASSERT_FALSE(removed.empty());
  std::filesystem::remove(removed);
  std::filesystem::remove_all(folder_ / "home");
  const Finished design = Design("third");
  EXPECT_NE(design.exit_code, 0);
  EXPECT_THAT(design.err, AllOf(HasSubstr("\"zones\""), HasSubstr(std::filesystem::path(removed).filename().string())));
}

INSTANTIATE_TEST_SUITE_P(Rooms, RecordedAnswers, ::testing::Values("study", "washroom"),
                         [](const auto& info) { return info.param; });

TEST(RecordedAnswersOfAnotherRoom, DoNotMixWithThoseOfOne) {
  const TestFolder folder;
  const auto import = [&](const std::string& room) { return ImportAnswers(RoomFile(room), folder / "answers"); };
  ASSERT_EQ(import("study").exit_code, 0);
  const std::string brief = ReadAll(folder / "answers" / "brief.json");
  EXPECT_EQ(import("study").exit_code, 0) << "the same again";
  const Finished other = import("washroom");
  EXPECT_NE(other.exit_code, 0);
  EXPECT_THAT(other.err, HasSubstr("choose another folder"));
  EXPECT_EQ(ReadAll(folder / "answers" / "brief.json"), brief);
}

TEST(RecordedAnswersOfAnotherFile, AreRefusedInOneLineAndLeaveNothingBehind) {
  const TestFolder folder;
  const Finished import = ImportAnswers(FLAIR_SOURCE_DIR "/CMakeLists.txt", folder / "x");
  EXPECT_NE(import.exit_code, 0);
  EXPECT_THAT(import.err,
              AllOf(HasSubstr("CMakeLists.txt"), HasSubstr("not a recorded room"), Not(HasSubstr("Traceback"))));
  EXPECT_FALSE(std::filesystem::exists(folder / "x"));
}

}  // namespace
}  // namespace flair::testing
