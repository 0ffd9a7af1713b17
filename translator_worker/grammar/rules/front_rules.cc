// SPDX-License-Identifier: GPL-3.0-or-later
// What must not stand beside or before a piece: free space, said by what is not there.
#include "translator_worker/grammar/rules/gaps.h"
#include "translator_worker/grammar/rules/rule.h"
#include "translator_worker/grammar/rules/space.h"

namespace flair::translator {
namespace {

// "Avoid placing objects too close to the sides of the bed."
void NothingNear(const Match& match, std::string_view, Composer& composer) {
  for (Placed owner : composer.TargetObjects(*match.b, {})) {
    if (owner.side.empty()) owner.side = "all";
    KeepSpace({owner}, match.distance, composer);
  }
}

// "No furniture in front".
void SpaceBefore(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& owner : composer.topic()) KeepSpaceAt(owner, {"front"}, match.distance, composer);
}

// "Nothing may stand beside it".
void NothingBeside(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& owner : composer.TargetObjects(*match.b, {})) {
    KeepSpace({{owner.object, owner.side.empty() ? "sides" : owner.side}}, match.distance, composer);
  }
}

// "Nothing within half a metre of its shelves".
void NothingWithin(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& owner : composer.TargetObjects(*match.b, {})) KeepFreeBeside(owner, match.distance, composer);
}

// "Nothing may stand behind it", tag: that side.
void NothingAtSide(const Match& match, std::string_view tag, Composer& composer) {
  for (const Placed& owner : composer.TargetObjects(*match.b, {})) {
    KeepSpaceAt(owner, {std::string(tag)}, match.distance, composer);
  }
}

void NothingInFront(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& owner : composer.TargetObjects(*match.b, {})) {
    KeepSpace({{owner.object, "front"}}, match.distance, composer);
  }
}

}  // namespace

std::vector<Rule> FrontRules() {
  return {
      {"not near B.side", NothingNear},
      {"A.group not near B.side", NothingNear},
      {"A.group not in_front_of B.thing", NothingInFront},
      {"A.group not in_front", SpaceBefore},
      {"A.group not behind B.thing", NothingAtSide, "back"},
      {"A.group not left_of B.thing", NothingAtSide, "left"},
      {"A.group not right_of B.thing", NothingAtSide, "right"},
      {"A.group not D of/near B.side", NothingNear},
      {"A.group not D of/near B.object", NothingWithin},
      {"C.vague not near B.side", NothingNear},
      {"C.vague not D of/near B.side", NothingNear},
      {"C.vague not D of/near B.object", NothingWithin},
      {"C.vague not in_front_of B.thing", NothingInFront},
      {"A.group not next_to/at_sides B.thing", NothingBeside},
      {"A.group not block around B.object", NothingNear},
      {"A.group not block in_front_of B.thing", NothingInFront},
  };
}

}  // namespace flair::translator
