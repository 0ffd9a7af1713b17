// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/explain/sentence_words.h"

#include <algorithm>
#include <array>

#include "fmt/format.h"

namespace flair::cli {
namespace {

char Lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool IsWordCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

// Characters of `text` from `at` on that say `name`, whole words in any case; 0 when they do not.
size_t NameAt(std::string_view text, size_t at, std::string_view name) {
  if (name.empty() || text.size() < at + name.size()) return 0;
  for (size_t i = 0; i < name.size(); ++i) {
    if (Lower(text[at + i]) != Lower(name[i])) return 0;
  }
  const size_t end = at + name.size();
  return end < text.size() && IsWordCharacter(text[end]) ? 0 : name.size();
}

size_t LongestNameAt(std::string_view text, size_t at, const std::vector<std::string>& names) {
  size_t longest = 0;
  for (const std::string& name : names) longest = std::max(longest, NameAt(text, at, name));
  return longest;
}

// Behind a name, "'s" or a word that no longer name of a thing would begin with.
bool EndsName(std::string_view rest) {
  static constexpr std::array<std::string_view, 24> kVerbs = {
      "is",    "are",  "has",  "have", "does", "do",  "should", "must", "faces", "face",  "stands", "stand",
      "hangs", "hang", "lies", "lie",  "sits", "sit", "looks",  "look", "rests", "needs", "leans",  "opens"};
  if (rest.empty() || rest.front() != ' ') return rest.empty();
  return std::any_of(kVerbs.begin(), kVerbs.end(), [&](std::string_view verb) { return NameAt(rest, 1, verb) > 0; });
}

// Whether the verb behind a name is that of several: "The wall hooks hang ...". "should" and "must" say nothing of
// that.
bool BeginsWithPlural(std::string_view rest) {
  static constexpr std::array<std::string_view, 9> kVerbs = {"are",  "have", "do",  "face", "stand",
                                                             "hang", "lie",  "sit", "look"};
  return std::any_of(kVerbs.begin(), kVerbs.end(), [&](std::string_view verb) { return NameAt(rest, 1, verb) > 0; });
}

// The name at `at` behind an optional "the": where it ends; 0 when it is not there.
size_t EndOfName(std::string_view text, size_t at, const std::vector<std::string>& names,
                 const std::vector<std::string>& others) {
  if (NameAt(text, at, "the") > 0 && text.size() > at + 4) at += 4;
  const size_t length = LongestNameAt(text, at, names);
  return length == 0 || LongestNameAt(text, at, others) > length ? 0 : at + length;
}

}  // namespace

std::string AboutIt(std::string_view sentence, const std::vector<std::string>& names,
                    const std::vector<std::string>& others) {
  while (!sentence.empty() && (sentence.back() == '.' || sentence.back() == ' ')) sentence.remove_suffix(1);
  if (const size_t end = EndOfName(sentence, 0, names, others); end > 0) {
    const std::string_view rest = sentence.substr(end);
    if (rest.starts_with("'s ")) return fmt::format("Its{}", rest.substr(2));
    if (EndsName(rest)) return fmt::format("{}{}", BeginsWithPlural(rest) ? "They" : "It", rest);
  }
  // "The front of the desk ...", "Both long sides of the bed ...".
  const size_t of = sentence.find(" of ");
  if (of == std::string_view::npos ||
      std::count(sentence.begin(), sentence.begin() + static_cast<std::ptrdiff_t>(of), ' ') > 3) {
    return std::string(sentence);
  }
  const size_t end = EndOfName(sentence, of + 4, names, others);
  if (end == 0 || !EndsName(sentence.substr(end))) return std::string(sentence);
  const std::string_view part = sentence.substr(0, of), rest = sentence.substr(end);
  if (NameAt(part, 0, "the") > 0) return fmt::format("Its{}{}", part.substr(3), rest);
  if (NameAt(part, 0, "both") > 0) return fmt::format("Both its{}{}", part.substr(4), rest);
  return std::string(sentence);
}

std::string Capital(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

}  // namespace flair::cli
