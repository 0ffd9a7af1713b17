// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/logging/log.h"

#include <gmock/gmock.h>

#include "nlohmann/json.hpp"

namespace flair::runtime {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

// 2026-05-21T13:45:01.078Z
constexpr std::chrono::system_clock::time_point kTime{std::chrono::milliseconds(1779371101078)};

LogLine Line(std::string_view message, LogFields fields) {
  return {.time = kTime, .level = "info", .program = "flair-optimizer", .message = message, .fields = fields};
}

std::string Text(std::string_view message, std::initializer_list<LogField> fields) {
  return TextLogLine(Line(message, {fields.begin(), fields.size()}));
}

nlohmann::json Json(std::string_view message, std::initializer_list<LogField> fields) {
  const std::string line = JsonLogLine(Line(message, {fields.begin(), fields.size()}));
  EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  return nlohmann::json::parse(line);
}

TEST(LogLine, TextIsForPeopleAndGrep) {
  EXPECT_EQ(Text("Solve OK", {{"request_id", "j-1/solve"}, {"duration_ms", 81.249}, {"messages", int64_t{3}}}),
            "2026-05-21T13:45:01.078Z info flair-optimizer Solve OK request_id=j-1/solve duration_ms=81.2 messages=3");
}

TEST(LogLine, JsonHasTheSameFields) {
  const nlohmann::json json =
      Json("Solve OK", {{"request_id", "j-1/solve"}, {"duration_ms", 81.249}, {"messages", int64_t{3}}});
  EXPECT_EQ(json, nlohmann::json({{"time", "2026-05-21T13:45:01.078Z"},
                                  {"level", "info"},
                                  {"program", "flair-optimizer"},
                                  {"message", "Solve OK"},
                                  {"request_id", "j-1/solve"},
                                  {"duration_ms", 81.249},
                                  {"messages", 3}}));
}

TEST(LogLine, LeavesOutWhatIsNotThere) {
  EXPECT_THAT(Text("Solve OK", {{"request_id", ""}, {"messages", {}}}), EndsWith("Solve OK"));
  EXPECT_FALSE(Json("Solve OK", {{"request_id", ""}, {"messages", {}}}).contains("request_id"));
}

TEST(LogLine, AnIdCannotForgeALineOrAField) {
  const std::string hostile = "x\n2026-05-21T13:45:01.078Z error flair \x1b[2J \"y\" code=OK \xc2\x9b \xe2\x80\xa8";
  const std::string text = Text("Solve OK", {{"request_id", hostile}});
  EXPECT_THAT(text, HasSubstr(R"(request_id="x\n2026-05-21T13:45:01.078Z error flair \x1b[2J \"y\" code=OK \xc2\x9b)"));
  EXPECT_THAT(text, EndsWith("\\xe2\\x80\\xa8\""));
  EXPECT_EQ(Json("Solve OK", {{"request_id", hostile}})["request_id"], hostile);
}

TEST(LogLine, NeitherCanAMessage) {
  const std::string text = Text("two\nlines \x1b[31m", {});
  EXPECT_THAT(text, EndsWith("two\\nlines \\x1b[31m"));
  EXPECT_EQ(Json("two\nlines", {})["message"], "two\nlines");
}

TEST(LogLine, TakesBytesThatAreNoText) {
  EXPECT_THAT(Text("m", {{"request_id", "\xff\xfe"}}), HasSubstr("request_id="));
  EXPECT_EQ(Json("m", {{"request_id", "a\xff"}})["request_id"], "a\xef\xbf\xbd");
}

TEST(LogLine, QuotesNothingThatNeedsNone) {
  EXPECT_THAT(Text("m", {{"address", "127.0.0.1:50051"}}), Not(HasSubstr("\"")));
  EXPECT_THAT(Text("m", {{"error", "zimmer für zwei"}}), EndsWith("error=\"zimmer für zwei\""));
}

}  // namespace
}  // namespace flair::runtime
