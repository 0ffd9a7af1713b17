// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "cli/input/message_text.h"

namespace flair::cli {
namespace {

constexpr char kJson[] = R"({
  "room_type": "bed \"room\" {[",
  "floor": {"vertices": [
    {"x_m": 0},
    {"x_m": 4,
     "y_m": 1}
  ]},
  "heightM": 3,
  "numbers": [1, -2.5e3, null, true, [], {}]
})";

int Line(const std::string& path, const std::string& json = kJson) {
  return LineAt(json, FindJsonField(json, ParseFieldPath(path).value()));
}

TEST(JsonPlace, FindsFieldsAndItemsWhereverTheyStand) {
  EXPECT_EQ(Line("room_type"), 2);
  EXPECT_EQ(Line("floor.vertices"), 3);
  EXPECT_EQ(Line("floor.vertices[0].x_m"), 4);
  EXPECT_EQ(Line("floor.vertices[1]"), 5);
  EXPECT_EQ(Line("floor.vertices[1].y_m"), 6);
  EXPECT_EQ(Line("numbers[5]"), 9);
}

TEST(JsonPlace, TakesNamesInCamelCaseForTheSame) { EXPECT_EQ(Line("height_m"), 8); }

TEST(JsonPlace, StaysAtTheInnermostPartThatIsThere) {
  EXPECT_EQ(Line("floor.vertices[0].y_m"), 4);
  EXPECT_EQ(Line("floor.vertices[2].x_m"), 3);
  EXPECT_EQ(Line("nothing.at.all"), 1);
  EXPECT_EQ(Line("room_type.part"), 2);
}

TEST(JsonPlace, WhatIsNoJsonEndsTheSearch) {
  const std::string json = kJson;
  for (size_t size = 0; size < json.size(); ++size) {
    EXPECT_LE(Line("numbers[5].x", json.substr(0, size)), 9);
  }
  for (const char* text : {"", "}", "]]]", "{\"a", "{\"a\":", "[[[[", "\xff\xfe", "{{{"}) {
    EXPECT_EQ(Line("a.b[3]", text), 1) << text;
  }
}

}  // namespace
}  // namespace flair::cli
