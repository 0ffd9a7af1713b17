// SPDX-License-Identifier: GPL-3.0-or-later
// The part of Composer that finds what noun phrases refer to.
#include <algorithm>

#include "fmt/format.h"
#include "room/conversion/conversion.h"
#include "translator_worker/grammar/composer.h"

namespace flair::translator {
std::vector<Placed> Composer::Movers(const Mention* mention) {
  if (mention == nullptr) return topic_;
  // "Hang a clock on the wall", "eye level on the wall" under the heading "Clock": it is what the heading names.
  const RefKind kind = mention->references.front().kind;
  const bool thing = kind == RefKind::kObjects || kind == RefKind::kPronoun;
  if (scope() == v1::SENTENCE_SCOPE_TERTIARY && !subjects_.empty() && !thing) return topic_;
  std::vector<Placed> result;
  for (const Reference& reference : mention->references) {
    for (const Placed& placed : Resolve(reference, {}, false)) result.push_back(PieceFor(placed));
    if (mention->either && !result.empty() && reference.kind == RefKind::kObjects) break;
  }
  return result;
}

Placed Composer::PieceFor(const Placed& placed) const {
  const bool part = ChosenLater(placed.object) && !topic_.empty() && !Contains(subjects_, placed.object);
  return part ? Placed{topic_.front().object, placed.side} : placed;
}

bool Composer::ChosenLater(int index) const {
  return scope() != v1::SENTENCE_SCOPE_TERTIARY && object(index).role() == v1::OBJECT_ROLE_TERTIARY &&
         object(index).kind() != v1::OBJECT_KIND_FLOOR;
}

int Composer::CarrierOf(int index) const {
  const v1::Object& thing = object(index);
  if (thing.kind() != v1::OBJECT_KIND_SURFACE || thing.host_id().empty()) return -1;
  const auto& objects = request_.object_list().objects();
  const auto host = std::ranges::find_if(objects, [&](const v1::Object& one) { return one.id() == thing.host_id(); });
  const int carrier = host == objects.end() ? -1 : static_cast<int>(host - objects.begin());
  return carrier >= 0 && !ChosenLater(carrier) ? carrier : -1;
}

std::vector<Target> Composer::Targets(const Mention& mention, const std::vector<Placed>& movers, bool first_of_either) {
  std::vector<Target> result;
  partners_.clear();
  for (const Reference& reference : mention.references) {
    Target target;
    target.kind = reference.kind;
    target.name = reference.name;
    target.opening = reference.opening;
    switch (reference.kind) {
      case RefKind::kWall:
      case RefKind::kCorner:
        if (reference.missing) {
          RefuseMissing(reference);
          continue;
        }
        break;
      case RefKind::kCeiling:
      case RefKind::kRoom:
      case RefKind::kFloor:
        break;
      case RefKind::kFeature:
        if (!HasFeature(reference.name)) {
          Refuse("names_absent_feature", fmt::format("the room has no {}", reference.name));
          continue;
        }
        last_feature = reference.name;
        break;
      case RefKind::kZone:
        // A zone as seen from its main object is a place.
        if (const int main = names_.MainObject(reference.name); main >= 0 && Contains(movers, main)) break;
        [[fallthrough]];
      default:
        target.objects = Resolve(reference, movers, true);
        if (target.objects.empty()) continue;
        if (reference.any || (reference.own && movers.size() == target.objects.size())) PairUp(movers, target.objects);
        if (reference.kind != RefKind::kZone) target.kind = RefKind::kObjects;
    }
    result.push_back(std::move(target));
    if (mention.either && first_of_either) break;
  }
  return result;
}

void Composer::RefuseMissing(const Reference& reference) {
  const std::string_view what = reference.kind == RefKind::kCorner ? "corner" : "wall";
  std::string names;
  if (const absl::StatusOr<Room> room = RoomFromProto(request_.room()); room.ok()) {
    for (const Wall& wall : room->walls) names += (names.empty() ? "" : ", ") + WallName(*room, wall);
  }
  Refuse("names_absent_feature",
         fmt::format("the room has no such {}{}{}", what, names.empty() ? "" : "; its walls are ", names));
}

void Composer::PairUp(const std::vector<Placed>& movers, const std::vector<Placed>& targets) {
  if (targets.size() < 2 || movers.size() % targets.size() != 0) return;
  const size_t each = movers.size() / targets.size();
  for (size_t i = 0; i < movers.size(); ++i) partners_[id(movers[i])] = id(targets[i / each]);
}

std::vector<Placed> Composer::TargetObjects(const Mention& mention, const std::vector<Placed>& movers,
                                            bool first_of_either) {
  std::vector<Placed> result;
  for (const Target& target : Targets(mention, movers, first_of_either)) {
    if (target.objects.empty()) Refuse("unknown_sentence", "this relation needs an object, not a part of the room");
    result.insert(result.end(), target.objects.begin(), target.objects.end());
  }
  return result;
}

std::vector<Placed> Composer::Resolve(const Reference& reference, const std::vector<Placed>& movers, bool target) {
  std::vector<int> objects;
  switch (reference.kind) {
    case RefKind::kPronoun: {
      // As a target "it" is the partner of the last fact unless that is what moves now.
      const bool bare_side = reference.name.empty();
      std::vector<Placed> meant = topic_;
      if (reference.name == "one") {
        const size_t index = static_cast<size_t>(reference.ordinal) - 1;
        if (index < subjects_.size()) return {subjects_[index]};
        Refuse("unknown_sentence", "nothing says of what one is meant; name the object");
        return {};
      }
      if (reference.plural && !target && calls_.empty() && scope() == v1::SENTENCE_SCOPE_INTER) meant = subjects_;
      if (target && !bare_side && !movers.empty()) {
        if (!pair_targets_.empty() && !Contains(pair_targets_, movers.front().object)) {
          meant = pair_targets_;
        } else if (!earlier_topic_.empty() && Contains(topic_, movers.front().object) &&
                   !Contains(earlier_topic_, movers.front().object)) {
          meant = earlier_topic_;
        } else if (Contains(topic_, movers.front().object) && movers.size() > 1 && reference.name == "it") {
          meant = named_;
        }
      }
      // "Beside the chair, 0.2 m from the side": from the chair's.
      if (target && bare_side && !movers.empty() && !pair_targets_.empty() &&
          (Contains(pair_movers_, movers.front().object) || IsLikePairMover(movers.front()))) {
        meant = pair_targets_;
      }
      // "All three pieces" at the beginning of a sentence about several.
      if (meant.empty() && reference.name == "them" && scope() == v1::SENTENCE_SCOPE_INTER) meant = Primaries();
      for (Placed& placed : meant) placed.side = reference.side.empty() && !target ? placed.side : reference.side;
      if (meant.empty()) Refuse("unknown_sentence", "nothing says what is spoken of; name the object");
      return meant;
    }
    case RefKind::kObjects:
      objects = Choose(reference, movers);
      // "Near a desk" of several is near one of them.
      if (target && reference.any && movers.size() < 2 && !objects.empty()) objects.resize(1);
      break;
    case RefKind::kGroup:
      objects = Group(reference.name, movers);
      // "The seating" under the heading "Dining chairs" is these chairs.
      if (reference.name == "seating" && !target) KeepSubjects(objects);
      // "the seating" is that of the zone when it has some.
      if (reference.name == "seating" && !reference.each && !movers.empty()) KeepZone(objects, movers.front());
      break;
    case RefKind::kZone: {
      const int main = names_.MainObject(reference.name);
      if (main >= 0) objects.push_back(main);
      break;
    }
    case RefKind::kAbsent:
      // "0.4 m to the seat" of the sofa, "seats should look into the room" of benches.
      if (reference.name == "seat") {
        const std::vector<Placed>& seats = target ? pair_targets_ : topic_;
        // "From every seat", "the seats": all that people sit on.
        if ((reference.each || reference.plural) && scope() == v1::SENTENCE_SCOPE_INTER) {
          objects = Group("seating", movers);
          KeepSubjects(objects);
          if (objects.size() > seats.size()) break;
          objects.clear();
        }
        if (!seats.empty() && PlacedIs("seats", seats.front())) return seats;
      }
      Refuse("names_absent_object",
             fmt::format("the room has no \"{}\"; its objects are those of the object list", reference.name));
      return {};
    case RefKind::kVague:
      Refuse("not_about_layout",
             fmt::format("{} cannot be said by a layout call; name the objects and distances that serve it",
                         reference.name));
      return {};
    default:
      Refuse("unknown_sentence", "a part of the room cannot be moved; name an object");
      return {};
  }
  std::vector<Placed> result;
  for (const int index : objects) {
    const bool too_early = target && !movers.empty() && ChosenLater(index) && !ChosenLater(movers.front().object) &&
                           reference.kind == RefKind::kObjects;
    const int carrier = too_early ? CarrierOf(index) : -1;
    if (carrier >= 0 && !Contains(movers, carrier)) {
      result.push_back({carrier, reference.side});
      continue;
    }
    if (too_early) {
      Refuse("names_absent_object", fmt::format("\"{}\" is chosen later and cannot place furniture", reference.name));
      continue;
    }
    if (!target || !Contains(movers, index) || movers.size() > 1) result.push_back({index, reference.side});
  }
  if (target && result.size() == 1) named_ = result;
  const bool named = reference.kind == RefKind::kObjects;
  if (result.empty() && (!named || !objects.empty())) {
    Refuse("names_absent_object",
           fmt::format("{} \"{}\"{}", named ? "the room has no" : "nothing in the room is meant by", reference.name,
                       named ? " but what is to be placed itself" : ""));
  }
  return result;
}

bool Composer::IsLikePairMover(const Placed& mover) const {
  return !pair_movers_.empty() && !Contains(pair_targets_, mover.object) && IsLike(pair_movers_.front(), mover);
}

}  // namespace flair::translator
