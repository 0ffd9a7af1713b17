// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
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
  bool part = false;     // "one window", "the other window": perhaps of several that were named before
  bool bare = false;     // neither article nor number
  std::size_t begin = 0;
  std::size_t noun = 0;  // its head
  std::size_t end = 0;
};

// Reads the opening whose head is at a token; of kind kNone where there is none, or where the word belongs to a name in
// `things` ("window seat", "a wardrobe with sliding doors"). Looks at a bounded number of tokens.
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

  bool found() const { return !sides.empty() || along.at != AlongWall::At::kAny || !not_read.empty(); }
};

// Reads where openings are. Looks at a bounded number of tokens.
class OpeningSiteReader {
 public:
  explicit OpeningSiteReader(const BriefText& words) : words_(words) {}

  // Of what follows an opening: "in the middle of the west wall", "opposite the door", "is on the left as you enter".
  // `verbs`: whether "is" and the like may come first. Adds to what `site` holds already; true when there is something.
  bool ReadAfter(std::size_t i, bool door, bool verbs, OpeningSite& site) const;

  // Of what comes before it: "On the south wall there is", "the south wall has", "south wall:". Its `end` is where it
  // begins.
  OpeningSite ReadBefore(std::size_t begin) const;

 private:
  bool SaysNoPlace(std::size_t i) const;
  bool TakeFromEnd(std::size_t& i, OpeningSite& site) const;
  bool TakeMiddle(std::size_t& i, OpeningSite& site) const;
  bool TakeEnd(std::size_t& i, OpeningSite& site) const;
  bool TakeFeature(std::size_t& i, bool door, OpeningSite& site) const;
  bool TakeEntering(std::size_t& i, OpeningSite& site) const;
  bool TakeSides(std::size_t& i, bool bare, OpeningSite& site) const;
  bool TakeSeveralSides(std::size_t& i, OpeningSite& site) const;
  bool TakeThing(std::size_t& i, OpeningSite& site) const;
  std::string SideAt(std::size_t i, std::size_t& end, bool& noun) const;

  const BriefText& words_;
};

// The openings that a brief has asked for so far: joins what it says twice of the same one, and finds the walls that go
// by other openings. The arguments must outlive it.
class OpeningList {
 public:
  OpeningList(const BriefText& words, OpeningWishes& openings) : words_(words), openings_(openings) {}

  void Add(const OpeningWish& wish);
  // One wish for each wall that was named.
  void AddOnSides(const OpeningNoun& noun, const OpeningSite& site);

  // To be called when all is read. A door by its relation to the windows; these have a wall of their own then.
  void SettleRelations();
  void SettleContradictions();

 private:
  std::string Resolved(const std::string& side, bool door) const;
  void Join(const OpeningNoun& noun, const OpeningSite& site, OpeningWish& wish);

  const BriefText& words_;
  OpeningWishes& openings_;
};

// Takes what one word before a door or window says of it: "large", "sliding", "bay", "north". `wish.door` must be set.
void Describe(std::string_view word, OpeningWish& wish);

// What doors lead to, as lists separated by spaces.

// Words of walls, as lists separated by spaces.

}  // namespace flair::language
