// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/reading/mention_list.h"
#include "language_worker/handbook/reading/own_classes.h"
#include "language_worker/handbook/reading/place_patterns.h"

namespace flair::language {

// Whether it stands on tops, or may do so.
inline bool IsOnATop(const hb::Furniture& furniture) {
  return furniture.kind() == hb::FURNITURE_KIND_SURFACE || IsOfAnyKind(furniture);
}

// Finds by what a brief tells a place: the piece that it names there, or one that it named before. The arguments must
// outlive it.
class TargetFinder {
 public:
  // `by_landmark`: of a mention, whether it only tells where another one goes.
  TargetFinder(const std::vector<Mention>& mentions, const MentionList& named, const std::vector<bool>& by_landmark)
      : mentions_(mentions), named_(named), by_landmark_(by_landmark) {}

  // Sets what the sentence of the place needs, for the piece of a mention; false when there is no such thing.
  bool Find(std::size_t subject, const PlacePatterns::Match& match, Place& place) const;

 private:
  bool FindPair(std::size_t subject, const Landmark& landmark, Place& place) const;
  bool FindNamedBefore(std::size_t subject, bool plural, Place& place) const;

  const std::vector<Mention>& mentions_;
  const MentionList& named_;
  const std::vector<bool>& by_landmark_;
};

}  // namespace flair::language
