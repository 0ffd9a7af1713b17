// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/target_finder.h"

#include <algorithm>

#include "language_worker/handbook/reading/piece_words.h"

namespace flair::language {

bool TargetFinder::Find(std::size_t subject, const PlacePatterns::Match& match, Place& place) const {
  place.side = match.landmark.side;
  if (place.side == "opposite" && AskedNames(*match.asked, "{wall}") && !OppositeOfLast().empty())
    place.side = OppositeOfLast();
  if (AskedNames(*match.asked, "{first}")) return FindPair(subject, match.landmark, place);
  if (!AskedNames(*match.asked, "{target}")) return true;
  // "A king bed with a bench at the foot", "a nightstand on the left": of what it usually stands by.
  const hb::Furniture& piece = *mentions_[subject].furniture;
  if (match.landmark.each_other) {
    place.target = &piece;
    return true;
  }
  // "At the foot" is a bed's; "the fridge at the end" is at no other piece.
  const bool foot =
      match.landmark.kind == Landmark::Kind::kNone && AskedNames(*match.asked, "next to the front of the {target}");
  if (match.landmark.kind == Landmark::Kind::kNone && IsOnTheFloor(piece)) {
    place.target = Partner(piece);
    if (place.target != nullptr) return !foot || place.target->category() == "bed";
    if (AskedNames(*match.asked, "side of the {target}") && match.asked->relation().condition().min_count() < 2)
      return false;
  }
  if (match.landmark.kind != Landmark::Kind::kPiece)
    return FindNamedBefore(subject, match.landmark.plural, place) && (!foot || place.target->category() == "bed");
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
  // "A sofa facing the fire, a low table between": those two.
  if (!places_.empty() && places_.back().target != nullptr && AskedNames(*places_.back().asked, "faces the {target}") &&
      places_.back().furniture != piece && places_.back().target != piece) {
    place.target = places_.back().furniture;
    place.other = places_.back().target;
    return true;
  }
  // Two of a kind, "two beds, each with a nightstand, a curtain in between"; else the two that were named last before
  // it, those first that do not only tell where others go.
  for (std::size_t m = subject; m-- > 0;) {
    if (mentions_[m].count != 2 || mentions_[m].furniture == piece || by_landmark_[m]) continue;
    place.target = place.other = mentions_[m].furniture;
    return true;
  }
  for (const bool landmarks_too : {false, true}) {
    place.target = place.other = nullptr;
    for (std::size_t m = subject; m-- > 0;) {
      const Mention& mention = mentions_[m];
      if (mention.furniture == piece || mention.furniture == place.other) continue;
      if (by_landmark_[m] && !landmarks_too) continue;
      // "A basin with a mirror, and the toilet between them".
      if (IsOnTheFloor(*piece) && !IsOnTheFloor(*mention.furniture)) continue;
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

// The piece of the brief that it usually stands by; null for none.
const hb::Furniture* TargetFinder::Partner(const hb::Furniture& piece) const {
  const auto partner = std::ranges::find_if(mentions_, [&](const Mention& mention) {
    return mention.furniture != &piece && IsOnTheFloor(*mention.furniture) && StandsWith(piece, *mention.furniture);
  });
  return partner == mentions_.end() ? nullptr : partner->furniture;
}

std::string TargetFinder::OppositeOfLast() const {
  for (std::size_t i = places_.size(); i-- > 0;) {
    const std::string& side = places_[i].side;
    if (side.empty() || !AskedNames(*places_[i].asked, "{wall}")) continue;
    return side.find(' ') == std::string::npos ? "across " + side : "";
  }
  return "";
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
      // "It" is one piece, where there is one.
      if (!plural && mentions_[m].count > 1 && tops > 0 && !on_a_top) continue;
      const bool has_top = target.top_places() >= tops && (tops > 0 || carried == hb::CARRIED_IN);
      const bool faced = target.kind() == hb::FURNITURE_KIND_WALL && AskedNames(*place.asked, "faces the {target}");
      const bool may_be = faced || IsOnTheFloor(target) ? !on_a_top || has_top : !on_a_top && !IsOnTheFloor(piece);
      if (may_be) place.target = &target;
    }
  }
  return place.target != nullptr;
}

MentionList::MentionList(const std::vector<Token>& tokens, const std::vector<Mention>& mentions)
    : text_(tokens), mentions_(mentions), at_(tokens.size(), mentions.size()) {
  for (std::size_t m = 0; m < mentions.size(); ++m) {
    for (std::size_t i = mentions[m].begin; i < mentions[m].end; ++i) at_[i] = m;
  }
}

std::optional<std::size_t> MentionList::At(std::size_t token) const {
  return token < at_.size() && at_[token] < mentions_.size() ? std::optional(at_[token]) : std::nullopt;
}

std::optional<std::size_t> MentionList::From(std::size_t token) const {
  constexpr std::size_t kMostBetween = 6;
  for (std::size_t i = token; i < text_.size() && i < token + kMostBetween; ++i) {
    if (At(i)) return At(i);
    if (!Describes(i)) break;
  }
  return std::nullopt;
}

bool MentionList::AreListed(std::size_t first, std::size_t second) const {
  constexpr std::size_t kMostBetween = 7;
  const std::size_t begin = mentions_[first].end, end = mentions_[second].begin;
  if (end <= begin || end - begin > kMostBetween) return false;
  bool joined = false;
  for (std::size_t i = begin; i < end; ++i) {
    const bool joint = text_.Says(i, {",", "and"});
    joined = joined || joint;
    if (!joint && !Describes(i)) return false;
  }
  return joined;
}

std::optional<std::size_t> MentionList::HolderOf(std::size_t held) const {
  std::size_t first = held;
  while (first > 0 && AreListed(first - 1, first)) --first;
  if (first == 0) return std::nullopt;
  // "A carpet with cushions": where its words go on as those of a part.
  if (mentions_[first - 1].end >= mentions_[first].end) return first - 1;
  bool with = false;
  for (std::size_t i = mentions_[first - 1].end; i < mentions_[first].begin; ++i) {
    with = with || text_.At(i) == "with";
    if (text_.At(i) != "with" && !Describes(i)) return std::nullopt;
  }
  return with ? std::optional(first - 1) : std::nullopt;
}

// Whether a token may stand before the noun of a piece.
bool MentionList::Describes(std::size_t token) const {
  if (text_.IsHyphen(token) || text_.Is(token, "thing_articles") || NumberWord(text_.At(token))) return true;
  return !text_.IsSign(token) && !text_.Is(token, "thing_ends");
}

}  // namespace flair::language
