// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "english/frames/noun_phrases.h"

namespace flair::english {
namespace {

bool IsTo(const Term& term) { return term.kind == Term::Kind::kPurpose && term.lemma == "to"; }

// "not" itself; "to avoid" begins a reason all the same.
bool IsPlainNot(const Term& term) { return term.IsWord("not") && term.end - term.begin == 3; }

// "Not to block", "to not block": no reason follows.
void DropToBesideNot(std::vector<Term>& terms) {
  std::vector<Term> kept;
  for (size_t i = 0; i < terms.size(); ++i) {
    const bool beside_not =
        (!kept.empty() && IsPlainNot(kept.back())) || (i + 1 < terms.size() && IsPlainNot(terms[i + 1]));
    if (!IsTo(terms[i]) || !beside_not) kept.push_back(std::move(terms[i]));
  }
  terms = std::move(kept);
}

// "Close to, but not in front of, the shelf", "beside and parallel to the desk": both are said of it.
void ShareTarget(std::vector<Term>& terms) {
  const auto relates = [](const Term& term) {
    return term.IsAnyWord({"near", "next_to", "behind", "in_front_of", "facing", "opposite", "parallel", "left_of",
                           "right_of", "perpendicular", "to_side", "against"});
  };
  const auto soft = [](const Term& term) { return term.kind == Term::Kind::kSoft; };
  std::vector<Term> shared;
  size_t skipped = terms.size();
  for (size_t i = 0; i < terms.size(); ++i) {
    if (i == skipped) continue;
    shared.push_back(terms[i]);
    size_t next = i + 1;
    while (next < terms.size() && soft(terms[next])) ++next;
    if (!relates(terms[i]) || next == i + 1) continue;
    const bool denied = next < terms.size() && terms[next].IsWord("not");
    if (denied) ++next;
    // "1 m in front of and 0.8 m behind every rack".
    const bool figure = next < terms.size() && terms[next].kind == Term::Kind::kDistance;
    if (figure) ++next;
    if (next + 1 >= terms.size() || !(relates(terms[next]) || (denied && terms[next].IsWord("block")) ||
                                      (figure && terms[next].IsWord("away_from"))))
      continue;
    const size_t target = next + (soft(terms[next + 1]) ? 2 : 1);
    if (target >= terms.size() || terms[target].kind != Term::Kind::kMention) continue;
    shared.push_back(terms[target]);
    if (target == next + 2) skipped = next + 1;
  }
  terms = std::move(shared);
}

// "Facing directly towards the door", "blocking or obstructing".
void DropRepeatedWords(std::vector<Term>& terms) {
  const auto repeated = [](const Term& a, const Term& b) {
    return a.kind == Term::Kind::kWord && b.kind == Term::Kind::kWord && a.lemma == b.lemma &&
           a.lemma != "side_by_side";
  };
  std::vector<Term> kept;
  for (size_t i = 0; i < terms.size(); ++i) {
    const bool choice = (terms[i].IsWord("or") || terms[i].IsSoft("and")) && !kept.empty() && i + 1 < terms.size() &&
                        repeated(kept.back(), terms[i + 1]);
    if (choice) continue;
    if (kept.empty() || !repeated(kept.back(), terms[i])) kept.push_back(std::move(terms[i]));
  }
  terms = std::move(kept);
}

bool SaysSomething(const Term& term) { return term.kind == Term::Kind::kWord && !term.IsAnyWord({"not", "or", "of"}); }

// "Against a wall: place it against a wall", "Accessible front: ...": what stands before the colon says it twice. Names
// stay, since "Bed: ..." tells what moves, and so do figures: "Length from the bed: 0.5 m".
void DropLabel(std::vector<Term>& terms) {
  constexpr size_t kLongestLabel = 6;
  const auto is_colon = [](const Term& term) { return term.IsSoft(":"); };
  const auto is_purpose = [](const Term& term) { return term.kind == Term::Kind::kPurpose; };
  const auto is_stop = [](const Term& term) { return term.kind == Term::Kind::kStop; };
  const auto is_object = [](const Term& term) { return term.Mentions(RefKind::kObjects); };
  const auto colon = std::ranges::find_if(terms, is_colon);
  if (colon == terms.end() || colon == terms.begin() || colon - terms.begin() > static_cast<long>(kLongestLabel))
    return;
  if (std::any_of(terms.begin(), colon, is_stop)) return;
  const auto reason = std::find_if(colon, terms.end(), is_purpose);
  // "Proximity of sofa and table: the sofa is near the table" says it twice; "Sofa: near the table" does not.
  const bool names = std::any_of(terms.begin(), colon, is_object);
  if (names && (!std::any_of(terms.begin(), colon, SaysSomething) || !std::any_of(colon, reason, is_object))) return;
  if (!std::any_of(colon, reason, SaysSomething)) return;
  // "Back side: against a wall": the side is what stands there.
  const auto is_own_side = [](const Term& term) { return term.IsOwnSide(); };
  const bool of_side = colon - terms.begin() == 1 && is_own_side(terms.front()) &&
                       !std::any_of(colon, std::find_if(colon, reason, is_stop), is_own_side);
  terms.erase(of_side ? colon : terms.begin(), colon + 1);
}

// "Not in front of windows or over sockets": both are denied.
void SpreadDenial(std::vector<Term>& terms) {
  const auto relates = [](const Term& term) {
    return SaysSomething(term) && !term.IsAnyWord({"accessible", "access_to", "allow_access_to", "accessible_from"});
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
    if (terms[i].IsWord("not") && terms[i + 1].IsSoft("with") && terms[i + 2].IsOwnSide())
      terms.erase(terms.begin() + static_cast<long>(i) + 1);
  }
}

// "Avoid the sideboard or the shelf in front of windows", "the sideboard or the shelf should not": neither of them.
void DenyEachOfChoice(std::vector<Term>& terms) {
  for (size_t i = 0; i + 1 < terms.size(); ++i) {
    if (terms[i].kind == Term::Kind::kMention && terms[i + 1].IsWord("not")) terms[i].mention.either = false;
  }
}

// "Avoid [X] in front of windows" and "X not in front of windows" are one form: the second.
void MoveNotBehindSubject(std::vector<Term>& terms) {
  for (size_t i = 0; i + 2 < terms.size(); ++i) {
    const bool figure = terms[i + 2].kind == Term::Kind::kDistance && i + 3 < terms.size();
    const bool relates =
        terms[i + 2].kind == Term::Kind::kWord ||
        (figure &&
         (IsTo(terms[i + 3]) || terms[i + 3].IsAnyWord({"of", "near", "away_from", "at_sides", "in_front", "behind"})));
    if (terms[i].IsWord("not") && terms[i + 1].kind == Term::Kind::kMention && relates && !terms[i + 2].IsWord("not")) {
      std::swap(terms[i], terms[i + 1]);
    }
  }
}

void RewriteDenials(std::vector<Term>& terms) {
  JoinNotToSide(terms);
  MoveNotBehindSubject(terms);
  DenyEachOfChoice(terms);
  SpreadDenial(terms);
}

}  // namespace

void RewriteTerms(std::vector<Term>& terms) {
  DropRepeatedWords(terms);
  DropLabel(terms);
  ShareTarget(terms);
  DropToBesideNot(terms);
  RewriteDenials(terms);
}

}  // namespace flair::english
