// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/assets/words.h"

#include <algorithm>
#include <array>
#include <utility>

namespace flair::renderer {
namespace {

constexpr size_t kMaxWords = 64;
constexpr size_t kMaxWordBytes = 40;
constexpr std::array<std::string_view, 16> kTellNothing = {"a",  "an", "and", "at", "by", "for", "from", "in",
                                                           "is", "it", "of",  "on", "or", "the", "to",   "with"};

bool IsLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || (c & 0x80) != 0;
}

std::string Singular(std::string word) {
  if (word.size() > 3 && word.back() == 's' && word[word.size() - 2] != 's') word.pop_back();
  return word;
}

}  // namespace

std::vector<std::string> WordsOf(std::string_view text) {
  std::vector<std::string> words;
  std::string word;
  const auto finish = [&] {
    const bool told = std::find(kTellNothing.begin(), kTellNothing.end(), word) == kTellNothing.end();
    if (!word.empty() && word.size() <= kMaxWordBytes && told) words.push_back(Singular(std::move(word)));
    word.clear();
  };
  for (const char c : text) {
    if (!IsLetter(c)) {
      finish();
      if (words.size() >= kMaxWords) return words;
    } else {
      word.push_back(c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c);
    }
  }
  finish();
  return words;
}

}  // namespace flair::renderer
