// SPDX-License-Identifier: GPL-3.0-or-later
// Walls and the ceiling: pictures above beds, lamps above tables.
#include "translator_worker/grammar/rules/rule.h"

namespace flair::translator {
namespace {

// The type depends on what carries the object that hangs.
void Above(const Match& match, std::string_view, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  const Mention& over = match.c != nullptr ? *match.c : *match.b;
  for (const Target& target : composer.Targets(over, movers)) {
    for (const Placed& mover : movers) {
      const std::string& id = composer.id(mover);
      if (target.objects.empty()) {
        composer.Refuse("unknown_sentence", "it can hang above an object");
        continue;
      }
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
  for (const Target& target : composer.Targets(*match.c, movers)) {
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

}  // namespace

std::vector<Rule> HangingRules() {
  return {
      {"A? hanging? above B", Above},
      {"A? hanging? centered? above B ,? on? B.wall?", Above},
      {"A? hanging? above side? B.object ,? on B.wall", Above},
      {"A? hanging? on B.wall centered? above/behind C", Above},
      {"A? hanging? on B.wall ,? directly? above C", Above},
      {"A? hanging? on B.wall next_to or above C", OnWallNear},
      {"A? hanging? on B.wall near/next_to/left_of/right_of C", OnWallNear},
      {"A? hanging? on B.wall above or near/next_to C", OnWallNear},
      {"A? hanging near/next_to C", OnWallNear},
      {"A? hanging? away_from? on? B.ceiling ,? above C", Above},
      {"A? hanging away_from B.ceiling ,? above C", Above},
  };
}

}  // namespace flair::translator
