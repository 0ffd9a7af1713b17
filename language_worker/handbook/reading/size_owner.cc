// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/size_owner.h"

#include <algorithm>
#include <array>

namespace flair::language {
namespace {

template <std::size_t n>
bool Among(const std::array<std::string_view, n>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

constexpr std::array<std::string_view, 18> kRoomWords = {
    "room", "rooms", "bedroom", "space", "area",      "flat",       "apartment",    "studio", "house",
    "hall", "loft",  "floor",   "plan",  "footprint", "dimensions", "measurements", "size",   "total"};
// Where a noun's own words end.
constexpr std::array<std::string_view, 21> kOwnerStops = {"that", "with", "for",  "in",    "and", "which", "where",
                                                          "on",   "at",   "of",   "to",    "is",  "has",   "or",
                                                          "but",  "from", "near", "under", "by",  "who",   "wall"};
// Between a noun and its size.
constexpr std::array<std::string_view, 12> kLinks = {"of",  "measuring", "measures", "is", "that", "which",
                                                     "are", "sized",     "about",    "a",  "(",    ":"};

// What is in the room comes after these.
constexpr std::array<std::string_view, 7> kHaving = {"with",    "has",  "having",   "holding",
                                                     "storing", "plus", "including"};

}  // namespace

bool SizeOwner::IsOfAThing(std::size_t start, std::size_t end) const {
  return ThingFollows(end) || ThingPrecedes(start);
}

bool SizeOwner::IsWordOfAThing(std::size_t start, std::size_t end) const {
  return IsOfAThing(start, end) || IsWithinAThing(start, end) || IsInWhatTheRoomHas(start, end);
}

// "baby grand".
bool SizeOwner::IsWithinAThing(std::size_t start, std::size_t end) const {
  constexpr std::size_t kLongestName = 4;
  for (std::size_t first = start - std::min(start, kLongestName - 1); first <= start; ++first) {
    if (ThingAt(first) >= end - first && ThingAt(first) > end - start) return true;
  }
  return false;
}

// What comes after "with" or "for", up to a comma, is not the room, unless it says so.
bool SizeOwner::IsInWhatTheRoomHas(std::size_t start, std::size_t end) const {
  for (std::size_t i = end; i < end + 3 && IsWord(i) && !Among(kOwnerStops, tokens_[i].text); ++i) {
    if (RoomAt(i)) return false;
  }
  for (std::size_t i = start; i > 0 && IsWord(i - 1); --i) {
    if (Among(kHaving, tokens_[i - 1].text) || tokens_[i - 1].text == "for") return true;
  }
  return false;
}

// "… solid oak desk": a thing within the next three words, and no "desk area" or "piano room".
bool SizeOwner::ThingFollows(std::size_t end) const {
  for (std::size_t i = end; i < end + 3 && IsWord(i) && !Among(kOwnerStops, tokens_[i].text); ++i) {
    if (RoomAt(i)) return false;
    const std::size_t length = ThingAt(i);
    if (length == 0) continue;
    for (std::size_t next = i + length; next < i + length + 2 && IsWord(next); ++next) {
      if (Among(kOwnerStops, tokens_[next].text)) break;
      if (RoomAt(next)) return false;
    }
    return true;
  }
  return false;
}

// "desk of …", "canvases of …", "somebody who is …".
bool SizeOwner::ThingPrecedes(std::size_t start) const {
  std::size_t end = start;
  while (end > 0 && start - end < 4 && Among(kLinks, tokens_[end - 1].text)) --end;
  if (end > 0 && end < start && tokens_[end - 1].text == "who") return true;
  if (end == 0 || end == start || !IsWord(end - 1)) return false;
  if (Among(kRoomWords, tokens_[end - 1].text) || EndsAt(names().rooms, end)) return false;
  if (EndsAt(names().things, end)) return true;
  // Of a word that nobody knows, only when it comes after "with": "a boutique of 5 m x 6 m" is a room.
  return tokens_[end].text == "of" &&
         std::any_of(tokens_.begin(), tokens_.begin() + static_cast<std::ptrdiff_t>(end - 1),
                     [](const Token& token) { return Among(kHaving, token.text); });
}

bool SizeOwner::RoomAt(std::size_t i) const {
  if (Among(kRoomWords, tokens_[i].text)) return true;
  return std::any_of(names().rooms.begin(), names().rooms.end(),
                     [&](const Phrase& name) { return name.MatchAt(tokens_, i) > 0; });
}

std::size_t SizeOwner::ThingAt(std::size_t i) const {
  std::size_t longest = 0;
  for (const Phrase& name : names().things) longest = std::max(longest, name.MatchAt(tokens_, i));
  return longest;
}

bool SizeOwner::EndsAt(const std::vector<Phrase>& names, std::size_t end) const {
  for (std::size_t length = 1; length <= std::min<std::size_t>(end, 4); ++length) {
    for (const Phrase& name : names) {
      if (name.MatchAt(tokens_, end - length) == length) return true;
    }
  }
  return false;
}

const SizeOwner::Names& SizeOwner::names() const {
  if (names_) return *names_;
  Names& made = names_.emplace();
  for (const hb::Archetype& archetype : handbook_.archetypes()) {
    if (!archetype.name().empty()) made.rooms.emplace_back(archetype.name());
    for (const std::string& synonym : archetype.synonyms()) made.rooms.emplace_back(synonym);
  }
  for (const char* opening : {"window", "door", "doorway", "opening"}) made.things.emplace_back(opening);
  for (const hb::Furniture& furniture : handbook_.furniture()) {
    made.things.emplace_back(furniture.name());
    for (const std::string& synonym : furniture.synonyms()) made.things.emplace_back(synonym);
  }
  return made;
}

}  // namespace flair::language
