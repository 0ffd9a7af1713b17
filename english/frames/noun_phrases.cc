// SPDX-License-Identifier: GPL-3.0-or-later
#include "english/frames/noun_phrases.h"

#include <algorithm>

namespace flair::english {
namespace {

using Role = RawTerm::Role;

bool IsOf(const RawTerm& raw) { return raw.role == Role::kNone && raw.term.IsWord("of"); }

// One pass: reads `in_` from left to right and writes finished terms.
class Grouper {
 public:
  explicit Grouper(std::vector<RawTerm> in) : in_(std::move(in)) {}

  std::vector<Term> Run() {
    AttachSides();
    return JoinLists(AttachQuantities(std::move(in_)));
  }

 private:
  const RawTerm* Peek(size_t index) const { return index < in_.size() ? &in_[index] : nullptr; }

  static RawTerm BareSide(const RawTerm& side) {
    RawTerm raw = side;
    raw.role = Role::kNone;
    raw.term.kind = Term::Kind::kMention;
    raw.term.mention.references = {{.kind = RefKind::kPronoun, .name = "", .side = side.term.lemma}};
    raw.term.lemma.clear();
    return raw;
  }

  // "X 's SIDE", "X SIDE", "its SIDE", "SIDE of X", "X doors".
  void AttachSides() {
    std::vector<RawTerm> out;
    for (size_t i = 0; i < in_.size(); ++i) {
      RawTerm& raw = in_[i];
      if (IsThing(raw)) {
        const bool possessive = Peek(i + 1) && in_[i + 1].role == Role::kPossessive;
        size_t next = i + (possessive ? 2 : 1);
        if (Peek(next) && in_[next].role == Role::kEach && Peek(next + 1) && in_[next + 1].role == Role::kSide) ++next;
        Reference& reference = raw.term.mention.references.back();
        // "Between each nightstand and its bed": whose it is follows from what the fact relates.
        if (!possessive && IsPossessivePronoun(raw) && Peek(next) && IsMention(in_[next]) &&
            in_[next].term.mention.references.back().kind == RefKind::kObjects) {
          in_[next].term.mention.references.back().own = true;
          continue;
        }
        if (Peek(next) && in_[next].role == Role::kSide &&
            (possessive || reference.kind != RefKind::kPronoun || reference.name == "it" || reference.name == "them")) {
          reference.side = in_[next].term.lemma;
          raw.term.end = in_[next].term.end;
          i = next;
        } else if (Peek(next) && IsFeature(in_[next]) && in_[next].part_of_furniture) {
          reference.side = "front";
          raw.term.end = in_[next].term.end;
          i = next;
        } else if (possessive) {
          i = next - 1;
        }
        out.push_back(std::move(raw));
      } else if (IsPartOf(i)) {
        raw.part_of_furniture = false;
        raw.term.mention = in_[i + 2].term.mention;
        raw.term.mention.references.back().side = "front";
        raw.term.end = in_[i + 2].term.end;
        out.push_back(std::move(raw));
        i += 2;
      } else if (IsLeftOrRightOne(i)) {
        in_[i + 1].term.mention.references.back().ordinal = raw.term.lemma == "left" ? 1 : 2;
      } else if (raw.role == Role::kSide) {
        i = AttachOf(i, out);
      } else if (raw.role != Role::kPossessive) {
        out.push_back(std::move(raw));
      }
    }
    in_ = std::move(out);
  }

  static bool IsPossessivePronoun(const RawTerm& raw) {
    const Reference& reference = raw.term.mention.references.back();
    const size_t length = raw.term.end - raw.term.begin;
    return reference.kind == RefKind::kPronoun &&
           ((reference.name == "it" && length == 3) || (reference.name == "them" && length == 5));
  }

  // "The doors of the wardrobe" are its front.
  bool IsPartOf(size_t i) const {
    return IsFeature(in_[i]) && in_[i].part_of_furniture && Peek(i + 2) && IsOf(in_[i + 1]) && IsThing(in_[i + 2]) &&
           in_[i + 2].term.mention.references.back().kind == RefKind::kObjects;
  }

  // "The right nightstand" of two.
  bool IsLeftOrRightOne(size_t i) const {
    if (in_[i].role != Role::kSide || (in_[i].term.lemma != "left" && in_[i].term.lemma != "right")) return false;
    if (in_[i].term.end - in_[i].term.begin > 5 || !Peek(i + 1) || !IsThing(in_[i + 1])) return false;
    const Reference& reference = in_[i + 1].term.mention.references.back();
    return reference.kind == RefKind::kObjects && reference.candidates.size() == 2 && !reference.plural;
  }

  bool IsComma(size_t i) const { return Peek(i) && in_[i].role == Role::kNone && in_[i].term.IsSoft(","); }

  // The side that a list goes on with at `next`, 0 when it does not: "front, left and right" needs its "and".
  size_t NextSide(size_t next) const {
    size_t i = next;
    const auto side_after_comma = [&](size_t at) {
      return IsComma(at) && Peek(at + 1) && in_[at + 1].role == Role::kSide;
    };
    // "Front, left and right": these two are one word of the lexicon.
    if (side_after_comma(i) && in_[i + 1].term.lemma == "sides") return i + 1;
    while (side_after_comma(i)) i += 2;
    if (IsComma(i)) ++i;
    const bool ends =
        Peek(i + 1) && (in_[i].role == Role::kAnd || in_[i].role == Role::kOr) && in_[i + 1].role == Role::kSide;
    if (!ends) return 0;
    return IsComma(next) && in_[next + 1].role == Role::kSide ? next + 1 : i + 1;
  }

  // "front and sides of the bed"; returns the last index that was used.
  size_t AttachOf(size_t i, std::vector<RawTerm>& out) {
    std::vector<size_t> sides = {i};
    size_t next = i + 1;
    while (const size_t joined = NextSide(next)) {
      sides.push_back(joined);
      next = joined + 1;
    }
    RawTerm raw = BareSide(in_[i]);
    raw.side_first = true;
    Mention& mention = raw.term.mention;
    mention.references.clear();
    for (const size_t index : sides) mention.references.push_back(BareSide(in_[index]).term.mention.references.front());
    mention.either = sides.size() > 1 && in_[sides.back() - 1].role == Role::kOr;
    raw.term.end = in_[next - 1].term.end;
    size_t owner = next + 1;
    while (Peek(next) && IsOf(in_[next]) && Peek(owner) &&
           (in_[owner].role == Role::kEach || in_[owner].role == Role::kOrdinal || IsLeftOrRightOne(owner))) {
      ++owner;
    }
    if (Peek(next) && IsOf(in_[next]) && Peek(owner) && (IsThing(in_[owner]) || IsMention(in_[owner]))) {
      for (Reference& reference : mention.references) {
        const std::string side = reference.side;
        reference = in_[owner].term.mention.references.back();
        reference.side = side;
        for (size_t k = next + 1; k < owner; ++k) {
          if (in_[k].role == Role::kOrdinal) reference.ordinal = in_[k].ordinal;
          if (in_[k].role == Role::kSide) reference.ordinal = in_[k].term.lemma == "left" ? 1 : 2;
          if (in_[k].role == Role::kEach) reference.each = true;
        }
      }
      raw.term.end = in_[owner].term.end;
      next = owner + 1;
      if (Peek(next) && in_[next].role == Role::kPossessive) ++next;
    }
    out.push_back(std::move(raw));
    return next - 1;
  }

  std::vector<RawTerm> in_;
};

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

bool IsThing(const RawTerm& raw) {
  if (!IsMention(raw)) return false;
  const RefKind kind = raw.term.mention.references.back().kind;
  return kind == RefKind::kObjects || kind == RefKind::kPronoun || kind == RefKind::kAbsent || kind == RefKind::kGroup;
}

bool IsMention(const RawTerm& raw) { return raw.role == Role::kNone && raw.term.kind == Term::Kind::kMention; }

bool IsFeature(const RawTerm& raw) {
  return IsMention(raw) && raw.term.mention.references.back().kind == RefKind::kFeature;
}

std::vector<Term> GroupNounPhrases(std::vector<RawTerm> raw) { return Grouper(std::move(raw)).Run(); }

void RewriteTerms(std::vector<Term>& terms) {
  DropRepeatedWords(terms);
  DropLabel(terms);
  ShareTarget(terms);
  DropToBesideNot(terms);
  RewriteDenials(terms);
}

}  // namespace flair::english
