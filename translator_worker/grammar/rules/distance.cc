// SPDX-License-Identifier: GPL-3.0-or-later
// Distances: away from, at least so far, gaps between, bare distances after another fact.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "fmt/format.h"
#include "translator_worker/grammar/frames.h"
#include "translator_worker/grammar/rules/shared.h"

namespace flair::translator {

void BetweenOrAnything(const Match& match, std::string_view detail, Composer& composer);
namespace {

bool Names(const Reference& reference, int object) {
  const auto has = [&](const std::vector<int>& list) {
    return std::find(list.begin(), list.end(), object) != list.end();
  };
  return has(reference.candidates) || has(reference.weak_candidates);
}

}  // namespace

void KeepAway(const Placed& mover, const Target& target, const Distance* distance, Composer& composer) {
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

void KeepFreeBeside(const Placed& placed, const Distance* distance, Composer& composer) {
  const std::vector<std::string> sides = SidesOf(composer, placed);
  KeepSpaceAt(placed, !sides.empty() ? sides : std::vector<std::string>{"front", "left", "right"}, distance, composer);
}

// Every pair of the list; "them" is the last pair spoken of, or the objects that the sentence is about.
void Between(const Match& match, std::string_view detail, Composer& composer) {
  static const Distance kTouching{0, 0, true};
  const Distance* distance = detail == "touching" ? &kTouching : match.distance;
  const Mention& mention = *match.b;
  const Reference& last = mention.references.back();
  const std::string& side = mention.references.front().side;
  if (last.kind == RefKind::kGroup && mention.references.size() > 1 && !side.empty() && side != "side") {
    BetweenOrAnything(match, detail, composer);
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
  } else if (last.kind == RefKind::kWall || last.kind == RefKind::kFeature) {
    for (size_t i = 0; i + 1 < mention.references.size(); ++i) {
      Mention one;
      one.references = {mention.references[i]};
      for (const Placed& mover : composer.Movers(&one)) {
        KeepAway(mover, {last.kind, {}, last.name}, distance, composer);
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
void BetweenOrAnything(const Match& match, std::string_view detail, Composer& composer) {
  const Reference& first = match.b->references.front();
  Mention owner;
  owner.references = {first};
  for (const Placed& placed : composer.Movers(&owner)) KeepFreeBeside(placed, match.distance, composer);
}

// "between the lamp and the walls".
void BetweenAndWall(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& mover : composer.Movers(match.b)) {
    KeepAway(mover, {RefKind::kWall, {}, match.c->references.front().name}, match.distance, composer);
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
  if (all.size() == 2) composer.SetPair({all[0]}, {all[1]});
}

// A bare distance belongs to the fact before it: to its pair, else it is free space in front.
void BareDistance(const Match& match, std::string_view, Composer& composer) {
  if (composer.CompleteClearance(match.distance->Nominal())) return;
  if (!composer.pair_targets().empty()) {
    for (const Placed& mover : composer.pair_movers()) {
      for (const Placed& other : composer.pair_targets()) KeepDistance(mover, other, match.distance, composer);
    }
    return;
  }
  if (match.distance->min_m && !match.distance->exact && !composer.topic().empty() && !composer.calls().empty()) {
    for (const Placed& mover : composer.topic()) KeepSpaceAt(mover, {"front"}, match.distance, composer);
    return;
  }
  composer.Refuse("unknown_sentence", "a distance needs two objects that it is kept between");
}

// "Nothing between the sofa and the TV stand".
void NothingBetween(const Match&, std::string_view, Composer& composer) {
  composer.Refuse("not_expressible", "no call keeps the space between two objects empty; name a side or a distance");
}

namespace {

void AwayFrom(const Match& match, std::string_view detail, Composer& composer) {
  // "Not within 0.5 m of" is at least so far away.
  Distance turned;
  const Distance* distance = match.distance;
  if (!detail.empty() && distance != nullptr && distance->max_m) {
    turned.min_m = distance->max_m;
    distance = &turned;
  }
  const std::vector<Placed> movers = composer.Movers(match.a);
  // "Close to a window, but not directly in front of it".
  const Reference& what = match.b->references.front();
  if (distance == nullptr && what.kind == RefKind::kPronoun && what.side.empty() && !composer.last_feature.empty()) {
    for (const Placed& mover : movers) {
      composer.RelateToFeature("clear_of_feature", mover, composer.last_feature);
    }
    return;
  }
  // "The front has 0.6 m of clearance from any other object": free space there.
  if (match.b->references.front().kind == RefKind::kGroup && !movers.empty() && !movers.front().side.empty()) {
    for (const Placed& mover : movers) KeepFreeBeside(mover, match.distance, composer);
    return;
  }
  const bool own_side = what.kind == RefKind::kPronoun && what.name.empty() && !what.side.empty();
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

// "0.5 m from the wall on its left": free space at that side.
void FromWallAtSide(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& mover : composer.Movers(match.a)) {
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

// "To the right of the desk, no gap": what stands beside it touches it.
void NoGap(const Match&, std::string_view, Composer&) {}

// "Across from the sofa, at least 1.5 m away": from what was related to last.
void AwayFromPartner(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& mover : composer.pair_movers()) {
    for (const Placed& other : composer.pair_targets()) KeepDistance(mover, other, match.distance, composer);
  }
}

// "Not between the sofa and the bookshelf" is away from both; doors and windows would say something else.
void NotBetween(const Match& match, std::string_view detail, Composer& composer) {
  const bool features = std::any_of(match.b->references.begin(), match.b->references.end(),
                                    [](const Reference& one) { return one.kind == RefKind::kFeature; });
  features ? NothingBetween(match, detail, composer) : AwayFrom(match, detail, composer);
}

// "A clear walkway between the sofa and the table" keeps them apart; between pieces that are not named it is a path.
void DistanceOrPathBetween(const Match& match, std::string_view detail, Composer& composer) {
  const Reference& first = match.b->references.front();
  const bool several = first.kind == RefKind::kObjects && (first.plural || first.each) && first.candidates.size() > 1;
  const bool named = several || (match.b->references.size() > 1 && first.kind != RefKind::kGroup);
  if (named && match.c->references.front().name == "paths") {
    Between(match, detail, composer);
  } else {
    composer.Refuse("not_about_layout", "paths cannot be asked for; name two objects and the distance between them");
  }
}

// "Walkways of at least 0.6 m": how wide ways are, wherever they lead. Of other vague things the figure is a space's.
void Ways(const Match& match, std::string_view detail, Composer& composer) {
  // "Opposite each other with an aisle of 1.2 m": between the two.
  const bool between =
      composer.scope() == v1::SENTENCE_SCOPE_INTER && !composer.calls().empty() && !composer.pair_targets().empty();
  if (match.c->references.front().name == "paths" && !between) {
    composer.Refuse("not_about_layout", "paths cannot be asked for; name two objects and the distance between them");
  } else {
    BareDistance(match, detail, composer);
  }
}

}  // namespace

std::vector<Meaning> DistanceMeanings() {
  return {
      {"between", Between},
      {"between_and_wall", BetweenAndWall},
      {"apart_from_each_other", ApartFromEachOther},
      {"bare_distance", BareDistance},
      {"nothing_between", NothingBetween},
      {"away_from", AwayFrom},
      {"from_wall_at_side", FromWallAtSide},
      {"from_to", FromTo},
      {"no_gap", NoGap},
      {"away_from_partner", AwayFromPartner},
      {"not_between", NotBetween},
      {"distance_or_path_between", DistanceOrPathBetween},
      {"ways", Ways},
  };
}

}  // namespace flair::translator
