// SPDX-License-Identifier: GPL-3.0-or-later
// Contact sheets of folders as people have them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "tests/fixtures/designed_bedroom.h"

namespace flair::testing {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

namespace fs = std::filesystem;

class ContactSheetCommand : public DesignedBedroom {
 protected:
  ContactSheetCommand() {
    for (const char* name : {"a", "b/c", "b/d"}) {
      fs::create_directories(folder_ / "batch" / name);
      for (const char* file : {"layout.pb", "plan.png"}) fs::copy(Design() / file, folder_ / "batch" / name / file);
    }
  }
  Finished Sheet(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"contact-sheet", folder_ / "batch", "--out", folder_ / "sheet.png"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunProgram("flair", arguments, {{"FLAIR_HOME", folder_ / "home"}});
  }
};

TEST_F(ContactSheetCommand, ShowsTheDesignsOfAFolderAtAnyDepth) {
  const Finished run = Sheet({"--title", "Bedrooms"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("3 tiles"));
  EXPECT_THAT(ReadAll(folder_ / "sheet.png"), StartsWith("\x89PNG"));
  const std::string first = ReadAll(folder_ / "sheet.png");
  ASSERT_EQ(Sheet({"--title", "Bedrooms"}).exit_code, 0);
  EXPECT_TRUE(first == ReadAll(folder_ / "sheet.png"));
}

TEST_F(ContactSheetCommand, ShowsPicturesThatLieThere) {
  const Finished run = Sheet({"--picture", "plan.png", "--tile", "200"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("3 tiles"));
}

TEST_F(ContactSheetCommand, ShowsViews) {
  const Finished run = Sheet({"--view", "birdseye", "--tile", "128"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
}

TEST_F(ContactSheetCommand, ADesignOfVariantsEndsInOnePictureOfThemAll) {
  const std::string out = folder_ / "variants";
  const Finished design = RunProgram("flair", {"design", "A bedroom.", "--variants", "3", "--out", out},
                                     {{"FLAIR_HOME", folder_ / "home"}});
  ASSERT_EQ(design.exit_code, 0) << design.err;
  EXPECT_THAT(design.err, HasSubstr("variants.png"));
  EXPECT_THAT(ReadAll(out + "/variants.png"), StartsWith("\x89PNG"));
  EXPECT_TRUE(fs::exists(out + "/layout-2.pb"));
  const Finished sheet = RunProgram("flair", {"contact-sheet", out, "--variants", "--out", folder_ / "sheet.png"},
                                    {{"FLAIR_HOME", folder_ / "home"}});
  ASSERT_EQ(sheet.exit_code, 0) << sheet.err;
  EXPECT_THAT(sheet.err, AnyOf(HasSubstr("2 tiles"), HasSubstr("3 tiles")));
}

TEST_F(ContactSheetCommand, HostilePicturesShowWhyInTheirPlaces) {
  std::string bomb = ReadAll(folder_ / "batch" / "a" / "plan.png");
  bomb.replace(16, 8, std::string("\x00\x00\xC3\x50\x00\x00\xC3\x50", 8));
  WriteAll(folder_ / "batch" / "a" / "plan.png", bomb);
  const std::string whole = ReadAll(folder_ / "batch" / "b" / "c" / "plan.png");
  WriteAll(folder_ / "batch" / "b" / "c" / "plan.png", whole.substr(0, whole.size() / 2));
  const Finished run = Sheet({"--picture", "plan.png"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("is said to be 50000 x 50000 px; at most 8192 px a side"));
  EXPECT_THAT(run.err, HasSubstr("\"b/c"));
  EXPECT_THAT(ReadAll(folder_ / "sheet.png"), StartsWith("\x89PNG"));
}

TEST_F(ContactSheetCommand, ALayoutThatIsNoneShowsWhyInItsPlace) {
  WriteAll(folder_ / "batch" / "a" / "layout.pb", "garbage");
  const Finished run = Sheet();
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("tile 1, \"a\""));
  EXPECT_THAT(run.err, HasSubstr("not a Flair artifact"));
}

TEST_F(ContactSheetCommand, ARendererOfItsOwnProcessGivesTheSameBytes) {
  AllPrograms programs(folder_.path());
  ASSERT_EQ(Sheet({"--renderer", programs.renderer()}).exit_code, 0);
  const std::string there = ReadAll(folder_ / "sheet.png");
  ASSERT_EQ(Sheet().exit_code, 0);
  EXPECT_TRUE(there == ReadAll(folder_ / "sheet.png"));
}

TEST_F(ContactSheetCommand, AThousandJobsStayWithinTheirMemory) {
  for (int i = 0; i < 1000; ++i) {
    const fs::path folder = folder_ / "batch" / ("job" + std::to_string(i));
    fs::create_directories(folder);
    fs::create_hard_link(folder_ / "batch" / "a" / "layout.pb", folder / "layout.pb");
  }
  Process process(ProgramPath("flair"),
                  {"contact-sheet", folder_ / "batch", "--tile", "64", "--out", folder_ / "s.png"},
                  {{"FLAIR_HOME", folder_ / "home"}});
  const Finished run = process.Wait();
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("1003 tiles"));
  rusage usage = {};
  getrusage(RUSAGE_CHILDREN, &usage);  // of the largest child so far
  EXPECT_LT(usage.ru_maxrss, 500 * 1024) << "KiB";
}

}  // namespace
}  // namespace flair::testing
