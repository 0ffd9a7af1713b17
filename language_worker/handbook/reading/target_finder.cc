// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/target_finder.h"

#include <optional>

namespace flair::language {

bool TargetFinder::Find(std::size_t subject, const PlacePatterns::Match& match, Place& place) const {
  place.side = match.landmark.side;
  if (AskedNames(*match.asked, "{first}")) return FindPair(subject, match.landmark, place);
  if (!AskedNames(*match.asked, "{target}")) return true;
  if (match.landmark.kind != Landmark::Kind::kPiece) return FindNamedBefore(subject, match.landmark.plural, place);
  place.target = match.landmark.piece;
  return place.target != mentions_[subject].furniture;
}

// "between the sofa and the fireplace", "between the armchairs", "between them".
bool TargetFinder::FindPair(std::size_t subject, const Landmark& landmark, Place& place) const {
  const hb::Furniture* piece = mentions_[subject].furniture;
  if (landmark.kind == Landmark::Kind::kPiece) {
    place.target = landmark.piece;
    place.other = landmark.second != nullptr ? landmark.second : landmark.piece;
    return place.target != piece && place.other != piece;
  }
  // The two that were named last before it, those first that do not only tell where others go.
  for (const bool landmarks_too : {false, true}) {
    place.target = place.other = nullptr;
    for (std::size_t m = subject; m-- > 0;) {
      const Mention& mention = mentions_[m];
      if (mention.furniture == piece || mention.furniture == place.other) continue;
      if (by_landmark_[m] && !landmarks_too) continue;
      if (place.other == nullptr && mention.count > 1) {
        place.target = place.other = mention.furniture;
        return true;
      }
      (place.other == nullptr ? place.other : place.target) = mention.furniture;
      if (place.target != nullptr) return true;
    }
  }
  return false;
}

// "next to it", "on top": the piece that was named before; for what is carried the last that has a top, best one for
// several things.
bool TargetFinder::FindNamedBefore(std::size_t subject, bool plural, Place& place) const {
  const hb::Furniture& piece = *mentions_[subject].furniture;
  const hb::Carried carried = place.asked->carried();
  const bool carries = carried == hb::CARRIED_ON || carried == hb::CARRIED_IN;
  if (const std::optional<std::size_t> holder = carries ? named_.HolderOf(subject) : std::nullopt) {
    if (!IsOnATop(*mentions_[*holder].furniture)) place.target = mentions_[*holder].furniture;
  }
  const bool on_a_top = carries || piece.kind() == hb::FURNITURE_KIND_CEILING;
  for (const int tops : {plural ? 2 : 1, 1, 0}) {
    for (std::size_t m = subject; m-- > 0 && place.target == nullptr;) {
      const hb::Furniture& target = *mentions_[m].furniture;
      if (&target == &piece || (plural && !on_a_top && mentions_[m].count < 2 && tops > 0)) continue;
      const bool has_top = target.top_places() >= tops && (tops > 0 || carried == hb::CARRIED_IN);
      const bool may_be = IsOnTheFloor(target) ? !on_a_top || has_top : !on_a_top && !IsOnTheFloor(piece);
      if (may_be) place.target = &target;
    }
  }
  return place.target != nullptr;
}

}  // namespace flair::language
