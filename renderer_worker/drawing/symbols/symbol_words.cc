// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include "renderer_worker/drawing/symbols/symbol_table.h"

namespace flair::renderer {
namespace {

struct Phrase {
  std::string_view words;
  std::string_view category;
};

#define WORDS(words, category) {words, category},
constexpr Phrase kPhrases[] = {
#include "renderer_worker/drawing/symbols/symbol_words.inc"
};
#undef WORDS

constexpr size_t kLongestPhrase = 3;

std::string_view Lookup(std::string_view words) {
  for (const Phrase& phrase : kPhrases) {
    if (phrase.words == words) return phrase.category;
  }
  return {};
}

// "shelves" stays (it is in the list), "boxes" becomes "box", "candles" "candle"; "glass" stays.
std::string Singular(const std::string& word) {
  const auto ends = [&word](std::string_view suffix) {
    return word.size() > suffix.size() + 1 && word.ends_with(suffix);
  };
  if (ends("ches") || ends("shes") || ends("xes") || ends("sses")) return word.substr(0, word.size() - 2);
  if (ends("s") && !ends("ss") && !ends("us")) return word.substr(0, word.size() - 1);
  return word;
}

std::vector<std::string> WordsOf(std::string_view text) {
  std::vector<std::string> words(1);
  for (const char c : text.substr(0, 200)) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalpha(byte) || byte >= 0x80) {
      words.back() += static_cast<char>(std::tolower(byte));
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

std::string_view CategoryOfWords(std::span<const std::string> words) {
  for (size_t end = words.size(); end > 0; --end) {
    for (size_t length = std::min(kLongestPhrase, end); length > 0; --length) {
      std::string phrase;
      for (size_t i = end - length; i < end; ++i) phrase += (phrase.empty() ? "" : " ") + words[i];
      std::string_view category = Lookup(phrase);
      if (category.empty()) category = Lookup(Singular(phrase));
      if (!category.empty()) return category;
    }
  }
  return {};
}

}  // namespace

std::string_view CategoryFromWords(std::string_view text) {
  const std::vector<std::string> words = WordsOf(text);
  if (const std::string_view whole = CategoryOfWords(std::span(words).last(std::min(kLongestPhrase, words.size())));
      !whole.empty() && words.size() <= kLongestPhrase && std::find(words.begin(), words.end(), "of") == words.end()) {
    return whole;
  }
  // "stack of books with a lamp": what comes before the first small word names the thing, unless it says nothing.
  for (size_t i = 1; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word == "chest" || (word == "of" && words[i - 1] == "chest") || (word == "of" && words[i - 1] == "suit"))
      continue;
    if (word != "of" && word != "with" && word != "for" && word != "on" && word != "in" && word != "and") continue;
    const std::string_view head = CategoryOfWords(std::span(words).first(i));
    if (!head.empty()) return head;
  }
  return CategoryOfWords(words);
}

const Symbol* SymbolFor(const v1::Object& object) {
  const Symbol* box = FindSymbol("box");
  // Names say more than classes: an office chair is a chair, a weight bench a bench.
  const Symbol* symbol = FindSymbol(CategoryFromWords(object.name()));
  if (symbol == nullptr) symbol = FindSymbol(object.category());
  if (symbol == nullptr) symbol = FindSymbol(CategoryFromWords(object.category()));
  if (symbol == nullptr) symbol = FindSymbol(CategoryFromWords(object.id()));
  // The same words mean other things on the floor, on walls and above.
  const Symbol* lamp = FindSymbol("lamp");
  const Symbol* wall_lamp = FindSymbol("wall_lamp");
  const bool above = object.kind() == v1::OBJECT_KIND_CEILING, on_wall = object.kind() == v1::OBJECT_KIND_WALL;
  if (above && (symbol == nullptr || symbol == lamp || symbol == wall_lamp)) return FindSymbol("pendant");
  if (on_wall && symbol == lamp) return wall_lamp;
  if (!on_wall && symbol == wall_lamp) return lamp;
  if (object.walk_over() && symbol == nullptr) return FindSymbol("rug");
  return symbol == nullptr ? box : symbol;
}

}  // namespace flair::renderer
