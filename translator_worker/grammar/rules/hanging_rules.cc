// SPDX-License-Identifier: GPL-3.0-or-later
// Walls and the ceiling: pictures above beds, lamps above tables.
#include "translator_worker/grammar/rules/rule.h"
#include "translator_worker/grammar/sides.h"

namespace flair::translator {
namespace {

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
void WallBehind(const Match& match, std::string_view tag, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.b);
  if (composer.scope() == v1::SENTENCE_SCOPE_TERTIARY || (!movers.empty() && !composer.IsFloor(movers.front()))) {
    Above(match, tag, composer);
    return;
  }
  for (const Placed& mover : movers) {
    const std::string side = OneSide(composer, mover);
    composer.EmitFirst(
        {Call("against_wall").Text("object", composer.id(mover)).Text("side", side.empty() ? "back" : side)});
  }
}

void NotInCorner(const Match&, std::string_view, Composer& composer) {
  composer.Refuse("not_expressible", "on the ceiling only the middle and places above objects can be asked for");
}

}  // namespace

std::vector<Rule> HangingRules() {
  return {
      {"C.wall behind B.pronoun", WallBehind},
      {"C.wall on/next_to/behind B.side", WallBehind},
      {"C.wall behind B.object", WallBehind},
      {"hanging? on? C.wall ,? centered? D? above/behind B", Above},
      {"hanging? on? C.wall ,? near/next_to/left_of/right_of/to_side/in_front_of B", OnWallNear},
      {"A? hanging? centered? D? above B", Above},
      {"A? hanging? centered? above B ,? on? C.wall ,? centered?", Above},
      {"A? hanging? on C.wall ,? centered? D? above/behind/centered B", Above},
      {"A? hanging? centered/wall_centered on? C.wall ,? above/behind B", Above},
      {"A? hanging? on C.wall around/in_front_of B", OnWallNear},
      {"A? hanging? on C.wall next_to or above B", OnWallNear},
      {"A? hanging? on C.wall near/next_to/left_of/right_of/to_side B", OnWallNear},
      {"A? hanging? on C.wall above or near/next_to/to_side B", OnWallNear},
      {"A? hanging? on_wall_of B.thing", OnWallNear},
      {"A? hanging near/next_to/left_of/right_of/to_side B", OnWallNear},
      {"A? hanging? away_from? on? C.ceiling ,? centered? above B", Above},
      {"A? hanging? away_from? on? C.ceiling ,? on/centered B.zone", Above},
      {"A? hanging? away_from? on? C.ceiling ,? on/centered B.zone ,? above B", Above},
      {"A? hanging away_from C.ceiling ,? above B", Above},
      {"A? hanging? away_from/on C.ceiling ,? near/next_to B.thing", Above},
      {"A? hanging? away_from/on C.ceiling ,? near/next_to/on? corner", NotInCorner},
  };
}

}  // namespace flair::translator
