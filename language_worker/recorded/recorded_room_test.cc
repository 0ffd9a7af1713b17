// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/recorded/recorded_room.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "language_worker/recorded/testing/test_room.h"

namespace flair::language {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

TEST(RecordedRoom, HasTheBriefTheObjectsAndTheTexts) {
  const RecordedRoom room = TestRoom("study");
  EXPECT_EQ(room.brief.text(), "A study that is 4m x 3m.");
  EXPECT_THAT(room.FloorObjects(), SizeIs(5));
  EXPECT_THAT(room.Tertiaries(), SizeIs(5));
  EXPECT_THAT(std::string(room.Text("primary_inter")), HasSubstr("at least 0.6m away"));
  EXPECT_EQ(room.Text("nothing"), "");
  EXPECT_NE(room.digest, TestRoom("washroom").digest);
}

TEST(RecordedRoom, ABriefOfTwoLinesBecomesOne) {
  nlohmann::json json = nlohmann::json::parse(RecordedText("study"));
  json["prompt"] = "  A study\nwith a\tdesk.  ";
  const auto room = ReadRecordedRoom(json.dump());
  ASSERT_TRUE(room.ok()) << room.status();
  EXPECT_EQ(room->brief.text(), "A study with a desk.");
}

// A change of the study, and what its refusal must name.
struct Bad {
  std::string name;
  std::string pointer;
  nlohmann::json value;
  std::string told;
};

class BadRecordedRoom : public ::testing::TestWithParam<Bad> {};

TEST_P(BadRecordedRoom, IsRefusedWithItsField) {
  nlohmann::json json = nlohmann::json::parse(RecordedText("study"));
  json[nlohmann::json::json_pointer(GetParam().pointer)] = GetParam().value;
  const auto room = ReadRecordedRoom(json.dump());
  ASSERT_EQ(room.status().code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(room.status().message()), HasSubstr(GetParam().told));
}

INSTANTIATE_TEST_SUITE_P(All, BadRecordedRoom,
                         ::testing::Values(Bad{"NoTexts", "/language", nullptr, "language"},
                                           Bad{"TextIsAList", "/language/style", {1}, "language.style"},
                                           Bad{"NoPrompt", "/prompt", nullptr, "prompt"},
                                           Bad{"EmptyPrompt", "/prompt", "  ", "prompt"},
                                           Bad{"LongPrompt", "/prompt", std::string(5000, 'x'), "prompt"},
                                           Bad{"NoZones", "/zones", nlohmann::json::array(), "zones"},
                                           Bad{"HugeRoom", "/room/width", 1e9, "room.width"},
                                           Bad{"ObjectWithoutSize", "/primary/0/width", "wide", "primary[0].width"},
                                           Bad{"IndexTwice", "/secondary/0/index", 0, "index"},
                                           Bad{"NotAnObject", "/primary/0", 3, "primary[0]"}),
                         [](const auto& info) { return info.param.name; });

TEST(RecordedRoom, OtherFilesAreRefused) {
  for (const char* text : {"", "{", "[]", "null", "{\"room\":{}}", "<html>"}) {
    EXPECT_EQ(ReadRecordedRoom(text).status().code(), absl::StatusCode::kInvalidArgument) << text;
  }
  EXPECT_THAT(std::string(ReadRecordedRoom(std::string(11'000'000, ' ')).status().message()), HasSubstr("at most"));
}

}  // namespace
}  // namespace flair::language
