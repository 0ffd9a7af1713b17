// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/noun_quantities.h"

#include <algorithm>
#include <string>
#include <utility>

namespace flair::translator {
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
  const bool named = std::any_of(out.begin(), out.end(), [](const RawTerm& raw) {
    return IsThing(raw) && raw.term.mention.references.back().candidates.size() > 1;
  });
  return !named && std::count_if(raws.begin(), raws.end(), one) == 2;
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

}  // namespace flair::translator
