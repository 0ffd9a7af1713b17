// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/unknown_things.h"

#include "gmock/gmock.h"
#include "gtest/gtest.h"

namespace flair::language {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// Of a text of which only the words in `known` were understood.
std::vector<std::string> UnknownOf(std::string_view text, const std::vector<std::string>& known) {
  const std::vector<Token> tokens = Tokenize(text);
  std::vector<bool> used;
  for (const Token& token : tokens) used.push_back(std::find(known.begin(), known.end(), token.text) != known.end());
  return UnknownThings(tokens, used);
}

TEST(UnknownThings, AreWhatIsListedAndNotUnderstood) {
  EXPECT_THAT(UnknownOf("A bakery of 50 m2 with a counter, two ovens, a proofing cabinet and four small tables.",
                        {"counter", "ovens", "tables"}),
              ElementsAre("bakery", "proofing cabinet"));
  EXPECT_THAT(UnknownOf("A hall with 3 left-handed violins", {"hall"}), ElementsAre("left-handed violins"));
  EXPECT_THAT(UnknownOf("A room for a cat and for another cat, with a cat", {"room"}), ElementsAre("cat"));
}

TEST(UnknownThings, AreAlsoThoseListedWithoutAnArticle) {
  EXPECT_THAT(UnknownOf("A foyer with sofa, vending machine, popcorn stand and plants", {"foyer", "sofa", "plants"}),
              ElementsAre("vending machine", "popcorn stand"));
  EXPECT_THAT(UnknownOf("A bedroom, calm and mossy, with light", {"bedroom"}), IsEmpty());
  EXPECT_THAT(UnknownOf("A bedroom with bed, put the board away", {"bedroom", "bed"}), IsEmpty());
}

TEST(UnknownThings, AreNoSizesMoodsOrPeople) {
  EXPECT_THAT(UnknownOf("A bedroom that is 4 m x 5 m, 3 metres high", {"bedroom"}), IsEmpty());
  EXPECT_THAT(UnknownOf("A bedroom, calm and a bit mossy, with a touch of gold", {"bedroom"}), IsEmpty());
  EXPECT_THAT(UnknownOf("An office for six people and 20 children", {"office"}), IsEmpty());
  EXPECT_THAT(UnknownOf("", {}), IsEmpty());
}

TEST(UnknownThings, AreToldOnceAndEightAtMost) {
  std::string text = "with";
  for (char c = 'a'; c < 'z'; ++c) text += std::string(" a q") + c + c + ",";
  EXPECT_EQ(UnknownOf(text, {}).size(), 8u);
}

TEST(ReadsAsEnglish, KnowsOtherLanguages) {
  EXPECT_TRUE(ReadsAsEnglish(Tokenize("A bedroom that is 4m x 5m.")));
  EXPECT_TRUE(ReadsAsEnglish(Tokenize("Bedroom 4m x 5m")));
  EXPECT_FALSE(ReadsAsEnglish(Tokenize("Ein Schlafzimmer mit einem Doppelbett und zwei Nachttischen.")));
  EXPECT_FALSE(ReadsAsEnglish(Tokenize("Una sala de estar de 5 por 4 metros con un sofá y un piano.")));
  EXPECT_FALSE(ReadsAsEnglish(Tokenize("Une chambre de 4 m sur 5 avec un grand lit et deux tables de nuit.")));
}

}  // namespace
}  // namespace flair::language
