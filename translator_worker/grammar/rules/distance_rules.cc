// SPDX-License-Identifier: GPL-3.0-or-later
// Distances: away from, at least so far, gaps between, bare distances after another fact.
#include <algorithm>

#include "translator_worker/grammar/rules/contact.h"
#include "translator_worker/grammar/rules/rule.h"
#include "translator_worker/grammar/sides.h"

namespace flair::translator {
namespace {

void AwayFromOne(const Placed& mover, const Target& target, const Distance* distance, Composer& composer) {
  const std::string& id = composer.id(mover);
  const bool at_most = distance != nullptr && !distance->min_m;
  if (target.kind == RefKind::kFeature) {
    if (at_most) {
      composer.EmitFirst({Call("close_to_feature")
                              .Text("object", id)
                              .Text("feature", target.name)
                              .MaybeNumber("max_distance_m", distance->max_m)});
    } else {
      Call call = Call("away_from_feature").Text("object", id).Text("feature", target.name);
      if (distance != nullptr) call.MaybeNumber("min_distance_m", distance->min_m);
      composer.EmitFirst({std::move(call)});
    }
  } else if (target.kind == RefKind::kWall) {
    if (at_most) {
      composer.EmitFirst({Call("near_wall").Text("object", id).MaybeNumber("max_distance_m", distance->max_m)});
    } else {
      Call call = Call("not_against_wall").Text("object", id).MaybeText("side", OneSide(composer, mover));
      if (distance != nullptr) call.MaybeNumber("min_distance_m", distance->min_m);
      composer.EmitFirst({std::move(call)});
    }
  } else if (target.objects.empty()) {
    composer.Refuse("unknown_sentence", "distances can be kept from objects, walls, doors, windows and sockets");
  }
  for (const Placed& other : target.objects) KeepDistance(mover, other, distance, composer);
  if (!target.objects.empty()) composer.SetPair({mover}, target.objects);
}

void FreeSpace(const Placed& placed, const Distance* distance, Composer& composer) {
  std::vector<std::string> sides = SidesOf(composer, placed);
  if (sides.empty()) sides = {"front", "left", "right"};
  Call call = Call("accessible").Text("object", composer.id(placed)).Texts("sides", sides);
  if (distance != nullptr) call.Number("min_clearance_m", distance->Nominal());
  composer.EmitFirst({std::move(call)});
}

void AwayFrom(const Match& match, std::string_view tag, Composer& composer) {
  // "Not within 0.5 m of" is at least so far away.
  Distance turned;
  const Distance* distance = match.distance;
  if (!tag.empty() && distance != nullptr && distance->max_m) {
    turned.min_m = distance->max_m;
    distance = &turned;
  }
  const std::vector<Placed> movers = composer.Movers(match.a);
  // "The front has 0.6 m of clearance from any other object": free space there.
  if (match.b->references.front().kind == RefKind::kGroup && !movers.empty() && !movers.front().side.empty()) {
    for (const Placed& mover : movers) FreeSpace(mover, match.distance, composer);
    return;
  }
  for (const Target& target : composer.Targets(*match.b, movers, false)) {
    for (const Placed& mover : movers) AwayFromOne(mover, target, distance, composer);
  }
}

// "0.5 m from the wall on its left": free space at that side; tag is a side word, else C names it.
void FromWallAtSide(const Match& match, std::string_view tag, Composer& composer) {
  for (const Placed& mover : composer.Movers(match.a)) {
    if (match.c == nullptr) FreeSpace({mover.object, std::string(tag)}, match.distance, composer);
    if (match.c == nullptr) continue;
    for (const Reference& reference : match.c->references) {
      FreeSpace({mover.object, reference.side}, match.distance, composer);
    }
  }
}

bool Names(const Reference& reference, int object) {
  const auto has = [&](const std::vector<int>& list) {
    return std::find(list.begin(), list.end(), object) != list.end();
  };
  return has(reference.candidates) || has(reference.weak_candidates);
}

void BetweenOrAnything(const Match& match, std::string_view tag, Composer& composer);

// Every pair of the list; "them" is the last pair spoken of, or the objects that the sentence is about.
void Between(const Match& match, std::string_view tag, Composer& composer) {
  static const Distance kTouching{0, 0, true};
  const Distance* distance = tag == "touching" ? &kTouching : match.distance;
  const Mention& mention = *match.b;
  const Reference& last = mention.references.back();
  const std::string& side = mention.references.front().side;
  if (last.kind == RefKind::kGroup && mention.references.size() > 1 && !side.empty() && side != "side") {
    BetweenOrAnything(match, tag, composer);
    return;
  }
  if (last.kind == RefKind::kGroup && mention.references.size() > 1 && distance != nullptr) {
    // "At least 0.3 m between the cabinet and any other object".
    Mention one;
    one.references = {mention.references.front()};
    Mention others;
    others.references = {last};
    const std::vector<Placed> movers = composer.Movers(&one);
    for (const Placed& other : composer.TargetObjects(others, movers, false)) {
      for (const Placed& mover : movers) KeepDistance(mover, other, distance, composer);
    }
    return;
  }
  if (last.kind == RefKind::kGroup) {
    composer.Refuse("not_about_layout",
                    "a passage between pieces that are not named cannot be asked for; name two objects");
    return;
  }
  std::vector<Placed> all;
  if (mention.references.size() == 1 && last.kind == RefKind::kPronoun) {
    if (!composer.pair_targets().empty()) {
      all = composer.pair_movers();
      all.insert(all.end(), composer.pair_targets().begin(), composer.pair_targets().end());
    } else {
      all = composer.topic().size() > 1 ? composer.topic() : composer.subjects();
      if (all.size() < 2) all = composer.TargetObjects(mention, {}, false);
    }
  } else if (last.kind == RefKind::kWall) {
    for (size_t i = 0; i + 1 < mention.references.size(); ++i) {
      Mention one;
      one.references = {mention.references[i]};
      for (const Placed& mover : composer.Movers(&one)) {
        AwayFromOne(mover, {RefKind::kWall, {}, last.name}, distance, composer);
      }
    }
    return;
  } else {
    all = composer.TargetObjects(mention, {}, false);
  }
  if (all.size() > 12 || all.size() < 2) {
    composer.Refuse("unknown_sentence", "a distance needs two objects that it is kept between");
    return;
  }
  if (all.size() == 2) composer.SetPair({all[0]}, {all[1]});
  // "Between the table and each chair": the chairs among themselves are not meant.
  const bool among_groups = mention.references.size() > 1;
  // "Between the shelf and both the desk and the table": from the shelf to each of the others.
  const auto both = std::find_if(mention.references.begin() + 1, mention.references.end(),
                                 [](const Reference& one) { return one.each && !one.plural; });
  const size_t first_of_both = both == mention.references.end() || mention.references.size() < 3
                                   ? mention.references.size()
                                   : static_cast<size_t>(both - mention.references.begin());
  const auto group_of = [&](const Placed& placed) {
    size_t group = 0;
    while (group < mention.references.size() && !Names(mention.references[group], placed.object)) ++group;
    return group < mention.references.size() ? std::min(group, first_of_both) : group;
  };
  for (size_t i = 0; i < all.size(); ++i) {
    for (size_t k = i + 1; k < all.size(); ++k) {
      if (among_groups && group_of(all[i]) == group_of(all[k]) && group_of(all[i]) < mention.references.size())
        continue;
      KeepDistance(all[i], all[k], distance, composer);
    }
  }
}

// "Between the backs of the chairs and any wall or furniture": free space there.
void BetweenOrAnything(const Match& match, std::string_view tag, Composer& composer) {
  const Reference& first = match.b->references.front();
  if (first.side.empty() || first.kind == RefKind::kGroup) {
    Between(match, tag, composer);
    return;
  }
  Mention owner;
  owner.references = {first};
  for (const Placed& placed : composer.Movers(&owner)) FreeSpace(placed, match.distance, composer);
}

// "between the lamp and the walls".
void BetweenAndWall(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& mover : composer.Movers(match.b)) {
    AwayFromOne(mover, {RefKind::kWall, {}, match.c->references.front().name}, match.distance, composer);
  }
}

// "at least 0.4 m from any seat to the bookshelf".
void FromTo(const Match& match, std::string_view, Composer& composer) {
  // "From the back of the chair to any other object": free space there.
  const RefKind to = match.c->references.front().kind;
  if (to == RefKind::kGroup || to == RefKind::kWall) {
    for (const Placed& from : composer.TargetObjects(*match.b, {}, false)) FreeSpace(from, match.distance, composer);
    return;
  }
  for (const Placed& from : composer.TargetObjects(*match.b, {}, false)) {
    for (const Placed& to : composer.TargetObjects(*match.c, {from}, false))
      KeepDistance(from, to, match.distance, composer);
  }
}

// "X and Y 0.5 m apart", "... at least 0.5 m apart" after a fact about X and Y.
void ApartFromEachOther(const Match& match, std::string_view, Composer& composer) {
  std::vector<Placed> all = composer.Movers(match.a);
  if (match.a != nullptr && match.a->references.front().kind == RefKind::kGroup) {
    composer.Refuse("not_about_layout",
                    "distances among pieces that are not named cannot be asked for; name two objects");
    return;
  }
  if (all.size() < 2) {
    all = composer.pair_movers();
    all.insert(all.end(), composer.pair_targets().begin(), composer.pair_targets().end());
  }
  if (all.size() < 2) all = composer.subjects();
  if (all.size() < 2 || all.size() > 12) {
    composer.Refuse("unknown_sentence", "nothing says what is kept apart; name two objects");
    return;
  }
  for (size_t i = 0; i < all.size(); ++i) {
    for (size_t k = i + 1; k < all.size(); ++k) KeepDistance(all[i], all[k], match.distance, composer);
  }
}

// "They are not close to them" means each other, "not close to it" what was spoken of.
void NotNearPronoun(const Match& match, std::string_view tag, Composer& composer) {
  const Reference& pronoun = match.b->references.front();
  const bool one = pronoun.name == "it" || !pronoun.side.empty();
  one ? AwayFrom(match, tag, composer) : ApartFromEachOther(match, tag, composer);
}

// "A clear walkway between the sofa and the table" keeps them apart; between pieces that are not named it is a path.
void PathBetween(const Match& match, std::string_view tag, Composer& composer) {
  if (match.a != nullptr && match.c->references.front().name == "paths") {
    ApartFromEachOther(match, tag, composer);
    return;
  }
  const bool named = match.b->references.size() > 1 && match.b->references.front().kind != RefKind::kGroup;
  if (named && match.c->references.front().name == "paths") {
    Between(match, tag, composer);
  } else {
    composer.Refuse("not_about_layout", "paths cannot be asked for; name two objects and the distance between them");
  }
}

// "Walkways of at least 0.6 m": how wide ways are, wherever they lead. Of other vague things the figure is a space's.
void Ways(const Match& match, std::string_view tag, Composer& composer);

// A bare distance belongs to the fact before it: to its pair, else it is free space in front.
void BareDistance(const Match& match, std::string_view, Composer& composer) {
  if (composer.CompleteClearance(match.distance->Nominal())) return;
  if (!composer.pair_targets().empty()) {
    for (const Placed& mover : composer.pair_movers()) {
      for (const Placed& other : composer.pair_targets()) KeepDistance(mover, other, match.distance, composer);
    }
    return;
  }
  if (!composer.topic().empty() && !composer.calls().empty() && !composer.IsFloor(composer.topic().front())) {
    composer.Note("partial", "heights and overhangs cannot be asked for");
    return;
  }
  if (match.distance->min_m && !match.distance->exact && !composer.topic().empty() && !composer.calls().empty()) {
    for (const Placed& mover : composer.topic()) {
      composer.EmitFirst({Call("accessible")
                              .Text("object", composer.id(mover))
                              .Texts("sides", {"front"})
                              .Number("min_clearance_m", *match.distance->min_m)});
    }
    return;
  }
  composer.Refuse("unknown_sentence", "a distance needs two objects that it is kept between");
}

void Ways(const Match& match, std::string_view tag, Composer& composer) {
  if (match.c->references.front().name == "paths") {
    composer.Refuse("not_about_layout", "paths cannot be asked for; name two objects and the distance between them");
  } else {
    BareDistance(match, tag, composer);
  }
}

// "No sockets nearby", "the door is at least 1 m away": from what is spoken of.
void FeatureAway(const Match& match, std::string_view, Composer& composer) {
  for (const Target& target : composer.Targets(*match.b, {}, false)) {
    const std::vector<Placed> movers = composer.Movers(match.a);
    for (const Placed& mover : movers) AwayFromOne(mover, target, match.distance, composer);
    if (movers.empty()) composer.Refuse("unknown_sentence", "nothing says what is kept away from it");
  }
}

// "Nothing between the sofa and the TV stand".
void NothingBetween(const Match&, std::string_view, Composer& composer) {
  composer.Refuse("not_expressible", "no call keeps the space between two objects empty; name a side or a distance");
}

// "Not between the sofa and the bookshelf" is away from both; doors and windows would say something else.
void NotBetween(const Match& match, std::string_view tag, Composer& composer) {
  const bool features = std::any_of(match.b->references.begin(), match.b->references.end(),
                                    [](const Reference& one) { return one.kind == RefKind::kFeature; });
  features ? NothingBetween(match, tag, composer) : AwayFrom(match, tag, composer);
}

}  // namespace

std::vector<Rule> WalkwayRules() {
  return {
      {"D? C.vague D? ,? between B", PathBetween}, {"D? C.vague between B ,? D", PathBetween},
      {"A.group not between B", NothingBetween},   {"A.list D? C.vague D? between B.pronoun", PathBetween},
      {"B.feature not near/next_to", FeatureAway}, {"B.feature not near/next_to A.object", FeatureAway},
      {"B.feature away_from", FeatureAway},        {"B.feature away_from/near D", FeatureAway},
      {"B.feature D apart", FeatureAway},          {"B.feature apart", FeatureAway},
      {"C.vague of? ,? D space?", Ways},           {"D of? space? C.vague", Ways},
  };
}

std::vector<Rule> DistanceRules() {
  return {
      {"A? space? D? space? away_from B", AwayFrom},
      {"A? not space? D? space? away_from B", AwayFrom, "not"},
      {"A? not D of/near B", AwayFrom, "not"},
      {"A.group not D to/away_from B", AwayFrom, "not"},
      {"space? of? D space? apart A.object away_from/and B", AwayFrom},
      {"not? apart A.object away_from B ,? D?", AwayFrom},
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
      {"A? not? space D? between ,? B ,? D?", Between},
      {"A? D of? space? ,? between B", Between},
      {"A? space? D? space? between B or C.group", BetweenOrAnything},
      {"space between B minimal", Between, "touching"},
      {"apart between B", Between},
      {"D apart B.list", Between},
      {"space D? apart B.list", Between},
      {"A? not centered? between B", NotBetween},
      {"A? not? space? D? space? apart", ApartFromEachOther},
      {"A? not? apart D space?", ApartFromEachOther},
      {"A? apart ,? D space? away_from B", AwayFrom},
      {"A? not near/next_to/against both_ways", ApartFromEachOther},
      {"A.list not near/next_to/together/side_by_side", ApartFromEachOther},
      {"A? not near/next_to/against B.pronoun", NotNearPronoun},
      {"D space?", BareDistance},
      {"space D", BareDistance},
      {"away_from? D apart?", BareDistance},
      {"A? D? space? away_from edge/corner of? B", AwayFrom},
      {"D away_from B", AwayFrom},
      {"A? not_closer B than D", AwayFrom},
      {"not near B", AwayFrom},
      {"A? not behind/left_of/right_of/foot_of/each_side_of B", AwayFrom},
      {"A? not near/next_to/in_front_of/behind or near/next_to/in_front_of/behind B", AwayFrom},
      {"space? D? space? between B , C.wall ,? D?", BetweenAndWall},
      {"A? space? D? space? away_from B.object to C.object", FromTo},
      {"A? space? away_from B.object to C.object D", FromTo},
      {"A? space? D? space? away_from B to C.group", FromTo},
      {"A? space? D? space? away_from B.object to_side/left_of/right_of/foot_of C.object", FromTo},
      {"A.vague? D? space? away_from B.object to_side/left_of/right_of/foot_of C.object", FromTo},
      {"A? space? D? space? away_from B to C.group or C.wall", FromTo},
      {"A? space? D? space? away_from B.side to C.wall", FromTo},
      {"A? space? D? space? away_from B.object edge? to C.wall", FromTo},
      {"A? space? D? space? away_from B.side to C.wall or C.group", FromTo},
      {"A? not B.feature", AwayFrom},
      {"A? not crowd B", AwayFrom},
      {"A.object to B.object ,? D", AwayFrom},
      {"A? D clear_of B.object", AwayFrom},
      {"A? away_from apart", ApartFromEachOther},
      {"A? space? D? space? away_from both_ways", ApartFromEachOther},
      {"space D? next_to/near B.feature", AwayFrom},
      {"space away_from B ,? D", AwayFrom},
  };
}

}  // namespace flair::translator
