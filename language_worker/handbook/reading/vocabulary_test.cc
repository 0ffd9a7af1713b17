// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/vocabulary.h"

#include <gtest/gtest.h>

#include <string>

#include "language_worker/handbook/reading/vocabulary.h"
#include "language_worker/handbook/testing/test_handbook.h"

namespace flair::language {
namespace {

const Speller& TheSpeller() { return *TheHandbook().vocabulary().speller; }

TEST(IsOneEditAway, LettersLeftOutPutInChangedOrSwapped) {
  for (const char* word : {"kichen", "kiitchen", "kitchan", "ktichen", "itchen", "kitche", "kitchens"}) {
    EXPECT_TRUE(IsOneEditAway("kitchen", word)) << word;
    EXPECT_TRUE(IsOneEditAway(word, "kitchen")) << word;
  }
  for (const char* word : {"kitchen", "kichn", "ktihcen", "kitchenss", "chitken", "", "k"}) {
    EXPECT_FALSE(IsOneEditAway("kitchen", word)) << word;
  }
  EXPECT_TRUE(IsOneEditAway("", "a"));
  EXPECT_FALSE(IsOneEditAway("", ""));
}

TEST(Speller, ReadsMisspeltPiecesRoomsAndColours) {
  const struct {
    const char* written;
    const char* meant;
  } kCases[] = {{"kichen", "kitchen"},
                {"iland", "island"},
                {"wardorbe", "wardrobe"},
                {"armchiars", "armchairs"},
                {"bedrom", "bedroom"},

                {"tabel", "table"},
                {"bookcse", "bookcase"},
                {"matress", "mattress"},
                {"fireplce", "fireplace"},
                {"dreser", "dresser"},
                {"turqoise", "turquoise"},
                {"refridgerator", "refrigerator"},
                {"bathrom", "bathroom"},
                {"nighstand", "nightstand"}};
  for (const auto& expected : kCases) EXPECT_EQ(TheSpeller().MeantBy(expected.written), expected.meant);
}

TEST(Speller, LeavesEnglishAlone) {
  for (const char* word :
       {"later",   "stable",  "bright",  "cheerful", "quite",   "closer",  "larger", "touch",   "watch",
        "leather", "mother",  "others",  "painted",  "tables",  "shelves", "cosier", "charm",   "reached",
        "steel",   "stored",  "sitting", "chairs",   "change",  "clothes", "ground", "growing", "waiter",
        "party",   "planner", "house",   "mouse",    "candles", "lounge"}) {
    EXPECT_EQ(TheSpeller().MeantBy(word), "") << word;
  }
}

TEST(Speller, LeavesAloneWhatIsShortFarOrNearToSeveral) {
  EXPECT_EQ(TheSpeller().MeantBy("dsek"), "");     // four letters
  EXPECT_EQ(TheSpeller().MeantBy("kchn"), "");     // three edits
  EXPECT_EQ(TheSpeller().MeantBy("wardrbo"), "");  // two edits
  EXPECT_EQ(TheSpeller().MeantBy("xyzzyxyzzy"), "");
  EXPECT_EQ(TheSpeller().MeantBy(std::string(100000, 'a')), "");
}

TEST(Speller, ReplacesEveryOneAndTellsEachOnce) {
  std::vector<Token> tokens = TokensOf("a kichen, another kichen and a tabel");
  const std::vector<Correction> corrections = TheSpeller().Correct(tokens);
  ASSERT_EQ(corrections.size(), 2u);
  EXPECT_EQ(corrections[0].written, "kichen");
  EXPECT_EQ(corrections[0].read, "kitchen");
  EXPECT_EQ(corrections[1].read, "table");
  EXPECT_EQ(tokens[4].text, "kitchen");
  EXPECT_EQ(tokens.back().text, "table");
}

}  // namespace
}  // namespace flair::language
