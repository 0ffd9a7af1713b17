// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/rules/near.h"

#include <algorithm>
#include <optional>
#include <string>

#include "translator_worker/grammar/rules/contact.h"
#include "translator_worker/grammar/sides.h"

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
  } else if (target.objects.empty()) {
    composer.Refuse("unknown_sentence", "it can be near objects, walls, doors, windows or sockets");
  }
  for (const Placed& other : target.objects) {
    if (LaidBeside(mover, other, composer)) {
      continue;
    } else if (composer.IsWall(mover)) {
      composer.EmitFirst({Call("on_wall_near").Text("object", id).Text("target", composer.id(other))});
    } else if (composer.IsCeiling(mover)) {
      composer.EmitFirst({Call("ceiling_above").Text("object", id).Text("target", composer.id(other))});
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

void Near(const Match& match, std::string_view tag, Composer& composer) {
  if (tag == "access" && match.a == nullptr && IsOwnPart(*match.b, composer)) {
    composer.EmitFirst(
        {Call("accessible").Text("object", composer.id(composer.topic().front())).Texts("sides", {"front"})});
    return;
  }
  // "Maintain clear access to the table", when nobody else is spoken of.
  if (tag == "access" && match.a == nullptr && composer.topic().empty()) {
    for (const Placed& other : composer.TargetObjects(*match.b, {})) {
      std::vector<std::string> sides = SidesOf(composer, other);
      if (sides.empty()) sides = {"front"};
      composer.EmitFirst({Call("accessible").Text("object", composer.id(other)).Texts("sides", sides)});
    }
    return;
  }
  // Access to an area is a matter of ways, not of nearness.
  if (tag == "access" && match.b->references.front().kind == RefKind::kZone) {
    composer.Refuse("not_about_layout",
                    "access to an area cannot be asked for; name the objects and sides that serve it");
    return;
  }
  if (match.a != nullptr && match.a->references.front().kind == RefKind::kGroup &&
      match.a->references.front().name != "seating") {
    composer.Refuse("not_about_layout", "say which object is near it");
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
  if (movers.size() == 2 && match.b->references.front().kind == RefKind::kPronoun) {
    NearOne(movers[0], {RefKind::kObjects, {movers[1]}, ""}, match.distance, composer);
  }
}

}  // namespace flair::translator
