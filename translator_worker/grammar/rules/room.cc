// SPDX-License-Identifier: GPL-3.0-or-later
// Places in the room, in a zone, on walls, in corners and on the ceiling. What "central" means depends on what
// carries the object.
#include <string>
#include <vector>

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
      for (const Placed& other : target.objects) {
        const std::string& host = composer.id(other);
        if (composer.IsRug(mover)) {
          LayRug("rug_under_center", mover, other, composer);
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
      // "above the headboard" after "above the bed": of the painting's own side nothing is said.
      if (target.objects.empty() || target.objects.front().object == mover.object) continue;
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
      for (const Placed& other : target.objects) {
        composer.EmitFirst({Call(composer.IsWall(mover) ? "on_wall_near" : "near")
                                .Text("object", id)
                                .Text("target", composer.id(other))});
      }
    }
  }
}

// "Needs a wall behind it", "a wall at its back".
void WallBehind(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& mover : composer.Movers(match.b)) {
    const std::string side = OneSide(composer, mover);
    composer.EmitFirst(
        {Call("against_wall").Text("object", composer.id(mover)).Text("side", side.empty() ? "back" : side)});
  }
}

bool IsPlainSide(const Mention& mention) {
  const std::string& side = mention.references.front().side;
  return side == "front" || side == "back" || side == "left" || side == "right";
}

// "[X] against a wall (back side)": the side stands before or after.
void Against(const Match& match, std::string_view, Composer& composer) {
  if (composer.RefuseUnnamed(*match.b)) return;
  std::vector<Placed> movers = composer.Movers(match.a);
  const Reference& what = match.b->references.front();
  for (Target target : composer.Targets(*match.b, movers)) {
    // "Each chair is against the side of the table": not all of them against the same.
    if (what.side == "side" && movers.size() > 2) {
      for (Placed& other : target.objects) other.side.clear();
    }
    for (Placed mover : movers) {
      // "In a corner with two sides against walls": the corner says it.
      const bool two = mover.side == "sides" || mover.side == "two_any" || mover.side == "opposite_two";
      if (target.kind == RefKind::kWall && two && composer.IsInCorner(mover)) continue;
      if (match.c != nullptr && IsPlainSide(*match.c)) mover.side = match.c->references.front().side;
      if (target.kind == RefKind::kWall) {
        if (composer.IsWall(mover)) {
          composer.Refuse("not_about_layout", "a wall object hangs on a wall anyway; say near, above or opposite what");
          continue;
        }
        composer.EmitFirst({Call("against_wall")
                                .Text("object", composer.id(mover))
                                .MaybeText("side", OneSide(composer, mover))
                                .MaybeText("wall", target.name)});
      } else {
        Contact(mover, target, composer);
      }
    }
  }
}

// "Against a wall with both sides accessible".
void AgainstAndAccessible(const Match& match, std::string_view detail, Composer& composer) {
  Match wall = match;
  wall.c = nullptr;
  Against(wall, detail, composer);
  for (const Placed& mover : composer.Movers(match.a)) {
    std::vector<std::string> sides;
    for (const Reference& reference : match.c->references) {
      for (const std::string& side : SidesOf(composer, {mover.object, reference.side})) sides.push_back(side);
    }
    KeepSpaceAt(mover, sides, nullptr, composer);
  }
}

// "X's right side aligns with Y's left": adjoining for opposite sides, the same direction for equal ones.
void Aligned(const Match& match, std::string_view detail, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  for (const Target& target : composer.Targets(*match.b, movers)) {
    if (target.objects.empty()) {
      Against(match, detail, composer);
      return;
    }
    for (const Placed& mover : movers) {
      for (const Placed& other : target.objects) {
        if (mover.side == "front" && other.side == "front" && composer.IsChair(mover)) {
          composer.Relate("facing", mover, other);
        } else if (!mover.side.empty() && mover.side == OppositeSide(other.side)) {
          Contact(mover, {RefKind::kObjects, {other}, ""}, composer);
        } else {
          composer.Relate("parallel", mover, other);
        }
      }
    }
  }
}

// "With their backs aligned": of the two last spoken of.
void AlignedPair(const Match&, std::string_view, Composer& composer) {
  for (const Placed& mover : composer.pair_movers()) {
    for (const Placed& other : composer.pair_targets()) {
      composer.Relate("parallel", mover, other);
    }
  }
}

void SameWall(const Match&, std::string_view, Composer& composer) {
  composer.Refuse("not_expressible", "no call compares the walls of two objects; name the wall");
}

void NotAgainst(const Match& match, std::string_view, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  for (const Target& target : composer.Targets(*match.b, movers, false)) {
    for (const Placed& mover : movers) {
      if (target.kind != RefKind::kWall) continue;
      composer.EmitFirst(
          {Call("not_against_wall").Text("object", composer.id(mover)).MaybeText("side", OneSide(composer, mover))});
    }
  }
}

void InCorner(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& mover : composer.Movers(match.a)) {
    composer.EmitFirst(
        {Call("in_corner").Text("object", composer.id(mover)).MaybeText("side", OneSide(composer, mover))});
  }
}

void TowardsWall(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& mover : composer.Movers(match.a)) {
    composer.EmitFirst(
        {Call("against_wall").Text("object", composer.id(mover)).MaybeText("side", OneSide(composer, mover))});
  }
}

void Freestanding(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& mover : composer.Movers(match.a)) {
    composer.Place("not_against_wall", mover);
  }
}

void CenteredOnWall(const Match& match, std::string_view, Composer& composer) {
  const std::string wall = match.b != nullptr ? match.b->references.front().name : "";
  for (const Placed& mover : composer.Movers(match.a)) {
    composer.EmitFirst({Call("centered_on_wall").Text("object", composer.id(mover)).MaybeText("wall", wall),
                        Call("against_wall").Text("object", composer.id(mover)).MaybeText("wall", wall)});
  }
}

}  // namespace

std::vector<Meaning> RoomMeanings() {
  return {{"central", Central},
          {"central_in", CentralIn},
          {"in_zone", InZone},
          {"ignore", Ignore},
          {"on_floor", OnFloor},
          {"above", Above},
          {"on_wall_near", OnWallNear},
          {"wall_behind", WallBehind},
          {"against", Against},
          {"against_and_accessible", AgainstAndAccessible},
          {"aligned", Aligned},
          {"aligned_pair", AlignedPair},
          {"same_wall", SameWall},
          {"not_against", NotAgainst},
          {"in_corner", InCorner},
          {"towards_wall", TowardsWall},
          {"freestanding", Freestanding},
          {"centered_on_wall", CenteredOnWall}};
}

}  // namespace flair::translator
