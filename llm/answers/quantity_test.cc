// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/quantity.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace flair::llm {
namespace {

struct Case {
  std::string text;
  std::string unit;
  double value;
};

TEST(ReadQuantity, UnderstandsLengthsAsPeopleWriteThem) {
  const std::vector<Case> cases = {
      {"1.2", "m", 1.2},
      {"1.2 m", "m", 1.2},
      {"1,2 m", "m", 1.2},
      {"120 cm", "m", 1.2},
      {"120cm", "m", 1.2},
      {"1200 mm", "m", 1.2},
      {"48 in", "m", 1.2192},
      {"48\"", "m", 1.2192},
      {"48 inches", "m", 1.2192},
      {"4 ft", "m", 1.2192},
      {"4'", "m", 1.2192},
      {"5'6\"", "m", 1.6764},
      {"5 ft 6 in", "m", 1.6764},
      {"5′ 6″", "m", 1.6764},
      {"1 m 20 cm", "m", 1.2},
      {"about 1.2 metres", "m", 1.2},
      {"~0.9m wide", "m", 0.9},
      {"  2 Meters.", "m", 2},
      {"-1 m", "m", -1},
      {".5 m", "m", 0.5},
      {"90°", "deg", 90},
      {"3.141592653589793 rad", "deg", 180},
      {"4", "", 4},
      {"four", "", 4},
      {"2e0 m", "m", 2},
      {"1/2 m", "m", 0.5},
      {"1 1/2 ft", "m", 0.4572},
      {"5' 6 1/2\"", "m", 1.6891},
      {"1½ m", "m", 1.5},
      {"¾", "m", 0.75},
      {"1 1⁄2", "", 1.5},
      {"two metres", "m", 2},
      {"1.6\u00a0m", "m", 1.6},
      {"\u200e160\u202fcm\u200e", "m", 1.6},
  };
  for (const Case& c : cases) {
    const std::optional<double> value = ReadQuantity(c.text, c.unit);
    ASSERT_TRUE(value.has_value()) << c.text;
    EXPECT_NEAR(*value, c.value, 1e-9) << c.text;
  }
}

TEST(ReadQuantity, GuessesNothing) {
  for (const std::string text :
       {"",      " ",     "m",          "wide",       "1,200",     "1-2 m", "1.2 m x 0.6 m", "1.2 kg", "1/0 m",
        "nan",   "inf",   "infinity m", "1.2 m 3",    "6 in 5 ft", "1.2.3", "0x10",          "1 m2",   "1,2,3",
        "100/3", "1 3/2", "1.5 1/2",    "two-seater", "1/2/3",     "٣ m",   "1.2 miles"}) {
    EXPECT_FALSE(ReadQuantity(text, "m").has_value()) << text;
  }
  EXPECT_FALSE(ReadQuantity("4 m", "").has_value());
  EXPECT_FALSE(ReadQuantity(std::string(1000, '1'), "m").has_value());
}

TEST(ReadRange, ReadsTwoNumbersOfOneUnit) {
  const std::vector<std::string> ranges = {"1.4-1.6 m", "1.4 to 1.6 m", "140–160 cm", "1.4 m - 1.6 m", "1.4 or 1.6"};
  for (const std::string& text : ranges) {
    const std::optional<QuantityRange> range = ReadRange(text, "m");
    ASSERT_TRUE(range.has_value()) << text;
    EXPECT_NEAR(range->least, 1.4, 1e-9) << text;
    EXPECT_NEAR(range->most, 1.6, 1e-9) << text;
  }
  EXPECT_EQ(ReadRange("two to three", "")->most, 3);
  for (const std::string text : {"", "2", "-2", "3-2", "2-", "-2-3", "1-2-3", "a-b", "2-3 kg", "2 x 3"}) {
    EXPECT_FALSE(ReadRange(text, "m").has_value()) << text;
  }
}

TEST(ReadCount, ReadsNumbersOfThings) {
  for (const std::string text : {"2", "two", "2x", "x2", "2 ×", "× 2", "2 pieces", "2 pcs.", "2.0", "about 2"}) {
    EXPECT_EQ(ReadCount(text), std::optional(2.0)) << text;
  }
  for (const std::string text : {"", "x", "pieces", "2x3", "2 m", "many", "2-3", "xx2", "2 dogs"}) {
    EXPECT_FALSE(ReadCount(text).has_value()) << text;
  }
}

}  // namespace
}  // namespace flair::llm
