// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/rewrite_terms.h"

#include <algorithm>
#include <utility>

namespace flair::translator {
namespace {

// "not" itself; "to avoid" begins a reason all the same.
bool IsPlainNot(const Term& term) { return term.IsWord("not") && term.end - term.begin == 3; }

// "Not to block", "to not block": no reason follows.
void DropToBesideNot(std::vector<Term>& terms) {
  std::vector<Term> kept;
  for (size_t i = 0; i < terms.size(); ++i) {
    const bool to = terms[i].kind == Term::Kind::kPurpose && terms[i].lemma == "to";
    const bool beside_not =
        (!kept.empty() && IsPlainNot(kept.back())) || (i + 1 < terms.size() && IsPlainNot(terms[i + 1]));
    if (!to || !beside_not) kept.push_back(std::move(terms[i]));
  }
  terms = std::move(kept);
}

// "Centrally in front of the sofa": of the sofa's front, not of the room.
void DropCenteredBesideRelation(std::vector<Term>& terms) {
  const auto says_where = [](const Term& term) {
    return term.IsWord("in_front_of") || term.IsWord("opposite") || term.IsWord("behind") || term.IsWord("facing") ||
           term.IsWord("next_to") || term.IsWord("foot_of");
  };
  std::vector<Term> kept;
  for (size_t i = 0; i < terms.size(); ++i) {
    const bool along = i + 2 < terms.size() && terms[i + 1].IsWord("along") &&
                       terms[i + 2].kind == Term::Kind::kMention &&
                       terms[i + 2].mention.references.front().kind != RefKind::kWall;
    const bool beside = terms[i].IsWord("centered") && i + 1 < terms.size() && (along || says_where(terms[i + 1]));
    if (!beside) kept.push_back(std::move(terms[i]));
  }
  terms = std::move(kept);
}

// "Essential features like the desk or bed", "major objects, such as the sofa and the desk": the names count.
void TakeExamples(std::vector<Term>& terms) {
  const auto vague = [](const Term& term) {
    if (term.kind != Term::Kind::kMention) return term.kind == Term::Kind::kUnknown;
    const RefKind kind = term.mention.references.back().kind;
    return kind == RefKind::kGroup || kind == RefKind::kVague || kind == RefKind::kAbsent;
  };
  const auto names = [](const Term& term) {
    if (term.kind != Term::Kind::kMention) return false;
    const RefKind kind = term.mention.references.front().kind;
    return kind == RefKind::kObjects || kind == RefKind::kFeature;
  };
  std::vector<Term> kept;
  for (size_t i = 0; i < terms.size(); ++i) {
    const bool such_as =
        terms[i].kind == Term::Kind::kPurpose && (terms[i].lemma == "like" || terms[i].lemma == "such");
    if (such_as && !kept.empty() && i + 1 < terms.size() && names(terms[i + 1])) {
      const bool comma = kept.back().kind == Term::Kind::kSoft;
      const size_t last = kept.size() - (comma ? 1 : 0);
      size_t from = last;
      while (from > 0 && vague(kept[from - 1])) --from;
      if (from < last) {
        kept.resize(from);
        continue;
      }
    }
    kept.push_back(std::move(terms[i]));
  }
  terms = std::move(kept);
}

// "Behind or beside the armchair": the choice is free, the first is taken.
void TakeFirstPlace(std::vector<Term>& terms) {
  const auto place = [](const Term& term) {
    return term.IsWord("behind") || term.IsWord("next_to") || term.IsWord("left_of") || term.IsWord("right_of") ||
           term.IsWord("in_front_of") || term.IsWord("near") || term.IsWord("opposite") || term.IsWord("to_side") ||
           term.IsWord("each_side_of");
  };
  std::vector<Term> kept;
  for (size_t i = 0; i < terms.size(); ++i) {
    const bool denied = kept.size() > 1 && kept[kept.size() - 2].IsWord("not");
    const bool choice = terms[i].IsWord("or") && !kept.empty() && place(kept.back()) && !denied &&
                        i + 2 < terms.size() && place(terms[i + 1]) && terms[i + 2].kind == Term::Kind::kMention;
    if (choice) {
      ++i;
    } else {
      kept.push_back(std::move(terms[i]));
    }
  }
  terms = std::move(kept);
}

// "Obstruct the view or access to the window": what of it is obstructed says nothing more.
void DropWhatIsBlocked(std::vector<Term>& terms) {
  const auto of_it = [](const Term& term) {
    if (term.kind == Term::Kind::kMention) {
      const Reference& first = term.mention.references.front();
      return first.kind == RefKind::kVague && (first.name == "comfort" || first.name == "lighting");
    }
    return term.IsWord("accessible") || term.IsWord("access_to") || term.IsWord("swing_open") ||
           term.IsWord("facing") || term.IsWord("of") || term.IsWord("or") || term.IsWord("away_from") ||
           (term.kind == Term::Kind::kSoft && term.lemma == "and") ||
           (term.kind == Term::Kind::kPurpose && term.lemma == "to");
  };
  const auto thing = [](const Term& term) {
    if (term.kind != Term::Kind::kMention) return false;
    const RefKind kind = term.mention.references.front().kind;
    return kind == RefKind::kFeature || kind == RefKind::kObjects;
  };
  std::vector<Term> kept;
  for (size_t i = 0; i < terms.size(); ++i) {
    kept.push_back(std::move(terms[i]));
    if (!kept.back().IsWord("block")) continue;
    size_t end = i + 1;
    // A line of sight to an object is another matter.
    bool sight = false;
    while (end < terms.size() && of_it(terms[end])) sight = terms[end++].IsWord("facing") || sight;
    const bool object =
        end < terms.size() && thing(terms[end]) && terms[end].mention.references.front().kind == RefKind::kObjects;
    if (end < terms.size() && thing(terms[end]) && !(sight && object)) i = end - 1;
  }
  terms = std::move(kept);
}

// "Close to, but not directly next to, the bed": near it.
void DropSofteningOfNear(std::vector<Term>& terms) {
  const auto soft = [](const Term& term) { return term.kind == Term::Kind::kSoft || term.IsWord("or"); };
  std::vector<Term> kept;
  for (size_t i = 0; i < terms.size(); ++i) {
    kept.push_back(std::move(terms[i]));
    if (!kept.back().IsWord("near")) continue;
    size_t end = i + 1;
    while (end < terms.size() && soft(terms[end])) ++end;
    if (end == i + 1 || end + 1 >= terms.size() || !terms[end].IsWord("not")) continue;
    ++end;
    if (!terms[end].IsWord("next_to") && !terms[end].IsWord("against") && !terms[end].IsWord("near")) continue;
    ++end;
    while (end < terms.size() && soft(terms[end])) ++end;
    if (end < terms.size() && terms[end].kind == Term::Kind::kMention) i = end - 1;
  }
  terms = std::move(kept);
}

// "Close to, but not in front of, the shelf", "beside and parallel to the desk": both are said of it.
void ShareTarget(std::vector<Term>& terms) {
  const auto relates = [](const Term& term) {
    return term.IsWord("near") || term.IsWord("next_to") || term.IsWord("behind") || term.IsWord("in_front_of") ||
           term.IsWord("facing") || term.IsWord("opposite") || term.IsWord("parallel") || term.IsWord("left_of") ||
           term.IsWord("right_of") || term.IsWord("perpendicular") || term.IsWord("to_side") || term.IsWord("against");
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

// "Space in front of at least 0.8 m": of the figure, not of a thing.
void EndFrontBeforeFigure(std::vector<Term>& terms) {
  for (size_t i = 0; i + 1 < terms.size(); ++i) {
    if (terms[i].IsWord("in_front_of") && terms[i + 1].kind == Term::Kind::kDistance) terms[i].lemma = "in_front";
  }
}

// "Facing directly towards the door", "blocking or obstructing".
void DropRepeatedWords(std::vector<Term>& terms) {
  const auto repeated = [](const Term& a, const Term& b) {
    return a.kind == Term::Kind::kWord && b.kind == Term::Kind::kWord && a.lemma == b.lemma &&
           a.lemma != "side_by_side";
  };
  std::vector<Term> kept;
  for (size_t i = 0; i < terms.size(); ++i) {
    const bool choice = (terms[i].IsWord("or") || (terms[i].kind == Term::Kind::kSoft && terms[i].lemma == "and")) &&
                        !kept.empty() && i + 1 < terms.size() && repeated(kept.back(), terms[i + 1]);
    if (choice) continue;
    if (kept.empty() || !repeated(kept.back(), terms[i])) kept.push_back(std::move(terms[i]));
  }
  terms = std::move(kept);
}

bool SaysSomething(const Term& term) {
  return term.kind == Term::Kind::kWord && !term.IsWord("not") && !term.IsWord("or") && !term.IsWord("of");
}

// "Against a wall: place it against a wall", "Accessible front: ...": what stands before the colon says it twice. Names
// stay, since "Bed: ..." tells what moves, and so do figures: "Distance from the bed: 0.5 m".
void DropLabel(std::vector<Term>& terms) {
  constexpr size_t kLongestLabel = 6;
  const auto is_colon = [](const Term& term) { return term.kind == Term::Kind::kSoft && term.lemma == ":"; };
  const auto is_purpose = [](const Term& term) { return term.kind == Term::Kind::kPurpose; };
  const auto is_stop = [](const Term& term) { return term.kind == Term::Kind::kStop; };
  const auto is_object = [](const Term& term) {
    return term.kind == Term::Kind::kMention && term.mention.references.front().kind == RefKind::kObjects;
  };
  const auto colon = std::find_if(terms.begin(), terms.end(), is_colon);
  if (colon == terms.end() || colon == terms.begin() || colon - terms.begin() > static_cast<long>(kLongestLabel))
    return;
  if (std::any_of(terms.begin(), colon, is_stop)) return;
  const auto reason = std::find_if(colon, terms.end(), is_purpose);
  // "Proximity of sofa and table: the sofa is near the table" says it twice; "Sofa: near the table" does not.
  const bool names = std::any_of(terms.begin(), colon, is_object);
  if (names && (!std::any_of(terms.begin(), colon, SaysSomething) || !std::any_of(colon, reason, is_object))) return;
  if (!std::any_of(colon, reason, SaysSomething)) return;
  // "Back side: against a wall": the side is what stands there.
  const auto is_own_side = [](const Term& term) {
    return term.kind == Term::Kind::kMention && term.mention.references.front().kind == RefKind::kPronoun &&
           !term.mention.references.front().side.empty();
  };
  const bool of_side = colon - terms.begin() == 1 && is_own_side(terms.front()) &&
                       !std::any_of(colon, std::find_if(colon, reason, is_stop), is_own_side);
  terms.erase(of_side ? colon : terms.begin(), colon + 1);
}

// "Placement: behind the desk", "ideally, behind the desk": what opens a sentence leaves no comma behind.
void DropLeadingCommas(std::vector<Term>& terms) {
  std::vector<Term> kept;
  for (Term& term : terms) {
    const bool opens = kept.empty() || kept.back().kind == Term::Kind::kStop;
    const bool comma = term.kind == Term::Kind::kSoft && (term.lemma == "," || term.lemma == ":");
    if (!opens || !comma) kept.push_back(std::move(term));
  }
  terms = std::move(kept);
}

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

void RewriteDenials(std::vector<Term>& terms) {
  JoinNotToSide(terms);
  MoveNotBehindSubject(terms);
  DenyEachOfChoice(terms);
  SpreadDenial(terms);
}

}  // namespace

void RewriteTerms(std::vector<Term>& terms) {
  DropLeadingCommas(terms);
  DropRepeatedWords(terms);
  DropSofteningOfNear(terms);
  DropWhatIsBlocked(terms);
  DropLabel(terms);
  TakeExamples(terms);
  TakeFirstPlace(terms);
  ShareTarget(terms);
  DropToBesideNot(terms);
  DropCenteredBesideRelation(terms);
  RewriteDenials(terms);
  EndFrontBeforeFigure(terms);
}

}  // namespace flair::translator
