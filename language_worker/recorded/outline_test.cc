// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/recorded/outline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flair::language {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(Outline, ItemsStandUnderTheHeadingAndTheItemAboveThem) {
  const auto lines = ReadOutline("### Desk\n- **Placement:**\n  - Against a wall.\n- Not by the door.\n");
  ASSERT_THAT(lines, SizeIs(4));
  EXPECT_EQ(lines[1].parent, 0);
  EXPECT_EQ(lines[2].parent, 1);
  EXPECT_EQ(lines[3].parent, 0);
  EXPECT_TRUE(lines[1].has_children);
  EXPECT_FALSE(lines[3].has_children);
}

TEST(Outline, ANumberedItemIsAboveTheDashesAtItsIndent) {
  const auto lines = ReadOutline("1. Shower caddy\n- Against a wall.\n2. Mat\n");
  ASSERT_THAT(lines, SizeIs(3));
  EXPECT_EQ(lines[1].parent, 0);
  EXPECT_EQ(lines[2].parent, -1);
  EXPECT_EQ(lines[2].number, 3);
}

struct Form {
  std::string line;
  std::string label;
  std::string text;
  bool title;
};

class OutlineForms : public ::testing::TestWithParam<Form> {};

TEST_P(OutlineForms, AreReadWithoutTheirMarks) {
  const auto lines = ReadOutline(GetParam().line);
  ASSERT_THAT(lines, SizeIs(1));
  EXPECT_EQ(lines[0].label, GetParam().label);
  EXPECT_EQ(lines[0].text, GetParam().text);
  EXPECT_EQ(lines[0].title, GetParam().title);
}

INSTANTIATE_TEST_SUITE_P(
    All, OutlineForms,
    ::testing::Values(Form{"### 2. Living Area:", "", "Living Area", true},
                      Form{"- **Against a wall**: in a corner.", "Against a wall", "in a corner.", false},
                      Form{"- **Colour:** White", "Colour", "White", false},
                      Form{"1. **Bed and Desk:**", "Bed and Desk", "", true},
                      Form{"1. The **sofa** faces the **tv**.", "", "The sofa faces the tv.", false},
                      Form{"  *Placed on the bed.*", "", "Placed on the bed.", false},
                      Form{"• Near a window", "", "Near a window", false},
                      Form{"   - *Dimensions*: 1m x 0.1m", "Dimensions", "1m x 0.1m", false},
                      Form{"Storage:", "", "Storage", true},
                      Form{"3.5 m is wide enough", "", "3.5 m is wide enough", false}));

TEST(Outline, RulesAndFencesSayNothing) { EXPECT_THAT(ReadOutline("---\n\n```\n   \n***\n"), IsEmpty()); }

TEST(Outline, BytesThatAreNoTextBecomeSigns) {
  const auto lines = ReadOutline(std::string("- a\xff\xfe wall\n\0- b", 16));
  ASSERT_FALSE(lines.empty());
  EXPECT_EQ(lines[0].text, "a\xef\xbf\xbd\xef\xbf\xbd wall");
}

TEST(Outline, EndlessTextsAreCut) {
  std::string text;
  for (int i = 0; i < 5000; ++i) text += "- line\n";
  EXPECT_THAT(ReadOutline(text), SizeIs(2000));
  EXPECT_LE(ReadOutline("- " + std::string(100000, 'x'))[0].text.size(), 2010u);
}

}  // namespace
}  // namespace flair::language
