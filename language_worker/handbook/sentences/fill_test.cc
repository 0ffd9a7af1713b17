// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/sentences/fill.h"

#include <gtest/gtest.h>

namespace flair::language {
namespace {

TEST(Fill, ReplacesKnownNamesAndLeavesOthers) {
  EXPECT_EQ(Fill("The {object} is {what}.", {{"object", "desk"}}), "The desk is {what}.");
}

TEST(Polish, SaysNothingTwice) {
  EXPECT_EQ(Polish("a desk in pale oak pale oak with a drawer."), "A desk in pale oak with a drawer.");
  EXPECT_EQ(Polish("A nightstand in oak oiled oak."), "A nightstand in oiled oak.");
  EXPECT_EQ(Polish("A bed with a linen linen frame."), "A bed with a linen frame.");
}

TEST(Polish, FindsArticlesAndCapitals) {
  EXPECT_EQ(Polish("a airy desk.  it is a old one."), "An airy desk. It is an old one.");
  EXPECT_EQ(Polish("a honest clock and a unique lamp."), "An honest clock and a unique lamp.");
  EXPECT_EQ(Polish(""), "");
}

}  // namespace
}  // namespace flair::language
