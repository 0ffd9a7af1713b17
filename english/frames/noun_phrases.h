// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "english/frames/term.h"

namespace flair::english {

// A term before noun phrases are put together.
struct RawTerm {
  // What it does in a noun phrase; kNone for terms that are complete in themselves.
  enum class Role { kNone, kSide, kPossessive, kEach, kOrdinal, kAnd, kOr, kModal };
  Term term;
  Role role = Role::kNone;
  int ordinal = 0;
  // "doors" may be those of a wardrobe.
  bool part_of_furniture = false;
  // "Long side of the table", not "the table's long side": a quantity before it counts sides.
  bool side_first = false;
  // "No object": the statement is denied.
  bool negative = false;
};

// Whether the term is a noun phrase, one that can be moved, and one of doors, windows or sockets.
bool IsMention(const RawTerm& raw);
bool IsThing(const RawTerm& raw);
bool IsFeature(const RawTerm& raw);

// Puts noun phrases together: "the bed's headboard", "both long sides of the bed", "the bed, the wardrobe and the
// desk", "the wardrobe doors", "the second nightstand". A bare side ("its back") refers to what was spoken of.
std::vector<Term> GroupNounPhrases(std::vector<RawTerm> raw);

// Joins lists of noun phrases to one mention each: "the bed, the wardrobe and the desk". What is not joined becomes a
// soft break ("and") or the word "or"; modal verbs go.
std::vector<Term> JoinLists(std::vector<RawTerm> raw);

// Gives "each chair", "the second nightstand" and "the other" their numbers; unknown adjectives before a thing belong
// to it, and denied things ("no chair") are followed by "not".
std::vector<RawTerm> AttachQuantities(std::vector<RawTerm> raws);

// Makes several wordings of one meaning one: labels before a colon go, what two relations share is said to both, "not"
// stands behind what it denies.
void RewriteTerms(std::vector<Term>& terms);

// "nightstand 2" is a nightstand.
inline std::string_view WithoutNumber(std::string_view name) {
  while (!name.empty() && (name.back() == ' ' || name.back() == '_' || (name.back() >= '0' && name.back() <= '9')))
    name.remove_suffix(1);
  return name;
}

inline void BecomeWord(std::string lemma, RawTerm& raw) {
  raw.term.kind = Term::Kind::kWord;
  raw.term.lemma = std::move(lemma);
}

inline void BecomeReference(RefKind kind, std::string name, RawTerm& raw) {
  Reference reference;
  reference.kind = kind;
  reference.name = std::move(name);
  raw.term.kind = Term::Kind::kMention;
  raw.term.mention.references = {std::move(reference)};
}

}  // namespace flair::english
