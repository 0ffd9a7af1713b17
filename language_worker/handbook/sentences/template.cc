// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/sentences/template.h"

#include <fmt/format.h>

#include <array>
#include <cctype>

namespace flair::language {
namespace {

constexpr std::array<std::string_view, 26> kKnown = {
    "object", "objects", "target", "targets", "front_m",  "sides_m", "back_m", "side",    "other_side",
    "corner", "zone",    "count",  "n",       "adjective", "material", "colour", "style",  "name",
    "room",   "colour1", "colour2", "colour3", "wall",     "floor",   "wood",   "textile"};

// Calls `found` with each {name}: its position and the name.
template <typename Found>
void ForEachPlaceholder(std::string_view text, Found found) {
  for (std::size_t open = text.find('{'); open != text.npos; open = text.find('{', open + 1)) {
    const std::size_t close = text.find('}', open);
    if (close == text.npos) return;
    found(open, text.substr(open + 1, close - open - 1));
  }
}

bool EndsWith(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

bool IsVowel(char c) { return std::string_view("aeiou").find(c) != std::string_view::npos; }

}  // namespace

std::string FillTemplate(std::string_view text, const TemplateValues& values) {
  std::string filled;
  std::size_t copied = 0;
  ForEachPlaceholder(text, [&](std::size_t open, std::string_view name) {
    const auto value = values.find(name);
    if (value == values.end()) return;
    filled += text.substr(copied, open - copied);
    filled += value->second;
    copied = open + name.size() + 2;
  });
  filled += text.substr(copied);
  return filled;
}

std::vector<std::string> UnknownPlaceholders(std::string_view text) {
  std::vector<std::string> unknown;
  ForEachPlaceholder(text, [&](std::size_t, std::string_view name) {
    bool known = name == "metal";
    for (const std::string_view candidate : kKnown) known = known || candidate == name;
    if (!known) unknown.emplace_back(name);
  });
  return unknown;
}

std::string PluralOf(std::string_view noun) {
  const std::string word(noun);
  if (noun.empty() || EndsWith(noun, "ss") == false && EndsWith(noun, "s")) return word;
  if (EndsWith(noun, "shelf")) return word.substr(0, word.size() - 1) + "ves";
  if (EndsWith(noun, "y") && noun.size() > 1 && !IsVowel(noun[noun.size() - 2])) return word.substr(0, word.size() - 1) + "ies";
  if (EndsWith(noun, "ch") || EndsWith(noun, "sh") || EndsWith(noun, "x") || EndsWith(noun, "ss")) return word + "es";
  return word + "s";
}

std::string NumberWord(int number) {
  constexpr std::array<std::string_view, 13> kWords = {"no",  "one",   "two",   "three", "four", "five",  "six",
                                                       "seven", "eight", "nine", "ten",   "eleven", "twelve"};
  return number >= 0 && number < 13 ? std::string(kWords[static_cast<std::size_t>(number)]) : fmt::format("{}", number);
}

std::string OrdinalWord(int number) {
  constexpr std::array<std::string_view, 12> kWords = {"first",   "second", "third", "fourth", "fifth",    "sixth",
                                                       "seventh", "eighth", "ninth", "tenth",  "eleventh", "twelfth"};
  return number >= 1 && number <= 12 ? std::string(kWords[static_cast<std::size_t>(number - 1)]) : fmt::format("{}th", number);
}

std::string_view ArticleFor(std::string_view word) { return !word.empty() && IsVowel(word[0]) ? "an" : "a"; }

std::string Capitalized(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

}  // namespace flair::language
