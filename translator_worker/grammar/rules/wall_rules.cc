// SPDX-License-Identifier: GPL-3.0-or-later
// Walls and corners: against, along, near, away from them; "against" another object is contact with it.
#include "translator_worker/grammar/rules/contact.h"
#include "translator_worker/grammar/rules/rule.h"
#include "translator_worker/grammar/sides.h"

namespace flair::translator {
namespace {

bool IsPlainSide(const Mention& mention) {
  const std::string& side = mention.references.front().side;
  return side == "front" || side == "back" || side == "left" || side == "right";
}

// "[X] against a wall (back side)": the side stands before or after.
void Against(const Match& match, std::string_view, Composer& composer) {
  if (composer.RefuseUnnamed(*match.b)) return;
  std::vector<Placed> movers = composer.Movers(match.a);
  // "The chairs are against the sides of the table".
  const Reference& what = match.b->references.front();
  if (what.kind == RefKind::kObjects && what.side == "sides" && movers.size() > 2) {
    Flank(movers, composer.TargetObjects(*match.b, movers), composer);
    return;
  }
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
void AgainstAndAccessible(const Match& match, std::string_view tag, Composer& composer) {
  Match wall = match;
  wall.c = nullptr;
  Against(wall, tag, composer);
  for (const Placed& mover : composer.Movers(match.a)) {
    std::vector<std::string> sides;
    for (const Reference& reference : match.c->references) {
      for (const std::string& side : SidesOf(composer, {mover.object, reference.side})) sides.push_back(side);
    }
    composer.EmitFirst({Call("accessible").Text("object", composer.id(mover)).Texts("sides", sides)});
  }
}

// "X's right side aligns with Y's left": adjoining for opposite sides, the same direction for equal ones.
void Aligned(const Match& match, std::string_view tag, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  for (const Target& target : composer.Targets(*match.b, movers)) {
    if (target.objects.empty()) {
      Against(match, tag, composer);
      return;
    }
    for (const Placed& mover : movers) {
      for (const Placed& other : target.objects) {
        // "Next to it, with one of its sides aligned": sides that stand next to each other are.
        if (mover.side == "side" && !composer.calls().empty()) continue;
        if (mover.side == "front" && other.side == "front" && composer.IsChair(mover)) {
          composer.EmitFirst({Call("facing").Text("object", composer.id(mover)).Text("target", composer.id(other))});
        } else if (!mover.side.empty() && mover.side == OppositeSide(other.side)) {
          Contact(mover, {RefKind::kObjects, {other}, ""}, composer);
        } else {
          composer.EmitFirst({Call("parallel").Text("object", composer.id(mover)).Text("target", composer.id(other))});
        }
      }
    }
  }
}

// "With their backs aligned": of the two last spoken of.
void AlignedPair(const Match&, std::string_view, Composer& composer) {
  for (const Placed& mover : composer.pair_movers()) {
    for (const Placed& other : composer.pair_targets()) {
      composer.EmitFirst({Call("parallel").Text("object", composer.id(mover)).Text("target", composer.id(other))});
    }
  }
  if (composer.pair_targets().empty()) composer.Refuse("unknown_sentence", "say with what it is aligned");
}

void SameWall(const Match& match, std::string_view, Composer& composer) {
  if (match.b != nullptr) {
    const std::vector<Placed> movers = composer.Movers(match.a);
    composer.SetPair(movers, composer.TargetObjects(*match.b, movers));
  }
  composer.Refuse("not_expressible", "no call compares the walls of two objects; name the wall");
}

void NotAgainst(const Match& match, std::string_view, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  // "Near a wall, not against it".
  const bool of_wall = match.b->references.front().kind == RefKind::kPronoun && composer.wall_named;
  const std::vector<Target> targets =
      of_wall ? std::vector<Target>{{RefKind::kWall, {}, ""}} : composer.Targets(*match.b, movers, false);
  for (const Target& target : targets) {
    for (const Placed& mover : movers) {
      if (target.kind == RefKind::kWall) {
        composer.EmitFirst(
            {Call("not_against_wall").Text("object", composer.id(mover)).MaybeText("side", OneSide(composer, mover))});
      }
      if (target.kind == RefKind::kFeature) {
        composer.EmitFirst({Call("clear_of_feature").Text("object", composer.id(mover)).Text("feature", target.name)});
      }
      for (const Placed& other : target.objects) {
        composer.EmitFirst({Call("away_from").Text("object", composer.id(mover)).Text("target", composer.id(other))});
      }
    }
    if (!target.objects.empty()) composer.SetPair(movers, target.objects);
  }
}

void InCorner(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& mover : composer.Movers(match.a)) {
    if (!composer.IsFloor(mover)) {
      composer.Refuse("unknown_sentence", "only floor objects stand in a corner of the room; say on a corner of what");
      continue;
    }
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

// "Placement against wall: back".
void PlacedWithSide(const Match& match, std::string_view tag, Composer& composer) {
  TowardsWall({match.c, nullptr, nullptr, nullptr, match.length}, tag, composer);
}

// "No wall directly behind them".
void NoWallThere(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& placed : composer.TargetObjects(*match.a, {})) {
    composer.EmitFirst({Call("not_against_wall").Text("object", composer.id(placed))});
  }
}

void Freestanding(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& mover : composer.Movers(match.a)) {
    composer.EmitFirst({Call("not_against_wall").Text("object", composer.id(mover))});
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

std::vector<Rule> WallRules() {
  return {
      {"A? against B , C.side", Against},
      {"A? against/along/on/next_to B.wall ,? C.side", Against},
      {"A? against/along/on/next_to B.wall , C.side accessible/keep_clear", AgainstAndAccessible},
      {"A? against/along/next_to B.wall", Against},
      {"A? against B", Against},
      {"A.side to/facing B.wall", Against},
      {"A? against/near corner", InCorner},
      {"A? on B.wall", Against},
      {"A? aligned B", Aligned},
      {"A? same_wall B", SameWall},
      {"A? not same_wall B", SameWall},
      {"A? not? same_wall", SameWall},
      {"A? against B.wall on C.side", Against},
      {"A? not against/along/next_to/near/on B.wall", NotAgainst},
      {"A? not against B", NotAgainst},
      {"not against B", NotAgainst},
      {"B.wall not behind/near/next_to/against A.object", NoWallThere},
      {"A? against edge of? B.object", Against},
      {"A.side towards_back", TowardsWall},
      {"A? wall_placement", TowardsWall},
      {"A.side aligned both_ways?", AlignedPair},
      {"A? freestanding", Freestanding},
      {"A? corner B.room?", InCorner},
      {"A? corner of? B.room", InCorner},
      {"A? corner or against/along/near B.wall", InCorner},
      {"A? centered/wall_centered B.wall", CenteredOnWall},
      {"A? centered on/against/along B.wall", CenteredOnWall},
      {"A? against B.wall , centered", CenteredOnWall},
      {"wall_placement ,? C.side", PlacedWithSide},
  };
}

}  // namespace flair::translator
