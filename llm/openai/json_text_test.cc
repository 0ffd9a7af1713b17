// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/openai/json_text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

namespace flair::llm {
namespace {

std::string Written(const std::string& text) {
  std::string json = "{";
  AppendJsonString(text, json);
  return json.substr(1);
}

std::string WrittenByLibrary(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

TEST(AppendJsonString, QuotesAndEscapes) {
  EXPECT_EQ(Written(""), R"("")");
  EXPECT_EQ(Written("A \"4 x 5\" room\\\n\x01"), R"("A \"4 x 5\" room\\\n\u0001")");
  EXPECT_EQ(Written("größer 🛏"), "\"größer 🛏\"");
}

TEST(AppendJsonString, NeverDiffersFromTheLibrary) {
  // Whole characters, halves of them, and what stands beside them.
  const std::vector<std::string> parts = {
      "a",        " ",        "room", "\"",   "\\",   "\n",          std::string(1, '\0'),
      "\x1f",     "\x7f",     "ä",    "€",    "🛏",    "\xc3",        "\xa4",
      "\xe2\x82", "\xf0\x9f", "\xff", "\x80", "\xc0", "\xed\xa0\x80"};
  std::mt19937 random(7);
  for (int i = 0; i < 20000; ++i) {
    std::string text;
    for (unsigned n = random() % 8; n > 0; --n) text += parts[random() % parts.size()];
    ASSERT_EQ(Written(text), WrittenByLibrary(text)) << i;
  }
}

}  // namespace
}  // namespace flair::llm
