// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/sentences/forms.h"

#include <algorithm>

#include "english/language.h"
#include "english/words.h"

namespace flair::session {
namespace {

constexpr std::string_view kEdit = "edit: ";

}  // namespace

Tokens PlainTokens(std::string_view text) {
  Tokens plain;
  for (english::Token& token : english::Tokenize(text)) {
    if (token.kind == english::Token::Kind::kSign && std::string_view(",'\"%").find(token.text[0]) == std::string::npos)
      continue;
    if (token.kind == english::Token::Kind::kWord) {
      const std::string british = english::British(token.text);
      if (!british.empty()) token.text = british;
    }
    plain.push_back(std::move(token));
  }
  return plain;
}

WordMeanings::WordMeanings(std::string_view prefix) {
  for (const auto& list : english::Language::Get().data().lists()) {
    if (!list.name().starts_with(prefix)) continue;
    meanings_.push_back(list.name().substr(prefix.size()));
    for (const std::string& phrase : list.words()) book_.Add(phrase, static_cast<int>(meanings_.size()) - 1);
  }
}

const std::string* WordMeanings::Find(const Tokens& tokens, Span span) const {
  if (span.empty()) return nullptr;
  const auto match = book_.Find(tokens, span.begin, span.end - span.begin);
  return match.length == span.end - span.begin ? &meanings_[match.value] : nullptr;
}

const Forms& Forms::Get() {
  static const auto* const forms = new Forms;
  return *forms;
}

Forms::Forms() {
  for (const auto& list : english::Language::Get().data().lists()) {
    if (!list.name().starts_with(kEdit)) continue;
    for (const std::string& phrase : list.words()) {
      size_t at = 0;
      forms_.emplace_back(list.name().substr(kEdit.size()), Parse(phrase, at));
    }
  }
}

Forms::Sequence Forms::Parse(std::string_view text, size_t& at) {
  Sequence sequence;
  while (at < text.size() && text[at] != ']' && text[at] != ')' && text[at] != '|') {
    Element element;
    if (text[at] == ' ') {
      ++at;
      continue;
    }
    if (text[at] == '[' || text[at] == '(') {
      element.optional = text[at] == '[';
      do {
        element.choices.push_back(Parse(text, ++at));
      } while (at < text.size() && text[at] == '|');
      ++at;
    } else if (text[at] == '<') {
      const size_t end = std::min(text.find('>', at), text.size() - 1);
      element.slot = text.substr(at + 1, end - at - 1);
      at = end + 1;
    } else {
      const size_t end = std::min(text.find_first_of(" []()|<", at), text.size());
      element.word = text.substr(at, end - at);
      at = end;
    }
    sequence.push_back(std::move(element));
  }
  return sequence;
}

bool Forms::Step(Search& search, size_t at, const Rest& rest) {
  if (rest.next == rest.sequence->size()) {
    return rest.outer == nullptr ? at == search.end : Step(search, at, *rest.outer);
  }
  const Element& element = (*rest.sequence)[rest.next];
  const Rest after{rest.sequence, rest.next + 1, rest.outer};
  if (!element.word.empty()) {
    return at < search.end && search.tokens[at].text == element.word && Step(search, at + 1, after);
  }
  if (!element.slot.empty()) {
    for (size_t end = search.end; end > at; --end) {
      if (!search.fits(element.slot, {at, end})) continue;
      search.slots[element.slot] = {at, end};
      if (Step(search, end, after)) return true;
      search.slots.erase(element.slot);
    }
    return false;
  }
  for (const Sequence& choice : element.choices) {
    if (Step(search, at, {&choice, 0, &after})) return true;
  }
  return element.optional && Step(search, at, after);
}

std::optional<Form> Forms::Match(const Tokens& tokens, Span span, const Fits& fits) const {
  // Nobody asks for one change in more words, and trying them all would take long.
  constexpr size_t kMostWords = 40;
  if (span.empty() || span.end - span.begin > kMostWords) return std::nullopt;
  for (const auto& [act, sequence] : forms_) {
    Search search{tokens, span.end, fits, {}};
    if (Step(search, span.begin, {&sequence, 0, nullptr})) return Form{act, std::move(search.slots)};
  }
  return std::nullopt;
}

}  // namespace flair::session
