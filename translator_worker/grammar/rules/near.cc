// SPDX-License-Identifier: GPL-3.0-or-later
// Nearness and contact by position: near, next to, left of, behind, in front of, on each side of.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "translator_worker/grammar/frames.h"
#include "translator_worker/grammar/rules/shared.h"

namespace flair::translator {

void NearOne(const Placed& mover, const Target& target, const Distance* distance, Composer& composer) {
  std::optional<double> most;
  if (distance != nullptr) most = distance->max_m;
  const std::string& id = composer.id(mover);
  if (target.kind == RefKind::kFeature) {
    composer.EmitFirst({Call("close_to_feature")
                            .Text("object", id)
                            .Text("feature", target.name)
                            .MaybeText("side", OneSide(composer, mover))
                            .MaybeNumber("max_distance_m", most)});
  } else if (target.kind == RefKind::kWall) {
    composer.EmitFirst({Call("near_wall")
                            .Text("object", id)
                            .MaybeText("side", OneSide(composer, mover))
                            .MaybeNumber("max_distance_m", most)});
  }
  for (const Placed& other : target.objects) {
    if (composer.IsWall(mover)) {
      composer.Relate("on_wall_near", mover, other);
    } else if (composer.IsCeiling(mover)) {
      composer.Relate("ceiling_above", mover, other);
    } else {
      composer.EmitFirst(
          {Call("near").Text("object", id).Text("target", composer.id(other)).MaybeNumber("max_distance_m", most)});
      if (distance != nullptr && distance->min_m) {
        composer.EmitFirst({Call("away_from")
                                .Text("object", id)
                                .Text("target", composer.id(other))
                                .Number("min_distance_m", *distance->min_m)});
      }
    }
  }
  if (!target.objects.empty()) composer.SetPair({mover}, target.objects);
}

bool IsOwnPart(const Mention& mention, const Composer& composer) {
  if (composer.topic().size() != 1 || mention.references.size() != 1) return false;
  const Reference& reference = mention.references.front();
  const int topic = composer.topic().front().object;
  const auto has = [&](const std::vector<int>& list) {
    return std::find(list.begin(), list.end(), topic) != list.end();
  };
  return reference.kind == RefKind::kObjects && (has(reference.candidates) || has(reference.weak_candidates));
}

void Near(const Match& match, std::string_view detail, Composer& composer) {
  // "Maintain clear access to the table", when nobody else is spoken of.
  if (detail == "access" && match.a == nullptr && composer.topic().empty()) {
    for (const Placed& other : composer.TargetObjects(*match.b, {})) {
      KeepFront(other, composer);
    }
    return;
  }
  // Access to an area is a matter of ways, not of nearness.
  if (detail == "access" && match.b->references.front().kind == RefKind::kZone) {
    composer.Refuse("not_about_layout",
                    "access to an area cannot be asked for; name the objects and sides that serve it");
    return;
  }
  const std::vector<Placed> movers = composer.Movers(match.a);
  for (const Target& target : composer.Targets(*match.b, movers)) {
    if (target.name == "all" || target.name == "others") {
      composer.Refuse("not_about_layout", "say which objects it is near");
      continue;
    }
    for (const Placed& mover : movers) NearOne(mover, target, match.distance, composer);
  }
}

namespace {

// "No further from the stove than 1.5 m".
void NotFurther(const Match& match, std::string_view detail, Composer& composer) {
  const Distance most{std::nullopt, match.distance->Nominal(), false};
  Match near = match;
  near.distance = &most;
  Near(near, detail, composer);
}

// "Next to the cabinet on the left": at that side of the cabinet.
void NextToAtSide(const Match& match, std::string_view, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  std::vector<Placed> targets = composer.TargetObjects(*match.b, movers);
  const std::string& side = match.c->references.front().side;
  for (Placed& target : targets) target.side = side;
  for (const Placed& mover : movers) {
    if (composer.IsFloor(mover)) {
      Contact(mover, {RefKind::kObjects, targets, ""}, composer);
    } else {
      for (const Placed& target : targets) NearOne(mover, {RefKind::kObjects, {target}, ""}, nullptr, composer);
    }
  }
}

// "Two chairs at each table": the first two at the first.
void ShareOut(const std::vector<Placed>& movers, const std::vector<Placed>& targets, Composer& composer) {
  const size_t each = movers.size() / targets.size();
  for (size_t i = 0; i < movers.size(); ++i) {
    Contact(movers[i], {RefKind::kObjects, {targets[i / each]}, ""}, composer);
  }
}

void NextTo(const Match& match, std::string_view, Composer& composer) {
  if (composer.RefuseUnnamed(*match.b) || KeepsOwnSides(match.a, *match.b, composer)) return;
  const std::string& side = match.b->references.front().side;
  // "People stand at three sides of the bench" that is spoken of.
  if (match.a == nullptr && !side.empty() && composer.scope() == v1::SENTENCE_SCOPE_INTRA &&
      IsOwnPart(*match.b, composer)) {
    KeepSpace({{composer.topic().front().object, side}}, match.distance, composer);
    return;
  }
  std::vector<Placed> movers = composer.Movers(match.a);
  const bool several_sides = side == "sides" || side == "long_both" || side == "short_both" || side == "all";
  if (several_sides) movers = OneAtEach(match.a, composer);
  // "Three chairs along each long side of the table".
  if (several_sides && movers.size() > 1 && composer.IsFloor(movers.front())) {
    Flank(movers, composer.TargetObjects(*match.b, movers), composer);
    return;
  }
  for (const Target& target : composer.Targets(*match.b, movers)) {
    const size_t targets = target.objects.size();
    if (match.b->references.front().each && targets > 1 && movers.size() > targets && movers.size() % targets == 0) {
      ShareOut(movers, target.objects, composer);
      continue;
    }
    for (const Placed& mover : movers) {
      if (composer.IsWall(mover) || target.kind == RefKind::kWall) {
        NearOne(mover, target, match.distance, composer);
      } else {
        Contact(mover, target, composer);
      }
    }
  }
}

// Stands at a named side of the target; detail is that side.
void AtSide(const Match& match, std::string_view detail, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  const std::vector<Placed> targets = composer.TargetObjects(
      *match.b, match.a == nullptr && match.distance != nullptr ? std::vector<Placed>{} : movers);
  // "The chairs have 0.6 m behind them".
  const bool own = match.distance != nullptr && !movers.empty() && !targets.empty() &&
                   movers.front().object == targets.front().object;
  // "At least 0.6 m behind each chair": free space, when nobody else is spoken of.
  if (own || (match.a == nullptr && match.distance != nullptr && !match.distance->max_m)) {
    for (const Placed& other : targets) {
      // "Behind the chair" of a desk is in front of the desk.
      const bool at_subject = detail == "back" && composer.StandsAtSubject(other);
      const Placed& owner = at_subject ? composer.subjects().front() : other;
      KeepSpaceAt(owner,
                  {at_subject         ? "front"
                   : detail == "side" ? "left"
                                      : std::string(detail)},
                  match.distance, composer);
    }
    return;
  }
  for (const Placed& mover : movers) {
    if (composer.IsTertiaryRug(mover) && detail == "front" && !targets.empty()) {
      LayRug("rug_under_forward", mover, targets.front(), composer);
    } else if (composer.IsSurface(mover)) {
      // "On the nightstand to the left of the bed": which nightstand.
      if (composer.IsOnTop(mover)) continue;
      // "On the right side of the desk": near that edge of its top.
      for (const Placed& other : targets) {
        Call call = Call("on_top_corner").Text("object", composer.id(mover)).Text("host", composer.id(other));
        if (detail == "back") call.Text("corner", "back_left");
        composer.EmitFirst({std::move(call)});
      }
    } else if (composer.IsWall(mover)) {
      for (const Placed& other : targets) {
        composer.EmitFirst({Call(detail == "back" ? "on_wall_above" : "on_wall_near")
                                .Text("object", composer.id(mover))
                                .Text("target", composer.id(other))});
      }
    } else {
      Beside(mover, targets, detail == "side" ? "left" : std::string(detail), composer);
      for (const Placed& other : targets) {
        if (match.distance != nullptr && match.distance->Nominal() > 0) {
          KeepDistance(mover, other, match.distance, composer);
        }
      }
    }
  }
}

void OnEachSide(const Match& match, std::string_view, Composer& composer) {
  const std::vector<Placed> movers = OneAtEach(match.a, composer);
  Flank(movers, composer.TargetObjects(*match.b, movers), composer);
}

// detail "after": the figure stands after the place, so it is how far away the mover stands.
void InFrontOf(const Match& match, std::string_view detail, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
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
    for (const Placed& other : target.objects) {
      // "1 m in front of every rack", of the racks that are spoken of.
      const bool several_own =
          match.a == nullptr && composer.scope() == v1::SENTENCE_SCOPE_INTRA &&
          std::any_of(movers.begin(), movers.end(), [&](const Placed& mover) { return mover.object == other.object; });
      const bool own = movers.empty() || several_own || (movers.size() == 1 && movers.front().object == other.object);
      const bool at_least = match.distance != nullptr && !match.distance->max_m;
      if ((own && match.distance != nullptr) || (match.a == nullptr && (own || (at_least && detail != "after")))) {
        KeepSpaceAt(other, {"front"}, match.distance, composer);
        continue;
      }
      for (const Placed& mover : movers) {
        if (composer.IsTertiaryRug(mover)) {
          LayRug("rug_under_forward", mover, other, composer);
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

std::vector<Meaning> NearMeanings() {
  return {{"near", Near},      {"not_further", NotFurther},  {"next_to_at_side", NextToAtSide}, {"next_to", NextTo},
          {"at_side", AtSide}, {"on_each_side", OnEachSide}, {"in_front_of", InFrontOf}};
}

}  // namespace flair::translator
