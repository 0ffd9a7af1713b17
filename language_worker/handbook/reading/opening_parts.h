// SPDX-License-Identifier: GPL-3.0-or-later
// The parts that opening_reader.cc puts together: nouns, places and the list of what was found. All of them look at a
// bounded number of tokens, and at words without the hyphens within them (see WithoutHyphens).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "language_worker/handbook/reading/opening_reader.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// The words that name an opening: "two large sliding doors to the garden, 1.8 m wide".
struct OpeningNoun {
  enum class Kind { kNone, kOpening, kOverhead };
  Kind kind = Kind::kNone;
  OpeningWish wish;
  bool none = false;     // "no windows"
  bool any = false;      // "each window", "any window": no particular one
  bool related = false;  // "under the window": it tells where something else is
  bool part = false;     // "one window", "the other": perhaps of several that were named before
  bool bare = false;     // neither article nor number
  bool plural = false;
  std::size_t begin = 0;
  std::size_t end = 0;
};

// Reads the opening whose head is at a token; of kind kNone where there is none, or where the word belongs to a name in
// `things` ("window seat", "a wardrobe with sliding doors").
OpeningNoun OpeningNounAt(const BriefText& words, const std::vector<bool>& things, std::size_t i);

// What stands behind a head and tells of the opening itself: where it leads, its measures, how it opens. The index
// behind that, or `i`.
std::size_t ReadMeasures(const BriefText& words, std::size_t i, OpeningWish& wish);

// Where a brief says that an opening is.
struct OpeningSite {
  std::vector<std::string> sides;  // words for walls, see WallOf; "across window" and "window" go by the windows
  AlongWall along;
  std::string by_side;   // of "opposite the window on the east wall" the wall of the window
  bool pair = false;     // "either side of the door": there are two
  std::size_t end = 0;   // behind its last token
  std::string not_read;  // words that stand where a place is told and tell none: "above the sink"
};

// Reads what follows an opening: "in the middle of the west wall", "opposite the door", "is on the left as you enter".
// `verbs`: whether "is" and the like may come first. Adds to what `site` holds already; true when there is something.
bool ReadSiteAfter(const BriefText& words, std::size_t i, bool door, bool verbs, OpeningSite& site);

// Reads what comes before it: "On the south wall there is", "the south wall has", "south wall:". Its `end` is where it
// begins.
OpeningSite ReadSiteBefore(const BriefText& words, std::size_t begin);

// The openings that a brief has asked for so far: joins what it says twice of the same one, and finds the walls that go
// by other openings. The argument must outlive it.
class OpeningList {
 public:
  explicit OpeningList(OpeningWishes& openings) : openings_(openings) {}

  // One wish for each wall that was named.
  void Add(const OpeningNoun& noun, const OpeningSite& site);

  // To be called when all is read: doors go by windows that have a wall of their own then, and of two wishes that
  // exclude each other one holds.
  void Settle();

 private:
  std::string Resolved(const std::string& side, bool door) const;
  void Join(const OpeningNoun& noun, const OpeningSite& site, OpeningWish& wish);
  void Add(const OpeningWish& wish);
  void SettleRelations();

  OpeningWishes& openings_;
};

}  // namespace flair::language
