// SPDX-License-Identifier: GPL-3.0-or-later
// What smaller and local models make of a format that they were asked for, as model_deviations_test.cc.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tests/end_to_end/deviations.h"

namespace flair::testing {
namespace {

// The elements of a list of objects in another form.
ordered_json WithElements(const ordered_json& answer, const std::function<ordered_json(const ordered_json&)>& element) {
  return Edited(answer, [&](const std::string& key, const ordered_json& value, ordered_json& object) {
    ordered_json list = ordered_json::array();
    const bool objects = value.is_array() && !value.empty() && value.front().is_object();
    for (const ordered_json& item : objects ? value : ordered_json::array()) list.push_back(element(item));
    object[key] = objects ? list : value;
  });
}

// The texts of a list of texts in another form.
ordered_json WithLists(const ordered_json& answer, const std::vector<std::string>& keys,
                       const std::function<ordered_json(const ordered_json&)>& list) {
  return Edited(answer, [&](const std::string& key, const ordered_json& value, ordered_json& object) {
    const bool meant = std::ranges::find(keys, key) != keys.end() && value.is_array();
    object[key] = meant ? list(value) : value;
  });
}

// An object with the values of a schema: {"type": ..., "value": ...}.
ordered_json AsSchema(const ordered_json& answer) {
  return Edited(answer, [](const std::string& key, const ordered_json& value, ordered_json& object) {
    const bool plain = value.is_number() || value.is_boolean();
    object[key] = plain ? ordered_json{{"type", value.is_number() ? "number" : "boolean"}, {"value", value}} : value;
  });
}

std::string Spaced(const std::string& json, const std::string& space) {
  return Replaced(Replaced(json, "\":", "\":" + space), ",\"", "," + space + "\"");
}

std::vector<Deviation> Wrappings() {
  return {
      {"AsACall",
       [](const auto& a) {
         return ordered_json{{"name", "submit"}, {"arguments", a}}.dump();
       },
       true},
      {"AsACallOfText",
       [](const auto& a) {
         return ordered_json{{"function", "submit"}, {"arguments", a.dump()}}.dump();
       },
       true},
      {"InToolCallTags",
       [](const auto& a) {
         return "<tool_call>\n" + ordered_json{{"name", "answer"}, {"parameters", a}}.dump() + "\n</tool_call>";
       },
       true},
      {"AfterChannelMarks", [](const auto& a) { return "<|channel|>final<|message|>" + a.dump() + "<|return|>"; }},
      {"Boxed", [](const auto& a) { return "$\\boxed{" + a.dump() + "}$"; }},
      {"WithoutItsLastBracket",
       [](const auto& a) {
         // What ends in a number might have ended in a longer one.
         const std::string text = a.dump();
         return text.ends_with("]}") ? text.substr(0, text.size() - 1) : text;
       },
       true},
      {"WithABracketTooMany", [](const auto& a) { return a.dump() + "}\n"; }},
      {"TheSchemaAround",
       [](const auto& a) {
         return ordered_json{{"type", "object"}, {"properties", a}}.dump();
       }},
      {"TheSchemaFilledIn", [](const auto& a) { return AsSchema(a).dump(); }, true},
      {"TheSchemaThenIt",
       [](const auto& a) {
         ordered_json schema = {{"type", "object"}, {"properties", ordered_json::object()}};
         for (const auto& [key, value] : a.items()) schema["properties"][key] = {{"type", "array"}};
         return schema.dump() + "\n\n" + a.dump();
       }},
      {"AnUnclosedThought", [](const auto& a) { return "<think>\nLet me plan {a room} [well].\n\n" + a.dump(); }},
      {"ElementsAsTexts",
       [](const auto& a) {
         return WithElements(a, [](const ordered_json& element) { return ordered_json(element.dump()); }).dump();
       },
       true},
      {"ListsAsTexts",
       [](const auto& a) {
         return Edited(a,
                       [](const std::string& key, const ordered_json& value, ordered_json& object) {
                         const bool objects = value.is_array() && !value.empty() && value.front().is_object();
                         object[key] = objects ? ordered_json(value.dump()) : value;
                       })
             .dump();
       },
       true},
  };
}

std::vector<Deviation> Spellings() {
  return {
      {"SpacesThatDoNotBreak", [](const auto& a) { return Spaced(a.dump(), "\u00a0"); }},
      {"WideSpaces", [](const auto& a) { return Spaced(a.dump(), "\u3000"); }},
      {"FullWidthMarks", [](const auto& a) { return Replaced(Replaced(a.dump(), "\":", "\"："), ",\"", "，\""); },
       true},
      {"MarksOfDirection", [](const auto& a) { return Replaced(a.dump(), ":\"", ":\"\u200f"); }},
      {"InvisibleSpaces", [](const auto& a) { return Replaced(a.dump(), "\",", "\u200b\","); }},
      {"Zeros", [](const auto& a) { return Replaced(a.dump(), ",\"", ",\\u0000\""); }, true},
      {"ZerosInTexts", [](const auto& a) { return Replaced(a.dump(), ":\"", ":\"\\u0000"); }},
      {"OtherHyphens",
       [](const auto& a) {
         return WithTexts(a, {"at", "object"}, [](const auto& text) { return Replaced(text, "_", "\u2011"); }).dump();
       },
       true},
      {"KeysInBold",
       [](const auto& a) { return WithKeys(a, [](const auto& key) { return "**" + key + "**"; }).dump(); }},
      {"KeysWithEscapes", [](const auto& a) { return Replaced(a.dump(), "_m\":", "\\_m\":"); }, true},
      {"KeysInSpanish",
       [](const auto& a) { return WithKeys(a, [](const auto& key) { return "el_" + key + "_es"; }).dump(); }, true},
      {"CommentsWithHashes", [](const auto& a) { return Replaced(a.dump(1), "\n", " # ok\n"); }, true},
      {"Yaml", [](const auto& a) { return Replaced(Replaced(Replaced(a.dump(1), "{", "-"), "\"", ""), "}", ""); },
       true},
  };
}

std::vector<Deviation> Values() {
  return {
      {"Fractions",
       [](const auto& a) { return Replaced(Replaced(a.dump(), ":1.5,", ":\"1 1/2\","), ":0.5,", ":\"½\","); }, true},
      {"MetresInWords",
       [](const auto& a) {
         return WithNumbers(a, [](double n) { return n == 2 ? ordered_json("two metres") : ordered_json(n); }).dump();
       },
       true},
      {"SpacesInQuantities",
       [](const auto& a) {
         return WithNumbers(a, [](double n) { return ordered_json(Centimetres(n) + "\u202fcm"); }).dump();
       }},
      {"Ranges",
       [](const auto& a) {
         return WithNumbers(
                    a, [](double n) { return ordered_json(Number(n) + "-" + Number(n + 1)); }, "count")
             .dump();
       },
       true},
      {"RangesOfLengths",
       [](const auto& a) {
         return WithNumbers(a,
                            [](double n) {
                              return ordered_json(Centimetres(n * 0.99) + " to " + Centimetres(n * 1.01) + " cm");
                            })
             .dump();
       },
       true},
      {"Percents",
       [](const auto& a) {
         return WithNumbers(
                    a, [](double n) { return ordered_json(Number(n * 100) + "%"); }, "position")
             .dump();
       },
       true},
      {"AUnitForAll",
       [](const auto& a) {
         ordered_json answer = WithNumbers(a, [](double n) { return ordered_json(n * 100); });
         answer["units"] = "cm";
         return answer.dump();
       },
       true},
      {"BooleansAsDigits",
       [](const auto& a) { return Replaced(Replaced(a.dump(), ":true", ":\"1\""), ":false", ":\"0\""); }, true},
      {"SentencesInObjects",
       [](const auto& a) {
         return WithLists(a, {"must", "should"},
                          [](const ordered_json& list) {
                            ordered_json objects = ordered_json::array();
                            for (const ordered_json& text : list) objects.push_back({{"text", text}});
                            return objects;
                          })
             .dump();
       },
       true},
      {"SentencesInOneText",
       [](const auto& a) {
         return WithLists(a, {"must", "should"},
                          [](const ordered_json& list) {
                            std::string text;
                            for (const ordered_json& item : list) text += "- " + item.get<std::string>() + "\n";
                            return text.empty() ? ordered_json::array() : ordered_json(text);
                          })
             .dump();
       },
       true},
      {"NamesInObjects",
       [](const auto& a) {
         return Edited(a,
                       [](const std::string& key, const ordered_json& value, ordered_json& object) {
                         const bool name = (key == "zone" || key == "at" || key == "object") && value.is_string();
                         object[key] = name ? ordered_json{{"id", value}} : value;
                       })
             .dump();
       },
       true},
      {"OpeningsByKind",
       [](ordered_json a) {
         if (!a.contains("openings")) return a.dump();
         for (const ordered_json& opening : ordered_json(a["openings"])) {
           ordered_json plain = opening;
           plain.erase("kind");
           a[opening["kind"].get<std::string>() + "s"].push_back(plain);
         }
         a.erase("openings");
         return a.dump();
       },
       true},
      {"HeightFirst",
       [](const auto& a) {
         return WithSize(a,
                         [](const std::vector<double>& s, ordered_json& object) {
                           object["size (HxWxD)"] = Number(s[2]) + " x " + Number(s[0]) + " x " + Number(s[1]) + " m";
                         })
             .dump();
       },
       true},
      {"ZonesInLines",
       [](const auto& a) {
         if (!a.contains("zones")) return a.dump();
         ordered_json zones = ordered_json::array();
         for (const ordered_json& zone : a["zones"]) {
           zones.push_back(zone["name"].template get<std::string>() + ": " +
                           zone["purpose"].template get<std::string>());
         }
         return ordered_json{{"zones", zones}}.dump();
       },
       true},
      {"ZonesAsNames",
       [](const auto& a) {
         if (!a.contains("zones")) return a.dump();
         ordered_json zones = ordered_json::array();
         for (const ordered_json& zone : a["zones"]) zones.push_back(zone["name"]);
         return ordered_json{{"zones", zones}}.dump();
       },
       true},
      {"NumbersForIds",
       [](const auto& a) {
         return Edited(a,
                       [](const std::string& key, const ordered_json& value, ordered_json& object) {
                         const std::string text = value.is_string() ? value.get<std::string>() : "";
                         const bool id = key == "id" && text.find_first_not_of("0123456789", 1) == std::string::npos;
                         object[key] = id ? ordered_json(std::stoi(text.substr(1))) : value;
                       })
             .dump();
       }},
      {"NamesInThePlural",
       [](const auto& a) {
         return WithTexts(a, {"at", "object"}, [](const auto& text) { return "the " + Title(text) + "s"; }).dump();
       },
       true},
      {"NegativeCounts",
       [](const auto& a) {
         return WithNumbers(
                    a, [](double n) { return ordered_json(-n); }, "count")
             .dump();
       },
       true},
      {"TwoHundredObjects",
       [](ordered_json a) {
         if (!a.contains("objects") || !a["objects"].front().contains("zone")) return a.dump();
         while (a["objects"].size() < 200) a["objects"].push_back(a["objects"].front());
         return a.dump();
       },
       true},
  };
}

class ModelHabits : public ::testing::TestWithParam<Deviation> {};

TEST_P(ModelHabits, EndInTheWholeDesign) { ExpectWholeDesign(GetParam()); }

std::string NameOfHabit(const ::testing::TestParamInfo<Deviation>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Wrappings, ModelHabits, ::testing::ValuesIn(Wrappings()), NameOfHabit);
INSTANTIATE_TEST_SUITE_P(Spellings, ModelHabits, ::testing::ValuesIn(Spellings()), NameOfHabit);
INSTANTIATE_TEST_SUITE_P(Values, ModelHabits, ::testing::ValuesIn(Values()), NameOfHabit);

}  // namespace
}  // namespace flair::testing
