// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/openai/reply_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace flair::llm {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(EventsOf, ReadsTheDataOfEvents) { EXPECT_THAT(EventsOf("data: a\n\ndata: b c\n\n"), ElementsAre("a", "b c")); }

TEST(EventsOf, TakesEveryKindOfLineEnd) {
  EXPECT_THAT(EventsOf("data: a\r\n\r\ndata: b\r\rdata: c\n\n"), ElementsAre("a", "b", "c"));
}

TEST(EventsOf, TakesAwayOneSpaceOnly) { EXPECT_THAT(EventsOf("data:a\n\ndata:  b\n\n"), ElementsAre("a", " b")); }

TEST(EventsOf, JoinsTheLinesOfOneEvent) { EXPECT_THAT(EventsOf("data: a\ndata\ndata: b\n\n"), ElementsAre("a\n\nb")); }

TEST(EventsOf, SkipsCommentsAndOtherFields) {
  EXPECT_THAT(EventsOf(": hello\n\nevent: x\nid: 7\nretry: 10\ndatabase: no\ndata: a\n\n:\n\n"), ElementsAre("a"));
}

TEST(EventsOf, ReadsALastEventThatNothingEnds) {
  EXPECT_THAT(EventsOf("data: a\n\ndata: b"), ElementsAre("a", "b"));
  EXPECT_THAT(EventsOf("data: a\n"), ElementsAre("a"));
}

TEST(EventsOf, NothingIsNoEvent) {
  EXPECT_THAT(EventsOf(""), IsEmpty());
  EXPECT_THAT(EventsOf("\n\n\r\n"), IsEmpty());
}

TEST(EventsOf, SkipsAByteOrderMark) {
  EXPECT_THAT(EventsOf("\xef\xbb\xbf"
                       "data: a\n\n"),
              ElementsAre("a"));
}

TEST(EventsOf, TakesAllOfThisTogether) {
  const std::string stream =
      "\xef\xbb\xbf: c\r\n\r\ndata: {\"größe\": \"🛏\"}\r\n\r\nevent: e\rdata: one\rdata: two\r\rdata:\n\ndata: "
      "end\r\n";
  EXPECT_THAT(EventsOf(stream), ElementsAre("{\"größe\": \"🛏\"}", "one\ntwo", "", "end"));
}

}  // namespace
}  // namespace flair::llm
