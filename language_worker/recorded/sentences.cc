// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/recorded/sentences.h"

#include <algorithm>
#include <set>

#include "language_worker/recorded/object_names.h"
#include "llm/answers/utf8.h"

namespace flair::language {
namespace {

constexpr size_t kLongest = 390;

bool EndsSentence(std::string_view line, size_t at) {
  if (line[at] != '.' && line[at] != '!' && line[at] != '?') return false;
  if (at + 2 >= line.size() || line[at + 1] != ' ') return false;
  const char next = line[at + 2];
  if (next < 'A' || next > 'Z') return false;
  // "e.g. Wooden beams"
  return at < 2 || line[at - 2] != '.';
}

}  // namespace

std::vector<std::string> SplitSentences(std::string_view line) {
  std::vector<std::string> sentences;
  size_t begin = 0;
  int open = 0;
  const auto add = [&](size_t end) {
    std::string_view sentence = line.substr(begin, end - begin);
    const size_t first = sentence.find_first_not_of(' ');
    if (first != std::string_view::npos) {
      sentences.push_back(llm::CutBytes(llm::ToUtf8(sentence.substr(first)), kLongest));
    }
    begin = end;
  };
  for (size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '(') ++open;
    if (line[i] == ')') open = std::max(0, open - 1);
    if (open == 0 && EndsSentence(line, i)) add(i + 1);
  }
  add(line.size());
  return sentences;
}

bool IsSize(std::string_view text) {
  static const std::set<std::string, std::less<>> kWords = {"width",     "length",     "x",    "by",  "wide",
                                                            "long",      "each",       "size", "m",   "approximately",
                                                            "dimension", "lengthwise", "and",  "high"};
  for (const Word& word : ReadWords(text)) {
    const bool number = word.key[0] >= '0' && word.key[0] <= '9';
    if (!number && !kWords.contains(word.key)) return false;
  }
  return true;
}

bool HasSize(std::string_view text) {
  const std::vector<Word> words = ReadWords(text);
  return std::any_of(words.begin(), words.end(), [](const Word& word) {
    return word.key.size() > 1 && word.key[0] >= '0' && word.key[0] <= '9' && word.key.back() == 'm';
  });
}

double Likeness(std::string_view a, std::string_view b) {
  const auto keys = [](std::string_view text) {
    static const std::set<std::string, std::less<>> kEmpty = {"the", "a", "an", "be", "is", "to", "of", "for", "it"};
    std::set<std::string, std::less<>> set;
    for (Word& word : ReadWords(text)) {
      if (!kEmpty.contains(word.key)) set.insert(std::move(word.key));
    }
    return set;
  };
  const auto first = keys(a), second = keys(b);
  const size_t least = std::min(first.size(), second.size());
  if (least == 0) return 0;
  const auto common =
      std::count_if(first.begin(), first.end(), [&](const auto& word) { return second.contains(word); });
  return static_cast<double>(common) / static_cast<double>(least);
}

}  // namespace flair::language
