// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/answer_lines.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "llm/answers/choices.h"

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

json FromLine(std::string_view line, const Descriptor& type) {
  line.remove_prefix(std::min(line.find_first_not_of(kAround), line.size()));
  const size_t end = FirstPartLength(line);
  const size_t rest = std::min(line.find_first_not_of(" \t:=\"'`])", end), line.size());
  json object = json::object();
  object[type.field(0)->name()] = std::string(line.substr(0, end));
  object[type.field(1)->name()] = json::array({std::string(line.substr(rest))});
  return object;
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
    list.push_back(item.is_string() ? FromLine(item.get_ref<const std::string&>(), type) : item);
  };
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

}  // namespace flair::llm
