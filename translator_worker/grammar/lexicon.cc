// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/lexicon.h"

#include <algorithm>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/str_split.h"

namespace flair::translator {
namespace {

using Words = std::vector<std::string>;

// Reads phrase[at...] up to `stop` characters; each element multiplies the variants.
class PhraseReader {
 public:
  explicit PhraseReader(std::string_view text) : text_(text) {}

  std::vector<Words> Sequence() {
    std::vector<Words> variants(1);
    while (at_ < text_.size() && text_[at_] != ']' && text_[at_] != ')' && text_[at_] != '|') {
      const char c = text_[at_];
      if (c == ' ') {
        ++at_;
      } else if (c == '[' || c == '(') {
        ++at_;
        std::vector<Words> inner = Alternatives();
        if (c == '[') inner.emplace_back();
        variants = Product(variants, inner);
      } else {
        const size_t end = std::min(text_.find_first_of(" []()|", at_), text_.size());
        variants = Product(variants, {{std::string(text_.substr(at_, end - at_))}});
        at_ = end;
      }
    }
    return variants;
  }

 private:
  std::vector<Words> Alternatives() {
    std::vector<Words> all = Sequence();
    while (at_ < text_.size() && text_[at_] == '|') {
      ++at_;
      for (Words& words : Sequence()) all.push_back(std::move(words));
    }
    ++at_;
    return all;
  }

  static std::vector<Words> Product(const std::vector<Words>& left, const std::vector<Words>& right) {
    std::vector<Words> result;
    for (const Words& a : left) {
      for (const Words& b : right) {
        Words both = a;
        both.insert(both.end(), b.begin(), b.end());
        result.push_back(std::move(both));
      }
    }
    return result;
  }

  const std::string_view text_;
  size_t at_ = 0;
};

// Splits at | outside brackets.
std::vector<std::string_view> TopLevelParts(std::string_view text) {
  std::vector<std::string_view> parts;
  int depth = 0;
  size_t begin = 0;
  for (size_t i = 0; i <= text.size(); ++i) {
    if (i == text.size() || (text[i] == '|' && depth == 0)) {
      parts.push_back(text.substr(begin, i - begin));
      begin = i + 1;
    } else if (text[i] == '[' || text[i] == '(') {
      ++depth;
    } else if (text[i] == ']' || text[i] == ')') {
      --depth;
    }
  }
  return parts;
}

WordClass ClassOf(std::string_view name) {
  static const std::map<std::string_view, WordClass> classes = {
      {"relation", WordClass::kRelation}, {"filler", WordClass::kFiller},   {"modal", WordClass::kModal},
      {"wish", WordClass::kWish},         {"purpose", WordClass::kPurpose}, {"condition", WordClass::kCondition},
      {"not", WordClass::kNot},           {"side", WordClass::kSide},       {"feature", WordClass::kFeature},
      {"place", WordClass::kPlace},       {"area", WordClass::kArea},       {"group", WordClass::kGroup},
      {"pronoun", WordClass::kPronoun},   {"vague", WordClass::kVague},     {"quantity", WordClass::kQuantity},
      {"ordinal", WordClass::kOrdinal},   {"and", WordClass::kAnd},         {"or", WordClass::kOr}};
  return classes.at(name);
}

// The word without the ending of its form: "overlapping", "overlaps" and "overlap" share one. Empty for short words.
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

}  // namespace

std::vector<std::vector<std::string>> ExpandPhrase(std::string_view phrase) {
  std::vector<Words> variants = PhraseReader(phrase).Sequence();
  std::erase_if(variants, [](const Words& words) { return words.empty(); });
  return variants;
}

const Lexicon& Lexicon::Get() {
  static const Lexicon* const lexicon = new Lexicon(std::string(LexiconRelations()) + std::string(LexiconEntries()));
  return *lexicon;
}

Lexicon::Lexicon(std::string_view entries) {
  std::string joined(entries);
  // A line that begins with a space continues the one before.
  for (size_t at = joined.find("\n "); at != std::string::npos; at = joined.find("\n ", at)) joined[at] = ' ';
  for (const std::string& line : std::vector<std::string>(absl::StrSplit(joined, '\n'))) {
    const size_t colon = line.find(':');
    if (colon == std::string::npos) continue;
    const std::vector<std::string> head = absl::StrSplit(line.substr(0, colon), ' ');
    const std::string rest = line.substr(colon + 1);
    for (const std::string_view part : TopLevelParts(rest)) {
      for (Words& words : ExpandPhrase(part)) {
        const Entry entry{words, ClassOf(head[0]), head.size() > 1 ? head[1] : ""};
        const std::string stem = words.size() == 1 ? Stem(words.front()) : "";
        if (!stem.empty() && entry.word_class == WordClass::kRelation) by_stem_.emplace(stem, entry);
        std::vector<Entry>& list = by_first_word_[words.front()];
        list.push_back({std::move(words), ClassOf(head[0]), head.size() > 1 ? head[1] : ""});
      }
    }
  }
  for (auto& [word, list] : by_first_word_) {
    std::stable_sort(list.begin(), list.end(),
                     [](const Entry& a, const Entry& b) { return a.words.size() > b.words.size(); });
  }
}

Phrase Lexicon::FindForm(const Token& token) const {
  if (token.kind != Token::Kind::kWord) return {};
  const auto found = by_stem_.find(Stem(token.text));
  return found == by_stem_.end() ? Phrase{} : Phrase{found->second.word_class, found->second.lemma, 1};
}

Phrase Lexicon::Find(const std::vector<Token>& tokens, size_t at, size_t max_length) const {
  if (at >= tokens.size() || tokens[at].text.empty()) return {};
  const auto found = by_first_word_.find(tokens[at].text);
  if (found == by_first_word_.end()) return {};
  for (const Entry& entry : found->second) {
    bool same = entry.words.size() <= max_length && at + entry.words.size() <= tokens.size();
    for (size_t i = 0; same && i < entry.words.size(); ++i) same = tokens[at + i].text == entry.words[i];
    if (same) return {entry.word_class, entry.lemma, entry.words.size()};
  }
  return {};
}

}  // namespace flair::translator
