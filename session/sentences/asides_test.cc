// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/sentences/asides.h"

#include <gtest/gtest.h>

namespace flair::session {
namespace {

TEST(AsidesTest, WhatFurnitureHasNothingToDoWithIsKnown) {
  EXPECT_EQ(OtherBusiness("Paint the walls dark blue"), "colours and surfaces");
  EXPECT_EQ(OtherBusiness("make the walls light blue"), "colours and surfaces");
  EXPECT_EQ(OtherBusiness("make the door lockable"), "doors, windows, walls and their locks");
  EXPECT_EQ(OtherBusiness("move the door to the left"), "doors, windows, walls and their locks");
  EXPECT_EQ(OtherBusiness("turn the heating down"), "heating, air and noise");
  EXPECT_EQ(OtherBusiness("it must not cost more than 500 euros"), "prices and orders");
  for (const char* const text : {"The door mat is near the door", "remove the window seat", "add a painting",
                                 "move the wall clock to the north wall", "The desk is under the window"}) {
    EXPECT_EQ(OtherBusiness(text), "") << text;
  }
}

bool IsNoStatement(std::string_view text) {
  const Tokens tokens = PlainTokens(text);
  return session::IsNoStatement(tokens, {0, tokens.size()});
}

TEST(AsidesTest, AnEditIsNoStatement) {
  EXPECT_TRUE(IsNoStatement("please remove the painting above the bed"));
  EXPECT_TRUE(IsNoStatement("could you get rid of that thing above the bed"));
  EXPECT_TRUE(IsNoStatement("the thing at the left end of the table should go"));
  EXPECT_FALSE(IsNoStatement("the desk is under the window"));
  EXPECT_FALSE(IsNoStatement("put the desk under the window"));
}

TEST(AsidesTest, WhatForIsNoPlace) {
  EXPECT_TRUE(IsPurpose("to read in"));
  EXPECT_TRUE(IsPurpose("for my books"));
  EXPECT_FALSE(IsPurpose("to the left of the bed"));
  EXPECT_FALSE(IsPurpose("under the window"));
}

}  // namespace
}  // namespace flair::session
