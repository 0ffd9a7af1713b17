// SPDX-License-Identifier: GPL-3.0-or-later
#include "english/lexicon.h"

#include <algorithm>
#include <utility>

#include "english/words.h"

namespace flair::english {

struct PhraseBook::Search {
  const std::vector<Token>& tokens;
  size_t end;  // no match reaches beyond it
  bool last_form;
};

void PhraseBook::Add(std::string_view phrase, int value) {
  size_t at = 0;
  entries_.push_back({Parse(phrase, at), value});
  const size_t entry = entries_.size() - 1;
  const Sequence& sequence = entries_.back().sequence;
  std::vector<std::string> first;
  FirstWords({&sequence, 0, nullptr}, first);
  std::ranges::sort(first);
  first.erase(std::unique(first.begin(), first.end()), first.end());
  for (const std::string& word : first) {
    by_first_word_[word].push_back(entry);
    by_singular_[Singular(word)].push_back(entry);
  }
}

PhraseBook::Sequence PhraseBook::Parse(std::string_view text, size_t& at) {
  Sequence sequence;
  while (at < text.size() && text[at] != ']' && text[at] != ')' && text[at] != '|') {
    if (text[at] == ' ') {
      ++at;
    } else if (text[at] == '[' || text[at] == '(') {
      Element element;
      element.optional = text[at] == '[';
      do {
        element.choices.push_back(Parse(text, ++at));
      } while (at < text.size() && text[at] == '|');
      ++at;
      sequence.push_back(std::move(element));
    } else {
      const size_t end = std::min(text.find_first_of(" []()|", at), text.size());
      sequence.push_back({std::string(text.substr(at, end - at)), {}, false});
      at = end;
    }
  }
  return sequence;
}

void PhraseBook::FirstWords(const Rest& rest, std::vector<std::string>& words) {
  if (rest.next == rest.sequence->size()) {
    if (rest.outer != nullptr) FirstWords(*rest.outer, words);
    return;
  }
  const Element& element = (*rest.sequence)[rest.next];
  const Rest after{rest.sequence, rest.next + 1, rest.outer};
  if (!element.word.empty()) words.push_back(element.word);
  for (const Sequence& choice : element.choices) FirstWords({&choice, 0, &after}, words);
  if (element.optional) FirstWords(after, words);
}

void PhraseBook::Step(const Search& search, size_t at, const Rest& rest, size_t& longest) {
  if (rest.next == rest.sequence->size()) {
    if (rest.outer == nullptr) {
      longest = std::max(longest, at);
    } else {
      Step(search, at, *rest.outer, longest);
    }
    return;
  }
  const Element& element = (*rest.sequence)[rest.next];
  const Rest after{rest.sequence, rest.next + 1, rest.outer};
  if (!element.word.empty()) {
    if (at >= search.end) return;
    const std::string& text = search.tokens[at].text;
    const bool last = rest.outer == nullptr && after.next == rest.sequence->size();
    if (text == element.word || (search.last_form && last && IsFormOf(text, element.word)))
      Step(search, at + 1, after, longest);
    return;
  }
  for (const Sequence& choice : element.choices) Step(search, at, {&choice, 0, &after}, longest);
  if (element.optional) Step(search, at, after, longest);
}

PhraseBook::Match PhraseBook::Find(const std::vector<Token>& tokens, size_t at, size_t max_length,
                                   bool last_form) const {
  Match best;
  if (at >= tokens.size() || tokens[at].text.empty()) return best;
  const auto& index = last_form ? by_singular_ : by_first_word_;
  const auto found = index.find(last_form ? Singular(tokens[at].text) : tokens[at].text);
  if (found == index.end()) return best;
  const Search search{tokens, std::min(tokens.size(), at + max_length), last_form};
  for (const size_t entry : found->second) {
    size_t end = at;
    Step(search, at, {&entries_[entry].sequence, 0, nullptr}, end);
    if (end - at > best.length) best = {entries_[entry].value, end - at};
  }
  return best;
}

std::vector<std::pair<std::string, int>> PhraseBook::SingleWords() const {
  std::vector<std::pair<std::string, int>> words;
  for (const Entry& entry : entries_) {
    std::vector<std::string> first;
    FirstWords({&entry.sequence, 0, nullptr}, first);
    for (const std::string& word : first) {
      std::vector<Token> alone(1);
      alone[0].text = word;
      size_t end = 0;
      Step({alone, 1, false}, 0, {&entry.sequence, 0, nullptr}, end);
      if (end == 1) words.emplace_back(word, entry.value);
    }
  }
  return words;
}

const Lexicon& Lexicon::Get() {
  static const auto* const lexicon = new Lexicon(Language::Get().data());
  return *lexicon;
}

Lexicon::Lexicon(const v1::Language& data) {
  for (const v1::Phrases& group : data.phrases()) {
    const int value = static_cast<int>(meanings_.size());
    meanings_.emplace_back(group.word_class(), group.lemma());
    for (const std::string& phrase : group.phrases()) phrases_.Add(phrase, value);
  }
  for (const auto& [word, value] : phrases_.SingleWords()) {
    const std::string stem = Stem(word);
    if (!stem.empty() && meanings_[value].first == v1::WORD_CLASS_RELATION) by_stem_.emplace(stem, value);
  }
}

Phrase Lexicon::Find(const std::vector<Token>& tokens, size_t at, size_t max_length) const {
  const PhraseBook::Match match = phrases_.Find(tokens, at, max_length);
  if (match.length == 0) return {};
  return {meanings_[match.value].first, meanings_[match.value].second, match.length};
}

Phrase Lexicon::FindForm(const Token& token) const {
  if (token.kind != Token::Kind::kWord) return {};
  const auto found = by_stem_.find(Stem(token.text));
  if (found == by_stem_.end()) return {};
  return {meanings_[found->second].first, meanings_[found->second].second, 1};
}

}  // namespace flair::english
