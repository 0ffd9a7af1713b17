// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <string>

#include "language_worker/handbook/loading/load_handbook.h"
#include "language_worker/model/prompt_text.h"

namespace flair::language {
namespace {

const Handbook& Book() {
  static const auto handbook = LoadHandbook(DefaultHandbookFolder());
  return **handbook;
}

std::string Read(std::string_view text) {
  const std::optional<v1::Colour> colour = ReadColour(text, Book());
  if (!colour) return "none";
  return colour->name() + " " + std::to_string(colour->red()) + " " + std::to_string(colour->green()) + " " +
         std::to_string(colour->blue());
}

TEST(ColourText, NameAndValueAreReadHoweverTheyStand) {
  for (const char* text : {"sage #7A8B6F", "sage (#7a8b6f)", "sage: #7A8B6F", "#7A8B6F sage"}) {
    EXPECT_EQ(Read(text), "sage 122 139 111") << text;
  }
  EXPECT_EQ(Read("#102030"), " 16 32 48");
}

TEST(ColourText, ValuesAreReadInTheFormsOfTheWeb) {
  EXPECT_EQ(Read("blush #fee"), "blush 255 238 238");
  EXPECT_EQ(Read("oak B98B55"), "oak 185 139 85");
  EXPECT_EQ(Read("burnt orange rgb(238, 85, 0)"), "burnt orange 238 85 0");
}

TEST(ColourText, WordsOfHexDigitsAreNoValues) {
  EXPECT_EQ(Read("a faded beige #C8B89A"), "a faded beige 200 184 154");
  EXPECT_EQ(Read("facade"), "none");
  EXPECT_EQ(Read("facade #FACADE"), "facade 250 202 222");
}

TEST(ColourText, ANameAloneIsTheHandbooksAndOthersAreNone) {
  EXPECT_EQ(Read("sage green #GGGGGG").substr(0, 10), "sage green");
  EXPECT_EQ(Read("a deep mysterious sage green").substr(0, 28), "a deep mysterious sage green");
  for (const char* text : {"mystery", "mystery #12", "", "{", "{}", "#", "rgb(300, 1, 2)", "rgb", "42", "null"}) {
    EXPECT_EQ(Read(text), "none") << text;
  }
}

}  // namespace
}  // namespace flair::language
