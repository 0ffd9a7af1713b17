// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/words.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace flair::language {
namespace {

// Lists of words are asked for by name; a name that is misspelt would find nothing.
TEST(WordLists, EveryListThatIsAskedForIsThere) {
  const std::regex kAsks(
      R"re((?:Is|IsIn|IsFormIn|PhrasesOf|WordsOf|BehindPhrase|SaysAny|FirstOf|begins)\([^"{;]*"([a-z_]+)"[,)])re");
  int asked = 0;
  for (const char* folder : {"reading", "cleaning"}) {
    for (const auto& entry : std::filesystem::directory_iterator(
             std::filesystem::path(FLAIR_SOURCE_DIR "/language_worker/handbook") / folder)) {
      const std::string name = entry.path().filename().string();
      if (!name.ends_with(".cc") || name.ends_with("_test.cc")) continue;
      std::ifstream file(entry.path());
      std::stringstream text;
      text << file.rdbuf();
      const std::string all = text.str();
      for (std::sregex_iterator it(all.begin(), all.end(), kAsks), end; it != end; ++it) {
        EXPECT_FALSE(WordsOf((*it)[1].str()).empty()) << name << ": " << (*it)[0];
        ++asked;
      }
    }
  }
  EXPECT_GT(asked, 100);
}

TEST(TokensOf, JoinsLargeNumbersAndLeavesSmallOnes) {
  const std::vector<Token> tokens = TokensOf("twenty-four chairs and a hundred books on two shelves");
  ASSERT_EQ(tokens.size(), 8u);
  EXPECT_EQ(tokens[0].number, 24);
  EXPECT_EQ(tokens[3].number, 100);
  EXPECT_EQ(tokens[6].text, "two");
}

}  // namespace
}  // namespace flair::language
