// SPDX-License-Identifier: GPL-3.0-or-later
#include "english/words.h"

#include <algorithm>

#include "english/language.h"

namespace flair::english {
namespace {

bool IsVowel(char c) { return c == 'a' || c == 'e' || c == 'i' || c == 'o' || c == 'u'; }

bool EndsInHiss(std::string_view word) {
  return word.ends_with("ch") || word.ends_with("sh") || word.ends_with('x') || word.ends_with("ss") ||
         word.ends_with("zz") || word.ends_with("us");
}

// The irregular form of the word's last part: "bookshelves" ends in "shelves".
template <typename Lookup>
std::string WithIrregularEnd(std::string_view word, const Lookup& lookup) {
  constexpr size_t kShortestFirstPart = 3;
  if (const std::string_view whole = lookup(word); !whole.empty()) return std::string(whole);
  for (size_t cut = kShortestFirstPart; cut + 3 < word.size(); ++cut) {
    const std::string_view end = lookup(word.substr(cut));
    if (!end.empty()) return std::string(word.substr(0, cut)) + std::string(end);
  }
  return "";
}

}  // namespace

std::string Singular(std::string_view word) {
  const Language& language = Language::Get();
  if (!word.ends_with('s') && language.IrregularSingular(word).empty()) {
    // "Footmen", "grandchildren".
    const std::string irregular =
        WithIrregularEnd(word, [&](std::string_view end) { return language.IrregularSingular(end); });
    return irregular.empty() ? std::string(word) : irregular;
  }
  const std::string irregular =
      WithIrregularEnd(word, [&](std::string_view end) { return language.IrregularSingular(end); });
  if (!irregular.empty()) return irregular;
  const auto without = [&](size_t count) { return std::string(word.substr(0, word.size() - count)); };
  if (word.ends_with("ies") && word.size() > 4) return without(3) + "y";
  if (word.ends_with("es") && word.size() > 3 && EndsInHiss(word.substr(0, word.size() - 2)) && !word.ends_with("uses"))
    return without(2);
  const bool singular = word.ends_with("ss") || word.ends_with("us") || word.ends_with("is");
  return singular || word.size() < 3 ? std::string(word) : without(1);
}

std::string Plural(std::string_view word) {
  const Language& language = Language::Get();
  std::string irregular = WithIrregularEnd(word, [&](std::string_view end) { return language.IrregularPlural(end); });
  if (!irregular.empty()) return irregular;
  if (EndsInHiss(word)) return std::string(word) + "es";
  const bool consonant_y = word.size() > 1 && word.ends_with('y') && !IsVowel(word[word.size() - 2]);
  return consonant_y ? std::string(word.substr(0, word.size() - 1)) + "ies" : std::string(word) + "s";
}

bool IsPlural(std::string_view word) { return Singular(word) != word; }

std::string Stem(std::string_view word) {
  constexpr size_t kShortest = 4;
  for (const std::string_view ending : {"ing", "ed", "es", "s", "e"}) {
    if (!word.ends_with(ending) || word.size() < kShortest + ending.size()) continue;
    word.remove_suffix(ending.size());
    const bool doubled = (ending == "ing" || ending == "ed") && word[word.size() - 1] == word[word.size() - 2];
    if (doubled) word.remove_suffix(1);
    if (word.ends_with('e')) word.remove_suffix(1);
    break;
  }
  return word.size() < kShortest ? std::string() : std::string(word);
}

std::string British(std::string_view word) {
  const std::string_view british = Language::Get().BritishSpelling(word);
  return std::string(british.empty() ? word : british);
}

bool IsFormOf(std::string_view word, std::string_view base) {
  if (word == base) return true;
  if (base.size() > 1 && base.ends_with('*')) return word.starts_with(base.substr(0, base.size() - 1));
  // Forms of one word begin alike; most pairs end here.
  if (word.empty() || base.empty() || word[0] != base[0]) return false;
  return British(Singular(word)) == British(Singular(base));
}

bool BeginAlike(std::string_view a, std::string_view b) {
  constexpr size_t kLeast = 4, kMost = 6;
  const size_t shared = std::min({a.size(), b.size(), kMost});
  return a == b || (shared >= kLeast && a.substr(0, shared) == b.substr(0, shared));
}

}  // namespace flair::english
