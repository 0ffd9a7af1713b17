// SPDX-License-Identifier: GPL-3.0-or-later
// Walls and corners: against, along, near, away from them; "against" another object is contact with it.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "fmt/format.h"
#include "translator_worker/grammar/frames.h"
#include "translator_worker/grammar/rules/shared.h"

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
void AgainstAndAccessible(const Match& match, std::string_view detail, Composer& composer) {
  Match wall = match;
  wall.c = nullptr;
  Against(wall, detail, composer);
  for (const Placed& mover : composer.Movers(match.a)) {
    std::vector<std::string> sides;
    for (const Reference& reference : match.c->references) {
      for (const std::string& side : SidesOf(composer, {mover.object, reference.side})) sides.push_back(side);
    }
    composer.EmitFirst({Call("accessible").Text("object", composer.id(mover)).Texts("sides", sides)});
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
        // "Next to it, with one of its sides aligned": sides that stand next to each other are.
        if (mover.side == "side" && !composer.calls().empty()) continue;
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
        composer.RelateToFeature("clear_of_feature", mover, target.name);
      }
      for (const Placed& other : target.objects) {
        composer.Relate("away_from", mover, other);
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

std::vector<Meaning> WallMeanings() {
  return {
      {"against", Against},           {"against_and_accessible", AgainstAndAccessible},
      {"aligned", Aligned},           {"aligned_pair", AlignedPair},
      {"same_wall", SameWall},        {"not_against", NotAgainst},
      {"in_corner", InCorner},        {"towards_wall", TowardsWall},
      {"freestanding", Freestanding}, {"centered_on_wall", CenteredOnWall},
  };
}

}  // namespace flair::translator
