// SPDX-License-Identifier: GPL-3.0-or-later
// flair-dev bench translate as a user runs it, on labels of ours.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "cli/exit_code.h"
#include "cli/output/output_folder.h"
#include "tests/fixtures/programs.h"

namespace flair::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::string kLabels = FLAIR_SOURCE_DIR "/evaluation/bench/testdata/translate";

class BenchTranslate : public ::testing::Test {
 protected:
  Finished Bench(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"bench", "translate"});
    return RunProgram(ProgramWith(arguments), arguments, {{"FLAIR_HOME", folder_ / "home"}});
  }
  std::string Labels(const std::string& text) const {
    const std::string path = folder_ / "labels.jsonl";
    std::ofstream(path, std::ios::binary) << text << "\n";
    return path;
  }

  TestFolder folder_;
};

TEST_F(BenchTranslate, PrintsWhatIsCorrectByFunctionRoomAndList) {
  const Finished run = Bench({kLabels, "--misses"});
  EXPECT_EQ(run.exit_code, cli::kExitDone) << run.err;
  EXPECT_THAT(run.out, HasSubstr("cabin secondary_inter: The log basket sings to the bunk.\n"));
  EXPECT_THAT(run.out, HasSubstr("70.0 % of 10 labels correct"));
  EXPECT_THAT(run.out, ::testing::ContainsRegex("\ncabin +10 +7 +1 +1 +1 +70.0\n"));
  EXPECT_THAT(run.out, ::testing::ContainsRegex("\nio_near +1 +0 +0 +0 +1 +0.0\n"));
}

TEST_F(BenchTranslate, BadLinesAreNamedAndTheRestIsMeasured) {
  const std::string path = Labels(
      "{\"room\": \"cabin\", \"list\": \"primary_intra\", \"subject_index\": [1], \"sentence\": \"Against a wall.\", "
      "\"gold\": [[{\"function\": \"ind_next_to_wall\", \"objects\": [1]}]]}\n"
      "{\"room\": \"cabin\", \"list\": \"primary_intra\", \"sentence\": \"s\", \"gold\": [[{\"function\": "
      "\"ind_dance\", "
      "\"objects\": [0]}]]}");
  const Finished run = Bench({path, "--rooms", kLabels + "/rooms"});
  EXPECT_EQ(run.exit_code, cli::kExitBadInput);
  EXPECT_THAT(run.out, HasSubstr("100.0 % of 1 labels correct"));
  EXPECT_THAT(run.err, HasSubstr(path + ":2: gold: unknown function ind_dance"));
  EXPECT_THAT(run.err, HasSubstr("1 line of labels could not be measured"));
}

TEST_F(BenchTranslate, FilesWithoutLabelsAreRefused) {
  const Finished absent = Bench({folder_ / "none"});
  EXPECT_EQ(absent.exit_code, cli::kExitBadInput);
  EXPECT_THAT(absent.err, HasSubstr("none"));
  const Finished broken = Bench({Labels("{\"room\": ")});
  EXPECT_EQ(broken.exit_code, cli::kExitBadInput);
  EXPECT_THAT(broken.err, HasSubstr(":1: not a JSON object"));
  const Finished roomless =
      Bench({Labels("{\"room\": \"palace\", \"list\": \"tertiary\", \"sentence\": \"s\", \"gold\": []}")});
  EXPECT_EQ(roomless.exit_code, cli::kExitBadInput);
  EXPECT_THAT(roomless.err, HasSubstr("--rooms"));
}

TEST_F(BenchTranslate, AModelWithoutRecordedAnswersIsNotScored) {
  std::filesystem::create_directory(std::string(folder_ / "answers"));
  const Finished run = Bench({kLabels, "--replay", folder_ / "answers"});
  EXPECT_EQ(run.exit_code, cli::kExitBadInput);
  EXPECT_THAT(run.err, HasSubstr("no recorded answers"));
  EXPECT_THAT(run.out, Not(HasSubstr("labels correct")));
}

TEST_F(BenchTranslate, AModelIsNotNamedForATranslatorElsewhere) {
  const Finished run = Bench({kLabels, "--translator", "127.0.0.1:1", "--model", "any"});
  EXPECT_EQ(run.exit_code, cli::kExitBadInput);
  EXPECT_THAT(run.err, HasSubstr("--model: not with --translator 127.0.0.1:1"));
}

}  // namespace
}  // namespace flair::testing
