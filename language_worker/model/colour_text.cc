// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/model/colour_text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string>

#include "language_worker/handbook/styling/choose_style.h"
#include "language_worker/model/furniture_index.h"
#include "llm/answers/utf8.h"

namespace flair::language {
namespace {

constexpr size_t kLongestName = 60;
constexpr size_t kValueLength = 7;  // "#7A8B6F"

// Where "#" and six hex digits stand in a text; npos for nowhere.
size_t FindValue(std::string_view text) {
  for (size_t at = text.find('#'); at != std::string_view::npos; at = text.find('#', at + 1)) {
    const std::string_view digits = text.substr(at + 1, kValueLength - 1);
    const auto is_digit = [](unsigned char c) { return std::isxdigit(c) != 0; };
    const bool longer =
        at + kValueLength < text.size() && is_digit(static_cast<unsigned char>(text[at + kValueLength]));
    if (digits.size() == kValueLength - 1 && !longer && std::ranges::all_of(digits, is_digit)) return at;
  }
  return std::string_view::npos;
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
  v1::Colour colour;
  const size_t at = FindValue(text);
  if (at == std::string_view::npos) {
    const std::string name = NameIn(text.substr(0, text.find('#')));
    const hb::NamedColour* named = FindNamed(name, handbook);
    if (named == nullptr) return std::nullopt;
    colour = ToColour(*named);
    colour.set_name(name);
    return colour;
  }
  int value = 0;
  std::from_chars(text.data() + at + 1, text.data() + at + kValueLength, value, 16);
  colour.set_red(value >> 16);
  colour.set_green((value >> 8) & 0xFF);
  colour.set_blue(value & 0xFF);
  std::string name = NameIn(text.substr(0, at));
  if (name.empty()) name = NameIn(text.substr(at + kValueLength));
  colour.set_name(name);
  return colour;
}

}  // namespace flair::language
