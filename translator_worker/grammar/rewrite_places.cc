// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/rewrite_places.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <utility>

namespace flair::translator {
namespace {

// Most sentences have nothing for most passes, which then copy nothing.
bool HasAnyWord(const std::vector<Term>& terms, std::initializer_list<std::string_view> words) {
  return std::any_of(terms.begin(), terms.end(), [&](const Term& term) { return term.IsAnyWord(words); });
}

bool SaysPlace(const Term& term) {
  return term.IsAnyWord(
      {"behind", "in_front_of", "around", "left_of", "right_of", "each_side_of", "in_front", "at_sides", "all_sides"});
}

// "0.6 m of space should be kept free behind it", "0.6 m must be left open before the shelf": space there.
void ReadKeptFreeAsSpace(std::vector<Term>& terms) {
  if (!HasAnyWord(terms, {"keep_clear"})) return;
  std::vector<Term> out;
  for (size_t i = 0; i < terms.size(); ++i) {
    const bool kept = terms[i].IsWord("keep_clear") && i > 0 && i + 1 < terms.size() && SaysPlace(terms[i + 1]);
    const bool of_space = kept && terms[i - 1].IsWord("space");
    const bool of_figure = kept && terms[i - 1].kind == Term::Kind::kDistance;
    if (of_space) continue;
    out.push_back(terms[i]);
    if (of_figure) out.back().lemma = "space";
  }
  terms = std::move(out);
}

// "0.9 m all around the table", "space all round it": on all its sides. "Around" alone leaves out the wall's.
void ReadAllAroundThing(std::vector<Term>& terms) {
  constexpr size_t kPlainLength = 6;
  for (size_t i = 0; i + 1 < terms.size(); ++i) {
    const bool all = terms[i].IsWord("around") && terms[i].end - terms[i].begin > kPlainLength + 1;
    const bool space =
        i > 0 ? terms[i - 1].kind == Term::Kind::kDistance || terms[i - 1].IsAnyWord({"space", "keep_clear"})
              : i + 2 < terms.size() && terms[i + 2].kind == Term::Kind::kDistance;
    const Term& next = terms[i + 1];
    const bool figure = next.kind == Term::Kind::kDistance || next.IsWord("of");
    if (all && space && (next.kind == Term::Kind::kMention || figure)) terms[i].lemma = "all_sides";
  }
}

bool IsBareSideOf(const Term& term, std::string_view side) {
  if (term.kind != Term::Kind::kMention || term.mention.references.size() != 1) return false;
  const Reference& reference = term.mention.references.front();
  return reference.kind == RefKind::kPronoun && reference.side == side;
}

// "On the left and on the right", as two places or as one list of sides; 0 when it is something else.
size_t LeftAndRight(const std::vector<Term>& terms, size_t at) {
  const auto place = [&](size_t i) { return i + 1 < terms.size() && terms[i].IsAnyWord({"on", "next_to", "along"}); };
  if (!place(at) || terms[at + 1].kind != Term::Kind::kMention) return 0;
  const std::vector<Reference>& first = terms[at + 1].mention.references;
  if (first.size() == 2) {
    const bool lateral =
        (first[0].side == "left" && first[1].side == "right") || (first[0].side == "right" && first[1].side == "left");
    return lateral ? 2 : 0;
  }
  const size_t other = at + 3;
  if (!place(other) || terms[at + 2].kind != Term::Kind::kSoft) return 0;
  const bool lateral = (IsBareSideOf(terms[at + 1], "left") && IsBareSideOf(terms[other + 1], "right")) ||
                       (IsBareSideOf(terms[at + 1], "right") && IsBareSideOf(terms[other + 1], "left"));
  return lateral ? 5 : 0;
}

// "Adjacent to the bed, one on its left and the other on its right": one at each side of it.
void ReadOneAtEachSide(std::vector<Term>& terms) {
  if (!HasAnyWord(terms, {"on", "along", "next_to"}) || terms.size() < 5) return;
  std::vector<Term> out;
  for (size_t i = 0; i < terms.size(); ++i) {
    const bool after_contact = terms[i].kind == Term::Kind::kSoft && out.size() > 1 &&
                               out.back().kind == Term::Kind::kMention &&
                               out[out.size() - 2].IsAnyWord({"next_to", "near", "against", "each_side_of"});
    const size_t sides = after_contact ? LeftAndRight(terms, i + 1) : 0;
    if (sides == 0) {
      out.push_back(terms[i]);
      continue;
    }
    out.push_back(terms[i + 1]);
    out.back().lemma = "one_each_side";
    i += sides;
  }
  terms = std::move(out);
}

// "The window above must not be covered", "the socket behind stays free": which one, of what is spoken of.
void DropPlaceAfterFeature(std::vector<Term>& terms) {
  const auto feature = [](const Term& term) {
    return term.kind == Term::Kind::kMention && term.mention.references.front().kind == RefKind::kFeature;
  };
  if (!HasAnyWord(terms, {"above", "behind", "next_to", "under"}) || std::none_of(terms.begin(), terms.end(), feature))
    return;
  std::vector<Term> out;
  for (size_t i = 0; i < terms.size(); ++i) {
    const bool after_feature = !out.empty() && feature(out.back());
    const bool place = terms[i].IsAnyWord({"above", "behind", "next_to", "under"});
    const bool verb = i + 1 < terms.size() && terms[i + 1].IsAnyWord({"not", "keep_clear", "accessible"});
    if (!after_feature || !place || !verb) out.push_back(terms[i]);
  }
  terms = std::move(out);
}

// "Center the stand opposite the sofa": the stand is, centred.
void MoveCenteredBehindThing(std::vector<Term>& terms) {
  for (size_t i = 0; i + 2 < terms.size(); ++i) {
    const bool begins = i == 0 || terms[i - 1].kind == Term::Kind::kStop;
    const bool thing = terms[i + 1].kind == Term::Kind::kMention && terms[i + 2].kind == Term::Kind::kWord &&
                       terms[i + 1].mention.references.front().kind == RefKind::kObjects;
    const bool imperative = terms[i].IsWord("centered") && terms[i].end - terms[i].begin <= 10;
    if (begins && imperative && thing && !terms[i + 2].IsAnyWord({"not", "or", "of"}))
      std::swap(terms[i], terms[i + 1]);
  }
}

}  // namespace

void BringPlacesFirst(std::vector<Term>& terms) { MoveCenteredBehindThing(terms); }

void RewritePlaces(std::vector<Term>& terms) {
  DropPlaceAfterFeature(terms);
  ReadAllAroundThing(terms);
  ReadOneAtEachSide(terms);
  ReadKeptFreeAsSpace(terms);
}

}  // namespace flair::translator
