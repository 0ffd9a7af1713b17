// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/no_piece.h"

#include <algorithm>

#include "english/wordnet.h"
#include "english/words.h"
#include "language_worker/handbook/reading/meanings.h"
#include "language_worker/handbook/reading/other_words.h"
#include "language_worker/handbook/reading/piece_words.h"
#include "language_worker/handbook/reading/vocabulary.h"

namespace flair::language {

namespace {

// "A rack for eight bikes", "a stand for his piano", "TV for the football".
bool IsHeld(const BriefText& text, const hb::Furniture& furniture, std::size_t i) {
  std::size_t begin = text.PhraseBegin(i);
  if (begin > 1 && text.At(begin - 1) == "for" && IsFormIn("shows_things", text.At(begin - 2))) return true;
  if (!IsFloorPiece(furniture) || PlacesOn(furniture) > 0) return false;
  const bool known = text.Is(begin, "known_before");
  // "For the vacuum and ironing board".
  const bool counted = text.IsNumber(begin) || NumberWord(text.At(begin)) || text.Is(begin, "vague_numbers");
  if (begin > 1 && text.At(begin - 1) == "and" && !counted) begin = text.PhraseBegin(begin - 2);
  for (std::size_t at = begin - std::min<std::size_t>(begin, 3); at > 0 && at < begin; ++at) {
    const std::size_t end = text.BehindPhrase(at, "made_for").value_or(0);
    if (end < begin || end > i) continue;
    return known ? IsFormIn("holders_of_things", text.At(at - 1)) : IsFormIn("thing_nouns", text.At(at - 1));
  }
  return false;
}

// "Wide enough for prams", "so that prams can pass".
bool IsPassing(const BriefText& text, std::size_t i, std::size_t length) {
  const std::size_t begin = text.PhraseBegin(i);
  const bool wide = begin > 2 && text.At(begin - 1) == "for" && text.At(begin - 2) == "enough";
  if (wide && text.Is(begin - 3, "wide_ways")) return true;
  return text.Is(i + length, "modal_verbs") && text.Is(i + length + 1, "verbs_of_passing");
}

// Whether the word at a token is that for the room behind a door which the brief names, not for a piece: "the back door
// to the toilets", "the closet door". "A door to the toilet" and "a toilet" are two.
bool IsNamedByADoor(const BriefText& text, std::size_t i) {
  constexpr std::size_t kMostWords = 3;
  if (text.Is(i + 1, "doors") && !text.At(i + 1).ends_with('s')) return true;
  const std::size_t at = text.PhraseBegin(i);
  if (at == 0 || !text.Says(at - 1, {"to", "into", "onto", "from"})) return false;
  std::size_t door = at - 1;  // "leading to"
  while (door > 0 && door + kMostWords > at && !text.Is(door, "doors")) --door;
  return text.Is(door, "doors");
}

// "Waiters with trays".
bool IsBorne(const BriefText& text, const hb::Furniture& furniture, std::size_t i) {
  return i > 1 && text.At(i - 1) == "with" && CountsPeople(text.At(i - 2)) && text.At(i).ends_with('s') &&
         furniture.kind() == hb::FURNITURE_KIND_SURFACE;
}

// "Where customers drop off bikes".
bool IsOfATale(const BriefText& text, std::size_t i) {
  constexpr std::size_t kMostBack = 6;
  if (!text.At(i).ends_with('s') || text.PhraseBegin(i) == 0) return false;
  bool people = false;
  for (std::size_t at = i; at > 0 && i - at < kMostBack; --at) {
    const std::size_t k = at - 1;
    if (text.IsSign(k) || text.IsNumber(k) || NumberWord(text.At(k)) || text.Is(k, "articles")) return false;
    if (text.Is(k, "having") || text.Is(k, "have") || text.Is(k, "verbs_of_being")) return false;
    people = people || CountsPeople(text.At(k));
    if (text.Is(k, "clause_openers")) return people;
  }
  return false;
}

}  // namespace

bool IsNoNoun(const BriefText& text, std::size_t i) {
  // "A trolley can pass".
  if (i > 0 && text.Is(i - 1, "modal_verbs")) return true;
  const std::size_t next = text.IsHyphen(i + 1) ? i + 2 : i + 1;
  return (text.Is(i, "verbs_of_having") && (text.Is(i + 1, "thing_articles") || NumberWord(text.At(i + 1)))) ||
         text.Says(next, {"shaped", "shape"}) || (text.At(next) == "of" && IsFormIn("groups_of_pieces", text.At(i)));
}

bool IsOnlyTold(const BriefText& text, const hb::Furniture& furniture, std::size_t i, std::size_t length) {
  return IsHeld(text, furniture, i) || IsPassing(text, i, length) || IsBorne(text, furniture, i) ||
         IsOfATale(text, i) || (length == 1 && IsBehindADoor(text, i));
}

bool IsBehindADoor(const BriefText& text, std::size_t i) {
  const std::string_view room = text.At(i);
  if (!IsFormIn("inner_rooms", room) && !text.Is(i, "open_air") && !room.ends_with("room")) return false;
  if (IsNamedByADoor(text, i)) return true;
  if (i == 0 || !text.Is(i - 1, "definite")) return false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (MatchesWord(text.At(k), english::Singular(room)) && IsNamedByADoor(text, k)) return true;
  }
  return false;
}

bool MakesACompound(const BriefText& text, std::size_t begin, std::size_t end) {
  // "A table seating twelve" is no table-seating.
  const auto goes_on = [&](std::size_t i) {
    return text.IsWord(i) && !text.Is(i, "thing_ends") && !NumberWord(text.At(i));
  };
  // "In camera view", "at desk height": one of them would have an article.
  const bool bare = begin > 0 && text.Is(begin - 1, "before_bare_nouns") && !text.At(end - 1).ends_with('s') &&
                    !english::WordNet::Get().SensesOf(text.At(end)).empty() && !IsFormIn("thing_nouns", text.At(end));
  return goes_on(end) && (bare || (text.At(end).ends_with("ing") && goes_on(end + 1)) || MeansPeople(text.At(end)));
}

std::size_t BehindParts(const BriefText& text, std::size_t end) {
  constexpr std::size_t kMostOfAPart = 4;
  const bool stands = text.At(end) == "on";
  if (!stands && !text.Says(end, {"with", "without"})) return end;
  for (std::size_t i = end + 1; i < text.size() && i <= end + kMostOfAPart; ++i) {
    if (stands ? text.Is(i, "parts_to_stand_on") : IsFormIn("parts_of_furniture", text.At(i))) return i + 1;
    const bool word = text.IsWord(i) || text.IsHyphen(i) || text.IsNumber(i);
    if (!word || (stands && text.Is(i, "articles"))) break;
  }
  return end;
}

bool IsOfAPurpose(const BriefText& text, std::size_t i) {
  const std::size_t begin = text.PhraseBegin(i);
  const bool article = begin < i && (text.Is(begin, "thing_articles") || NumberWord(text.At(begin)));
  return begin > 0 && !article && text.Says(begin - 1, {"for", "of", "to", "like"});
}

}  // namespace flair::language
