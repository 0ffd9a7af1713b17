// SPDX-License-Identifier: GPL-3.0-or-later
#include "english/frames/frames.h"

#include <algorithm>
#include <map>

#include "absl/strings/str_split.h"
#include "english/language.h"

namespace flair::english {

bool IsOfKind(RefKind kind, std::string_view name) {
  static const std::map<std::string_view, RefKind> kKinds = {
      {"wall", RefKind::kWall},       {"corner", RefKind::kCorner}, {"feature", RefKind::kFeature},
      {"ceiling", RefKind::kCeiling}, {"room", RefKind::kRoom},     {"floor", RefKind::kFloor},
      {"zone", RefKind::kZone},       {"vague", RefKind::kVague},   {"pronoun", RefKind::kPronoun},
      {"group", RefKind::kGroup}};
  const auto wanted = kKinds.find(name);
  return wanted != kKinds.end() && wanted->second == kind;
}

bool OfSort(const Mention& mention, std::string_view sort) {
  const RefKind kind = mention.references.front().kind;
  if (sort.empty() || IsOfKind(kind, sort)) return true;
  if (sort == "side") return !mention.references.front().side.empty();
  if (sort == "list") return mention.references.size() > 1 && kind == RefKind::kObjects;
  const bool thing =
      kind == RefKind::kObjects || kind == RefKind::kPronoun || kind == RefKind::kGroup || kind == RefKind::kAbsent;
  return sort == "thing" ? thing : sort == "object" && (thing || kind == RefKind::kZone);
}

Form::Form(std::string_view text) {
  for (std::string part : std::vector<std::string>(absl::StrSplit(std::string(text), ' ', absl::SkipEmpty()))) {
    Element element;
    if (part.back() == '?') {
      element.optional = true;
      part.pop_back();
    }
    const bool slot =
        part == "," || part == "~" || (part[0] >= 'A' && part[0] <= 'D' && (part.size() == 1 || part[1] == '.'));
    if (slot) {
      element.slot = part[0];
      if (part.size() > 2) element.sort = part.substr(2);
    } else {
      element.words = absl::StrSplit(part, '/');
    }
    elements_.push_back(std::move(element));
  }
}

Match Form::At(std::span<const Term> terms) const {
  Match best;
  Step(terms, 0, 0, {}, best);
  return best;
}

bool Form::Takes(const Match& match) const {
  const auto element_of = [&](char slot) {
    return std::ranges::find_if(
        elements_, [&](const Element& one) { return one.slot == slot || (slot == 'D' && one.slot == '~'); });
  };
  const auto fits = [&](char slot, const Mention* mention, bool bound) {
    const auto element = element_of(slot);
    if (element == elements_.end()) return !bound;
    return bound ? mention == nullptr || OfSort(*mention, element->sort) : element->optional || element->slot == '~';
  };
  return fits('A', match.a, match.a != nullptr) && fits('B', match.b, match.b != nullptr) &&
         fits('C', match.c, match.c != nullptr) && fits('D', nullptr, match.distance != nullptr);
}

bool Form::Fits(const Element& element, const Term& term, const Match& match) const {
  switch (element.slot) {
    case 0:
      return (term.kind == Term::Kind::kWord || term.kind == Term::Kind::kPurpose) &&
             std::ranges::find(element.words, term.lemma) != element.words.end();
    case ',':
      return term.kind == Term::Kind::kSoft;
    case 'D':
      return term.kind == Term::Kind::kDistance;
    case '~':
      return term.kind == Term::Kind::kSoft || term.IsAnyWord({"space", "of"}) ||
             (term.kind == Term::Kind::kDistance && match.distance == nullptr);
    default:
      return term.kind == Term::Kind::kMention && OfSort(term.mention, element.sort);
  }
}

void Form::Step(std::span<const Term> terms, size_t at, size_t element, Match match, Match& best) const {
  if (element == elements_.size()) {
    // A comma at the end belongs to what follows.
    while (at > 0 && terms[at - 1].kind == Term::Kind::kSoft) --at;
    match.length = at;
    if (at > best.length) best = match;
    return;
  }
  const Element& wanted = elements_[element];
  if (at < terms.size() && Fits(wanted, terms[at], match)) {
    Match next = match;
    if (wanted.slot == 'A') next.a = &terms[at].mention;
    if (wanted.slot == 'B') next.b = &terms[at].mention;
    if (wanted.slot == 'C') next.c = &terms[at].mention;
    if (terms[at].kind == Term::Kind::kDistance) next.distance = &terms[at].distance;
    Step(terms, at + 1, wanted.slot == '~' ? element : element + 1, next, best);
  }
  if (wanted.optional || wanted.slot == '~') Step(terms, at, element + 1, match, best);
}

const FrameBook& FrameBook::Get() {
  static const auto* const book = new FrameBook;
  return *book;
}

FrameBook::FrameBook() {
  for (const v1::Frame& frame : Language::Get().data().frames()) {
    for (const std::string& text : frame.forms()) forms_.push_back({Form(text), &frame});
  }
}

FrameBook::Hit FrameBook::Find(std::span<const Term> terms) const {
  Hit best;
  for (const Entry& entry : forms_) {
    const Match match = entry.form.At(terms);
    if (match.length > best.match.length) best = {entry.frame->meaning(), entry.frame->detail(), match};
  }
  return best;
}

bool FrameBook::Knows(std::string_view meaning, std::string_view detail, const Match& match) const {
  return std::ranges::any_of(forms_, [&](const Entry& entry) {
    return entry.frame->meaning() == meaning && entry.frame->detail() == detail && entry.form.Takes(match);
  });
}

}  // namespace flair::english
