// SPDX-License-Identifier: GPL-3.0-or-later
// The parts that opening_reader.cc puts together: the words for an opening and for its place. All of them look at a
// bounded number of tokens, and at words without the hyphens within them.
#pragma once

#include <cstddef>
#include <string>
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
  bool bare = false;     // neither article nor number
  bool plural = false;
  bool glass = false;              // "glass on three sides": an opening only where its wall is told
  std::vector<std::string> leads;  // of several doors each: "two doors, bedroom and bathroom"
  std::size_t begin = 0;
  std::size_t end = 0;
};

// Reads the opening whose head is at a token; of kind kNone where there is none, or where the word belongs to a name in
// `things` ("window seat"), kOfAPiece in "a wardrobe with sliding doors".
OpeningNoun OpeningNounAt(const BriefText& words, const std::vector<bool>& things, std::size_t i);

// What stands behind a head and tells of the opening itself: where it leads, its measures, its number, how it opens.
// The index behind that, or `i`.
std::size_t ReadMeasures(const BriefText& words, std::size_t i, OpeningNoun& noun);

// Where a brief says that an opening is.
struct OpeningSite {
  std::vector<std::string> sides;  // words for walls, see WallOf; "across window" and "window" go by the windows
  AlongWall along;
  bool pair = false;     // "either side of the door": there are two
  bool fills = false;    // "all along", "full width"
  std::size_t end = 0;   // behind its last token
  std::string not_read;  // words that stand where a place is told and tell none: "above the sink"
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

// The walls named from `at` on ("the long wall"), `end` behind them.
std::vector<std::string> WallsAt(const BriefText& words, std::size_t at, std::size_t& end);

}  // namespace flair::language
