// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/token.h"

#include <string>

#include "fmt/format.h"
#include "gtest/gtest.h"
#include "translator_worker/grammar/lexicon.h"
#include "translator_worker/grammar/pattern.h"
#include "translator_worker/grammar/quantity.h"

namespace flair::translator {
namespace {

// Words as they are, lengths as [least..largest].
std::string Shown(const std::string& text) {
  std::string result;
  for (const Token& token : JoinQuantities(Tokenize(text))) {
    if (!result.empty()) result += ' ';
    if (token.kind != Token::Kind::kDistance) {
      result += token.text;
      continue;
    }
    const Distance& d = token.distance;
    result += fmt::format("[{}..{}]", d.min_m ? fmt::format("{:.4g}", *d.min_m) : "",
                          d.max_m ? fmt::format("{:.4g}", *d.max_m) : "");
  }
  return result;
}

TEST(Tokens, KeepPossessivesAndSplitNegations) {
  EXPECT_EQ(Shown("The bed\xE2\x80\x99s head doesn't"), "the bed 's head does not");
  EXPECT_EQ(Shown("side-by-side"), "side by side");
}

TEST(Quantities, AreReadInAllTheirForms) {
  EXPECT_EQ(Shown("0.6m"), "[0.6..0.6]");
  EXPECT_EQ(Shown("60 cm"), "[0.6..0.6]");
  EXPECT_EQ(Shown("half a metre"), "[0.5..0.5]");
  EXPECT_EQ(Shown("one and a half metres"), "[1.5..1.5]");
  EXPECT_EQ(Shown("2 ft"), "[0.6096..0.6096]");
  EXPECT_EQ(Shown("at least 0.5 m"), "[0.5..]");
  EXPECT_EQ(Shown("no more than 30 cm"), "[..0.3]");
  EXPECT_EQ(Shown("0.3-1m"), "[0.3..1]");
  EXPECT_EQ(Shown("between 0.3 m and 0.5 m"), "[0.3..0.5]");
  EXPECT_EQ(Shown("a minimum distance of 0.5m"), "a distance of [0.5..]");
  EXPECT_EQ(Shown("1 m or more"), "[1..]");
}

TEST(Quantities, DropSizesWhichPlaceNothing) {
  EXPECT_EQ(Shown("rug 1.8m x 2.8m here"), "rug here");
  EXPECT_EQ(Shown("0.6m wide, 0.1m long"), ",");
  EXPECT_EQ(Shown("the 2.5m side"), "the length:2.500");
}

TEST(Lexicon, PhrasesWriteOutTheirOptions) {
  const auto phrases = ExpandPhrase("[flush] (against|on) x");
  ASSERT_EQ(phrases.size(), 4u);
  EXPECT_EQ(phrases[0], (std::vector<std::string>{"flush", "against", "x"}));
  EXPECT_EQ(phrases[3], (std::vector<std::string>{"on", "x"}));
}

TEST(Pattern, BindsWhatItNamesAndTakesTheLongest) {
  Term bed;
  bed.kind = Term::Kind::kMention;
  bed.mention.references = {Reference{}};
  Term near;
  near.kind = Term::Kind::kWord;
  near.lemma = "near";
  const std::vector<Term> terms = {bed, near, bed};
  const Match match = Pattern("A? near/beside B ,? D?").At(terms);
  EXPECT_EQ(match.length, 3u);
  EXPECT_EQ(match.a, &terms[0].mention);
  EXPECT_EQ(match.b, &terms[2].mention);
  EXPECT_EQ(Pattern("near B").At(terms).length, 0u);
}

}  // namespace
}  // namespace flair::translator
