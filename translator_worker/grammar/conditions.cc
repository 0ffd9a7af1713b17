// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/conditions.h"

#include <algorithm>
#include <string_view>

namespace flair::translator {
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
  // "Close to the kiln so that pots do not have to be carried far": a reason holds no condition.
  const bool in_reason =
      std::any_of(terms.rbegin(), std::find_if(terms.rbegin(), terms.rend(), IsStop),
                  [](const RawTerm& raw) { return raw.term.kind == Term::Kind::kPurpose && raw.term.lemma == "so"; });
  if (in_reason && IsOneOf(tokens[at], {"do", "does", "not"})) return NextStop(tokens, at);
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
  // "It does not have to be against a wall, but must ...": what is not asked for goes, the rest stays.
  const bool needless = IsOneOf(tokens[at], {"do", "does", "not", "need", "no"});
  if ((!main_clause && !needless) || next + 2 >= tokens.size()) return std::nullopt;
  terms.resize(begin);
  return next;
}

}  // namespace flair::translator
