// SPDX-License-Identifier: GPL-3.0-or-later
#include "english/words.h"

#include "gtest/gtest.h"

namespace flair::english {
namespace {

struct NounForms {
  const char* singular;
  const char* plural;
};

TEST(Words, KnowSingularAndPlural) {
  for (const NounForms& one : std::initializer_list<NounForms>{{"stove", "stoves"},
                                                               {"shelf", "shelves"},
                                                               {"bookshelf", "bookshelves"},
                                                               {"box", "boxes"},
                                                               {"bench", "benches"},
                                                               {"glass", "glasses"},
                                                               {"case", "cases"},
                                                               {"vase", "vases"},
                                                               {"pantry", "pantries"},
                                                               {"tray", "trays"},
                                                               {"child", "children"},
                                                               {"grandchild", "grandchildren"},
                                                               {"sleeve", "sleeves"},
                                                               {"shoe", "shoes"},
                                                               {"canvas", "canvases"},
                                                               {"bus", "buses"},
                                                               {"chaise", "chaises"}}) {
    EXPECT_EQ(Singular(one.plural), one.singular);
    EXPECT_EQ(Plural(one.singular), one.plural);
    EXPECT_EQ(Singular(one.singular), one.singular);
    EXPECT_TRUE(IsPlural(one.plural)) << one.plural;
    EXPECT_FALSE(IsPlural(one.singular)) << one.singular;
  }
}

TEST(Words, CompareFormsAndSpellings) {
  EXPECT_TRUE(IsFormOf("shelves", "shelf"));
  EXPECT_TRUE(IsFormOf("gray", "grey"));
  EXPECT_TRUE(IsFormOf("painted", "paint*"));
  EXPECT_FALSE(IsFormOf("table", "tablet"));
  EXPECT_EQ(Stem("overlapping"), Stem("overlaps"));
  EXPECT_EQ(Stem("bed"), "");
  EXPECT_TRUE(BeginAlike("prep", "preparation"));
  EXPECT_FALSE(BeginAlike("bed", "bedroom"));
}

}  // namespace
}  // namespace flair::english
