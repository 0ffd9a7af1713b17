// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/model/colour_text.h"

#include <algorithm>
#include <array>
#include <regex>
#include <string>

#include "language_worker/handbook/styling/choose_style.h"
#include "language_worker/model/object_size.h"
#include "llm/answers/utf8.h"

namespace flair::language {
namespace {

constexpr size_t kLongestName = 60;
// A value where it stands in a text: "#7A8B6F", "#fee", "B98B55" with a digit, since "facade" is a word, "rgb(238, 85,
// 0)".
struct FoundValue {
  v1::Colour colour;
  size_t begin = 0;
  size_t end = 0;
};

std::optional<FoundValue> FindValue(std::string_view text) {
  static const auto* const kValue = new std::regex(
      R"(#([0-9a-f]{6}|[0-9a-f]{3})(?![0-9a-f])|\b((?=[a-f]*[0-9])[0-9a-f]{6})\b|\brgb\(([0-9]{1,3}), *([0-9]{1,3}), *([0-9]{1,3})\))",
      std::regex::icase);
  std::cmatch match;
  if (!std::regex_search(text.data(), text.data() + text.size(), match, *kValue)) return std::nullopt;
  std::array<int, 3> parts = {};
  for (size_t i = 0; i < parts.size(); ++i) {
    const std::string hex = match[1].matched ? match[1].str() : match[2].str();
    const size_t digits = hex.size() / parts.size();
    if (hex.empty()) parts[i] = std::stoi(match[3 + i].str());
    if (!hex.empty()) parts[i] = std::stoi(hex.substr(i * digits, digits), nullptr, 16) * (digits == 1 ? 17 : 1);
    if (parts[i] > 255) return std::nullopt;
  }
  FoundValue found;
  found.begin = static_cast<size_t>(match.position());
  found.end = found.begin + static_cast<size_t>(match.length());
  found.colour.set_red(parts[0]);
  found.colour.set_green(parts[1]);
  found.colour.set_blue(parts[2]);
  return found;
}

std::string NameIn(std::string_view text) {
  constexpr std::string_view kMarks = " \t#()[]:;,.-/|";
  const size_t first = text.find_first_not_of(kMarks);
  if (first == std::string_view::npos) return "";
  text = text.substr(first, text.find_last_not_of(kMarks) - first + 1);
  return llm::CutBytes(std::string(text), kLongestName);
}

// The handbook's colour of that name, else of the end of it: "deep forest green" is a forest green, or a green.
const hb::NamedColour* FindNamed(std::string_view name, const Handbook& handbook) {
  std::string rest = PlainName(name);
  while (!rest.empty()) {
    if (const hb::NamedColour* const named = handbook.FindColour(rest)) return named;
    rest.erase(0, std::min(rest.find(' '), rest.size() - 1) + 1);
  }
  return nullptr;
}

}  // namespace

std::optional<v1::Colour> ReadColour(std::string_view text, const Handbook& handbook) {
  if (std::optional<FoundValue> value = FindValue(text)) {
    std::string name = NameIn(text.substr(0, value->begin));
    if (name.empty()) name = NameIn(text.substr(value->end));
    value->colour.set_name(name);
    return value->colour;
  }
  const std::string name = NameIn(text.substr(0, text.find('#')));
  const hb::NamedColour* named = FindNamed(name, handbook);
  if (named == nullptr) return std::nullopt;
  v1::Colour colour = ToColour(*named);
  colour.set_name(name);
  return colour;
}

}  // namespace flair::language
