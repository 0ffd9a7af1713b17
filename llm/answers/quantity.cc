// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/quantity.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <numbers>
#include <string>

#include "llm/answers/utf8.h"

namespace flair::llm {
namespace {

struct UnitName {
  std::string_view unit;
  std::string_view name;
  double factor;
};

constexpr std::array kUnits = std::to_array<UnitName>({
    {"m", "m", 1},
    {"m", "metre", 1},
    {"m", "metres", 1},
    {"m", "meter", 1},
    {"m", "meters", 1},
    {"m", "cm", 0.01},
    {"m", "centimetre", .01},
    {"m", "centimetres", 0.01},
    {"m", "centimeter", .01},
    {"m", "centimeters", .01},
    {"m", "mm", 0.001},
    {"m", "millimetres", 0.001},
    {"m", "millimeters", 0.001},
    {"m", "in", 0.0254},
    {"m", "inch", 0.0254},
    {"m", "inches", 0.0254},
    {"m", "\"", 0.0254},
    {"m", "''", 0.0254},
    {"m", "ft", 0.3048},
    {"m", "foot", 0.3048},
    {"m", "feet", 0.3048},
    {"m", "'", 0.3048},
    {"m", "yd", 0.9144},
    {"m", "yards", 0.9144},
    {"deg", "deg", 1},
    {"deg", "degree", 1},
    {"deg", "degrees", 1},
    {"deg", "°", 1},
    {"deg", "rad", 180 / std::numbers::pi},
    {"deg", "radians", 180 / std::numbers::pi},
});

constexpr std::array<std::string_view, 13> kWords = {"zero",  "one",   "two",  "three", "four",   "five",  "six",
                                                     "seven", "eight", "nine", "ten",   "eleven", "twelve"};

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

void SkipSpace(std::string_view& text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
}

bool TakePrefix(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

// Fractions that are one character.
struct Fraction {
  std::string_view character;
  std::string_view plain;
};
constexpr std::array kFractions = std::to_array<Fraction>(
    {{"½", " 1/2"}, {"¼", " 1/4"}, {"¾", " 3/4"}, {"⅓", " 1/3"}, {"⅔", " 2/3"}, {"⅛", " 1/8"}, {"⁄", "/"}});

// Lower case, primes as quotes, fractions as people type them.
std::string Plain(std::string_view written) {
  std::string plain;
  const std::string text = PlainSpaces(ToUtf8(written));
  for (size_t i = 0; i < text.size(); ++i) {
    if (static_cast<unsigned char>(text[i]) < 0x80) {
      plain += text[i] >= 'A' && text[i] <= 'Z' ? static_cast<char>(text[i] - 'A' + 'a') : text[i];
      continue;
    }
    const std::string_view rest = std::string_view(text).substr(i);
    const auto* const fraction =
        std::ranges::find_if(kFractions, [&](const Fraction& known) { return rest.starts_with(known.character); });
    if (fraction != kFractions.end()) {
      plain += fraction->plain;
      i += fraction->character.size() - 1;
    } else if (rest.starts_with("−")) {
      plain += '-';
      i += 2;
    } else if (rest.starts_with("′") || rest.starts_with("’")) {
      plain += '\'';
      i += 2;
    } else if (rest.starts_with("″") || rest.starts_with("”")) {
      plain += '"';
      i += 2;
    } else {
      plain += text[i];
    }
  }
  return plain;
}

// "3/4" at the start, of whole numbers up to 99.
std::optional<double> TakeFraction(std::string_view& text) {
  int above = 0, below = 0;
  const char* const end = text.data() + text.size();
  const auto [bar, bad_above] = std::from_chars(text.data(), end, above);
  if (bad_above != std::errc() || bar == end || *bar != '/') return std::nullopt;
  const auto [stop, bad_below] = std::from_chars(bar + 1, end, below);
  constexpr int kMost = 99;
  if (bad_below != std::errc() || above < 1 || above > kMost || below < 2 || below > kMost) return std::nullopt;
  text.remove_prefix(static_cast<size_t>(stop - text.data()));
  return static_cast<double>(above) / below;
}

// A number at the start: digits with a point, or with a comma before one or two decimals.
std::optional<double> TakeNumber(std::string_view& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return std::nullopt;
  // "inf", "nan" and the like are no numbers here.
  const char last = *(end - 1);
  if (!IsDigit(last) && last != '.') return std::nullopt;
  const std::string_view number = text.substr(0, static_cast<size_t>(end - text.data()));
  if (const std::optional<double> fraction = TakeFraction(text)) return fraction;
  text.remove_prefix(number.size());
  // "1 1/2"
  if (std::ranges::all_of(number, IsDigit) && text.starts_with(' ')) {
    std::string_view rest = text;
    SkipSpace(rest);
    if (const std::optional<double> fraction = TakeFraction(rest); fraction && *fraction < 1) {
      text = rest;
      return value + *fraction;
    }
  }
  if (!text.starts_with(',')) return value;
  size_t decimals = 1;
  while (decimals < text.size() && IsDigit(text[decimals])) ++decimals;
  --decimals;
  if (decimals < 1 || decimals > 2 || number.find('.') != std::string_view::npos) return std::nullopt;
  const std::string with_point = std::string(number) + '.' + std::string(text.substr(1, decimals));
  text.remove_prefix(decimals + 1);
  if (std::from_chars(with_point.data(), with_point.data() + with_point.size(), value).ec != std::errc()) {
    return std::nullopt;
  }
  return value;
}

// "two", alone or before a space.
std::optional<double> TakeWord(std::string_view& text) {
  const std::string_view word = text.substr(0, text.find(' '));
  const auto* const found = std::ranges::find(kWords, word);
  if (found == kWords.end()) return std::nullopt;
  text.remove_prefix(word.size());
  return static_cast<double>(found - kWords.begin());
}

// The factor of the unit's name at the start; nothing when it is none of `unit`.
std::optional<double> TakeUnit(std::string_view& text, std::string_view unit) {
  const UnitName* best = nullptr;
  for (const UnitName& candidate : kUnits) {
    if (candidate.unit != unit || !text.starts_with(candidate.name)) continue;
    const std::string_view behind = text.substr(candidate.name.size());
    const char last = candidate.name.back();
    const bool word = last >= 'a' && last <= 'z';
    if (word && !behind.empty() && behind.front() >= 'a' && behind.front() <= 'z') continue;
    if (best == nullptr || candidate.name.size() > best->name.size()) best = &candidate;
  }
  if (best == nullptr) return std::nullopt;
  text.remove_prefix(best->name.size());
  return best->factor;
}

void SkipAbout(std::string_view& text) {
  for (const std::string_view about :
       {"~", "≈", "about ", "around ", "approximately ", "approx. ", "approx ", "circa ", "ca. ", "c. "}) {
    if (TakePrefix(text, about)) break;
  }
  SkipSpace(text);
}

bool OnlyNoiseLeft(std::string_view text) {
  SkipSpace(text);
  for (const std::string_view noise : {"wide", "deep", "long", "high", "tall", "each"}) {
    if (TakePrefix(text, noise)) break;
  }
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.remove_suffix(1);
  return text.empty();
}

}  // namespace

std::string_view UnitNamed(std::string_view bare, std::string_view unit) {
  for (const UnitName& candidate : kUnits) {
    if (candidate.unit == unit && candidate.name == bare) return candidate.name;
  }
  return {};
}

std::optional<double> ReadQuantity(std::string_view written, std::string_view unit) {
  if (written.size() > 60) return std::nullopt;
  const std::string plain = Plain(written);
  std::string_view text = plain;
  SkipSpace(text);
  SkipAbout(text);
  TakePrefix(text, "+");
  std::optional<double> value = TakeWord(text);
  if (!value) value = TakeNumber(text);
  if (!value) return std::nullopt;
  SkipSpace(text);
  if (const std::optional<double> factor = TakeUnit(text, unit)) {
    *value *= *factor;
    SkipSpace(text);
    // A second, smaller part: "5 ft 6 in".
    std::string_view rest = text;
    if (const std::optional<double> more = TakeNumber(rest)) {
      SkipSpace(rest);
      const std::optional<double> smaller = TakeUnit(rest, unit);
      if (!smaller || *smaller >= *factor || *more < 0) return std::nullopt;
      *value += *more * *smaller;
      text = rest;
    }
  }
  if (!OnlyNoiseLeft(text)) return std::nullopt;
  return value;
}

std::optional<double> ReadCount(std::string_view written) {
  if (const std::optional<double> count = ReadQuantity(written, "")) return count;
  const std::string plain = Plain(written);
  std::string_view text = plain;
  SkipSpace(text);
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.remove_suffix(1);
  for (const std::string_view times : {"x", "×"}) {
    if (TakePrefix(text, times)) return ReadQuantity(text, "");
  }
  for (const std::string_view things : {"x", "×", "pieces", "piece", "pcs", "pc", "units", "unit", "items", "item"}) {
    if (text.ends_with(things)) return ReadQuantity(text.substr(0, text.size() - things.size()), "");
  }
  return std::nullopt;
}

std::optional<QuantityRange> ReadRange(std::string_view written, std::string_view unit) {
  if (written.size() > 60) return std::nullopt;
  const std::string plain = PlainMarks(Plain(written));
  for (const std::string_view between : {" to ", " or ", "-", ".."}) {
    const size_t at = plain.find(between);
    if (at == 0 || at == std::string::npos) continue;
    std::string first = plain.substr(0, at);
    const std::string second = plain.substr(at + between.size());
    const std::optional<double> most = ReadQuantity(second, unit);
    // A unit behind the second number is that of both.
    const size_t digits = second.find_last_of("0123456789");
    if (digits != std::string::npos && ReadQuantity(first, "")) first += second.substr(digits + 1);
    const std::optional<double> least = ReadQuantity(first, unit);
    if (least && most && *least >= 0 && *least <= *most) return QuantityRange{*least, *most};
  }
  return std::nullopt;
}

}  // namespace flair::llm
