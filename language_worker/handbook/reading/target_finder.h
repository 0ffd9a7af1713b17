// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/reading/own_classes.h"
#include "language_worker/handbook/reading/place_patterns.h"
#include "language_worker/handbook/reading/place_reader.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// Where a brief names its pieces, and which of them it names together. Mentions are told by their index; the arguments
// must outlive it.
class MentionList {
 public:
  MentionList(const std::vector<Token>& tokens, const std::vector<Mention>& mentions);

  // The mention that covers a token, that ends right before one.
  std::optional<std::size_t> At(std::size_t token) const;
  std::optional<std::size_t> EndingAt(std::size_t end) const { return end == 0 ? std::nullopt : At(end - 1); }

  // The first from a token on, over words for its looks.
  std::optional<std::size_t> From(std::size_t token) const;

  // Whether between two there are only a comma or "and", and words for the looks of the second: "a vase, a wooden
  // tray".
  bool AreListed(std::size_t first, std::size_t second) const;

  // "A table with a vase and a lamp": the table, of the lamp.
  std::optional<std::size_t> HolderOf(std::size_t held) const;

 private:
  bool Describes(std::size_t token) const;

  const BriefText text_;
  const std::vector<Mention>& mentions_;
  std::vector<std::size_t> at_;  // of a token; the number of mentions for none
};

// Whether it stands on tops, or may do so.
inline bool IsOnATop(const hb::Furniture& furniture) {
  return furniture.kind() == hb::FURNITURE_KIND_SURFACE || IsOfAnyKind(furniture);
}

// Finds by what a brief tells a place: the piece that it names there, or one that it named before. The arguments must
// outlive it.
class TargetFinder {
 public:
  // `by_landmark`: of a mention, whether it only tells where another one goes.
  TargetFinder(const std::vector<Mention>& mentions, const MentionList& named, const std::vector<bool>& by_landmark,
               const std::vector<Place>& places)
      : mentions_(mentions), named_(named), by_landmark_(by_landmark), places_(places) {}

  // Sets what the sentence of the place needs, for the piece of a mention; false when there is no such thing.
  bool Find(std::size_t subject, const PlacePatterns::Match& match, Place& place) const;

  // Of the wall where a piece was put last the one across the room; empty where no wall was named.
  std::string OppositeOfLast() const;

 private:
  bool FindPair(std::size_t subject, const Landmark& landmark, Place& place) const;
  bool FindNamedBefore(std::size_t subject, bool plural, Place& place) const;
  const hb::Furniture* Partner(const hb::Furniture& piece) const;

  const std::vector<Mention>& mentions_;
  const MentionList& named_;
  const std::vector<bool>& by_landmark_;
  const std::vector<Place>& places_;  // those read so far
};

}  // namespace flair::language
