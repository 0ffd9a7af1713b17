// SPDX-License-Identifier: GPL-3.0-or-later
// Whole designs with models that mean the right thing and write it in ways of their own, and with servers that take
// less than the protocol has.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "nlohmann/json.hpp"
#include "tests/fixtures/programs.h"
#include "tests/fixtures/scripted_model.h"

namespace flair::testing {
namespace {

using nlohmann::ordered_json;
using ::testing::HasSubstr;
using ::testing::Not;

// Changes all numbers and keys of a value.
ordered_json Rewritten(const ordered_json& value, const std::function<std::string(const std::string&)>& key,
                       const std::function<ordered_json(const std::string& key, double)>& number,
                       const std::string& of = "") {
  if (value.is_number()) return number(of, value.get<double>());
  if (!value.is_structured()) return value;
  ordered_json rewritten = value.is_array() ? ordered_json::array() : ordered_json::object();
  for (const auto& [name, member] : value.items()) {
    if (value.is_array()) {
      rewritten.push_back(Rewritten(member, key, number, of));
    } else {
      rewritten[key(name)] = Rewritten(member, key, number, name);
    }
  }
  return rewritten;
}

std::string SameKey(const std::string& key) { return key; }
ordered_json SameNumber(const std::string&, double number) { return number; }

std::string InCamelCase(const std::string& key) {
  std::string camel;
  for (size_t i = 0; i < key.size(); ++i) {
    const bool begins = i > 0 && key[i - 1] == '_';
    if (key[i] != '_') camel += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(key[i]))) : key[i];
  }
  return camel;
}

ordered_json WithoutNulls(const ordered_json& value) {
  if (!value.is_structured()) return value;
  ordered_json kept = value.is_array() ? ordered_json::array() : ordered_json::object();
  for (const auto& [name, member] : value.items()) {
    if (value.is_array()) {
      kept.push_back(WithoutNulls(member));
    } else if (!member.is_null()) {
      kept[name] = WithoutNulls(member);
    }
  }
  return kept;
}

// Of several places, each with another text.
std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  for (size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

// A way of writing an answer.
struct Quirk {
  std::string name;
  std::function<std::string(const ordered_json&)> write;
};

const std::vector<Quirk>& Quirks() {
  static const std::vector<Quirk> quirks = {
      {"ThinksAloudAndFencesIt",
       [](const ordered_json& answer) {
         return "<think>\nMaybe {\"zones\": [{\"name\": \"x\"}]}?\n</think>\n\nHere it is:\n```json\n" +
                answer.dump(2) + "\n```\nShall I change anything?";
       }},
      {"TrailingCommasAndRemarks",
       [](const ordered_json& answer) {
         return "// the plan\n" + Replaced(Replaced(answer.dump(2), "\n", " // ok\n"), "} // ok\n", "}, // ok\n");
       }},
      {"Wrapped",
       [](const ordered_json& answer) {
         return ordered_json{{"answer", answer}}.dump();
       }},
      {"WithoutNulls", [](const ordered_json& answer) { return WithoutNulls(answer).dump(); }},
      {"ExtraKeys",
       [](ordered_json answer) {
         answer["explanation"] = "I chose calm colours.";
         answer["confidence"] = 0.9;
         return answer.dump();
       }},
      {"CamelCase", [](const ordered_json& answer) { return Rewritten(answer, InCamelCase, SameNumber).dump(); }},
      {"NumbersAsTexts",
       [](const ordered_json& answer) {
         return Rewritten(answer, SameKey,
                          [](const std::string& key, double number) {
                            return ordered_json(ordered_json(number).dump() + (key.ends_with("_m") ? " m" : ""));
                          })
             .dump();
       }},
  };
  return quirks;
}

class ModelQuirks : public ::testing::Test {
 protected:
  // A whole design, which must end well.
  std::string Design(const ScriptedServer& server, const std::vector<std::string>& more = {}) {
    ++count_;
    WriteAll(folder_ / "llm.textproto", LlmConfigText(server, "temperature: 0.7"));
    std::vector<std::string> arguments = {"design", kModelBrief,      "--llm", (folder_ / "llm.textproto").string(),
                                          "--out",  Folder().string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Finished run = RunProgram("flair", arguments, {{"FLAIR_HOME", Folder().string() + "_home"}});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_TRUE(std::filesystem::exists(Folder() / "plan.png"));
    return run.err;
  }
  std::filesystem::path Folder() const { return folder_ / ("out_" + std::to_string(count_)); }

  TestFolder folder_;
  int count_ = 0;
};

TEST_F(ModelQuirks, AreUnderstoodWithoutAskingAgain) {
  for (const Quirk& quirk : Quirks()) {
    SCOPED_TRACE(quirk.name);
    Script script = DesignScript();
    for (Exchange& exchange : script.exchanges) {
      const std::string good = exchange.answer["text"];
      exchange.answer["text"] = quirk.write(ordered_json::parse(good));
    }
    ScriptedServer server(script);
    const std::string said = Design(server);
    EXPECT_THAT(said, HasSubstr("\nmodels       11 calls, "));
    EXPECT_THAT(said, Not(HasSubstr("repair")));
    EXPECT_THAT(said, HasSubstr("3 zones: sleeping, storage, working"));
  }
}

TEST_F(ModelQuirks, AModelThatThinksTooLongGetsRoomAndASecondTry) {
  Script script = DesignScript();
  script.rejects = {{"max_tokens", "Unsupported parameter: 'max_tokens' is not supported with this model."},
                    {"temperature", "Only the default (1) value is supported."}};
  Exchange& exchange = AddFirst("room", script);
  exchange.answer = {{"text", ""}, {"finish_reason", "length"}, {"reasoning_tokens", 4096}};
  ScriptedServer server(script);
  EXPECT_THAT(Design(server), HasSubstr("1 repair"));
  EXPECT_THAT(RequestsOf("zones", server).front().body, HasSubstr("\"max_completion_tokens\":16384"));
}

TEST_F(ModelQuirks, AServerThatHeedsNoSchemaIsToldItInThePrompt) {
  Script script = DesignScript();
  AddFirst("room", script).answer = {
      {"text", R"({"room": {"kind": "bedroom", "size": "4m x 5m"}, "doors": [{"side": "south"}]})"}};
  ScriptedServer server(script);
  Design(server);
  const std::vector<RecordedRequest> asked = RequestsOf("room", server);
  ASSERT_EQ(asked.size(), 2u);
  EXPECT_THAT(asked[0].body, Not(HasSubstr("It must follow this JSON schema")));
  EXPECT_THAT(asked[1].body, HasSubstr("It must follow this JSON schema"));
}

TEST_F(ModelQuirks, SeedsReachTheModelAndAreKeptApart) {
  Script script = DesignScript();
  const std::vector<Exchange> once = script.exchanges;
  script.exchanges.insert(script.exchanges.end(), once.begin(), once.end());
  ScriptedServer server(script);
  const auto asked_with = [&](int64_t seed) {
    return std::ranges::count_if(server.requests(), [&](const RecordedRequest& request) {
      return nlohmann::json::parse(request.body).value("seed", int64_t{-1}) == seed;
    });
  };
  const std::string cache = (folder_ / "cache").string();
  Design(server, {"--seed", "7", "--cache", cache});
  EXPECT_EQ(asked_with(7), 7);
  EXPECT_EQ(asked_with(0), 4) << "cleaning and translation know no brief";
  Design(server, {"--seed", "7", "--cache", cache});
  EXPECT_EQ(server.requests().size(), 11u) << "the same seed is the same room";
  EXPECT_TRUE(ReadAll(Folder() / "layout.pb") == ReadAll(folder_ / "out_1" / "layout.pb"));
  Design(server, {"--seed", "8", "--cache", cache});
  EXPECT_EQ(asked_with(8), 7);
}

}  // namespace
}  // namespace flair::testing
