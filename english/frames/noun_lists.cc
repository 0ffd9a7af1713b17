// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>
#include <utility>

#include "english/frames/noun_phrases.h"

namespace flair::english {
namespace {

using Role = RawTerm::Role;

bool IsVague(const RawTerm& raw) {
  return IsMention(raw) && raw.term.mention.references.back().kind == RefKind::kVague;
}

// The thing spoken of before that "the other", "the second one", "the first one" is another of.
const RawTerm* Earlier(int ordinal, const std::vector<RawTerm>& out) {
  for (size_t i = out.size(); i > 0; --i) {
    if (!IsThing(out[i - 1])) continue;
    const Reference& reference = out[i - 1].term.mention.references.back();
    const bool fits = ordinal == 1 ? reference.ordinal > 1 : reference.ordinal == ordinal - 1;
    if (fits && reference.candidates.size() > 1) return &out[i - 1];
  }
  return nullptr;
}

void NameTheOther(const Term& term, int ordinal, std::vector<RawTerm>& out) {
  const RawTerm* const earlier = Earlier(ordinal, out);
  if (earlier == nullptr) return;
  RawTerm named = *earlier;
  named.term.begin = term.begin;
  named.term.end = term.end;
  named.term.mention.references.back().ordinal = ordinal;
  out.push_back(std::move(named));
}

// "One above the desk and the other above the bed": of those that the heading names, none being named here.
bool StandsAlone(const std::vector<RawTerm>& raws, size_t at, const std::vector<RawTerm>& out) {
  const auto relates = [&](size_t i) {
    return i < raws.size() && raws[i].role == Role::kNone && raws[i].term.kind == Term::Kind::kWord;
  };
  if (!relates(at + 1) || raws[at].ordinal > 2 || raws[at + 1].term.IsWord("of")) return false;
  const auto one = [&](const RawTerm& raw) {
    return raw.role == Role::kOrdinal && raw.ordinal < 3 && relates(static_cast<size_t>(&raw - raws.data()) + 1);
  };
  const bool named = std::ranges::any_of(
      out, [](const RawTerm& raw) { return IsThing(raw) && raw.term.mention.references.back().candidates.size() > 1; });
  return !named && std::ranges::count_if(raws, one) == 2;
}

RawTerm OneOfHeading(const RawTerm& raw, int number) {
  RawTerm named = raw;
  named.role = Role::kNone;
  named.term.kind = Term::Kind::kMention;
  Reference reference;
  reference.name = "one";
  reference.ordinal = number;
  named.term.mention.references = {std::move(reference)};
  return named;
}

// "Each long side".
std::string BothOf(const std::string& side) {
  if (side == "long_one") return "long_both";
  if (side == "short_one") return "short_both";
  return side == "side" ? "sides" : side;
}

bool AdjectiveLike(const Term& term) {
  if (term.kind != Term::Kind::kUnknown) return false;
  const std::string& word = term.lemma;
  return word.size() < 3 || (word.back() != 's' && word.substr(word.size() - 3) != "ing");
}

class ListJoiner {
 public:
  explicit ListJoiner(std::vector<RawTerm> in) : in_(std::move(in)) {}

  std::vector<Term> Run() {
    std::vector<Term> out;
    bool relation_seen = false;
    for (size_t i = 0; i < in_.size(); ++i) {
      RawTerm& raw = in_[i];
      if (raw.role == Role::kModal) {
        DropWhichOnes(out);
        continue;
      }
      if (raw.role == Role::kAnd || raw.role == Role::kOr) {
        raw.term.kind = raw.role == Role::kAnd ? Term::Kind::kSoft : Term::Kind::kWord;
        raw.term.lemma = raw.role == Role::kAnd ? "and" : "or";
        out.push_back(std::move(raw.term));
        continue;
      }
      if (raw.term.kind == Term::Kind::kStop) relation_seen = false;
      if (IsMention(raw) && subject_.empty()) subject_ = raw.term.mention.references.back().name;
      if (raw.term.kind == Term::Kind::kWord) {
        relation_seen = relation_seen || raw.term.lemma != "not";
        after_between_ = raw.term.lemma == "between";
        after_away_ = raw.term.lemma == "away_from";
      }
      if (IsMention(raw)) i = ReadList(i, relation_seen);
      out.push_back(std::move(in_[i].term));
    }
    return out;
  }

 private:
  const RawTerm* Peek(size_t index) const { return index < in_.size() ? &in_[index] : nullptr; }

  // "The chairs around the table should ...": which chairs, not where they stand.
  static void DropWhichOnes(std::vector<Term>& out) {
    const size_t count = out.size();
    if (count < 3 || out[count - 1].kind != Term::Kind::kMention || out[count - 3].kind != Term::Kind::kMention) return;
    const Term& relation = out[count - 2];
    const bool which = relation.IsWord("next_to") || relation.IsWord("around") || relation.IsWord("surround");
    const bool begins = count == 3 || out[count - 4].kind == Term::Kind::kStop;
    const bool things = out[count - 3].mention.references.front().kind == RefKind::kObjects &&
                        out[count - 1].mention.references.front().kind == RefKind::kObjects;
    if (which && begins && things) out.resize(count - 2);
  }

  // Things are listed with things and parts of the room with parts of the room.
  static bool SameSort(const Term& a, const Term& b) {
    return IsShell(a.mention.references.back().kind) == IsShell(b.mention.references.back().kind);
  }

  static bool IsShell(RefKind kind) {
    return kind == RefKind::kWall || kind == RefKind::kCeiling || kind == RefKind::kRoom || kind == RefKind::kFloor;
  }

  // Merges the list that begins at i into its last member; returns the index of that member.
  size_t ReadList(size_t i, bool relation_seen) {
    while (true) {
      size_t next = i + 1;
      bool joined = false;
      bool either = in_[i].term.mention.either;
      while (Peek(next) && (in_[next].role == Role::kAnd || in_[next].role == Role::kOr ||
                            (in_[next].role == Role::kNone && in_[next].term.IsSoft(",")))) {
        if (in_[next].role == Role::kOr) either = true;
        joined = joined || in_[next].role == Role::kAnd || in_[next].role == Role::kOr || ListGoesOn(next);
        ++next;
      }
      if (!joined || !Peek(next) || !IsMention(in_[next]) || !SameSort(in_[i].term, in_[next].term)) return i;
      // "... near the desk and the armchair should face the sofa": a new clause, not a list.
      if (relation_seen && !after_between_ && Peek(next + 1) && in_[next + 1].role == Role::kModal) return i;
      if (relation_seen && (BeginsFact(next) || IsNewSubject(next) || IsOwnSideAfterFeature(i, next))) return i;
      Mention merged = std::move(in_[i].term.mention);
      for (Reference reference : in_[next].term.mention.references) {
        const Reference& before = merged.references.back();
        // "the wardrobe's doors or drawers": both are the wardrobe's.
        if (reference.kind == RefKind::kPronoun && reference.name.empty() && before.kind == RefKind::kObjects) {
          const std::string side = reference.side;
          reference = before;
          reference.side = side;
        }
        merged.references.push_back(std::move(reference));
      }
      merged.either = either;
      in_[next].term.mention = std::move(merged);
      in_[next].term.begin = in_[i].term.begin;
      i = next;
    }
  }

  // "Not in front of windows, and it does not block doors".
  bool IsNewSubject(size_t next) const {
    const Reference& reference = in_[next].term.mention.references.back();
    return reference.kind == RefKind::kPronoun && !reference.name.empty() && reference.side.empty() &&
           !after_between_ && !after_away_;
  }

  // "Close to a socket and its back to the wall": whose side it is, the socket does not say.
  bool IsOwnSideAfterFeature(size_t i, size_t next) const {
    const Reference& reference = in_[next].term.mention.references.back();
    return IsFeature(in_[i]) && reference.kind == RefKind::kPronoun && !reference.side.empty();
  }

  // "Chair 1 to the left of the table and chair 2 to its right": another of what was spoken of first, and a relation.
  bool BeginsFact(size_t next) const {
    const Reference& reference = in_[next].term.mention.references.back();
    if (reference.kind != RefKind::kObjects || WithoutNumber(reference.name) != WithoutNumber(subject_) ||
        after_between_ || !Peek(next + 2))
      return false;
    const Term& relation = in_[next + 1].term;
    return in_[next + 1].role == Role::kNone && relation.kind == Term::Kind::kWord && !relation.IsWord("not") &&
           !relation.IsWord("of") && (IsMention(in_[next + 2]) || in_[next + 2].role == Role::kSide);
  }

  // "the bed, wardrobe, and desk": after the comma come only list members up to an "and" or "or".
  bool ListGoesOn(size_t comma) const {
    // "Doors, windows.": features need no "and".
    if (comma > 0 && Peek(comma + 1) && IsFeature(in_[comma - 1]) && IsFeature(in_[comma + 1])) return true;
    for (size_t i = comma + 1, seen = 0; Peek(i) && seen < 12; ++i, ++seen) {
      if (in_[i].role == Role::kAnd || in_[i].role == Role::kOr) return i > comma + 1;
      if (!IsMention(in_[i]) && !in_[i].term.IsSoft(",")) return false;
    }
    return false;
  }

  std::vector<RawTerm> in_;
  // The name that the sentence speaks of first.
  std::string subject_;
  // "between X and Y should": X and Y belong together.
  bool after_between_ = false;
  // "away from X and Y": walls and features in one list.
  bool after_away_ = false;
};

}  // namespace

std::vector<RawTerm> AttachQuantities(std::vector<RawTerm> raws) {
  std::vector<RawTerm> out;
  bool each = false;
  bool none = false;
  bool other = false;
  Term other_term;
  int ordinal = 0;
  int alone = 0;
  for (RawTerm& raw : raws) {
    if (raw.role == Role::kEach) {
      each = true;
      none = none || raw.negative;
      continue;
    }
    if (raw.role == Role::kOrdinal && StandsAlone(raws, static_cast<size_t>(&raw - raws.data()), out)) {
      out.push_back(OneOfHeading(raw, ++alone));
      continue;
    }
    if (raw.role == Role::kOrdinal) {
      if (other && raw.ordinal == 1) continue;  // "the second one", "the first one"
      ordinal = raw.ordinal;
      other = raw.ordinal > 1 || other || Earlier(ordinal, out) != nullptr;
      if (other) other_term = raw.term;
      continue;
    }
    if (other && !IsMention(raw)) NameTheOther(other_term, ordinal, out);
    other = false;
    // "Water splash and sockets": what follows a vague thing belongs to it.
    if (raw.role == Role::kNone && raw.term.kind == Term::Kind::kUnknown && !out.empty() && IsVague(out.back())) {
      out.back().term.end = raw.term.end;
      continue;
    }
    if (IsMention(raw)) {
      Reference& reference = raw.term.mention.references.back();
      // "Along each long side of the table": of one table.
      reference.each = reference.each || (each && !(raw.side_first && reference.kind == RefKind::kObjects));
      // "Both the front and one side" are two, no two of a kind.
      const bool one_side = raw.term.mention.references.size() == 1;
      if (each && raw.side_first && one_side) reference.side = BothOf(reference.side);
      if (ordinal > 0) reference.ordinal = ordinal;
      if ((IsThing(raw) || IsFeature(raw) || reference.kind == RefKind::kWall) && !out.empty() &&
          out.back().role == Role::kNone && AdjectiveLike(out.back().term)) {
        out.pop_back();
        // "Flammable objects": which those are, nobody knows.
        const bool unnamed = reference.kind == RefKind::kGroup && !reference.each &&
                             (reference.name == "all" || reference.name == "others");
        if (unnamed) reference.name = "kind";
      }
      each = false;
      ordinal = 0;
    } else if (raw.term.kind != Term::Kind::kUnknown || raw.role != Role::kNone) {
      each = false;
      ordinal = 0;
    }
    const bool negative = raw.negative || (none && IsMention(raw));
    if (negative) none = false;
    out.push_back(std::move(raw));
    if (negative) {
      RawTerm denial;
      denial.term.kind = Term::Kind::kWord;
      denial.term.lemma = "not";
      out.push_back(std::move(denial));
    }
  }
  return out;
}

std::vector<Term> JoinLists(std::vector<RawTerm> raw) { return ListJoiner(std::move(raw)).Run(); }

}  // namespace flair::english
