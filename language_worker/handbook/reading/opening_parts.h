// SPDX-License-Identifier: GPL-3.0-or-later
// The parts that opening_reader.cc puts together: the words for an opening and for its place. All of them look at a
// bounded number of tokens, and at words without the hyphens within them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "language_worker/handbook/reading/opening_reader.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// The words that name an opening: "two large sliding doors to the garden, 1.8 m wide".
struct OpeningNoun {
  enum class Kind { kNone, kOpening, kOverhead, kOfAPiece };
  Kind kind = Kind::kNone;
  OpeningWish wish;
  bool none = false;     // "no windows"
  bool any = false;      // "each window", "any window": no particular one
  bool related = false;  // "under the window": it tells where something else is
  bool part = false;     // "one window", "the other": perhaps of several that were named before
  bool further = false;  // "a second door": of two, when none was said to be one of several
  bool bare = false;     // neither article nor number
  bool plural = false;
  bool whole_wall = false;         // "nearly all window"
  bool glass = false;              // "glass on three sides": an opening only where its wall is told
  std::vector<std::string> leads;  // of several doors each: "two doors, bedroom and bathroom"
  std::size_t begin = 0;
  std::size_t end = 0;
};

inline constexpr double kPairOfLeavesM = 1.5;

// Reads the opening whose head is at a token; of kind kNone where there is none, or where the word belongs to a name in
// `things` ("window seat"), kOfAPiece in "a wardrobe with sliding doors".
OpeningNoun OpeningNounAt(const BriefText& words, const std::vector<bool>& things, std::size_t i);

// A number of openings at a token.
std::optional<int> OpeningCountAt(const BriefText& words, std::size_t i);

// What stands behind a head and tells of the opening itself: where it leads, its measures, its number, how it opens.
// The index behind that, or `i`.
std::size_t ReadMeasures(const BriefText& words, std::size_t i, OpeningNoun& noun);

// Where a brief says that an opening is.
struct OpeningSite {
  std::vector<std::string> sides;  // words for walls, see WallOf; "across window" and "window" go by the windows
  AlongWall along;
  bool pair = false;       // "either side of the door": there are two
  bool both_ends = false;  // of its wall: there is one at each
  bool fills = false;      // "all along", "full width"
  bool that = false;       // "in the middle of it": of the wall that was spoken of
  std::size_t end = 0;     // behind its last token
  std::string not_read;    // words that stand where a place is told and tell none: "above the sink"
};

// Reads what follows an opening: "in the middle of the west wall", "opposite the door", ", which is on the left as you
// enter". `verbs`: whether "is" and the like may come first. Adds to what `site` holds already; true when there is
// something.
bool ReadSiteAfter(const BriefText& words, std::size_t i, bool door, bool verbs, OpeningSite& site);

// Reads what comes before it: "On the south wall there is", "the south wall has", "south wall:". Its `end` is where it
// begins.
OpeningSite ReadSiteBefore(const BriefText& words, std::size_t begin);

// The wall named before an opening that it goes by: of "the long wall opposite the windows", whose noun phrase begins
// at `begin`, that across from the long one. Empty when there is none.
std::string WallBefore(const BriefText& words, std::size_t begin);

// What is named behind a preposition: a wall, or an end or corner of one, with the words that say which.
struct WallTarget {
  std::vector<std::string> sides;
  bool wall = false, end_of_wall = false, corner = false;  // the noun, if there is one
  bool several = false;                                    // "the short walls"
  std::size_t end = 0;
};

WallTarget WallTargetAt(const BriefText& words, std::size_t at);

// The walls named from `at` on, `end` behind them; none when the words tell none. `alone`: no preposition says that a
// wall follows, so that one without its noun must end its phrase ("left sofa").
std::vector<std::string> WallsAt(const BriefText& words, std::size_t at, bool alone, std::size_t& end);

// Whether the words for a wall can end before a token.
bool EndsWall(const BriefText& words, std::size_t i);

// The openings that a brief has asked for so far: joins what it says twice of the same one, and finds the walls that go
// by other openings. The wishes must outlive it.
class OpeningList {
 public:
  explicit OpeningList(OpeningWishes& openings) : openings_(openings) {}

  // One wish for each wall, or room behind, that was named.
  void Add(const OpeningNoun& noun, OpeningSite site);
  void Add(const OpeningWish& wish);

  // A wall that words for a piece tell of an opening: it holds where no other is told.
  void Hint(const OpeningNoun& noun, const std::string& side) { hints_.push_back({noun, side}); }

  // An audience looks on from the south.
  void LookOn();

  // To be called when all is read: doors go by windows that have a wall of their own then, and of two wishes that
  // exclude each other one holds.
  void Settle();

 private:
  std::string Resolved(const std::string& side, bool door) const;
  void Join(const OpeningNoun& noun, const OpeningSite& site, OpeningWish& wish);
  void SettleRelations();

  OpeningWishes& openings_;
  std::vector<std::pair<OpeningNoun, std::string>> hints_;
  bool onlookers_ = false;
};

}  // namespace flair::language
