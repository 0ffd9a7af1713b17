// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "llm/answers/read_answer.h"

namespace flair::llm {
namespace {

struct Case {
  std::string text;
  std::string unit;
  double value;
};

TEST(ReadQuantity, TakesANumberAloneOrWithItsUnit) {
  const std::vector<Case> cases = {{"1.2", "m", 1.2},    {"1.2 m", "m", 1.2},     {"120 cm", "m", 1.2},
                                   {"1200mm", "m", 1.2}, {"  2 metres ", "m", 2}, {"-1 m", "m", -1},
                                   {".5 m", "m", 0.5},   {"90°", "deg", 90},      {"45 degrees", "deg", 45},
                                   {"4", "", 4},         {"2e0 m", "m", 2}};
  for (const Case& c : cases) {
    const std::optional<double> value = ReadQuantity(c.text, c.unit);
    ASSERT_TRUE(value.has_value()) << c.text;
    EXPECT_NEAR(*value, c.value, 1e-9) << c.text;
  }
}

TEST(ReadQuantity, GuessesNothing) {
  for (const std::string text : {"",      " ",   "m",   "wide",  "1,200",      "1-2 m",   "1.2 m x 0.6 m", "1.2 kg",
                                 "1/2 m", "5'6", "nan", "inf",   "infinity m", "1.2 m 3", "1.2.3",         "0x10",
                                 "1 m2",  "two", "90°", "1e999", "1 ft",       "1½ m"}) {
    EXPECT_FALSE(ReadQuantity(text, "m").has_value()) << text;
  }
  EXPECT_FALSE(ReadQuantity("4 m", "").has_value());
  EXPECT_FALSE(ReadQuantity(std::string(1000, '1'), "m").has_value());
}

}  // namespace
}  // namespace flair::llm
