// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/answer_lines.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "llm/answers/choices.h"
#include "llm/answers/field_facts.h"
#include "llm/answers/plain_value.h"
#include "llm/answers/utf8.h"

namespace flair::llm {
namespace {

using google::protobuf::Descriptor;
using nlohmann::json;

constexpr std::string_view kAround = " \t-*[]()\"'`";

bool IsOfAName(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

// Length of the first part, from its first letter: names up to a colon, "s1, s2", else one name.
size_t FirstPartLength(std::string_view line) {
  constexpr std::string_view kBetween = " ,+&";
  const std::string_view names = line.substr(0, line.find(':'));
  const size_t last = names.find_last_not_of(kAround);
  if (names.size() < line.size() && last != std::string_view::npos &&
      std::all_of(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(last) + 1,
                  [&](char c) { return IsOfAName(c) || kBetween.find(c) != std::string_view::npos; })) {
    return last + 1;
  }
  return std::min(line.find_first_of(std::string(kAround) + ":="), line.size());
}

// Without the marks of a list and quotes.
std::string_view FromFirstLetter(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(kAround), line.size()));
  return line;
}

json FromLine(std::string_view line, const Descriptor& type) {
  line = FromFirstLetter(line);
  const size_t end = FirstPartLength(line);
  const size_t rest = std::min(line.find_first_not_of(" \t:=*\"'`])", end), line.size());
  json object = json::object();
  object[type.field(0)->name()] = std::string(line.substr(0, end));
  object[type.field(1)->name()] = json::array({std::string(line.substr(rest))});
  return object;
}

// Letters and digits: "s12".
bool IsId(std::string_view text) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  return std::ranges::all_of(text, IsOfAName) && std::ranges::any_of(text, is_digit) && !is_digit(text.front());
}

// Whether a line begins with what its list may speak of, and a colon.
bool IsLineOf(std::string_view line, const Choices* choices) {
  line = FromFirstLetter(line);
  const size_t end = FirstPartLength(line);
  const size_t colon = line.find_first_not_of(kAround, end);
  if (end == 0 || colon == std::string_view::npos || line[colon] != ':') return false;
  const std::string_view first = line.substr(0, end);
  if (choices != nullptr) return FindChoice(first, *choices).has_value();
  return IsId(first.substr(0, first.find_first_of(" ,+&")));
}

bool Has(const json& object, const std::string& name) {
  const std::string bare = Bare(name);
  return std::any_of(object.items().begin(), object.items().end(),
                     [&](const auto& item) { return Bare(item.key()) == bare; });
}

}  // namespace

json ListOfLines(const json& value, const Descriptor& type) {
  json list = json::array();
  const auto add = [&](const json& item) {
    // The object of an element as a text of its own.
    const json inner = item.is_string() ? JsonIn(item.get_ref<const std::string&>()) : json();
    const bool line = item.is_string() && !inner.is_object();
    list.push_back(line ? FromLine(item.get_ref<const std::string&>(), type) : item.is_string() ? inner : item);
  };
  const json whole = value.is_string() ? JsonIn(value.get_ref<const std::string&>()) : json();
  if (whole.is_structured()) return ListOfLines(whole, type);
  if (value.is_string()) {
    std::string_view text = value.get_ref<const std::string&>();
    while (!text.empty()) {
      const size_t end = std::min(text.find('\n'), text.size());
      if (end > 0) list.push_back(FromLine(text.substr(0, end), type));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
  } else if (value.is_object() && !Has(value, type.field(0)->name())) {
    for (const auto& [name, words] : value.items()) {
      json& object = list.emplace_back(json::object());
      object[type.field(0)->name()] = name;
      object[type.field(1)->name()] = words;
    }
  } else if (value.is_array()) {
    for (const json& item : value) add(item);
  } else {
    add(value);
  }
  return list;
}

json AnswerOfLines(std::string_view answer, const Descriptor& type, const FieldChoices& choices) {
  json lines = json::array();
  if (type.field_count() == 1 && FactsOf(*type.field(0)).line()) {
    const FieldTexts texts(*type.field(0)->message_type()->field(0), choices);
    while (!answer.empty()) {
      const size_t end = std::min(answer.find('\n'), answer.size());
      const std::string line = PlainSpaces(ToUtf8(answer.substr(0, end)));
      if (IsLineOf(line, texts.get())) lines.push_back(line);
      answer.remove_prefix(std::min(end + 1, answer.size()));
    }
  }
  if (lines.empty()) return json(json::value_t::discarded);
  return json::object({{type.field(0)->name(), std::move(lines)}});
}

}  // namespace flair::llm
