// SPDX-License-Identifier: GPL-3.0-or-later
#include "english/frames/noun_phrases.h"

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

}  // namespace flair::english
