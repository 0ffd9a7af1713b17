// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/vocabulary.h"

namespace flair::language {

// What a place is told by: "the kitchen door", "the sofa and the fireplace", "them", "the far left corner".
struct Landmark {
  enum class Kind { kNone, kPiece, kPronoun, kDoor, kWindow, kSocket, kWall, kCorner };
  Kind kind = Kind::kNone;
  const hb::Furniture* piece = nullptr;   // of kPiece
  const hb::Furniture* second = nullptr;  // "... and the fireplace": another piece behind it, up to `second_end`
  Kind beside = Kind::kNone;              // "... and the window", "the door and ...": behind or before it
  bool plural = false;                    // "them", "the sofas", "both desks"
  bool each_other = false;                // the subjects themselves
  // Of a wall or corner the words that tell it from others, with spaces: "north", "far left", "at door", of all corners
  // "each"; empty for any of them. Of a door or window those that describe it: "kitchen".
  std::string side;
  std::size_t end = 0;  // behind its last token
  std::size_t second_end = 0;
};

// Reads landmarks. The arguments must outlive it. Looks at a bounded number of tokens, and up each only once.
class LandmarkReader {
 public:
  // `rank` says how likely a class is meant by a word that several share; higher is likelier.
  LandmarkReader(const std::vector<Token>& tokens, const PieceNames& names,
                 std::function<int(const hb::Furniture&)> rank);

  // The landmark that begins at a token; of kind kNone where none does.
  Landmark Read(std::size_t start) const;

  // Whether a door, window, socket, wall or corner is named at a token.
  Landmark::Kind FeatureAt(std::size_t i) const;

 private:
  using Found = std::pair<const hb::Furniture*, std::size_t>;

  const Found& PieceAt(std::size_t i) const;
  std::size_t BehindDeterminers(std::size_t i) const;
  Landmark Pronoun(std::size_t start) const;
  Landmark Noun(std::size_t start) const;
  bool Describes(std::size_t i) const;
  bool JoinsWalls(std::size_t i) const;
  void TakeSecond(Landmark& landmark) const;
  void TakeWhichOne(std::size_t start, Landmark& landmark) const;

  const std::vector<Token>& tokens_;
  const BriefText text_;
  const PieceNames& names_;
  const std::function<int(const hb::Furniture&)> rank_;
  mutable std::vector<std::optional<Found>> pieces_;  // of a token
};

}  // namespace flair::language
