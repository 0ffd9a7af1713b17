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

TEST(TokensOf, LettersOfTheCompassAndBareMillimetresAreSpeltOut) {
  const auto spelt = [](const char* text) {
    std::string all;
    for (const Token& token : TokensOf(text)) all += (all.empty() || token.glued ? "" : " ") + token.text;
    return all;
  };
  EXPECT_EQ(spelt("Door on W wall, at the SW corner"), "door on west wall, at the south-west corner");
  EXPECT_EQ(spelt("headboard to N."), "headboard to north wall.");
  EXPECT_EQ(spelt("S hooks and e scooters"), "s hooks and e scooters");
  EXPECT_EQ(spelt("Room 4200 x 3800, window 1800, 2 chairs"), "room 4200 mm x 3800 mm, window 1800 mm, 2 chairs");
  EXPECT_EQ(spelt("Room 4 x 3, since 1800"), "room 4 x 3, since 1800");
  EXPECT_EQ(spelt("meeting rm, 6 ppl"), "meeting room, 6 people");
}

}  // namespace
}  // namespace flair::language
