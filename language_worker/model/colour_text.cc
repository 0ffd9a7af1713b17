// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/model/colour_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <nlohmann/json.hpp>
#include <string>

#include "language_worker/handbook/styling/choose_style.h"
#include "language_worker/model/furniture_index.h"
#include "llm/answers/utf8.h"

namespace flair::language {
namespace {

constexpr size_t kLongestName = 60;

using Triple = std::array<int, 3>;

bool IsHexDigit(char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }

int HexValue(std::string_view digits) {
  int value = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  return value;
}

// A colour's value and where it stands in a text.
struct Value {
  Triple triple = {};
  size_t begin = 0, end = 0;
};

// The three numbers behind "rgb(".
std::optional<Value> FindTriple(std::string_view text) {
  Value value;
  value.begin = text.find("rgb");
  if (value.begin == std::string_view::npos) return std::nullopt;
  const char* at = text.data() + value.begin;
  const char* const end = text.data() + text.size();
  for (int& number : value.triple) {
    while (at != end && (*at < '0' || *at > '9')) ++at;
    const auto [stop, error] = std::from_chars(at, end, number);
    if (error != std::errc() || number > 255) return std::nullopt;
    at = stop;
  }
  value.end = std::min(text.find(')', static_cast<size_t>(at - text.data())), text.size() - 1) + 1;
  return value;
}

// Whether six hex digits are a value and no word: "B98B55", "FFEEDD", not "facade".
bool IsValue(std::string_view digits) {
  return std::any_of(digits.begin(), digits.end(), [](char c) { return c <= '9'; }) ||
         std::all_of(digits.begin(), digits.end(), [](char c) { return c <= 'F'; });
}

// Six hex digits, or behind "#" three, or eight of which the last two say how opaque it is.
std::optional<Value> FindHex(std::string_view text) {
  for (size_t begin = 0; begin < text.size(); ++begin) {
    const bool marked = text[begin] == '#';
    const bool inside = begin > 0 && std::isalnum(static_cast<unsigned char>(text[begin - 1])) != 0;
    const size_t first = begin + (marked ? 1 : 0);
    size_t end = first;
    while (end < text.size() && IsHexDigit(text[end])) ++end;
    const bool cut = end < text.size() && std::isalnum(static_cast<unsigned char>(text[end])) != 0;
    const std::string_view digits = text.substr(first, end - first);
    if (inside || cut || (digits.size() != 6 && !(marked && (digits.size() == 3 || digits.size() == 8)))) continue;
    if (!marked && !IsValue(digits)) continue;
    Value value{{}, begin, end};
    for (size_t i = 0; i < 3; ++i) {
      value.triple[i] = digits.size() >= 6 ? HexValue(digits.substr(2 * i, 2)) : 17 * HexValue(digits.substr(i, 1));
    }
    return value;
  }
  return std::nullopt;
}

// {"name": "sage", "hex": "#7A8B6F"} as "sage #7A8B6F".
std::string WithoutJson(std::string_view text) {
  const nlohmann::json value = nlohmann::json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (!value.is_structured()) return std::string(text);
  std::string parts, hex;
  for (const nlohmann::json& member : value) {
    if (!member.is_string()) continue;
    const auto& part = member.get_ref<const std::string&>();
    (part.starts_with("#") ? hex : parts) += part + " ";
  }
  return parts + hex;
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

std::optional<v1::Colour> ReadColour(std::string_view written, const Handbook& handbook) {
  const std::string text =
      written.starts_with('{') || written.starts_with('[') ? WithoutJson(written) : std::string(written);
  v1::Colour colour;
  std::optional<Value> value = FindHex(text);
  if (!value) value = FindTriple(text);
  if (!value) {
    const std::string name = NameIn(text.substr(0, text.find('#')));
    const hb::NamedColour* named = FindNamed(name, handbook);
    if (named == nullptr) return std::nullopt;
    colour = ToColour(*named);
    colour.set_name(name);
    return colour;
  }
  colour.set_red(value->triple[0]);
  colour.set_green(value->triple[1]);
  colour.set_blue(value->triple[2]);
  std::string name = NameIn(text.substr(0, value->begin));
  if (name.empty()) name = NameIn(text.substr(value->end));
  colour.set_name(name);
  return colour;
}

}  // namespace flair::language
