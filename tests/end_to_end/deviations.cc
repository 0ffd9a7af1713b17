// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/end_to_end/deviations.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "tests/fixtures/programs.h"
#include "tests/fixtures/scripted_model.h"

namespace flair::testing {

using ::testing::HasSubstr;
using ::testing::Not;

ordered_json Edited(const ordered_json& value, const MemberEdit& edit) {
  if (!value.is_structured()) return value;
  ordered_json copy = value.is_array() ? ordered_json::array() : ordered_json::object();
  for (const auto& [key, member] : value.items()) {
    if (value.is_array()) {
      copy.push_back(Edited(member, edit));
    } else {
      edit(key, Edited(member, edit), copy);
    }
  }
  return copy;
}

ordered_json WithKeys(const ordered_json& answer, const TextEdit& key) {
  return Edited(answer, [&](const std::string& name, const ordered_json& value, ordered_json& object) {
    object[key(name)] = value;
  });
}

ordered_json WithNumbers(const ordered_json& answer, const std::function<ordered_json(double)>& number,
                         const std::string& ending) {
  return Edited(answer, [&](const std::string& name, const ordered_json& value, ordered_json& object) {
    object[name] = value.is_number() && name.ends_with(ending) ? number(value.get<double>()) : value;
  });
}

ordered_json WithNulls(const ordered_json& answer, const ordered_json& null) {
  return Edited(answer, [&](const std::string& name, const ordered_json& value, ordered_json& object) {
    object[name] = value.is_null() ? null : value;
  });
}

ordered_json WithTexts(const ordered_json& answer, const std::vector<std::string>& keys, const TextEdit& text) {
  return Edited(answer, [&](const std::string& name, const ordered_json& value, ordered_json& object) {
    const bool meant = std::ranges::find(keys, name) != keys.end() && value.is_string();
    object[name] = meant ? ordered_json(text(value.get<std::string>())) : value;
  });
}

ordered_json WithSize(const ordered_json& answer,
                      const std::function<void(const std::vector<double>&, ordered_json&)>& write) {
  const std::vector<std::string> keys = {"width_m", "depth_m", "height_m"};
  if (!answer.is_structured()) return answer;
  ordered_json copy = answer.is_array() ? ordered_json::array() : ordered_json::object();
  const bool sized = answer.is_object() && std::ranges::all_of(keys, [&](const std::string& key) {
                       return answer.contains(key) && answer[key].is_number();
                     });
  for (const auto& [key, member] : answer.items()) {
    if (answer.is_array()) {
      copy.push_back(WithSize(member, write));
    } else if (!sized || std::ranges::find(keys, key) == keys.end()) {
      copy[key] = WithSize(member, write);
    }
  }
  if (sized) write({answer["width_m"], answer["depth_m"], answer["height_m"]}, copy);
  return copy;
}

std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  for (size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

std::string Upper(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

std::string Title(std::string text) {
  bool begins = true;
  for (char& c : text) {
    if (begins) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    begins = c == ' ' || c == '_';
    if (c == '_') c = ' ';
  }
  return text;
}

std::string Number(double number) { return ordered_json(number).dump(); }
std::string Centimetres(double metres) { return Number(std::round(metres * 1000) / 10); }

void ExpectWholeDesign(const Deviation& deviation) {
  const TestFolder folder;
  Script script = DesignScript();
  // As it deviates first; the second time, where there has to be one, as it was asked for.
  const std::vector<Exchange> good = script.exchanges;
  for (size_t i = good.size(); i-- > 0;) {
    Exchange odd = good[i];
    odd.answer["text"] = deviation.write(ordered_json::parse(std::string(good[i].answer["text"])));
    script.exchanges.insert(script.exchanges.begin(), odd);
  }
  ScriptedServer server(script);
  WriteAll(folder / "llm.textproto", LlmConfigText(server, "temperature: 0.7"));
  const Finished run = RunProgram("flair",
                                  {"design", kModelBrief, "--llm", (folder / "llm.textproto").string(), "--out",
                                   (folder / "out").string(), "--restarts", "1", "--size", "256"},
                                  {{"FLAIR_HOME", (folder / "home").string()}});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("3 zones: sleeping, storage, working")) << "nothing is lost";
  if (deviation.asks) {
    EXPECT_THAT(run.err, HasSubstr("repair"));
  } else {
    EXPECT_THAT(run.err, HasSubstr("\nmodels       11 calls, ")) << "plain, and yet asked about";
    EXPECT_THAT(run.err, Not(HasSubstr("repair")));
  }
}

}  // namespace flair::testing
