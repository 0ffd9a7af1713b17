// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>

#include "language_worker/handbook/reading/vocabulary.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// Tells the size of the room from that of something in it: "a 1.6 m x 0.8 m desk", "a desk of 1.6 m x 0.8 m", "canvases
// of 3 m x 2 m", "a giant who is 4 m tall".
class SizeOwner {
 public:
  SizeOwner(const BriefText& text, const Vocabulary& vocabulary) : text_(text), vocabulary_(vocabulary) {}

  // Whether the size in tokens [start, end) is that of a thing, as far as the words around it say.
  bool IsOfAThing(std::size_t start, std::size_t end) const { return ThingFollows(end) || ThingPrecedes(start); }

  // "lamps 30 cm high": a single length right behind a thing; "a shelf, 40 cm deep": one that no room has.
  bool IsBehindAThing(std::size_t start, double metres) const {
    constexpr double kLeastRoomM = 2.5;
    const std::size_t end = metres < kLeastRoomM && text_.At(start - 1) == "," ? start - 1 : start;
    for (std::size_t length = 1; length <= std::min<std::size_t>(end, 4); ++length) {
      if (ThingAt(end - length) == length && !RoomAt(end - length)) return true;
    }
    return false;
  }

  // "A desk 1.8 x 0.9 m": sides right behind a thing, one of them shorter than a room's.
  bool IsRightBehindAThing(std::size_t start, double shorter_m) const {
    constexpr double kLeastSideM = 1.6;
    return shorter_m < kLeastSideM && IsBehindAThing(start, shorter_m);
  }

  // The same for a word of size, such as "large": "a large wardrobe", "with large windows", "for a little girl", and
  // the "grand" of a grand piano.
  bool IsWordOfAThing(std::size_t start, std::size_t end) const {
    return IsOfAThing(start, end) || IsWithinAThing(start, end) || IsInWhatTheRoomHas(start, end);
  }

 private:
  // "baby grand".
  bool IsWithinAThing(std::size_t start, std::size_t end) const {
    constexpr std::size_t kLongestName = 4;
    for (std::size_t first = start - std::min(start, kLongestName - 1); first <= start; ++first) {
      const std::size_t length = ThingAt(first);
      if (length >= end - first && length > end - start) return true;
    }
    return false;
  }

  // What comes after "with" or "for", up to a comma, is not the room, unless it says so.
  bool IsInWhatTheRoomHas(std::size_t start, std::size_t end) const {
    for (std::size_t i = end; i < end + 3 && GoesOn(i); ++i) {
      if (RoomAt(i)) return false;
    }
    for (std::size_t i = start; i > 0 && text_.IsWord(i - 1); --i) {
      if (text_.Is(i - 1, "holding") || text_.At(i - 1) == "for") return true;
    }
    return false;
  }

  // "… solid oak desk": a thing within the next three words, and no "desk area" or "piano room".
  bool ThingFollows(std::size_t end) const {
    for (std::size_t i = end; i < end + 3 && GoesOn(i); ++i) {
      if (RoomAt(i)) return false;
      const std::size_t length = ThingAt(i);
      if (length == 0) continue;
      for (std::size_t next = i + length; next < i + length + 2 && GoesOn(next); ++next) {
        if (RoomAt(next)) return false;
      }
      return true;
    }
    return false;
  }

  // "desk of …", "canvases of …", "somebody who is …".
  bool ThingPrecedes(std::size_t start) const {
    std::size_t end = start;
    while (end > 0 && start - end < 4 && text_.Is(end - 1, "size_links")) --end;
    if (end > 0 && end < start && text_.At(end - 1) == "who") return true;
    if (end == 0 || end == start || !text_.IsWord(end - 1)) return false;
    bool room = text_.Is(end - 1, "sized_rooms"), thing = text_.Is(end - 1, "openings");
    for (std::size_t length = 1; length <= std::min<std::size_t>(end, 4); ++length) {
      room = room || LongestAt(vocabulary_.rooms, text_.tokens(), end - length, /*plural=*/true).second == length;
      thing = thing || ThingAt(end - length) == length;
    }
    if (room || thing) return !room;
    // Of a word that nobody knows, only when it comes after "with": "a boutique of 5 m x 6 m" is a room.
    if (text_.At(end) != "of") return false;
    for (std::size_t i = 0; i + 1 < end; ++i) {
      if (text_.Is(i, "holding")) return true;
    }
    return false;
  }

  bool GoesOn(std::size_t i) const { return text_.IsWord(i) && !text_.Is(i, "size_stops"); }
  bool RoomAt(std::size_t i) const {
    return text_.Is(i, "sized_rooms") || LongestAt(vocabulary_.rooms, text_.tokens(), i, /*plural=*/true).second > 0;
  }
  std::size_t ThingAt(std::size_t i) const {
    const std::size_t opening = text_.Is(i, "openings") ? 1 : 0;
    return std::max(opening, LongestAt(vocabulary_.names, text_.tokens(), i, /*plural=*/true).second);
  }

  const BriefText& text_;
  const Vocabulary& vocabulary_;
};

}  // namespace flair::language
