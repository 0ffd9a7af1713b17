// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "llm/answers/read_answer.h"

namespace flair::llm {
namespace {

using ::testing::HasSubstr;

const std::vector<std::string> kKeys = {"zones"};

struct Case {
  std::string name;
  std::string answer;
  // Compact JSON, or nothing.
  std::string value;
  // Part of the first fault; empty for none.
  std::string fault;
};

class ExtractJsonTest : public ::testing::TestWithParam<Case> {};

TEST_P(ExtractJsonTest, TakesTheValueOrSaysWhatThereIsInstead) {
  const ExtractedJson extracted = ExtractJson(GetParam().answer, kKeys);
  EXPECT_EQ(extracted.value.is_discarded() ? "" : extracted.value.dump(), GetParam().value);
  ASSERT_EQ(extracted.faults.empty(), GetParam().fault.empty());
  if (!extracted.faults.empty()) {
    EXPECT_THAT(extracted.faults[0].text, HasSubstr(GetParam().fault));
  }
}

const std::string kGood = R"({"zones":[{"name":"sleeping"}]})";

INSTANTIATE_TEST_SUITE_P(
    Answers, ExtractJsonTest,
    ::testing::ValuesIn(std::vector<Case>{
        {"Plain", kGood, kGood, ""},
        {"Fenced", "```json\n" + kGood + "\n```", kGood, ""},
        {"FenceThatNeverCloses", "```json\n" + kGood, kGood, ""},
        {"ProseAround", "Sure! Here is {the plan} [as asked]:\n" + kGood + "\nEnjoy {it}.", kGood, ""},
        {"ByteOrderMark", "\xEF\xBB\xBF" + kGood, kGood, ""},
        {"TrailingCommas", R"({"zones":[{"name":"sleeping",},],})", kGood, ""},
        {"Comments", "{ // the plan\n\"zones\": [ /* one */ {\"name\": \"sleeping\"} ] }", kGood, ""},
        {"AnEmptyListAloneIsTheAnswer", "Nothing to change: []", "[]", ""},
        {"AnEmptyListInWhatIsNoJsonIsNone", "{= zones: []}", "", "has no JSON"},
        {"CommentMarksInsideAString", R"({"zones":["a // b, ] /* c */"]})", R"({"zones":["a // b, ] /* c */"]})", ""},
        {"LineEndInsideAString", "{\"zones\":[\"a\nb\"]}", R"({"zones":["a\nb"]})", ""},
        {"BracketsInsideAString", R"({"zones":["}]{["]})", R"({"zones":["}]{["]})", ""},
        {"EscapedQuotes", R"({"zones":["say \"}\" \\"]})", R"({"zones":["say \"}\" \\"]})", ""},
        {"Thoughts", "<think>{\"zones\": []} or rather</think>" + kGood, kGood, ""},
        {"TheSchemaFirst", R"({"type":"object","properties":{"zones":{"type":"array"}}} )" + kGood, kGood, ""},
        {"TheSecondThoughtCounts", R"({"zones":[]} no: )" + kGood, kGood, ""},
        {"AnAsideAfterIt", kGood + R"( where {"x": 1} is mine)", kGood, ""},
        {"Empty", "", "", "is empty"},
        {"OnlySpace", " \n\t ", "", "is empty"},
        {"Refusal", "I'm sorry, but I can't help with that.", "", "has no JSON; it says \"I'm sorry, but I can't"},
        {"Html", "<!DOCTYPE html><html><script>var a = {\"zones\": []};</script></html>", "", "is an HTML page"},
        {"HtmlWithoutDoctype", "<HTML><body>502 Bad Gateway", "", "is an HTML page"},
        {"TruncatedAtOnce", "{", "", "ended"},
        {"SpacesAndMarksNobodySees", "\u200e{\u00a0\"zones\":\u3000[{\"name\":\u202f\"sleeping\u200f\"}]\u2028}\u2060",
         kGood, ""},
        {"FullWidthMarksInATextStay", "{\"zones\":[\"a：b，c\"]}", "{\"zones\":[\"a：b，c\"]}", ""},
        {"Truncated", R"({"zones":[{"name":"sleeping"},{"name":"dres)", kGood, "ended after"},
        {"TruncatedInTheFirst", R"({"zones":[{"name":"sle)", "", "ended after"},
        {"TruncatedAfterAComma", R"({"zones":[{"name":"sleeping"},)", kGood, "ended after"},
        {"WithoutTheLastBracket", R"({"zones":[{"name":"sleeping"}])", kGood, "ended after"},
        {"SingleQuotes", R"({'zones': []})", "", "has no JSON"},
        {"KeysWithoutQuotes", "{\"zones\":[{name: 1}]}", "", "is no valid JSON near"},
        {"MissingComma", R"({"zones":[{"name":"a"} {"name":"b"}]})", "", "is no valid JSON near"},
        {"MissingColon", R"({"zones" [1]})", "", "is no valid JSON near"},
        {"WrongBracket", R"({"zones":[{"name":"a"}})", "", "a bracket that does not match near"},
        {"HugeNumber", R"({"zones":1e999})", "", "a number is too large"},
        {"HalfACharacter", R"({"zones":"\ud83d"})", "", "is no valid JSON near"},
    }),
    [](const auto& info) { return info.param.name; });

TEST(ExtractJson, BytesThatAreNoUtf8BecomeReplacementCharacters) {
  const ExtractedJson extracted = ExtractJson("{\"zones\":\"a\xFF\xC0z\xED\xA0\x80\"}", kKeys);
  ASSERT_TRUE(extracted.faults.empty());
  EXPECT_EQ(extracted.value["zones"], "a\uFFFD\uFFFDz\uFFFD\uFFFD\uFFFD");
}

TEST(ExtractJson, NestingAndLengthHaveLimits) {
  const ExtractedJson deep = ExtractJson(std::string(100000, '['), kKeys);
  EXPECT_TRUE(deep.value.is_discarded());
  EXPECT_FALSE(deep.faults.empty());
  const ExtractedJson closed = ExtractJson(std::string(1000, '[') + std::string(1000, ']'), kKeys);
  EXPECT_TRUE(closed.value.is_discarded());
  const ExtractedJson lengthy = ExtractJson(std::string(2'000'000, ' '), kKeys);
  ASSERT_EQ(lengthy.faults.size(), 1U);
  EXPECT_EQ(lengthy.faults[0].text, "has 2000000 bytes; at most 1000000");
}

TEST(ExtractJson, FaultsAreGoodTextWhereverTheyQuote) {
  for (
      const std::string whole :
      {R"({"zones":[{"größe des schönen möbelstücks im zimmer über dem öfchen":"ä 家具 🛋 é"},{"name":äöü家具🛋}]})",
       R"({"zones":[家具🛋äöü家具🛋äöü家具🛋äöü家具🛋äöü家具🛋äöü]})",
       "家具🛋äöü家具🛋äöü家具🛋äöü家具🛋äöü家具🛋äöü家具🛋äöü家具🛋äö"
       "ü"}) {
    for (size_t start = 0; start < whole.size(); ++start) {
      for (const std::string& part : {whole.substr(start), whole.substr(0, start)}) {
        for (const Fault& fault : ExtractJson(part, kKeys).faults) EXPECT_EQ(ToUtf8(fault.text), fault.text) << part;
      }
      EXPECT_EQ(ToUtf8(Quoted(whole.substr(start))), Quoted(whole.substr(start)));
    }
  }
}

TEST(ExtractJson, FaultsHaveNoControlCharactersAndNoHalfCharacters) {
  for (const std::string text : {"{\"zo\nnes\x7f\":[{\"a\": ]", "{'a\tb': [1}", "[1,{\"\xC3\xA4\xC3\xB6\" {} }]",
                                 "{\"zones\":[{},{\xEF\xBF\xBD \"a\":,}]}"}) {
    for (size_t length = 1; length <= text.size(); ++length) {
      for (const Fault& fault : ExtractJson(text.substr(0, length), kKeys).faults) {
        EXPECT_EQ(WithoutControls(ToUtf8(fault.text)), fault.text) << text;
      }
    }
  }
}

TEST(ExtractJson, EveryPrefixOfAGoodAnswerIsATruncatedOne) {
  const std::string whole = R"({"zones":[{"name":"sleeping \"a\""},{"name":"b","n":[1,2]}],"x":{"y":null}})";
  for (size_t length = 1; length < whole.size(); ++length) {
    const ExtractedJson extracted = ExtractJson(whole.substr(0, length), kKeys);
    ASSERT_EQ(extracted.faults.size(), 1U) << length;
    EXPECT_THAT(extracted.faults[0].text, HasSubstr("ended")) << length;
    if (!extracted.value.is_discarded()) {
      EXPECT_FALSE(extracted.value["zones"].empty()) << length;
    }
  }
}

}  // namespace
}  // namespace flair::llm
