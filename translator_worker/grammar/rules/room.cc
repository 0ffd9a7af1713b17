// SPDX-License-Identifier: GPL-3.0-or-later
// Places in the room, in a zone, on walls and on the ceiling. What "central" means depends on what carries the object.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "fmt/format.h"
#include "translator_worker/grammar/frames.h"
#include "translator_worker/grammar/rules/shared.h"

namespace flair::translator {
namespace {

void InMiddleOfRoom(const Placed& mover, Composer& composer) {
  if (composer.IsCeiling(mover)) {
    composer.Place("ceiling_center", mover);
  } else if (composer.IsRug(mover) || composer.IsFloor(mover)) {
    composer.EmitFirst({Call("central").Text("object", composer.id(mover)).Flag("both", true)});
  } else {
    composer.Refuse("unknown_sentence", "only floor and ceiling objects can be in the middle of the room");
  }
}

void Central(const Match& match, std::string_view, Composer& composer) {
  // "In front of the sofa, centred": of the sofa, not of the room.
  if (match.a == nullptr && match.b == nullptr && !composer.calls().empty()) return;
  for (const Placed& mover : composer.Movers(match.a)) InMiddleOfRoom(mover, composer);
}

// "centred in the seating area", "in the middle of the table".
void CentralIn(const Match& match, std::string_view, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  for (const Target& target : composer.Targets(*match.b, movers)) {
    for (const Placed& mover : movers) {
      const std::string& id = composer.id(mover);
      const bool furniture = composer.IsFloor(mover) && !composer.IsRug(mover);
      if (target.kind == RefKind::kZone && (target.objects.empty() || furniture)) {
        composer.EmitFirst({Call("in_zone").Text("object", id).Text("zone", target.name)});
        continue;
      }
      if (target.kind == RefKind::kRoom || target.kind == RefKind::kCeiling || target.kind == RefKind::kFloor) {
        InMiddleOfRoom(mover, composer);
        continue;
      }
      for (const Placed& other : target.objects) {
        const std::string& host = composer.id(other);
        if (composer.IsRug(mover)) {
          if (!composer.rug_placed) composer.EmitFirst({Call("rug_under_center").Text("rug", id).Text("object", host)});
          composer.rug_placed = true;
        } else if (composer.IsCeiling(mover)) {
          composer.EmitFirst({Call("ceiling_above").Text("object", id).Text("target", host)});
        } else if (composer.IsWall(mover)) {
          composer.EmitFirst({Call("on_wall_above").Text("object", id).Text("target", host)});
        } else if (composer.IsSurface(mover)) {
          composer.EmitFirst({Call("on_top_center").Text("object", id).Text("host", host)});
        } else {
          // "Centred at the desk's front" is in front of it.
          const char* type = other.side == "front" ? "in_front_of" : "near";
          composer.EmitFirst({Call(type).Text("object", id).Text("target", host)});
        }
      }
    }
  }
}

void InZone(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& mover : composer.Movers(match.a)) {
    const std::string& zone = match.b->references.front().name;
    // "Under the sofa in the seating area": the sofa says it all.
    const bool rug = composer.IsTertiaryRug(mover);
    if ((!composer.IsFloor(mover) || rug) && !composer.calls().empty()) continue;
    if (composer.IsWall(mover)) {
      composer.EmitFirst({Call("on_wall_in_zone").Text("object", composer.id(mover)).Text("zone", zone)});
    } else if (composer.IsFloor(mover)) {
      composer.EmitFirst({Call("in_zone").Text("object", composer.id(mover)).Text("zone", zone)});
    } else if (composer.calls().empty()) {
      composer.Refuse("unknown_sentence", "only floor and wall objects can be put into a zone");
    }
  }
}

// "on the desk in the study area": the object says it all.
void Ignore(const Match&, std::string_view, Composer&) {}

void OnFloor(const Match&, std::string_view, Composer& composer) {
  composer.Refuse("not_about_layout", "what stands on the floor is known from the object list");
}

// The type depends on what carries the object that hangs.
void Above(const Match& match, std::string_view, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  for (const Target& target : composer.Targets(*match.b, movers)) {
    for (const Placed& mover : movers) {
      const std::string& id = composer.id(mover);
      if (target.objects.empty()) {
        composer.Refuse("unknown_sentence", "it can hang above an object");
        continue;
      }
      // "above the headboard" after "above the bed": of the painting's own side nothing is said.
      if (target.objects.front().object == mover.object) continue;
      const std::string& below = composer.id(target.objects.front());
      if (composer.IsCeiling(mover)) {
        composer.EmitFirst({Call("ceiling_above").Text("object", id).Text("target", below)});
      } else if (composer.IsWall(mover)) {
        composer.EmitFirst({Call("on_wall_above").Text("object", id).Text("target", below)});
      } else if (composer.IsSurface(mover)) {
        composer.EmitFirst({Call("on_top_center").Text("object", id).Text("host", below)});
      } else {
        composer.EmitFirst({Call("near").Text("object", id).Text("target", below)});
      }
    }
  }
}

void OnWallNear(const Match& match, std::string_view, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  for (const Target& target : composer.Targets(*match.b, movers)) {
    for (const Placed& mover : movers) {
      const std::string& id = composer.id(mover);
      if (target.kind == RefKind::kFeature) {
        composer.EmitFirst({Call("close_to_feature").Text("object", id).Text("feature", target.name)});
      }
      for (const Placed& other : target.objects) {
        composer.EmitFirst({Call(composer.IsWall(mover) ? "on_wall_near" : "near")
                                .Text("object", id)
                                .Text("target", composer.id(other))});
      }
    }
  }
}

// "Needs a wall behind it", "a wall at its back".
void WallBehind(const Match& match, std::string_view detail, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.b);
  if (composer.scope() == v1::SENTENCE_SCOPE_TERTIARY || (!movers.empty() && !composer.IsFloor(movers.front()))) {
    Above(match, detail, composer);
    return;
  }
  for (const Placed& mover : movers) {
    const std::string side = OneSide(composer, mover);
    composer.EmitFirst(
        {Call("against_wall").Text("object", composer.id(mover)).Text("side", side.empty() ? "back" : side)});
  }
}

}  // namespace

std::vector<Meaning> RoomMeanings() {
  return {
      {"central", Central},  {"central_in", CentralIn}, {"in_zone", InZone},          {"ignore", Ignore},
      {"on_floor", OnFloor}, {"above", Above},          {"on_wall_near", OnWallNear}, {"wall_behind", WallBehind},
  };
}

}  // namespace flair::translator
