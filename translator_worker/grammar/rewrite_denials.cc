// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/rewrite_denials.h"

#include <utility>

namespace flair::translator {
namespace {

// "Not in front of windows or over sockets": both are denied.
void SpreadDenial(std::vector<Term>& terms) {
  const auto relates = [](const Term& term) {
    return term.kind == Term::Kind::kWord && term.lemma != "not" && term.lemma != "or" && term.lemma != "accessible" &&
           term.lemma != "access_to" && term.lemma != "allow_access_to" && term.lemma != "accessible_from";
  };
  bool denied = false;
  for (size_t i = 0; i < terms.size(); ++i) {
    const bool ends = terms[i].kind == Term::Kind::kStop || terms[i].kind == Term::Kind::kSoft ||
                      terms[i].kind == Term::Kind::kPurpose;
    denied = (denied || terms[i].IsWord("not")) && !ends;
    const bool next_fact = terms[i].IsWord("or") && i > 0 && terms[i - 1].kind == Term::Kind::kMention &&
                           i + 2 < terms.size() && relates(terms[i + 1]) && terms[i + 2].kind == Term::Kind::kMention;
    if (denied && next_fact) terms[i].lemma = "not";
  }
}

// "Not with their backs against the wall": the backs are not.
void JoinNotToSide(std::vector<Term>& terms) {
  for (size_t i = 0; i + 2 < terms.size(); ++i) {
    const bool with = terms[i].IsWord("not") && terms[i + 1].kind == Term::Kind::kSoft && terms[i + 1].lemma == "with";
    const Term& side = terms[i + 2];
    if (with && side.kind == Term::Kind::kMention && side.mention.references.front().kind == RefKind::kPronoun &&
        !side.mention.references.front().side.empty()) {
      terms.erase(terms.begin() + static_cast<long>(i) + 1);
    }
  }
}

// "Avoid the sideboard or the shelf in front of windows", "the sideboard or the shelf should not": neither of them.
void DenyEachOfChoice(std::vector<Term>& terms) {
  for (size_t i = 0; i + 1 < terms.size(); ++i) {
    if (terms[i].kind == Term::Kind::kMention && terms[i + 1].IsWord("not")) terms[i].mention.either = false;
  }
}

bool IsTo(const Term& term) { return term.kind == Term::Kind::kPurpose && term.lemma == "to"; }

// "Avoid [X] in front of windows" and "X not in front of windows" are one form: the second.
void MoveNotBehindSubject(std::vector<Term>& terms) {
  for (size_t i = 0; i + 2 < terms.size(); ++i) {
    const bool relates = terms[i + 2].kind == Term::Kind::kWord ||
                         (terms[i + 2].kind == Term::Kind::kDistance && i + 3 < terms.size() &&
                          (terms[i + 3].IsWord("of") || terms[i + 3].IsWord("near") ||
                           terms[i + 3].IsWord("away_from") || terms[i + 3].IsWord("at_sides") ||
                           terms[i + 3].IsWord("in_front") || terms[i + 3].IsWord("behind") || IsTo(terms[i + 3])));
    if (terms[i].IsWord("not") && terms[i + 1].kind == Term::Kind::kMention && relates && !terms[i + 2].IsWord("not")) {
      std::swap(terms[i], terms[i + 1]);
    }
  }
}

}  // namespace

void RewriteDenials(std::vector<Term>& terms) {
  JoinNotToSide(terms);
  MoveNotBehindSubject(terms);
  DenyEachOfChoice(terms);
  SpreadDenial(terms);
}

}  // namespace flair::translator
