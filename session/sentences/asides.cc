// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/sentences/asides.h"

#include "english/words.h"
#include "session/sentences/spoken.h"

namespace flair::session {
namespace {

using english::IsIn;
using english::Token;

// Whether a phrase that ends here goes on as the name of a piece: "lock the door" but not "lock the door mat".
bool GoesOn(const Tokens& tokens, size_t end) {
  return end < tokens.size() && tokens[end].kind == Token::Kind::kWord && !IsIn("words after a piece", tokens[end]) &&
         !IsIn("words after other business", tokens[end]);
}

}  // namespace

size_t ReasonAt(const Tokens& tokens, size_t at) {
  static const WordMeanings reasons("beginnings of reasons");
  return reasons.LengthAt(tokens, at);
}

bool IsReason(const Tokens& tokens, Span clause) {
  static const WordMeanings complaints("complaints");
  if (clause.empty()) return false;
  if (clause.begin > 0 && ReasonAt(tokens, clause.begin - 1) > 0) return true;
  if (ReasonAt(tokens, clause.begin) > 0) return true;
  return complaints.LengthAt(tokens, WithoutPolite(tokens, clause)) > 0;
}

bool IsPurpose(std::string_view text) {
  const Tokens tokens = PlainTokens(text);
  if (tokens.empty()) return false;
  if (ReasonAt(tokens, 0) > 0 || IsIn("beginnings of purposes", tokens[0])) return true;
  return tokens[0].IsWord("to") && tokens.size() > 1 && !IsIn("words before a known piece", tokens[1]);
}

std::string OtherBusiness(std::string_view clause) {
  static const WordMeanings business("other business: ");
  static const WordMeanings words("words of other business: ");
  const Tokens tokens = PlainTokens(clause);
  for (size_t at = 0; at < tokens.size(); ++at) {
    const size_t phrase = business.LengthAt(tokens, at), word = words.LengthAt(tokens, at);
    if (phrase > 0 && !GoesOn(tokens, at + phrase)) return *business.Find(tokens, {at, at + phrase});
    if (word > 0) return *words.Find(tokens, {at, at + word});
  }
  return "";
}

bool IsNoStatement(const Tokens& tokens, Span span) {
  static const WordMeanings phrases("words of no statement");
  const size_t first = WithoutPolite(tokens, span);
  if (first < span.end && IsIn("verbs of no statement", tokens[first])) return true;
  for (size_t at = span.begin; at < span.end; ++at) {
    if (phrases.LengthAt(tokens, at) > 0) return true;
  }
  return false;
}

}  // namespace flair::session
