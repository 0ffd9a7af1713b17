// SPDX-License-Identifier: GPL-3.0-or-later
// Distances: away from, at least so far, gaps between, bare distances after another fact.
#include <algorithm>

#include "translator_worker/grammar/rules/contact.h"
#include "translator_worker/grammar/rules/gaps.h"
#include "translator_worker/grammar/rules/rule.h"
#include "translator_worker/grammar/sides.h"

namespace flair::translator {
namespace {

void AwayFrom(const Match& match, std::string_view tag, Composer& composer) {
  // "Not within 0.5 m of" is at least so far away.
  Distance turned;
  const Distance* distance = match.distance;
  if (!tag.empty() && distance != nullptr && distance->max_m) {
    turned.min_m = distance->max_m;
    distance = &turned;
  }
  const std::vector<Placed> movers = composer.Movers(match.a);
  // "Close to a window, but not directly in front of it".
  const Reference& what = match.b->references.front();
  if (distance == nullptr && what.kind == RefKind::kPronoun && what.side.empty() && !composer.last_feature.empty()) {
    for (const Placed& mover : movers) {
      composer.EmitFirst(
          {Call("clear_of_feature").Text("object", composer.id(mover)).Text("feature", composer.last_feature)});
    }
    return;
  }
  // "The front has 0.6 m of clearance from any other object": free space there.
  if (match.b->references.front().kind == RefKind::kGroup && !movers.empty() && !movers.front().side.empty()) {
    for (const Placed& mover : movers) KeepFreeBeside(mover, match.distance, composer);
    return;
  }
  // "0.5 m of clearance from the back": free space there.
  const bool own_side = what.kind == RefKind::kPronoun && what.name.empty() && !what.side.empty();
  if (own_side && distance != nullptr && composer.calls().empty()) {
    for (const Placed& mover : movers) KeepFreeBeside({mover.object, what.side}, distance, composer);
    return;
  }
  // "Used from both long sides": they are to be got at.
  const bool several =
      what.side == "sides" || what.side == "all" || what.side == "three" || what.side.ends_with("both");
  if (own_side && several && composer.calls().empty()) {
    for (const Placed& mover : movers) KeepFreeBeside({mover.object, what.side}, nullptr, composer);
    return;
  }
  // "The sides of the bed are 0.6 m from walls and furniture": space on both of them.
  const bool both_sides = !movers.empty() && (movers.front().side == "sides" || movers.front().side.ends_with("both"));
  if (both_sides && distance != nullptr && (what.kind == RefKind::kWall || what.kind == RefKind::kGroup)) {
    for (const Placed& mover : movers) KeepFreeBeside(mover, distance, composer);
    return;
  }
  for (const Target& target : composer.Targets(*match.b, movers, false)) {
    for (const Placed& mover : movers) KeepAway(mover, target, distance, composer);
  }
}

// "0.5 m from the wall on its left": free space at that side; tag is a side word, else C names it.
void FromWallAtSide(const Match& match, std::string_view tag, Composer& composer) {
  for (const Placed& mover : composer.Movers(match.a)) {
    if (match.c == nullptr) KeepFreeBeside({mover.object, std::string(tag)}, match.distance, composer);
    if (match.c == nullptr) continue;
    for (const Reference& reference : match.c->references) {
      KeepFreeBeside({mover.object, reference.side}, match.distance, composer);
    }
  }
}

// "at least 0.4 m from any seat to the bookshelf".
void FromTo(const Match& match, std::string_view, Composer& composer) {
  // "From the back of the chair to any other object": free space there.
  const RefKind to = match.c->references.front().kind;
  if (to == RefKind::kGroup || to == RefKind::kWall) {
    for (const Placed& from : composer.TargetObjects(*match.b, {}, false))
      KeepFreeBeside(from, match.distance, composer);
    return;
  }
  for (const Placed& from : composer.TargetObjects(*match.b, {}, false)) {
    for (const Placed& to : composer.TargetObjects(*match.c, {from}, false))
      KeepDistance(from, to, match.distance, composer);
  }
}

// "They are not close to them" means each other, "not close to it" what was spoken of.
void NotNearPronoun(const Match& match, std::string_view tag, Composer& composer) {
  const Reference& pronoun = match.b->references.front();
  const bool one = pronoun.name == "it" || !pronoun.side.empty();
  one ? AwayFrom(match, tag, composer) : ApartFromEachOther(match, tag, composer);
}

// "The screen separates the bed from the desk".
void Separates(const Match& match, std::string_view, Composer& composer) {
  Mention both = *match.b;
  if (match.c != nullptr)
    both.references.insert(both.references.end(), match.c->references.begin(), match.c->references.end());
  const std::vector<Placed> movers = composer.Movers(match.a);
  const std::vector<Placed> parted = composer.TargetObjects(both, movers, false);
  if (parted.size() != 2 || movers.size() != 1) {
    composer.Refuse("unknown_sentence", "one object separates two others; name them");
    return;
  }
  composer.EmitFirst({Call("between")
                          .Text("object", composer.id(movers[0]))
                          .Text("first", composer.id(parted[0]))
                          .Text("second", composer.id(parted[1]))});
}

// "To the right of the desk, no gap": what stands beside it touches it.
void NoGap(const Match&, std::string_view, Composer& composer) {
  if (composer.pair_targets().empty()) composer.Refuse("unknown_sentence", "say between what there is no gap");
}

// "Across from the sofa, at least 1.5 m away": from what was related to last.
void AwayFromPartner(const Match& match, std::string_view tag, Composer& composer) {
  if (composer.pair_targets().empty()) {
    ApartFromEachOther(match, tag, composer);
    return;
  }
  for (const Placed& mover : composer.pair_movers()) {
    for (const Placed& other : composer.pair_targets()) KeepDistance(mover, other, match.distance, composer);
  }
}

// "No wall may be closer than 0.8 m to it".
void WallAway(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& placed : composer.TargetObjects(*match.a, {})) {
    KeepAway(placed, {RefKind::kWall, {}, match.b->references.front().name}, match.distance, composer);
  }
}

// "Not between the sofa and the bookshelf" is away from both; doors and windows would say something else.
void NotBetween(const Match& match, std::string_view tag, Composer& composer) {
  const bool features = std::any_of(match.b->references.begin(), match.b->references.end(),
                                    [](const Reference& one) { return one.kind == RefKind::kFeature; });
  features ? NothingBetween(match, tag, composer) : AwayFrom(match, tag, composer);
}

}  // namespace

std::vector<Rule> DistanceRules() {
  return {
      {"D space? away", AwayFromPartner},
      {"B.wall not D to/of/near/away_from A.object", WallAway},
      {"A? space? D? space? away_from B", AwayFrom},
      {"A? not space? D? space? away_from B", AwayFrom, "not"},
      {"A? not D of/near B", AwayFrom, "not"},
      {"A.group not D to/away_from B", AwayFrom, "not"},
      {"space? of? D space? apart/away A.object away_from/and B", AwayFrom},
      {"not? apart/away A.object away_from B ,? D?", AwayFrom},
      {"A? space? D space? to B.object", AwayFrom},
      {"A? space? D space? to B.wall", AwayFrom},
      {"A.list each_side_of B.room", ApartFromEachOther},
      {"A? not block B.object ,? space? D space?", AwayFrom},
      {"A? not? D space? to B.object", AwayFrom, "to"},
      {"A.list D space?", ApartFromEachOther},
      {"A.list space ,? D?", ApartFromEachOther},
      {"A? space? away_from B ,? D", AwayFrom},
      {"A? space? D? space? away_from B.wall all_sides", AwayFrom},
      {"A? space? D? space? away_from B.wall on/to/at_sides C.side", FromWallAtSide},
      {"A? space? D? space? away_from B.wall behind", FromWallAtSide, "back"},
      {"A? space? D? space? away_from B.wall at_sides", FromWallAtSide, "sides"},
      {"A? space? D? space? away_from B.wall in_front", FromWallAtSide, "front"},
      {"A? space? away_from B next_to D", AwayFrom},
      {"A? D space? of B", AwayFrom},
      {"A? not near/next_to/in_front_of B", AwayFrom},
      {"A? not along/to_side B.thing", AwayFrom},
      {"A? not along/to_side B.feature", AwayFrom},
      {"A? not? space D? between ,? B ,? D?", Between},
      {"A? D of? space? ,? between B", Between},
      {"between B ,? D keep_clear/accessible", Between},
      {"A? space? D? space? between B or C.group", BetweenOrAnything},
      {"space between B minimal", Between, "touching"},
      {"apart/away between B", Between},
      {"D apart/away B.list", Between},
      {"space D? apart/away B.list", Between},
      {"A? not centered? between B", NotBetween},
      {"A? not? space? D? space? apart/away", ApartFromEachOther},
      {"A? not? apart/away D space?", ApartFromEachOther},
      {"A? apart/away ,? D space? away_from B", AwayFrom},
      {"A? not near/next_to/against both_ways", ApartFromEachOther},
      {"A.list not near/next_to/together/side_by_side", ApartFromEachOther},
      {"A? not near/next_to/against B.pronoun", NotNearPronoun},
      {"D space?", BareDistance},
      {"space D", BareDistance},
      {"away_from? D apart/away?", BareDistance},
      {"A? space? D? space? away_from edge/corner of? B", AwayFrom},
      {"D away_from B", AwayFrom},
      {"A? not_closer B than D", AwayFrom},
      {"not near B", AwayFrom},
      {"A? not behind/left_of/right_of/foot_of/end_of/each_side_of B", AwayFrom},
      {"A? not near/next_to/in_front_of/behind or near/next_to/in_front_of/behind B", AwayFrom},
      {"space? D? space? between B , C.wall ,? D?", BetweenAndWall},
      {"A? space? D? space? away_from B.object to C.object", FromTo},
      {"A? space? away_from B.object to C.object D", FromTo},
      {"A? space? D? space? away_from B to C.group", FromTo},
      {"A? space? D? space? away_from B.object to_side/left_of/right_of/foot_of/end_of C.object", FromTo},
      {"A.vague? D? space? away_from B.object to_side/left_of/right_of/foot_of/end_of C.object", FromTo},
      {"A? space? D? space? away_from B to C.group or C.wall", FromTo},
      {"A? space? D? space? away_from B.side to C.wall", FromTo},
      {"A? space? D? space? away_from B.object edge? to C.wall", FromTo},
      {"A? space? D? space? away_from B.side to C.wall or C.group", FromTo},
      {"A? not B.feature", AwayFrom},
      {"A? not crowd B", AwayFrom},
      {"A.object to B.object ,? D", AwayFrom},
      {"A? D clear_of B.object", AwayFrom},
      {"A? clear_of B.object next_to? D", AwayFrom},
      {"A? not? space? D? space? between both_ways ,? D?", ApartFromEachOther},
      {"A? D clear_of B.wall", AwayFrom},
      {"A? D clear_of B.feature", AwayFrom},
      {"A.object apart/away B.object away_from/and C.object", Separates},
      {"A.object apart/away B.list", Separates},
      {"A.object space for B.list", AwayFrom},
      {"A? no_gap between B", Between, "touching"},
      {"no_gap between B", Between, "touching"},
      {"no_gap", NoGap},
      {"A? away_from apart/away", ApartFromEachOther},
      {"A? space? D? space? away_from both_ways", ApartFromEachOther},
      {"space D? next_to/near B.feature", AwayFrom},
      {"space away_from B ,? D", AwayFrom},
      {"A? D space? to B.feature", AwayFrom},
      {"space D? to B.feature", AwayFrom},
      {"A.list , D of? space?", ApartFromEachOther},
      {"space? away_from C.wall to B.object ,? D", BetweenAndWall},
      {"D space? away_from C.wall to B.object", BetweenAndWall},
  };
}

}  // namespace flair::translator
