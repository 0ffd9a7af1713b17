// SPDX-License-Identifier: GPL-3.0-or-later
// In front of a piece: where something stands, or how much is kept free there.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "fmt/format.h"
#include "translator_worker/grammar/frames.h"
#include "translator_worker/grammar/rules/shared.h"

namespace flair::translator {
namespace {

// detail "after": the figure stands after the place, so it is how far away the mover stands.
void InFrontOf(const Match& match, std::string_view detail, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  // "In front of the desk, 1 to 2 m from it".
  const bool of_same = match.c != nullptr && match.c->references.front().kind == RefKind::kPronoun &&
                       match.c->references.front().side.empty();
  if (of_same && match.distance != nullptr) {
    InFrontOf({match.a, match.b, nullptr, match.distance, match.length}, "after", composer);
    return;
  }
  // "In front of the desk, at least 1 m from the bed": the figure is for the bed.
  if (match.c != nullptr && match.distance != nullptr) {
    Match place = match;
    place.c = nullptr;
    place.distance = nullptr;
    const std::vector<Placed> others = composer.TargetObjects(*match.c, movers);
    const std::vector<Placed> fronts = composer.TargetObjects(*match.b, movers);
    const bool same = !others.empty() && !fronts.empty() && others.front().object == fronts.front().object;
    if (same && match.distance->exact) place.distance = match.distance;
    InFrontOf(place, "", composer);
    for (const Placed& mover : movers) {
      for (const Placed& other : others) {
        if (place.distance == nullptr) KeepDistance(mover, other, match.distance, composer);
      }
    }
    return;
  }
  // "The desk and the shelf have 0.5 m in front of them": free space of their own.
  if (match.a != nullptr && match.distance != nullptr && match.b->references.front().name == "them") {
    for (const Placed& mover : composer.Movers(match.a)) {
      composer.EmitFirst({Call("accessible")
                              .Text("object", composer.id(mover))
                              .Texts("sides", {"front"})
                              .Number("min_clearance_m", match.distance->Nominal())});
    }
    return;
  }
  // "Keep 0.6 m in front of the wardrobe": free space, when nobody else is spoken of. "Parallel to the oven and 1.5 m
  // in front of it": of the oven.
  const bool of_partner = match.distance != nullptr && match.distance->exact &&
                          composer.scope() == v1::SENTENCE_SCOPE_INTER && !composer.pair_targets().empty() &&
                          !composer.calls().empty() && match.b->references.front().name == "it";
  // "One can stand in front of the wardrobe" that is spoken of.
  const bool of_topic =
      match.a == nullptr && composer.scope() == v1::SENTENCE_SCOPE_INTRA && IsOwnPart(*match.b, composer);
  const bool may_be_own = of_topic || (match.a == nullptr && match.distance != nullptr && !of_partner);
  for (const Target& target : composer.Targets(*match.b, may_be_own ? std::vector<Placed>{} : movers)) {
    if (target.kind == RefKind::kFeature) {
      for (const Placed& mover : movers) {
        composer.RelateToFeature("close_to_feature", mover, target.name);
      }
      continue;
    }
    if (target.objects.empty()) {
      composer.Refuse("unknown_sentence", "it can stand in front of an object, a door or a window");
      continue;
    }
    for (const Placed& other : target.objects) {
      // "1 m in front of every rack", of the racks that are spoken of.
      const bool several_own =
          match.a == nullptr && composer.scope() == v1::SENTENCE_SCOPE_INTRA &&
          std::any_of(movers.begin(), movers.end(), [&](const Placed& mover) { return mover.object == other.object; });
      const bool own = movers.empty() || several_own || (movers.size() == 1 && movers.front().object == other.object);
      const bool at_least = match.distance != nullptr && !match.distance->max_m;
      if ((own && match.distance != nullptr) || (match.a == nullptr && (own || (at_least && detail != "after")))) {
        Call call = Call("accessible").Text("object", composer.id(other)).Texts("sides", {"front"});
        if (match.distance != nullptr) call.Number("min_clearance_m", match.distance->Nominal());
        composer.EmitFirst({std::move(call)});
        continue;
      }
      for (const Placed& mover : movers) {
        if (composer.IsTertiaryRug(mover)) {
          composer.EmitFirst(
              {Call("rug_under_forward").Text("rug", composer.id(mover)).Text("object", composer.id(other))});
          composer.rug_placed = true;
          continue;
        }
        if (composer.IsWall(mover)) {
          composer.Relate("on_wall_near", mover, other);
          continue;
        }
        Call call = Call("in_front_of").Text("object", composer.id(mover)).Text("target", composer.id(other));
        const bool exact = match.distance != nullptr && match.distance->exact;
        if (exact) call.Number("distance_m", match.distance->Nominal());
        composer.EmitFirst({std::move(call)});
        if (match.distance != nullptr && !exact) KeepDistance(mover, other, match.distance, composer);
      }
    }
    composer.SetPair(movers, target.objects);
  }
}

}  // namespace

std::vector<Meaning> InFrontMeanings() {
  return {
      {"in_front_of", InFrontOf},
  };
}

}  // namespace flair::translator
