// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/sentences/fill.h"

#include <cctype>
#include <sstream>
#include <vector>

#include "language_worker/handbook/reading/words.h"

namespace flair::language {
namespace {

using Words = std::vector<std::string>;

// Whether "an" stands before a word: by its first letter, unless it sounds otherwise ("an honest clock", "a unique
// one").
bool TakesAn(const std::string& word) {
  if (IsIn("with_an", word) || IsIn("with_a", word)) return IsIn("with_an", word);
  return std::string_view("aeiouAEIOU").find(word[0]) != std::string_view::npos;
}

// Whether the `length` words from `first` on are those from `second` on, the latter perhaps with a sign behind.
bool Same(const Words& words, std::size_t first, std::size_t second, std::size_t length) {
  if (second + length > words.size()) return false;
  for (std::size_t i = 0; i < length; ++i) {
    std::string_view other = words[second + i];
    if (i + 1 == length && !other.empty() && std::ispunct(static_cast<unsigned char>(other.back())) != 0) {
      other.remove_suffix(1);
    }
    if (words[first + i] != other) return false;
  }
  return true;
}

// Takes out the first of two equal runs of up to three words, next to each other or with one word between them.
void DropEchoes(Words& words) {
  for (std::size_t length = 3; length >= 1; --length) {
    for (std::size_t i = 0; i + length < words.size(); ++i) {
      const bool noun = words[i].size() >= 3 && words[i] != "the" && words[i] != "its" && words[i] != "and";
      const bool between = length == 1 && noun && Same(words, i, i + 2, 1);
      if (Same(words, i, i + length, length) || (between && words[i + 1] != "and" && words[i + 1] != "or")) {
        words.erase(words.begin() + static_cast<std::ptrdiff_t>(i),
                    words.begin() + static_cast<std::ptrdiff_t>(i + length));
      }
    }
  }
}

}  // namespace

std::string Polish(std::string_view text) {
  std::istringstream stream{std::string(text)};
  Words words;
  for (std::string word; stream >> word;) words.push_back(word);
  DropEchoes(words);
  std::string polished;
  bool begins = true;
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::string& word = words[i];
    if ((word == "a" || word == "A") && i + 1 < words.size() && TakesAn(words[i + 1])) word += "n";
    if (begins) word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
    begins = word.back() == '.';
    polished += (i > 0 ? " " : "") + word;
  }
  return polished;
}

std::string Fill(std::string_view text, const std::map<std::string, std::string, std::less<>>& values) {
  std::string filled;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t close = text[i] == '{' ? text.find('}', i) : std::string_view::npos;
    const auto value = close == std::string_view::npos ? values.end() : values.find(text.substr(i + 1, close - i - 1));
    if (value == values.end()) {
      filled += text[i++];
    } else {
      filled += value->second;
      i = close + 1;
    }
  }
  return filled;
}

}  // namespace flair::language
