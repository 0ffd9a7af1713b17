// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/json_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <nlohmann/json.hpp>
#include <optional>

namespace flair::llm {
namespace {

// An opening mark and those that may close it.
struct Marks {
  std::string_view open;
  std::array<std::string_view, 3> close;
};
constexpr std::array<Marks, 7> kMarks = {{{"\"", {"\""}},
                                          {"'", {"'"}},
                                          {"“", {"”", "“", "\""}},
                                          {"”", {"”", "“", "\""}},
                                          {"„", {"“", "”", "\""}},
                                          {"‘", {"’", "‘", "'"}},
                                          {"’", {"’", "‘", "'"}}}};

const Marks* MarksAt(std::string_view text) {
  const auto found = std::ranges::find_if(kMarks, [&](const Marks& marks) { return text.starts_with(marks.open); });
  return found == kMarks.end() ? nullptr : &*found;
}

// Bytes at the start that are of no mark, escape or control character.
size_t PlainLength(std::string_view text) {
  size_t length = 0;
  for (; length < text.size(); ++length) {
    const auto c = static_cast<unsigned char>(text[length]);
    // Typographic marks begin with 0xE2.
    if (c < 0x20 || c == '"' || c == '\'' || c == '\\' || c == 0xE2) break;
  }
  return length;
}

// Bytes of the closing mark at the start; 0 for none.
size_t ClosingLength(std::string_view text, const Marks& marks) {
  for (const std::string_view close : marks.close) {
    if (!close.empty() && text.starts_with(close)) return close.size();
  }
  return 0;
}

// Whether JSON goes on so behind a string; a line's end counts too, as a comma may be missing there.
bool EndsString(std::string_view behind) {
  const size_t next = behind.find_first_not_of(" \t\r\n");
  if (next == std::string_view::npos) return true;
  if (std::string_view(",:}]").find(behind[next]) != std::string_view::npos) return true;
  if (FullWidthMark(behind.substr(next)) != 0) return true;
  if (behind.substr(next).starts_with("//") || behind.substr(next).starts_with("/*")) return true;
  return behind.substr(0, next).find('\n') != std::string_view::npos;
}

// The code unit of "\uXXXX" at the start.
std::optional<unsigned> CodeUnit(std::string_view text) {
  if (text.size() < 6 || !text.starts_with("\\u")) return std::nullopt;
  unsigned unit = 0;
  for (const char c : text.substr(2, 4)) {
    if (std::isxdigit(static_cast<unsigned char>(c)) == 0) return std::nullopt;
    const int lower = std::tolower(static_cast<unsigned char>(c));
    unit = unit * 16 + static_cast<unsigned>(lower <= '9' ? lower - '0' : lower - 'a' + 10);
  }
  return unit;
}

// Copies the escape at the start, a backslash and what belongs to it; how many bytes it has.
size_t CopyEscape(std::string_view text, std::string& json) {
  if (text.size() < 2) {
    json += text;
    return text.size();
  }
  if (std::string_view("\"\\/bfnrt").find(text[1]) != std::string_view::npos) {
    json += text.substr(0, 2);
    return 2;
  }
  // One that JSON does not know.
  const std::optional<unsigned> unit = CodeUnit(text);
  if (!unit) return 1;
  const bool high = *unit >= 0xD800 && *unit < 0xDC00, low = *unit >= 0xDC00 && *unit < 0xE000;
  const std::optional<unsigned> next = high ? CodeUnit(text.substr(6)) : std::nullopt;
  if (next && *next >= 0xDC00 && *next < 0xE000) {
    json += text.substr(0, 12);
    return 12;
  }
  json += high || low ? std::string_view("\\ufffd") : text.substr(0, 6);
  return 6;
}

bool IsNumber(std::string_view text) {
  const char first = text.front();
  return (first == '-' || (first >= '0' && first <= '9')) && nlohmann::json::accept(text);
}

// Python's and JavaScript's words as JSON's; nothing for others.
std::string_view KnownWord(std::string_view text) {
  if (text == "true" || text == "True") return "true";
  if (text == "false" || text == "False") return "false";
  const bool none = text == "null" || text == "None" || text == "undefined" || text == "NaN";
  return none ? "null" : std::string_view();
}

}  // namespace

size_t QuoteLength(std::string_view text) {
  const Marks* const marks = MarksAt(text);
  return marks == nullptr ? 0 : marks->open.size();
}

char FullWidthMark(std::string_view text) {
  if (text.starts_with("，")) return ',';
  return text.starts_with("：") ? ':' : '\0';
}

JsonWord ReadQuoted(std::string_view text, std::string& json) {
  const Marks& marks = *MarksAt(text);
  json += '"';
  size_t at = marks.open.size();
  while (at < text.size()) {
    // What needs no second look.
    const size_t plain = PlainLength(text.substr(at));
    json += text.substr(at, plain);
    at += plain;
    if (at == text.size()) break;
    const std::string_view rest = text.substr(at);
    const size_t closing = ClosingLength(rest, marks);
    if (closing > 0 && EndsString(rest.substr(closing))) {
      json += '"';
      return {text.substr(marks.open.size(), at - marks.open.size()), at + closing};
    }
    const char c = rest.front();
    if (c == '\\') {
      at += CopyEscape(rest, json);
      continue;
    }
    if (static_cast<unsigned char>(c) < 0x20) {
      json += fmt::format("\\u{:04x}", static_cast<int>(c));
    } else if (c == '"') {
      json += "\\\"";
    } else {
      json += c;
    }
    ++at;
  }
  return {text.substr(marks.open.size()), text.size()};
}

JsonWord ReadBare(std::string_view text, bool quoted, std::string& json) {
  size_t end = 1;
  while (end < text.size() && std::string_view(",:{}[]\"\r\n").find(text[end]) == std::string_view::npos &&
         !text.substr(end).starts_with("//") && !text.substr(end).starts_with("/*") &&
         FullWidthMark(text.substr(end)) == 0) {
    ++end;
  }
  while (end > 1 && (text[end - 1] == ' ' || text[end - 1] == '\t')) --end;
  const JsonWord word{text.substr(0, end), end};
  if (const std::string_view known = KnownWord(word.content); !known.empty()) {
    json += known;
  } else if (quoted && !IsNumber(word.content)) {
    json += nlohmann::json(word.content).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  } else {
    json += word.content;
  }
  return word;
}

}  // namespace flair::llm
