// SPDX-License-Identifier: GPL-3.0-or-later
#include "english/frames/facts.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace flair::english {
namespace {

using ::flair::v1::ParticipantSide;
using ::flair::v1::RoomPart;

struct Part {
  RoomPart part;
  RefKind kind;
  std::string_view name;
};

constexpr std::array<Part, 7> kParts = {{{::flair::v1::ROOM_PART_WALL, RefKind::kWall, ""},
                                         {::flair::v1::ROOM_PART_DOOR, RefKind::kFeature, "door"},
                                         {::flair::v1::ROOM_PART_WINDOW, RefKind::kFeature, "window"},
                                         {::flair::v1::ROOM_PART_SOCKET, RefKind::kFeature, "socket"},
                                         {::flair::v1::ROOM_PART_ROOM, RefKind::kRoom, ""},
                                         {::flair::v1::ROOM_PART_FLOOR, RefKind::kFloor, ""},
                                         {::flair::v1::ROOM_PART_CEILING, RefKind::kCeiling, ""}}};

constexpr std::array<std::pair<ParticipantSide, std::string_view>, 14> kSides = {
    {{::flair::v1::PARTICIPANT_SIDE_UNSPECIFIED, ""},
     {::flair::v1::PARTICIPANT_SIDE_FRONT, "front"},
     {::flair::v1::PARTICIPANT_SIDE_BACK, "back"},
     {::flair::v1::PARTICIPANT_SIDE_LEFT, "left"},
     {::flair::v1::PARTICIPANT_SIDE_RIGHT, "right"},
     {::flair::v1::PARTICIPANT_SIDE_LEFT_AND_RIGHT, "sides"},
     {::flair::v1::PARTICIPANT_SIDE_FRONT_AND_BACK, "axial"},
     {::flair::v1::PARTICIPANT_SIDE_ALL_BUT_BACK, "three"},
     {::flair::v1::PARTICIPANT_SIDE_ALL, "all"},
     {::flair::v1::PARTICIPANT_SIDE_LONG, "long_both"},
     {::flair::v1::PARTICIPANT_SIDE_SHORT, "short_both"},
     {::flair::v1::PARTICIPANT_SIDE_ONE_LONG, "long_one"},
     {::flair::v1::PARTICIPANT_SIDE_ONE_SHORT, "short_one"},
     {::flair::v1::PARTICIPANT_SIDE_LEFT_OR_RIGHT, "side"}}};

bool IsPlain(const Mention& mention) {
  if (mention.either) return false;
  return std::ranges::all_of(mention.references, [](const Reference& reference) {
    const bool named = reference.kind == RefKind::kObjects || reference.kind == RefKind::kZone ||
                       reference.kind == RefKind::kWall || PartOf(reference).has_value();
    return named && reference.opening.empty() && !reference.each && !reference.any && reference.ordinal == 0 && SideOf(reference.side);
  });
}

std::optional<Mention> Bound(const Mention* mention) {
  return mention == nullptr ? std::nullopt : std::optional<Mention>(*mention);
}

}  // namespace

Match Fact::AsMatch() const {
  Match match;
  if (a) match.a = &*a;
  if (b) match.b = &*b;
  if (c) match.c = &*c;
  if (distance) match.distance = &*distance;
  return match;
}

std::optional<std::vector<Fact>> ReadFacts(std::string_view text, const Names& names) {
  const Analysis analysis = Analyse(text, names);
  if (analysis.wish || analysis.conditional || analysis.partly_conditional) return std::nullopt;
  std::vector<Fact> facts;
  for (size_t at = 0; at < analysis.terms.size();) {
    if (analysis.terms[at].kind == Term::Kind::kStop) {
      ++at;
      continue;
    }
    const FrameBook::Hit hit = FrameBook::Get().Find(std::span(analysis.terms).subspan(at));
    if (hit.meaning.empty()) return std::nullopt;
    for (const Mention* mention : {hit.match.a, hit.match.b, hit.match.c}) {
      if (mention != nullptr && !IsPlain(*mention)) return std::nullopt;
    }
    Fact& fact = facts.emplace_back();
    fact.meaning = hit.meaning;
    fact.detail = hit.detail;
    fact.a = Bound(hit.match.a);
    fact.b = Bound(hit.match.b);
    fact.c = Bound(hit.match.c);
    if (hit.match.distance != nullptr) fact.distance = *hit.match.distance;
    at += hit.match.length;
  }
  return facts.empty() ? std::nullopt : std::optional(std::move(facts));
}

std::optional<RoomPart> PartOf(const Reference& reference) {
  const auto found = std::ranges::find_if(
      kParts, [&](const Part& part) { return part.kind == reference.kind && part.name == reference.name; });
  return found == kParts.end() ? std::nullopt : std::optional(found->part);
}

Reference ReferenceTo(RoomPart part) {
  const auto found = std::ranges::find(kParts, part, &Part::part);
  Reference reference;
  if (found == kParts.end()) return reference;
  reference.kind = found->kind;
  reference.name = found->name;
  reference.plural = found->kind == RefKind::kFeature;
  return reference;
}

std::optional<ParticipantSide> SideOf(std::string_view word) {
  const auto found = std::ranges::find(kSides, word, &std::pair<ParticipantSide, std::string_view>::second);
  return found == kSides.end() ? std::nullopt : std::optional(found->first);
}

std::string_view WordOf(ParticipantSide side) {
  const auto found = std::ranges::find(kSides, side, &std::pair<ParticipantSide, std::string_view>::first);
  return found == kSides.end() ? "" : found->second;
}

}  // namespace flair::english
