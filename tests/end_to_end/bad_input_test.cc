// SPDX-License-Identifier: GPL-3.0-or-later
// What people get wrong: a clear message, the right exit code, and nothing half-written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include "cli/exit_code.h"
#include "tests/fixtures/programs.h"

namespace flair::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class BadInput : public ::testing::Test {
 protected:
  Finished Flair(const std::vector<std::string>& arguments) const {
    return RunProgram("flair", arguments, {{"FLAIR_HOME", folder_ / "home"}});
  }
  Finished Design(const std::string& text) const { return Flair({"design", text, "--out", folder_ / "out"}); }
  void ExpectRefused(const Finished& run, int exit_code, const std::string& message) const {
    EXPECT_EQ(run.exit_code, exit_code) << run.err;
    EXPECT_THAT(run.err, HasSubstr(message));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
      EXPECT_EQ(entry.path().filename().string().find(".flair-"), std::string::npos) << entry.path();
    }
  }

  TestFolder folder_;
};

TEST_F(BadInput, AnEmptyBrief) { ExpectRefused(Design(""), cli::kExitBadInput, "brief.text: is empty"); }

TEST_F(BadInput, WhitespaceOnly) { ExpectRefused(Design(" \t\n "), cli::kExitBadInput, "brief.text: is empty"); }

TEST_F(BadInput, AHundredKilobytes) {
  ExpectRefused(Design(std::string(100000, 'a')), cli::kExitBadInput, "has 100000 characters; at most 4000");
}

TEST_F(BadInput, ControlCharacters) {
  ExpectRefused(Design("A bed\x07room."), cli::kExitBadInput, "control character 0x07 at byte 5");
}

TEST_F(BadInput, NothingButEmoji) {
  ExpectRefused(Design("\xF0\x9F\x9B\x8F\xF0\x9F\x9B\x8B"), cli::kExitBadInput, "has no word");
}

TEST_F(BadInput, TextThatIsNotUtf8) { ExpectRefused(Design("bed\xff\xfe"), cli::kExitBadInput, "not valid UTF-8"); }

TEST_F(BadInput, ARoomWithoutArea) { ExpectRefused(Design("A bedroom that is 0m x -3m"), cli::kExitBadInput, "0"); }

TEST_F(BadInput, ARoomOfHalfAMetre) {
  ExpectRefused(Design("A bedroom that is 0.5m x 0.5m"), cli::kExitBadInput, "0.5");
}

TEST_F(BadInput, ARoomOfTwoHundredMetres) {
  ExpectRefused(Design("A bedroom that is 200m x 200m"), cli::kExitBadInput, "200");
}

TEST_F(BadInput, TenWishesForFourSquareMetresNamesWhatDoesNotFit) {
  const Finished run = Design(
      "A 2m x 2m bedroom with a grand piano, a king size bed, a sofa, two armchairs, a dining table, a wardrobe, a "
      "desk, "
      "a bookshelf, a treadmill and a billiard table.");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("left out"));
  const std::string report = ReadAll(folder_ / "out" / "report.md");
  EXPECT_THAT(report, HasSubstr("## Left out"));
  EXPECT_THAT(report, HasSubstr("piano"));
}

TEST_F(BadInput, AnUnwritableFolder) {
  const Finished run = Flair({"design", "A bedroom.", "--out", "/proc/flair/out"});
  EXPECT_EQ(run.exit_code, cli::kExitFiles);
  EXPECT_THAT(run.err, HasSubstr("/proc"));
}

TEST_F(BadInput, AFileInsteadOfAFolder) {
  WriteAll(folder_ / "file", "mine");
  const Finished run = Flair({"design", "A bedroom.", "--out", folder_ / "file"});
  EXPECT_EQ(run.exit_code, cli::kExitFiles);
  EXPECT_THAT(run.err, HasSubstr("is a file"));
  EXPECT_EQ(ReadAll(folder_ / "file"), "mine");
}

TEST_F(BadInput, AFolderWithFilesOfOthersKeepsThem) {
  std::filesystem::create_directory(folder_ / "out");
  WriteAll(folder_ / "out" / "notes.txt", "mine");
  ASSERT_EQ(Design("A bedroom that is 3m x 4m.").exit_code, 0);
  EXPECT_EQ(ReadAll(folder_ / "out" / "notes.txt"), "mine");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out" / "plan.png"));

  std::filesystem::create_directory(folder_ / "other");
  WriteAll(folder_ / "other" / "report.md", "my own report");
  const Finished run = Flair({"design", "A bedroom.", "--out", folder_ / "other"});
  EXPECT_EQ(run.exit_code, cli::kExitFiles);
  EXPECT_EQ(ReadAll(folder_ / "other" / "report.md"), "my own report");
}

TEST_F(BadInput, AStoreThatCannotBeMade) {
  const Finished run =
      RunProgram("flair", {"design", "A bedroom.", "--out", folder_ / "out"}, {{"FLAIR_HOME", "/proc/flair-store"}});
  ExpectRefused(run, cli::kExitFiles, "FLAIR_HOME");
}

TEST_F(BadInput, ACorruptArtifact) {
  WriteAll(folder_ / "garbage.pb", "this is no artifact");
  WriteAll(folder_ / "empty.pb", "");
  for (const char* name : {"garbage.pb", "empty.pb"}) {
    const Finished run = Flair({"inspect", folder_ / name});
    EXPECT_EQ(run.exit_code, cli::kExitCorrupt) << name;
    EXPECT_THAT(run.err, HasSubstr("not a Flair artifact"));
  }
  const Finished drawn = Flair({"render", folder_ / "garbage.pb", "--out", folder_ / "plan.png"});
  EXPECT_EQ(drawn.exit_code, cli::kExitCorrupt);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "plan.png"));
}

TEST_F(BadInput, AnArtifactWithAFlippedBitIsFoundOut) {
  ASSERT_EQ(Design("A bedroom that is 3m x 4m.").exit_code, 0);
  const std::filesystem::path path = folder_ / "out" / "brief.pb";
  std::string bytes = ReadAll(path);
  bytes[bytes.find("bedroom")] = 'B';
  WriteAll(path, bytes);
  const Finished run = Flair({"inspect", path});
  EXPECT_EQ(run.exit_code, cli::kExitCorrupt);
  EXPECT_THAT(run.out, HasSubstr("does NOT match"));
}

TEST_F(BadInput, NobodyAtTheAddress) {
  const Finished run = Flair({"design", "A bedroom.", "--out", folder_ / "out", "--orchestrator", "127.0.0.1:1"});
  ExpectRefused(run, cli::kExitUnreachable, "127.0.0.1:1");
}

TEST_F(BadInput, AnAddressThatIsNone) {
  const Finished run = Flair({"design", "A bedroom.", "--out", folder_ / "out", "--orchestrator", "nonsense"});
  ExpectRefused(run, cli::kExitBadInput, "nonsense");
}

TEST_F(BadInput, AWorkerThatIsDown) {
  AllPrograms programs(folder_.path());
  ASSERT_NE(programs.orchestrator(), "");
  programs.optimizer_program().process().Signal(SIGKILL);
  programs.optimizer_program().process().Wait();
  const Finished run =
      Flair({"design", "A bedroom.", "--out", folder_ / "out", "--orchestrator", programs.orchestrator()});
  ExpectRefused(run, cli::kExitUnreachable, programs.optimizer());
}

TEST_F(BadInput, OptionsOutOfRange) {
  for (const std::vector<std::string>& option : std::vector<std::vector<std::string>>{
           {"--size", "100"}, {"--threads", "0"}, {"--seed", "-1"}, {"--restarts", "x"}, {"--colour", "red"}}) {
    std::vector<std::string> arguments = {"design", "A bedroom.", "--out", folder_ / "out"};
    arguments.insert(arguments.end(), option.begin(), option.end());
    ExpectRefused(Flair(arguments), cli::kExitBadInput, option[0]);
  }
}

TEST_F(BadInput, ARoomFileWithABadWindow) {
  WriteAll(folder_ / "room.json", R"({"room_type": "bedroom", "height_m": 3,
    "floor": {"vertices": [{}, {"x_m": 4}, {"x_m": 4, "y_m": 5}, {"y_m": 5}]},
    "walls": [{"name": "south"}, {"name": "east"}, {"name": "north"}, {"name": "west"}],
    "openings": [{"id": "window_1", "kind": "OPENING_KIND_WINDOW", "wall": "south", "offset_m": 1, "width_m": 7.2,
                  "sill_height_m": 1, "head_height_m": 2}]})");
  const Finished run = Flair({"design", "A bedroom.", "--out", folder_ / "out", "--room", folder_ / "room.json"});
  ExpectRefused(run, cli::kExitBadInput, "room.json:4: openings[0].width_m: 7.2 does not fit wall \"south\"");
}

}  // namespace
}  // namespace flair::testing
