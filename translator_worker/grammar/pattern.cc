// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/pattern.h"

#include <algorithm>

#include "absl/strings/str_split.h"

namespace flair::translator {
namespace {

bool OfSort(const Mention& mention, const std::string& sort) {
  if (sort.empty()) return true;
  const RefKind kind = mention.references.front().kind;
  if (sort == "wall") return kind == RefKind::kWall;
  if (sort == "feature") return kind == RefKind::kFeature;
  if (sort == "ceiling") return kind == RefKind::kCeiling;
  if (sort == "room") return kind == RefKind::kRoom;
  if (sort == "floor") return kind == RefKind::kFloor;
  if (sort == "zone") return kind == RefKind::kZone;
  if (sort == "side") return !mention.references.front().side.empty();
  if (sort == "pronoun") return kind == RefKind::kPronoun;
  if (sort == "vague") return kind == RefKind::kVague;
  if (sort == "list") return mention.references.size() > 1 && kind == RefKind::kObjects;
  if (sort == "group") return kind == RefKind::kGroup;
  if (sort == "thing" && kind == RefKind::kZone) return false;
  return kind == RefKind::kObjects || kind == RefKind::kPronoun || kind == RefKind::kGroup || kind == RefKind::kZone ||
         kind == RefKind::kAbsent;
}

}  // namespace

Pattern::Pattern(std::string_view text) {
  for (std::string part : std::vector<std::string>(absl::StrSplit(std::string(text), ' ', absl::SkipEmpty()))) {
    Element element;
    if (part.back() == '?') {
      element.optional = true;
      part.pop_back();
    }
    const bool slot = part == "," || (part[0] >= 'A' && part[0] <= 'D' && (part.size() == 1 || part[1] == '.'));
    if (slot) {
      element.slot = part[0];
      if (part.size() > 2) element.sort = part.substr(2);
    } else {
      element.words = absl::StrSplit(part, '/');
    }
    elements_.push_back(std::move(element));
  }
}

Match Pattern::At(std::span<const Term> terms) const {
  Match best;
  Step(terms, 0, 0, {}, best);
  return best;
}

std::vector<std::vector<std::string>> Pattern::RequiredWords() const {
  std::vector<std::vector<std::string>> required;
  for (const Element& element : elements_) {
    if (element.slot == 0 && !element.optional) required.push_back(element.words);
  }
  return required;
}

bool Pattern::Fits(const Element& element, const Term& term) const {
  switch (element.slot) {
    case 0:
      return (term.kind == Term::Kind::kWord || term.kind == Term::Kind::kPurpose) &&
             std::find(element.words.begin(), element.words.end(), term.lemma) != element.words.end();
    case ',':
      return term.kind == Term::Kind::kSoft;
    case 'D':
      return term.kind == Term::Kind::kDistance;
    default:
      return term.kind == Term::Kind::kMention && OfSort(term.mention, element.sort);
  }
}

void Pattern::Step(std::span<const Term> terms, size_t at, size_t element, Match match, Match& best) const {
  if (element == elements_.size()) {
    // A comma at the end belongs to what follows.
    while (at > 0 && terms[at - 1].kind == Term::Kind::kSoft) --at;
    match.length = at;
    if (at > best.length) best = match;
    return;
  }
  const Element& wanted = elements_[element];
  if (at < terms.size() && Fits(wanted, terms[at])) {
    Match next = match;
    if (wanted.slot == 'A') next.a = &terms[at].mention;
    if (wanted.slot == 'B') next.b = &terms[at].mention;
    if (wanted.slot == 'C') next.c = &terms[at].mention;
    if (wanted.slot == 'D') next.distance = &terms[at].distance;
    Step(terms, at + 1, element + 1, next, best);
  }
  if (wanted.optional) Step(terms, at, element + 1, match, best);
}

}  // namespace flair::translator
