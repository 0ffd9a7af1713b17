// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/batch/batch_input.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/fixtures/programs.h"

namespace flair::cli {
namespace {

using ::testing::ElementsAre;

class LineReaderTest : public ::testing::Test {
 protected:
  // "NUMBER:TEXT" of every line.
  std::vector<std::string> Lines(const std::string& bytes, int64_t offset = 0, int64_t number = 1) {
    testing::WriteAll(folder_ / "lines", bytes);
    const auto reader = LineReader::Open(folder_ / "lines", offset, number);
    EXPECT_TRUE(reader.ok());
    std::vector<std::string> lines;
    Line line;
    while (*(*reader)->Next(line)) {
      lines.push_back(fmt::format("{}:{}{}", line.number, line.text, line.too_long ? "..." : ""));
      end_ = line.end_offset;
    }
    return lines;
  }

  testing::TestFolder folder_;
  int64_t end_ = 0;
};

TEST_F(LineReaderTest, TakesEveryKindOfLineBreakAndALastLineWithoutOne) {
  EXPECT_THAT(Lines("\xEF\xBB\xBF"
                    "a\r\n\nb\nc"),
              ElementsAre("1:a", "2:", "3:b", "4:c"));
  EXPECT_EQ(end_, 10);
  EXPECT_THAT(Lines("a\n"), ElementsAre("1:a"));
  EXPECT_THAT(Lines(""), ElementsAre());
}

TEST_F(LineReaderTest, GoesOnBehindALine) {
  EXPECT_THAT(Lines("ab\ncd\nef\n", 3, 2), ElementsAre("2:cd", "3:ef"));
  EXPECT_EQ(end_, 9);
}

TEST_F(LineReaderTest, SkipsWhatIsTooLongAndGoesOn) {
  const std::string longest(LineReader::kLongestLine, 'x');
  const std::vector<std::string> lines = Lines(longest + "\n" + longest + "y\nshort\n");
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0], "1:" + longest);
  EXPECT_EQ(lines[1], "2:" + longest.substr(0, 1000) + "...");
  EXPECT_EQ(lines[2], "3:short");
  EXPECT_EQ(end_, static_cast<int64_t>(2 * longest.size() + 9));
  EXPECT_THAT(Lines(longest + "y").back(), ::testing::EndsWith("..."));
}

TEST_F(LineReaderTest, SaysThatThereIsNoFile) {
  EXPECT_EQ(LineReader::Open("/no/such/file").status().message(), "/no/such/file: no such file");
}

}  // namespace
}  // namespace flair::cli
