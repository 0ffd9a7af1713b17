// SPDX-License-Identifier: GPL-3.0-or-later
#include "english/text.h"

#include <string>

#include "gtest/gtest.h"

namespace flair::english {
namespace {

std::string Shown(const std::vector<Token>& tokens) {
  std::string result;
  for (const Token& token : tokens) result += (result.empty() ? "" : " ") + token.text;
  return result;
}

TEST(Tokenize, KeepsPossessivesAndSplitsContractions) {
  EXPECT_EQ(Shown(Tokenize("The bed\u2019s head doesn't")), "the bed 's head does not");
  EXPECT_EQ(Shown(Tokenize("It's near the chairs' backs; can't, won't, cannot, we'd")),
            "it is near the chairs 's backs ; can not , will not , can not , we would");
}

TEST(Tokenize, ReadsNumbersAsPeopleWriteThem) {
  EXPECT_EQ(Tokenize("1,5")[0].number, 1.5);
  EXPECT_EQ(Tokenize("1,200 mm")[0].number, 1200);
  EXPECT_EQ(Tokenize("0,125")[0].number, 0.125);
  EXPECT_EQ(Tokenize("\u00BD")[0].number, 0.5);
  EXPECT_EQ(Tokenize("1\u00BD")[0].number, 1.5);
  EXPECT_EQ(Tokenize("3/4")[0].number, 0.75);
  EXPECT_EQ(Shown(Tokenize("4x5 and 4mx5m")), "4 x 5 and 4 m x 5 m");
}

TEST(Tokenize, NamesTheBytesOfEachTokenAndWhatIsGluedToWhat) {
  const std::string text = "Caf\u00E9: 12'6\"";
  const std::vector<Token> tokens = Tokenize(text);
  ASSERT_EQ(Shown(tokens), "cafe : 12 ' 6 \"");
  EXPECT_EQ(text.substr(tokens[0].begin, tokens[0].end - tokens[0].begin), "Caf\u00E9");
  EXPECT_TRUE(tokens[1].glued);
  EXPECT_FALSE(tokens[2].glued);
  EXPECT_TRUE(tokens[3].glued);
}

TEST(Tokenize, KeepsForeignLettersAndDropsSymbols) {
  EXPECT_EQ(Shown(Tokenize("Ein B\u00DCRO f\u00FCr zwei \u2192 \U0001F600 K\u00FCche")),
            "ein b\u00FCro f\u00FCr zwei k\u00FCche");
  EXPECT_EQ(Shown(Tokenize("bed\xff\xfe desk\xC3")), "bed desk");
}

TEST(KeepClauseMarks, LeavesWhatDividesSentences) {
  EXPECT_EQ(Shown(KeepClauseMarks(Tokenize("side-by-side \u2014 \"good\"! A & B; approx. 2 m"))),
            "side by side , good . a and b . approx 2 m");
  EXPECT_EQ(Shown(KeepClauseMarks(Tokenize("0.3-1m, 12'6\""))), "0.3 - 1 m , 12 ft 6 inch");
  EXPECT_EQ(Shown(KeepClauseMarks(Tokenize("bookshelf 13's back, 13'x12'"))), "bookshelf 13 's back , 13 ft x 12 ft");
}

}  // namespace
}  // namespace flair::english
