// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "language_worker/handbook/reading/opening_wish.h"
#include "language_worker/handbook/reading/opening_words.h"

namespace flair::language {

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
  explicit OpeningSiteReader(const OpeningWords& words) : words_(words) {}

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

  const OpeningWords& words_;
};

}  // namespace flair::language
