// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/rules/gaps.h"

#include <algorithm>

#include "fmt/format.h"
#include "translator_worker/grammar/rules/contact.h"
#include "translator_worker/grammar/rules/space.h"
#include "translator_worker/grammar/sides.h"

namespace flair::translator {
namespace {

bool Names(const Reference& reference, int object) {
  const auto has = [&](const std::vector<int>& list) {
    return std::find(list.begin(), list.end(), object) != list.end();
  };
  return has(reference.candidates) || has(reference.weak_candidates);
}

bool IsPlainSide(const std::string& side) {
  return side == "front" || side == "back" || side == "left" || side == "right";
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
  std::vector<std::string> sides = SidesOf(composer, placed);
  if (sides.empty()) sides = {"front", "left", "right"};
  Call call = Call("accessible").Text("object", composer.id(placed)).Texts("sides", sides);
  if (distance != nullptr) call.Number("min_clearance_m", distance->Nominal());
  composer.EmitFirst({std::move(call)});
}

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
  } else if (last.kind == RefKind::kWall && mention.references.size() == 2 && IsPlainSide(side)) {
    // "Between the wardrobe's front and the opposite wall": free space there.
    BetweenOrAnything(match, tag, composer);
    return;
  } else if (last.kind == RefKind::kWall || last.kind == RefKind::kFeature) {
    if (last.kind == RefKind::kFeature && !composer.HasFeature(last.name)) {
      composer.Refuse("names_absent_feature", fmt::format("the room has no {}", last.name));
      return;
    }
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
  // "Between each nightstand and its bed": the first with the first, the second with the second.
  if (mention.references.size() == 2 && last.own && all.size() % 2 == 0) {
    for (size_t i = 0; i < all.size() / 2; ++i) KeepDistance(all[i], all[i + all.size() / 2], distance, composer);
    return;
  }
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
  for (const Placed& placed : composer.Movers(&owner)) KeepFreeBeside(placed, match.distance, composer);
}

// "between the lamp and the walls".
void BetweenAndWall(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& mover : composer.Movers(match.b)) {
    if (IsPlainSide(mover.side) && match.distance != nullptr && match.distance->min_m) {
      KeepFreeBeside(mover, match.distance, composer);
      continue;
    }
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

// "Nothing between the sofa and the TV stand".
void NothingBetween(const Match&, std::string_view, Composer& composer) {
  composer.Refuse("not_expressible", "no call keeps the space between two objects empty; name a side or a distance");
}

}  // namespace flair::translator
