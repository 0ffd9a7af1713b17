// SPDX-License-Identifier: GPL-3.0-or-later
// Free space by its place: in front, behind, at the sides, around, with or without a figure.
#include "translator_worker/grammar/rules/rule.h"
#include "translator_worker/grammar/rules/space.h"
#include "translator_worker/grammar/rules/space_at.h"

namespace flair::translator {
namespace {

// "0.1 m on each side and behind": as much as at the sides.
void MoreSpace(const Match&, std::string_view tag, Composer& composer) {
  const bool sides = tag == "sides";
  if (!composer.AddSides(sides ? std::vector<std::string>{"left", "right"}
                               : std::vector<std::string>{std::string(tag)}))
    composer.Refuse("unknown_sentence", "nothing says what is there");
}

// "0.8 m behind the user": behind chairs, in front of what people sit or stand at.
void BehindUser(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& owner : composer.Movers(match.a)) {
    KeepSpace({{owner.object, composer.IsSeat(owner) ? "back" : "front"}}, match.distance, composer);
  }
}

// "Legroom underneath": inside of the piece nothing is kept free.
void SpaceUnderneath(const Match&, std::string_view, Composer& composer) {
  composer.Refuse("not_expressible", "free space can be asked for beside an object, not under it");
}

}  // namespace

std::vector<Rule> SpaceRules() {
  return {
      {"C.feature space? D? space? keep_clear? in_front keep_clear?", SpaceAt, "front"},
      {"C.feature in_front space? D space? swing_open?", SpaceAt, "front"},
      {"A.side D space? swing_open", SpaceAt, "named"},
      {"A.side D of? space? swing_open", SpaceAt, "named"},
      {"A? D of? in_front_of C.pronoun", SpaceAt, "front"},
      {"A? D to in_front_of C.pronoun", SpaceAt, "front"},
      {"A? space? legroom under B?", SpaceUnderneath},
      {"A? space? D? of? legroom ,? of? D? space? ,? in_front?", SpaceAt, "front"},
      {"D keep_clear behind B.object", SpaceAt, "back"},
      {"D keep_clear in_front_of B.object", SpaceAt, "front"},
      {"D keep_clear around B.object", SpaceAt, "around"},
      {"D keep_clear at_sides", SpaceAt, "sides"},
      {"behind B.object ,? D keep_clear", SpaceAt, "back"},
      {"in_front_of B.object ,? D keep_clear", SpaceAt, "front"},
      {"around B.object ,? D keep_clear", SpaceAt, "around"},
      {"around B.pronoun ,? D space?", SpaceAt, "around"},
      {"all_sides B.pronoun ,? D space?", SpaceAt, "all"},
      {"A.object? accessible_from ,? around", SpaceAt, "around"},
      {"A.object? space? D? accessible ,? at_sides", SpaceAt, "sides"},
      {"A? accessible in_front", SpaceAt, "front"},
      {"A? space? in_front of? ,? D", SpaceAt, "front"},
      {"A? space D? space? ,? at_sides", SpaceAt, "sides"},
      {"A? space? D space? ,? at_sides", SpaceAt, "sides"},
      {"D space left_of B.object", SpaceAt, "left"},
      {"space D? left_of B.object", SpaceAt, "left"},
      {"D space right_of B.object", SpaceAt, "right"},
      {"space D? right_of B.object", SpaceAt, "right"},
      {"A? ,? D? space? keep_clear? in_front keep_clear?", SpaceAt, "front"},
      {"A? ,? space? D? space? in_front", SpaceAt, "front"},
      {"A? ,? space? D? space? behind", SpaceAt, "back"},
      {"A? ,? space D? at_sides", SpaceAt, "sides"},
      {"A? space? D? space? around B.side", SpaceAt, "named"},
      {"A? space D? around", SpaceAt, "around"},
      {"A? space? D? around D? space ,? D?", SpaceAt, "around"},
      {"A? space? ,? D? space? all_sides", SpaceAt, "all"},
      {"A? space? D? space? all_sides B.object", SpaceAt, "all"},
      {"A? space? D? space? all_sides that? not against/near/along/next_to B.wall", SpaceAt, "free_sides"},
      {"A? space? all_sides , D space?", SpaceAt, "all"},
      {"A? space? around B.side , D space?", SpaceAt, "named"},
      {"A? space? around B.object , D space?", SpaceAt, "around"},
      {"A? space? around B.object , D space? all_sides", SpaceAt, "all"},
      {"A.object? accessible space? D? on? B.side", SpaceAt, "named"},
      {"A? accessible/access_to/allow_access_to B.object ,? all_sides", SpaceAt, "all"},
      {"not? C.vague not? in_front", SpaceAt, "front"},
      {"around B.object keep_clear/clear_of", SpaceAt, "around"},
      {"A? space D? around B.object keep_clear", SpaceAt, "around"},
      {"A? space D? in_front_of B.object keep_clear", SpaceAt, "front"},
      {"A? space D? behind B.object keep_clear", SpaceAt, "back"},
      {"A? space D? all_sides keep_clear", SpaceAt, "all"},
      {"A? space D? at_sides keep_clear", SpaceAt, "sides"},
      {"around B.object clear_of C", SpaceAt, "around"},
      {"A.object? accessible all_sides", SpaceAt, "all"},
      {"A.object? accessible around", SpaceAt, "all"},
      {"A.object? accessible around ,? D space?", SpaceAt, "all"},
      {"A? space D? around B.object", SpaceAt, "around"},
      {"D space? around B.object", SpaceAt, "around"},
      {"D space? around", SpaceAt, "around"},
      {"space D? in_front_of B.object keep_clear?", SpaceAt, "front"},
      {"D space in_front_of B.object keep_clear?", SpaceAt, "front"},
      {"D in_front_of B.object keep_clear", SpaceAt, "front"},
      {"space D? behind B.object keep_clear?", SpaceAt, "back"},
      {"D space behind B.object keep_clear?", SpaceAt, "back"},
      {"A.object D space? behind B.object keep_clear?", SpaceAt, "back"},
      {"A.object space D? behind B.object keep_clear?", SpaceAt, "back"},
      {"D behind B.object keep_clear", SpaceAt, "back"},
      {"space D? foot_of/end_of B", SpaceAt, "front"},
      {"D space? foot_of/end_of B", SpaceAt, "front"},
      {"space D? on/at_sides/next_to/along/each_side_of B.side keep_clear?", SpaceAt, "named"},
      {"D space? on/at_sides/next_to/along/each_side_of B.side keep_clear?", SpaceAt, "named"},
      {"on/at_sides/next_to/along/each_side_of B.side keep_clear", SpaceAt, "named"},
      {"A space? D space? behind C.pronoun", SpaceAt, "back"},
      {"A.object space D space? on/next_to/at_sides/along B.side", SpaceAt, "named"},
      {"A.object D space? on/next_to/at_sides/along B.side", SpaceAt, "named"},
      {"A space? D space? in_front_of C.pronoun", SpaceAt, "front"},
      {"space D? on/next_to/along/near B.object", SpaceAt, "named"},
      {"D space on/next_to/along B.object", SpaceAt, "named"},
      {"space D? each_side_of B.object", SpaceAt, "sides"},
      {"D space? each_side_of B.object", SpaceAt, "sides"},
      {"A.object space ,? D", SpaceAt, "named"},
      {"A.side D space?", SpaceAt, "named"},
      {"D space? on/next_to/along B.side", SpaceAt, "named"},
      {"A.side space D?", SpaceAt, "named"},
      {"A.object? space D? swing_open ,? C.feature?", SpaceAt, "named"},
      {"A? swing_open ,? not block/against/near/next_to C.object", SpaceAt, "named"},
      {"nearest B D apart/away?", SpaceAt, "around"},
      {"space for around ,? D?", SpaceAt, "around"},
      {"space for C ,? on/at_sides/along/next_to B.side", SpaceAt, "named"},
      {"D space? B.side", SpaceAt, "named"},
      {"space D? B.side", SpaceAt, "named"},
      {"B.side of D", SpaceAt, "named"},
      {"space B.side of D", SpaceAt, "named"},
      {"behind B.object accessible/keep_clear ,? D?", SpaceAt, "back"},
      {"in_front_of B.object accessible/keep_clear ,? D?", SpaceAt, "front"},
      {"around B.object accessible ,? D?", SpaceAt, "around"},
      {", behind", MoreSpace, "back"},
      {", in_front", MoreSpace, "front"},
      {", at_sides", MoreSpace, "sides"},
      {"D space? around B.side", SpaceAt, "named"},
      {"A swing_open", SpaceAt, "named"},
      {"A.object? space D? for/to swing_open ,? C.feature?", SpaceAt, "named"},
      {"space for? A swing_open", SpaceAt, "named"},
      {"D space? for/to A.side swing_open", SpaceAt, "named"},
      {"C.vague? on/next_to/at_sides B.side D space?", SpaceAt, "named"},
      {"space? D? space? to/for? step_back", SpaceAt, "front"},
      {"step_back D? space? away_from B.object", SpaceAt, "front"},
      {"step_back D", SpaceAt, "front"},
      {"A? ,? space? D? space? behind_user", BehindUser},
      {"C.vague? space? D? space? surround B.object", SpaceAt, "around"},
      {"C.vague? space? D? space? surround B.object all_sides", SpaceAt, "all"},
      {"C.vague not D? at_sides", SpaceAt, "sides"},
      {"C.vague not D? in_front", SpaceAt, "front"},
      {"C.vague not D? behind", SpaceAt, "back"},
      {"C.vague not D? all_sides/around", SpaceAt, "all"},
      {"C.group not D at_sides", SpaceAt, "sides"},
      {"C.group not D in_front", SpaceAt, "front"},
      {"C.group not D behind", SpaceAt, "back"},
      {"C.group not D all_sides/around", SpaceAt, "all"},
      {"A? surrounded_by D? space ,? D?", SpaceAt, "around"},
      {"A? surrounded_by C.vague ,? D", PathAround, "around"},
      {"A? surrounded_by D C.vague", PathAround, "around"},
      {"D of in_front", SpaceAt, "front"},
  };
}

}  // namespace flair::translator
