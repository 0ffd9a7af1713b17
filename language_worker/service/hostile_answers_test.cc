// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever a model answers, a step ends in a good artifact or in a typed failure that names the step.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "language_worker/service/testing/model_session.h"
#include "room/validation/validate.h"

namespace flair::language {
namespace {

using ::testing::HasSubstr;

// A step by name, and how to ask it once the earlier ones are done. The result is the status of its answer, which is
// good when OK.
struct Step {
  std::string name;
  std::function<absl::Status(ModelSession&)> ask;
};

std::vector<Step> Steps() {
  const auto room = [](ModelSession& session) {
    const auto response = session.DescribeRoom();
    return response.ok() ? Validate(response->room()) : response.status();
  };
  const auto zones = [](ModelSession& session) {
    const auto response = session.PlanZones();
    return response.ok() ? Validate(response->zone_plan()) : response.status();
  };
  const auto objects = [](ModelSession& session) {
    const auto response = session.ListObjects();
    return response.ok() ? Validate(response->object_list(), session.zones()) : response.status();
  };
  const auto style = [](ModelSession& session) {
    const auto response = session.ChooseStyle();
    return response.ok() ? Validate(response->style_sheet(), session.room(), session.objects()) : response.status();
  };
  const auto constraints = [](ModelSession& session) {
    const auto response = session.ListConstraints();
    return response.ok() ? Validate(response->constraint_list(), session.objects()) : response.status();
  };
  const auto cleaning = [](ModelSession& session) {
    const auto response = session.CleanConstraints();
    return response.ok() ? Validate(response->constraint_list(), session.objects()) : response.status();
  };
  return {{"room", room},
          {"zones", zones},
          {"objects.floor", objects},
          {"objects.tertiary", objects},
          {"style", style},
          {"constraints.intra", constraints},
          {"constraints.inter", constraints},
          {"cleaning", cleaning}};
}

// A session in which every step was answered well.
const ModelSession& Finished() {
  static const ModelSession* const session = [] {
    auto* made = new ModelSession;
    made->DescribeRoom().IgnoreError();
    made->PlanZones().IgnoreError();
    made->ListObjects().IgnoreError();
    EXPECT_TRUE(made->ListConstraints().ok());
    return made;
  }();
  return *session;
}

// Asks the step of that name with the two answers, after good ones for all others.
absl::Status AskWith(const Step& step, const std::string& first, const std::string& second, bool stand_in,
                     llm::FinishReason finish = llm::FinishReason::kStop) {
  ModelSession session(step.name);
  session.options().set_stand_in_allowed(stand_in);
  session.model().Answer(step.name, first, finish);
  session.model().Answer(step.name + "/repair", second, finish);
  // What an odd answer lacks, later ones may name: they are asked about too.
  for (const auto& [name, answer] : GoodAnswers()) {
    if (name != step.name) session.model().Answer(name + "/repair", answer);
  }
  session.TakePartsOf(Finished());
  return step.ask(session);
}

const std::vector<std::pair<std::string, std::string>>& HostileAnswers() {
  static const std::vector<std::pair<std::string, std::string>> answers = {
      {"Empty", ""},
      {"Refusal", "I'm sorry, but I can't assist with that request."},
      {"Html", "<!DOCTYPE html>\n<html><head><title>502 Bad Gateway</title></head></html>"},
      {"Prose", "A lovely room! The bed goes to the wall, 1.6m x 2m, with two nightstands."},
      {"Null", "null"},
      {"Number", "42"},
      {"String", "\"bedroom\""},
      {"EmptyObject", "{}"},
      {"EmptyList", "[]"},
      {"OtherObject", R"({"error":{"message":"overloaded","code":529}})"},
      {"ListOfNumbers", "[1,2,3]"},
      {"Nested", std::string(5000, '[')},
      {"NestedObjects",
       [] {
         std::string text;
         for (int i = 0; i < 3000; ++i) text += "{\"objects\":";
         return text;
       }()},
      {"NoUtf8", "\xff\xfe{\"objects\":[{\"name\":\"\xc3\x28\"}]}"},
      {"Zeros", std::string(1000, '\0')},
      {"Nulls",
       R"({"room_type":null,"width_m":null,"zones":null,"objects":null,"left_out":null,"looks":null,"changes":null})"},
      {"ListsOfNulls",
       R"({"zones":[null,null],"objects":[null],"openings":[null],"constraints":[null],"changes":[null]})"},
      {"WrongTypes",
       R"({"room_type":5,"width_m":"wide","depth_m":[4],"zones":"none","objects":7,"name":{},"changes":true})"},
      {"EmptyElements",
       R"({"zones":[{}],"objects":[{},{}],"looks":[{}],"constraints":[{}],"changes":[{}],"openings":[{}]})"},
      {"HugeNumbers", R"({"room_type":"x","width_m":1e308,"depth_m":-1e308,"objects":[{"name":"bed","count":1e300}]})"},
      {"Schema", R"({"type":"object","properties":{"objects":{"type":"array"}},"required":["objects"]})"},
  };
  return answers;
}

void ExpectTypedEnd(const Step& step, const absl::Status& status, const std::string& what) {
  if (status.ok()) return;
  EXPECT_EQ(status.code(), absl::StatusCode::kDataLoss) << step.name << " with " << what << ": " << status;
  EXPECT_THAT(status.message(), HasSubstr("step \"" + step.name.substr(0, step.name.find('.')))) << what;
}

TEST(HostileAnswers, EndInAGoodArtifactOrInAFailureThatNamesTheStep) {
  for (const Step& step : Steps()) {
    for (const auto& [name, answer] : HostileAnswers()) {
      ExpectTypedEnd(step, AskWith(step, answer, answer, /*stand_in=*/false), name);
      EXPECT_EQ(AskWith(step, answer, answer, /*stand_in=*/true), absl::OkStatus()) << step.name << " with " << name;
      EXPECT_EQ(AskWith(step, answer, GoodAnswers().at(step.name), false), absl::OkStatus())
          << step.name << " " << name;
    }
  }
}

TEST(HostileAnswers, AGoodAnswerThatWasCutOffAnywhereEndsWell) {
  for (const Step& step : Steps()) {
    const std::string& whole = GoodAnswers().at(step.name);
    for (size_t length = 0; length < whole.size(); length += 1 + whole.size() / 60) {
      const std::string cut = whole.substr(0, length);
      const absl::Status status = AskWith(step, cut, cut, /*stand_in=*/false, llm::FinishReason::kLength);
      ExpectTypedEnd(step, status, "cut at " + std::to_string(length));
    }
  }
}

// Values to put in the place of any other.
const std::vector<std::string>& OddValues() {
  static const std::vector<std::string> values = {"null",
                                                  "0",
                                                  "-1",
                                                  "1e9",
                                                  "\"\"",
                                                  "\"nothing\"",
                                                  "[]",
                                                  "{}",
                                                  "true",
                                                  "99999",
                                                  "\"120cm\"",
                                                  "\"6 ft\"",
                                                  "0.0001",
                                                  "\"unknown_zone\"",
                                                  "\"s1\"",
                                                  "[null]",
                                                  "19.9",
                                                  "\"Double-Bed\"",
                                                  "2.5",
                                                  "[\"a\",\"b\",\"c\"]",
                                                  "\"\\u0000\\u202e\"",
                                                  "\"<script>\"",
                                                  "\"Ünïcode 家具 🛋\"",
                                                  "40"};
  return values;
}

// The good answer with one value (the `number`-th) replaced.
std::string WithOddValue(const std::string& answer, size_t number, const std::string& odd) {
  std::vector<size_t> starts;
  for (size_t i = 0; i + 1 < answer.size(); ++i) {
    if (answer[i] == ':') starts.push_back(i + 1);
  }
  const size_t start = starts[number % starts.size()];
  int depth = 0;
  bool quoted = false;
  size_t end = start;
  for (; end < answer.size(); ++end) {
    const char c = answer[end];
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (c == '{' || c == '[') ++depth;
    if (depth == 0 && (c == ',' || c == '}' || c == ']')) break;
    if (c == '}' || c == ']') --depth;
  }
  return answer.substr(0, start) + odd + answer.substr(end);
}

TEST(HostileAnswers, AnyValueReplacedByAnyOtherEndsWell) {
  std::mt19937 random(7);
  int good = 0, failed = 0;
  for (const Step& step : Steps()) {
    const std::string& answer = GoodAnswers().at(step.name);
    for (size_t number = 0; number < 120; ++number) {
      const std::string odd = WithOddValue(answer, number, OddValues()[random() % OddValues().size()]);
      const absl::Status status = AskWith(step, odd, odd, /*stand_in=*/false);
      ExpectTypedEnd(step, status, odd);
      ++(status.ok() ? good : failed);
    }
  }
  EXPECT_GT(good, 4 * failed) << "one odd value seldom makes a whole answer useless: " << failed << " failed";
}

TEST(HostileAnswers, BytesAtRandomEndWell) {
  std::mt19937 random(11);
  for (const Step& step : Steps()) {
    for (int round = 0; round < 60; ++round) {
      std::string text = GoodAnswers().at(step.name);
      for (int change = 0; change < 4; ++change) {
        const size_t at = random() % text.size();
        if (random() % 2 == 0) {
          text[at] = static_cast<char>(random() % 256);
        } else {
          text.erase(at, 1 + random() % 8);
        }
      }
      ExpectTypedEnd(step, AskWith(step, text, text, /*stand_in=*/false), text);
    }
  }
}

}  // namespace
}  // namespace flair::language
