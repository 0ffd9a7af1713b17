// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/rewrite_clauses.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <utility>

namespace flair::translator {
namespace {

bool IsAnyWord(const Term& term, std::initializer_list<std::string_view> words) {
  return std::any_of(words.begin(), words.end(), [&](std::string_view word) { return term.IsWord(word); });
}

bool IsPurpose(const Term& term, std::string_view lemma) {
  return term.kind == Term::Kind::kPurpose && term.lemma == lemma;
}

bool IsSoft(const Term& term) { return term.kind == Term::Kind::kSoft; }

bool IsMentionOf(const Term& term, RefKind kind) {
  return term.kind == Term::Kind::kMention && term.mention.references.front().kind == kind;
}

// "On the left", "its back": a side of what is spoken of.
bool IsBareSide(const Term& term) {
  return IsMentionOf(term, RefKind::kPronoun) && term.mention.references.front().name.empty();
}

// Whether nothing more of the clause comes at `at`.
bool ClauseEnds(const std::vector<Term>& terms, size_t at) {
  if (at >= terms.size()) return true;
  const Term& term = terms[at];
  if (term.kind == Term::Kind::kStop || term.kind == Term::Kind::kPurpose) return true;
  return IsSoft(term) && (at + 1 >= terms.size() || terms[at + 1].kind == Term::Kind::kUnknown ||
                          terms[at + 1].kind == Term::Kind::kPurpose || IsSoft(terms[at + 1]));
}

// Where "free" or "accessible" stands from `at` on, one unknown word aside; 0 when it does not.
size_t KeptFreeAt(const std::vector<Term>& terms, size_t at) {
  if (at < terms.size() && terms[at].kind == Term::Kind::kUnknown) ++at;
  return at < terms.size() && IsAnyWord(terms[at], {"keep_clear", "accessible"}) ? at : 0;
}

// "Near sockets, which must not be covered", "in front of the desk, which it faces": of the thing before "which".
// "The stand, which is beside the bench, must be ...": of the first thing, two facts.
void ReadRelativeClauses(std::vector<Term>& terms) {
  const auto relative = [](const Term& term) { return IsPurpose(term, "which") || IsPurpose(term, "that"); };
  if (std::none_of(terms.begin(), terms.end(), relative)) return;
  std::vector<Term> out;
  size_t things = 0;
  for (size_t i = 0; i < terms.size(); ++i) {
    const size_t commas = !out.empty() && IsSoft(out.back()) ? 1 : 0;
    const bool after_thing = out.size() > commas && out[out.size() - 1 - commas].kind == Term::Kind::kMention;
    if (!after_thing || i + 2 >= terms.size() || !(IsPurpose(terms[i], "which") || IsPurpose(terms[i], "that"))) {
      things += terms[i].kind == Term::Kind::kMention;
      out.push_back(terms[i]);
      continue;
    }
    const Term thing = out[out.size() - 1 - commas];
    if (terms[i + 1].IsWord("not") && terms[i + 2].IsWord("block") && ClauseEnds(terms, i + 3)) {
      out.insert(out.end(), {terms[i + 1], terms[i + 2], thing});
      i += 2;
    } else if (IsMentionOf(terms[i + 1], RefKind::kPronoun) && terms[i + 2].IsWord("facing") &&
               ClauseEnds(terms, i + 3)) {
      out.insert(out.end(), {terms[i + 1], terms[i + 2], thing});
      i += 2;
    } else if (const size_t verb = KeptFreeAt(terms, i + 1); commas == 1 && verb > 0 && IsBareSide(thing)) {
      // "From the front, which must therefore be free".
      out.push_back(thing);
      i = verb - 1;
    } else if (commas == 1 && things == 1 && terms[i].lemma == "which" && terms[i + 1].kind == Term::Kind::kWord) {
      out.pop_back();
    } else {
      out.push_back(terms[i]);
    }
  }
  terms = std::move(out);
}

// "Space to gather around it", "room for people to stand behind it": where the space is.
void JoinSpaceToItsPlace(std::vector<Term>& terms) {
  if (std::none_of(terms.begin(), terms.end(), [](const Term& term) { return term.IsWord("space"); })) return;
  constexpr size_t kLongestUse = 4;
  std::vector<Term> out;
  for (size_t i = 0; i < terms.size(); ++i) {
    out.push_back(terms[i]);
    if (!terms[i].IsWord("space") || i + 1 >= terms.size()) continue;
    if (!IsPurpose(terms[i + 1], "to") && !IsPurpose(terms[i + 1], "for")) continue;
    size_t place = i + 2;
    while (place < terms.size() && place < i + 2 + kLongestUse && terms[place].kind == Term::Kind::kUnknown) ++place;
    const bool used = place > i + 2 || terms[i + 1].lemma == "to";
    if (used && place < terms.size() &&
        IsAnyWord(terms[place], {"around", "behind", "in_front_of", "in_front", "at_sides", "all_sides"})) {
      i = place - 1;
    }
  }
  terms = std::move(out);
}

// "0.8 m on the left as well as on the right": both sides are of one list.
void JoinSides(std::vector<Term>& terms) {
  std::vector<Term> out;
  for (size_t i = 0; i < terms.size(); ++i) {
    const size_t last = out.size();
    const bool joined = i + 2 < terms.size() && last > 1 && IsSoft(terms[i]) && terms[i].lemma == "and" &&
                        IsAnyWord(terms[i + 1], {"on", "next_to", "along"}) && IsBareSide(terms[i + 2]) &&
                        out[last - 2].IsWord(terms[i + 1].lemma) && IsBareSide(out[last - 1]);
    if (!joined) {
      out.push_back(terms[i]);
      continue;
    }
    auto& sides = out[last - 1].mention.references;
    const auto& more = terms[i + 2].mention.references;
    sides.insert(sides.end(), more.begin(), more.end());
    out[last - 1].end = terms[i + 2].end;
    i += 2;
  }
  terms = std::move(out);
}

// "Flank the table, one on its left and one on its right": which sides these are is clear.
void DropSidesOfFlank(std::vector<Term>& terms) {
  if (std::none_of(terms.begin(), terms.end(), [](const Term& term) { return term.IsWord("each_side_of"); })) return;
  const auto own_side = [&](size_t at) {
    return at + 1 < terms.size() && IsAnyWord(terms[at], {"on", "next_to", "left_of", "right_of"}) &&
           IsMentionOf(terms[at + 1], RefKind::kPronoun);
  };
  std::vector<Term> out;
  for (size_t i = 0; i < terms.size(); ++i) {
    out.push_back(terms[i]);
    const size_t n = out.size();
    if (n < 2 || !out[n - 2].IsWord("each_side_of") || out[n - 1].kind != Term::Kind::kMention) continue;
    size_t next = i + 1;
    while (next < terms.size() && (IsSoft(terms[next]) || own_side(next))) next += IsSoft(terms[next]) ? 1 : 2;
    if (ClauseEnds(terms, next) && next > i + 2 && own_side(next - 2)) i = next - 1;
  }
  terms = std::move(out);
}

// "It must never be obstructed": it is to be got at. Doors, windows and what is no thing are other matters.
void ReadPassiveOfBlock(std::vector<Term>& terms) {
  if (std::none_of(terms.begin(), terms.end(), [](const Term& term) { return term.IsWord("block"); })) return;
  std::vector<Term> out;
  for (size_t i = 0; i < terms.size(); ++i) {
    const bool denied = terms[i].IsWord("not") && i + 1 < terms.size() && terms[i + 1].IsWord("block");
    const bool of_thing =
        out.empty() || out.back().kind != Term::Kind::kMention || IsMentionOf(out.back(), RefKind::kObjects) ||
        (IsMentionOf(out.back(), RefKind::kPronoun) && !out.back().mention.references.front().name.empty());
    const bool said = !out.empty() && (out.back().IsWord("accessible") || (IsSoft(out.back()) && out.size() > 1 &&
                                                                           out[out.size() - 2].IsWord("accessible")));
    if (!denied || !of_thing || said || !ClauseEnds(terms, i + 2)) {
      out.push_back(terms[i]);
      continue;
    }
    out.push_back(terms[i + 1]);
    out.back().lemma = "accessible";
    ++i;
  }
  terms = std::move(out);
}

// "1 m all round" is on all sides, "all round the table" around it.
void ReadAllAround(std::vector<Term>& terms) {
  constexpr size_t kPlainLength = 6;
  for (size_t i = 0; i < terms.size(); ++i) {
    const bool all = terms[i].IsWord("around") && terms[i].end - terms[i].begin > kPlainLength + 1;
    if (all && ClauseEnds(terms, i + 1)) terms[i].lemma = "all_sides";
  }
}

}  // namespace

void ShareFigure(std::vector<Term>& terms) {
  const auto place = [](const Term& term) {
    return IsAnyWord(term, {"in_front_of", "behind", "left_of", "right_of", "around"});
  };
  std::vector<Term> out(1);  // so that there is always one before a figure
  for (size_t i = 0; i < terms.size(); ++i) {
    out.push_back(terms[i]);
    const size_t n = out.size();
    const bool shared = n > 4 && i + 2 < terms.size() && IsSoft(terms[i]) && place(terms[i + 1]) && place(out[n - 3]) &&
                        terms[i + 2].kind == Term::Kind::kMention && out[n - 2].kind == Term::Kind::kMention &&
                        out[n - 2].begin == terms[i + 2].begin;
    if (!shared) continue;
    // "1 m of space", "1 m is kept free".
    const Term figure = out[IsAnyWord(out[n - 4], {"space", "keep_clear"}) ? n - 5 : n - 4];
    if (figure.kind == Term::Kind::kDistance) out.push_back(figure);
  }
  out.erase(out.begin());
  terms = std::move(out);
}

void RewriteClauses(std::vector<Term>& terms) {
  ReadRelativeClauses(terms);
  JoinSpaceToItsPlace(terms);
  DropSidesOfFlank(terms);
  JoinSides(terms);
  ReadPassiveOfBlock(terms);
  ReadAllAround(terms);
}

}  // namespace flair::translator
