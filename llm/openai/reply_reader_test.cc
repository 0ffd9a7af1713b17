// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/openai/reply_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace flair::llm {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// The events of a stream that arrives in pieces of one size.
std::vector<std::string> Read(const std::string& stream, size_t piece_size = std::string::npos) {
  std::vector<std::string> events;
  const auto keep = [&](std::string_view data) {
    events.emplace_back(data);
    return absl::OkStatus();
  };
  SseReader reader;
  for (size_t at = 0; at < stream.size(); at += std::min(piece_size, stream.size() - at)) {
    EXPECT_TRUE(reader.Take(std::string_view(stream).substr(at, piece_size), keep).ok());
  }
  EXPECT_TRUE(reader.Finish(keep).ok());
  return events;
}

TEST(SseReader, ReadsTheDataOfEvents) { EXPECT_THAT(Read("data: a\n\ndata: b c\n\n"), ElementsAre("a", "b c")); }

TEST(SseReader, TakesEveryKindOfLineEnd) {
  EXPECT_THAT(Read("data: a\r\n\r\ndata: b\r\rdata: c\n\n"), ElementsAre("a", "b", "c"));
}

TEST(SseReader, TakesAwayOneSpaceOnly) { EXPECT_THAT(Read("data:a\n\ndata:  b\n\n"), ElementsAre("a", " b")); }

TEST(SseReader, JoinsTheLinesOfOneEvent) { EXPECT_THAT(Read("data: a\ndata\ndata: b\n\n"), ElementsAre("a\n\nb")); }

TEST(SseReader, SkipsCommentsAndOtherFields) {
  EXPECT_THAT(Read(": hello\n\nevent: x\nid: 7\nretry: 10\ndatabase: no\ndata: a\n\n:\n\n"), ElementsAre("a"));
}

TEST(SseReader, ReadsALastEventThatNothingEnds) {
  EXPECT_THAT(Read("data: a\n\ndata: b"), ElementsAre("a", "b"));
  EXPECT_THAT(Read("data: a\n"), ElementsAre("a"));
}

TEST(SseReader, NothingIsNoEvent) {
  EXPECT_THAT(Read(""), IsEmpty());
  EXPECT_THAT(Read("\n\n\r\n"), IsEmpty());
}

TEST(SseReader, SkipsAByteOrderMark) {
  EXPECT_THAT(Read("\xef\xbb\xbf"
                   "data: a\n\n"),
              ElementsAre("a"));
}

TEST(SseReader, PiecesOfAnySizeMakeTheSameEvents) {
  const std::string stream =
      "\xef\xbb\xbf: c\r\n\r\ndata: {\"größe\": \"🛏\"}\r\n\r\nevent: e\rdata: one\rdata: two\r\rdata:\n\ndata: "
      "end\r\n";
  const auto whole = Read(stream);
  EXPECT_THAT(whole, ElementsAre("{\"größe\": \"🛏\"}", "one\ntwo", "", "end"));
  for (size_t size = 1; size <= stream.size(); ++size) EXPECT_EQ(Read(stream, size), whole) << size;
}

TEST(SseReader, AnErrorOfTheReceiverEndsTheReading) {
  SseReader reader;
  int count = 0;
  const auto fail = [&](std::string_view) {
    ++count;
    return absl::DataLossError("no");
  };
  EXPECT_EQ(reader.Take("data: a\n\ndata: b\n\n", fail).code(), absl::StatusCode::kDataLoss);
  EXPECT_EQ(count, 1);
}

}  // namespace
}  // namespace flair::llm
