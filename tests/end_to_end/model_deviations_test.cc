// SPDX-License-Identifier: GPL-3.0-or-later
// What live models make of a format that they were asked for, step after step through the whole pipeline: what the
// schema leaves plain is read at once, the rest is asked about once more; never a crash, a hang or a design with less
// in it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tests/end_to_end/deviations.h"

namespace flair::testing {
namespace {

std::vector<Deviation> Wrappings() {
  return {
      {"InDataAndResult",
       [](const auto& a) {
         return ordered_json{{"data", {{"result", a}}}}.dump();
       }},
      {"InAList", [](const auto& a) { return ordered_json::array({a}).dump(); }},
      {"WithAStatus",
       [](const auto& a) {
         return ordered_json{{"status", "ok"}, {"answer", a}}.dump();
       }},
      {"InResponses",
       [](const auto& a) {
         return ordered_json{{"responses", {a}}}.dump();
       }},
      {"WithAByteOrderMark", [](const auto& a) { return "\xef\xbb\xbf" + a.dump(); }},
      {"InTags", [](const auto& a) { return "<answer>\n" + a.dump(1) + "\n</answer>"; }},
      {"InAFenceWithoutAnEnd", [](const auto& a) { return "```json\n" + a.dump(2); }},
      {"InAFenceOfJson5",
       [](const auto& a) { return "Sure! 🛋️\n\n```json5\n" + a.dump(2) + "\n```\n\n✨ Enjoy!"; }},
      {"ThoughtsWithoutABeginning", [](const auto& a) { return "so a bed {ok}.\n</think>\n" + a.dump(); }},
      {"ADraftFirst", [](const auto& a) { return "{\"draft\": true}\n\nFinal answer:\n" + a.dump(); }},
      {"TheSameTwice", [](const auto& a) { return a.dump() + "\n" + a.dump(); }},
      {"AfterACall", [](const auto& a) { return "submit_answer(" + a.dump() + ")"; }},
      {"AsAnAssignment", [](const auto& a) { return "const answer = " + a.dump(2) + ";"; }},
  };
}

std::vector<Deviation> Spellings() {
  const auto pythonic = [](const ordered_json& a) {
    return Replaced(
        Replaced(Replaced(Replaced(Replaced(a.dump(), "'", "\\u2019"), "\"", "'"), ":null", ":None"), ":true", ":True"),
        ":false", ":False");
  };
  return {
      {"Python", pythonic, true},
      {"NaNForNull", [](const auto& a) { return Replaced(a.dump(), ":null", ":NaN"); }, true},
      {"UndefinedForNull", [](const auto& a) { return Replaced(a.dump(), ":null", ":undefined"); }, true},
      {"BlockComments", [](const auto& a) { return Replaced(a.dump(), ",\"", ", /* next */ \""); }},
      {"TrailingCommas", [](const auto& a) { return Replaced(Replaced(a.dump(), "}", ",}"), "]", ",]"); }},
      {"NoCommasBetweenLines", [](const auto& a) { return Replaced(a.dump(1), ",\n", "\n"); }, true},
      {"KeysInCapitals", [](const auto& a) { return WithKeys(a, Upper).dump(); }},
      {"KeysWithSpaces", [](const auto& a) { return WithKeys(a, Title).dump(); }},
      {"KeysWithHyphens",
       [](const auto& a) { return WithKeys(a, [](const auto& key) { return Replaced(key, "_", "-"); }).dump(); }},
      {"KeysWithEmojis", [](const auto& a) { return WithKeys(a, [](const auto& key) { return "📏 " + key; }).dump(); },
       true},
      {"KeysTwice", [](const auto& a) { return Replaced(a.dump(), "\"name\":\"", "\"name\":\"draft\",\"name\":\""); }},
      {"EmptyTextsForNull", [](const auto& a) { return WithNulls(a, "").dump(); }, true},
      {"NoneAsATextForNull", [](const auto& a) { return WithNulls(a, "None").dump(); }, true},
      {"NotApplicableForNull", [](const auto& a) { return WithNulls(a, "N/A").dump(); }, true},
      {"KeysInGerman",
       [](const auto& a) { return WithKeys(a, [](const auto& key) { return "das_" + key + "_feld"; }).dump(); }, true},
  };
}

std::vector<Deviation> Values() {
  const std::vector<std::string> names = {"zone", "kind", "at", "object", "wall", "swing"};
  return {
      {"NamesInCapitals", [=](const auto& a) { return WithTexts(a, names, Upper).dump(); }},
      {"NamesAsTitles", [=](const auto& a) { return WithTexts(a, names, Title).dump(); }},
      {"NamesWithEmojis",
       [=](const auto& a) { return WithTexts(a, names, [](const auto& text) { return "✅ " + text; }).dump(); }, true},
      {"ZonesWithTheWordZone",
       [](const auto& a) { return WithTexts(a, {"zone"}, [](const auto& text) { return text + " zone"; }).dump(); },
       true},
      {"CountsAsTimes",
       [](const auto& a) {
         return WithNumbers(
                    a, [](double n) { return ordered_json(Number(n) + "x"); }, "count")
             .dump();
       },
       true},
      {"TimesBeforeCounts",
       [](const auto& a) {
         return WithNumbers(
                    a, [](double n) { return ordered_json("x" + Number(n)); }, "count")
             .dump();
       },
       true},
      {"CountsWithPieces",
       [](const auto& a) {
         return WithNumbers(
                    a, [](double n) { return ordered_json(Number(n) + " pieces"); }, "count")
             .dump();
       },
       true},
      {"CountsInWords",
       [](const auto& a) {
         const auto word = [](double n) {
           return ordered_json(n == 1 ? "one" : n == 2 ? "two" : n == 3 ? "three" : "four");
         };
         return WithNumbers(a, word, "count").dump();
       },
       true},
      {"DecimalCommas",
       [](const auto& a) {
         return WithNumbers(a, [](double n) { return ordered_json(Replaced(Number(n), ".", ",")); }).dump();
       },
       true},
      {"NumbersWithSigns",
       [](const auto& a) {
         return WithNumbers(a, [](double n) { return ordered_json("~" + Number(n) + " metres"); }).dump();
       },
       true},
      {"NumbersInLists",
       [](const auto& a) { return WithNumbers(a, [](double n) { return ordered_json::array({n}); }).dump(); }, true},
      {"UnitsBehindNumbers",
       [](const auto& a) {
         const std::string text = WithNumbers(a, [](double n) { return ordered_json("@" + Number(n) + "m@"); }).dump();
         return Replaced(Replaced(text, "\"@", ""), "@\"", "");
       },
       true},
      {"InfiniteNumbers",
       [](const auto& a) {
         return Replaced(WithNumbers(a, [](double) { return ordered_json("@"); }).dump(), "\"@\"", "Infinity");
       },
       true},
      {"NegativeNumbers",
       [](const auto& a) { return WithNumbers(a, [](double n) { return ordered_json(-1 - n); }).dump(); }, true},
      {"ThousandsWithCommas",
       [](const auto& a) { return WithNumbers(a, [](double) { return ordered_json("1,600 mm"); }).dump(); }, true},
  };
}

std::vector<Deviation> Sizes() {
  using Lengths = std::vector<double>;
  const auto size = [](const std::function<void(const Lengths&, ordered_json&)>& write) {
    return [write](const ordered_json& a) { return WithSize(a, write).dump(); };
  };
  return {
      {"SizeInOneText", size([](const Lengths& s, ordered_json& object) {
         object["dimensions"] = Number(s[0]) + " x " + Number(s[1]) + " x " + Number(s[2]) + " m";
       }),
       true},
      {"SizeInCentimetres", size([](const Lengths& s, ordered_json& object) {
         object["size_cm"] = Centimetres(s[0]) + "×" + Centimetres(s[1]) + "×" + Centimetres(s[2]);
       }),
       true},
      {"SizeInAList", size([](const Lengths& s, ordered_json& object) { object["dimensions_m"] = s; }), true},
      {"SizeByLetters", size([](const Lengths& s, ordered_json& object) {
         object["size"] = {{"w", s[0]}, {"d", s[1]}, {"h", s[2]}};
       }),
       true},
      {"LettersBesideTheName", size([](const Lengths& s, ordered_json& object) {
         object["w"] = s[0];
         object["d"] = s[1];
         object["h"] = s[2];
       }),
       true},
      {"SizeInWords", size([](const Lengths& s, ordered_json& object) {
         object["size"] = Number(s[0]) + " m wide, " + Number(s[1]) + " m deep, " + Number(s[2]) + " m high";
       }),
       true},
  };
}

class ModelDeviations : public ::testing::TestWithParam<Deviation> {};

TEST_P(ModelDeviations, EndInTheWholeDesign) { ExpectWholeDesign(GetParam()); }

std::string NameOfDeviation(const ::testing::TestParamInfo<Deviation>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Wrappings, ModelDeviations, ::testing::ValuesIn(Wrappings()), NameOfDeviation);
INSTANTIATE_TEST_SUITE_P(Spellings, ModelDeviations, ::testing::ValuesIn(Spellings()), NameOfDeviation);
INSTANTIATE_TEST_SUITE_P(Values, ModelDeviations, ::testing::ValuesIn(Values()), NameOfDeviation);
INSTANTIATE_TEST_SUITE_P(Sizes, ModelDeviations, ::testing::ValuesIn(Sizes()), NameOfDeviation);

}  // namespace
}  // namespace flair::testing
