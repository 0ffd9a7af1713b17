// SPDX-License-Identifier: GPL-3.0-or-later
#include "english/frames/token_context.h"

#include <algorithm>

namespace flair::english {

bool VerbFollows(const TokenContext& context) {
  const auto& [tokens, at, names, terms] = context;
  if (at == 0 || tokens[at - 1].IsMark('.') || tokens[at - 1].IsWord("to")) return true;
  if (IsOneOf(tokens[at - 1], {"each", "both", "one", "other", "it", "they", "which", "that"})) return true;
  if (terms.empty()) return false;
  const RawTerm& before = terms.back();
  if (before.role == RawTerm::Role::kModal || before.term.IsWord("not")) return before.term.end == tokens[at - 1].end;
  return before.role == RawTerm::Role::kNone && before.term.kind == Term::Kind::kMention;
}

bool NounFollows(const TokenContext& context, size_t at) {
  if (at >= context.tokens.size()) return false;
  return context.names.Find(context.tokens, at).length > 0 ||
         Lexicon::Get().Find(context.tokens, at).word_class == v1::WORD_CLASS_FEATURE;
}

Phrase FindPhrase(const TokenContext& context) {
  const Phrase phrase = Lexicon::Get().Find(context.tokens, context.at);
  // "0.6 m should be left open": kept so, it does not open.
  const size_t after = context.at + phrase.length;
  if (phrase.word_class == v1::WORD_CLASS_MODAL && phrase.length > 1 && context.tokens[after - 1].IsWord("left") &&
      after < context.tokens.size() && IsOneOf(context.tokens[after], {"open", "free", "clear", "unobstructed"}))
    return Lexicon::Get().Find(context.tokens, context.at, phrase.length - 1);
  // "Side by side with no gap": what comes with it is no partner.
  if (phrase.length > 1 && phrase.word_class == v1::WORD_CLASS_RELATION && context.tokens[after - 1].IsWord("with") &&
      after < context.tokens.size() &&
      (IsOneOf(context.tokens[after], {"no", "at"}) || context.tokens[after].kind == Token::Kind::kLength))
    return Lexicon::Get().Find(context.tokens, context.at, phrase.length - 1);
  for (size_t k = 1; k < phrase.length; ++k) {
    const Names::Found name = context.names.Find(context.tokens, context.at + k);
    const Phrase inner = Lexicon::Get().Find(context.tokens, context.at + k);
    const bool of_feature = (phrase.word_class == v1::WORD_CLASS_PLACE || phrase.lemma == "into_room") &&
                            inner.word_class == v1::WORD_CLASS_FEATURE && inner.length > 1;
    // "Along a side wall" is not "along" and "a side"; but "the left side of the room divider" is a side.
    const bool of_wall =
        phrase.word_class == v1::WORD_CLASS_SIDE && inner.word_class == v1::WORD_CLASS_PLACE && inner.length > 1 &&
        context.names.Find(context.tokens, context.at + k + inner.length - 1).length <= 1;
    const size_t length = std::max(name.length, of_feature || of_wall ? inner.length : 0);
    if (length > 1 && k + length > phrase.length) return Lexicon::Get().Find(context.tokens, context.at, k);
  }
  return phrase;
}

bool AnyIsMeant(const TokenContext& context) {
  const auto& [tokens, at, names, terms] = context;
  size_t before = at;
  if (before > 0 && tokens[before - 1].IsWord("the")) --before;
  if (before > 0 && tokens[before - 1].IsWord("of")) --before;
  if (before == at) return at > 0 && IsOneOf(tokens[at - 1], {"a", "an", "one"});
  return before > 0 && tokens[before - 1].IsWord("one");
}

bool EndsSideClear(const TokenContext& context, const Phrase& phrase) {
  const auto& [tokens, at, names, terms] = context;
  if (phrase.word_class != v1::WORD_CLASS_FILLER || phrase.length != 1 || terms.empty()) return false;
  const Token& token = tokens[at];
  if (token.IsWord("accessibility") && terms.back().role == RawTerm::Role::kSide) return true;
  if (!IsOneOf(token, {"clear", "free", "open"})) return false;
  // "Front: clear".
  const bool colon = terms.back().role == RawTerm::Role::kNone && terms.back().term.lemma == ":";
  const size_t modals = terms.back().role == RawTerm::Role::kModal || colon ? 1 : 0;
  if (terms.size() <= modals) return false;
  const RawTerm& what = terms[terms.size() - 1 - modals];
  const bool thing = what.role == RawTerm::Role::kNone && what.term.kind == Term::Kind::kMention;
  if (what.role != RawTerm::Role::kSide && !thing) return false;
  return at + 1 == tokens.size() || tokens[at + 1].IsMark('.') || tokens[at + 1].IsMark(',') ||
         IsOneOf(tokens[at + 1], {"for", "to", "so", "by", "because", "since", "while", "when", "as", "during"});
}

bool ReachedFromSide(const TokenContext& context, const Phrase& phrase) {
  const std::vector<Token>& tokens = context.tokens;
  size_t next = context.at + phrase.length;
  if (!tokens[next - 1].IsWord("from") || tokens[context.at].text.starts_with("receiv")) return false;
  while (next < tokens.size() && IsOneOf(tokens[next], {"the", "its"})) ++next;
  if (next >= tokens.size()) return false;
  const Phrase side = Lexicon::Get().Find(tokens, next);
  return side.word_class == v1::WORD_CLASS_SIDE && side.length > 0;
}

bool TellsWhichOne(const TokenContext& context, const Phrase& phrase) {
  const auto& [tokens, at, names, terms] = context;
  if (phrase.lemma == "around" && at + 1 < tokens.size() && tokens[at + 1].kind == Token::Kind::kLength) return true;
  if (phrase.length != 1 || at == 0) return false;
  // "Over the round table".
  if (tokens[at].IsWord("round") && IsOneOf(tokens[at - 1], {"the", "a", "each", "every"})) return true;
  if (IsOneOf(tokens[at], {"adjacent", "nearby"})) {
    return IsOneOf(tokens[at - 1], {"between", "any", "of", "the", "from", "two", "other"}) &&
           NounFollows(context, at + 1);
  }
  return tokens[at].IsWord("central") && tokens[at - 1].IsWord("the") &&
         (NounFollows(context, at + 1) || NounFollows(context, at + 2));
}

Names::Found FindNameWithSharedHead(const TokenContext& context) {
  const auto& [tokens, at, names, terms] = context;
  const size_t other = at + 2;
  if (other >= tokens.size() || tokens[at].kind != Token::Kind::kWord || !IsOneOf(tokens[at + 1], {"and", "or"}))
    return {};
  const Names::Found last = names.Find(tokens, other);
  if (last.length < 2 || !last.reference.plural) return {};
  Names::Found found = names.Find({tokens[at], tokens[other + last.length - 1]}, 0);
  if (found.length != 2 || found.reference.kind != RefKind::kObjects) return {};
  found.length = 1;
  found.reference.plural = false;
  return found;
}

namespace {

// "..., especially if the bed is tall", "... unless it is used for a lamp": what stands before holds anyhow.
bool IsAside(const std::vector<Token>& tokens, size_t at, size_t length) {
  const bool even = at > 0 && IsOneOf(tokens[at - 1], {"especially", "particularly", "mainly", "even", "specifically"});
  return even || (length == 1 && tokens[at].IsWord("unless"));
}

bool IsStop(const RawTerm& raw) { return raw.term.kind == Term::Kind::kStop; }

// A stop, "but", or a comma or "and" before a verb of another clause.
bool BeginsClause(const std::vector<Token>& tokens, size_t at) {
  if (tokens[at].IsMark('.') || tokens[at].IsWord("but")) return true;
  if (!tokens[at].IsMark(',') && !tokens[at].IsWord("and")) return false;
  return IsOneOf(tokens[at + 1], {"should", "must", "avoid", "needs", "ensure"});
}

size_t NextStop(const std::vector<Token>& tokens, size_t at) {
  while (at < tokens.size() && !tokens[at].IsMark('.')) ++at;
  return at;
}

}  // namespace

std::optional<size_t> LeaveOutCondition(const std::vector<Token>& tokens, size_t at, size_t length,
                                        std::vector<RawTerm>& terms) {
  if (!terms.empty() && IsAside(tokens, at, length)) return NextStop(tokens, at);
  const auto after = [&](auto&& ends) {
    size_t begin = terms.size();
    while (begin > 0 && !ends(terms[begin - 1])) --begin;
    return begin;
  };
  // "The front is accessible; the back need not be": only what follows the stop is conditional.
  if (const size_t begin = after(IsStop); begin > 0) {
    terms.resize(begin);
    return NextStop(tokens, at);
  }
  // "Against a wall if space is limited, but not in front of windows": only the first clause is.
  const size_t begin = after([](const RawTerm& raw) { return IsStop(raw) || raw.term.lemma == "but"; });
  const bool main_clause = std::any_of(terms.begin() + static_cast<long>(begin), terms.end(), [](const RawTerm& raw) {
    return raw.role == RawTerm::Role::kNone && raw.term.kind == Term::Kind::kWord;
  });
  size_t next = at;
  while (next + 1 < tokens.size() && !BeginsClause(tokens, next)) ++next;
  if (!main_clause || next + 2 >= tokens.size()) return std::nullopt;
  terms.resize(begin);
  return next;
}

}  // namespace flair::english
