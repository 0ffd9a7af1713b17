// SPDX-License-Identifier: GPL-3.0-or-later
// Meanings about free space and bare figures that no table tells.
#include <string>
#include <vector>

#include "translator_worker/grammar/meanings.h"
#include "translator_worker/grammar/rules/shared.h"

namespace flair::translator {
namespace {

// Space at a place relative to B, or to the topic: detail is a side word, "around" or "named".
void SpaceAt(const Match& match, std::string_view detail, Composer& composer) {
  const Mention* const of = match.b != nullptr ? match.b : match.a;
  if (of != nullptr && of->references.front().kind == RefKind::kGroup && of->references.front().name != "seating") {
    composer.Refuse("not_about_layout", "space around pieces that are not named cannot be asked for; name them");
    return;
  }
  // "No more than 0.3 m behind the chair": there it stands.
  if (detail == "back" && match.a != nullptr && match.b != nullptr && match.distance != nullptr &&
      !match.distance->min_m) {
    MakeCalls("at_side", match, detail, composer);
    return;
  }
  std::vector<Placed> placed = match.b != nullptr ? composer.TargetObjects(*match.b, {}) : composer.Movers(match.a);
  const bool several = placed.size() > 1;
  for (Placed& owner : placed) {
    if (detail == "back" && composer.PlacedIs("own-chair", owner)) {
      // "Behind the chair" of a desk is in front of the desk, behind the chairs of a table all round it.
      owner = {composer.subjects().front().object, several ? "all" : "front"};
    } else if (detail == "around") {
      // Most pieces have their back at a wall; chairs are got at from there.
      if (owner.side.empty()) owner.side = composer.IsChair(owner) ? "all" : "three";
    } else if (detail != "named") {
      owner.side = std::string(detail);
    }
  }
  MakeCallsOf("of_movers", placed, {}, match.distance, composer);
}

// "0.1 m on each side and behind": as much as at the sides.
void MoreSpace(const Match&, std::string_view, Composer& composer) { composer.AddSides({"left", "right"}); }

void OwnSides(const Match& match, std::string_view detail, Composer& composer) {
  const std::string& side = match.b->references.front().side;
  const bool one = composer.topic().size() == 1;
  if (one && composer.AddSides(SidesOf(composer, {composer.topic().front().object, side}))) return;
  MakeCalls("side_of_topic", match, detail, composer);
}

// A bare distance belongs to the fact before it.
void BareDistance(const Match& match, std::string_view detail, Composer& composer) {
  if (!composer.CompleteClearance(match.distance->Nominal())) MakeCalls("distance_alone", match, detail, composer);
}

// "Not within 0.5 m of" is at least so far away.
void NotAwayFrom(const Match& match, std::string_view detail, Composer& composer) {
  Match turned = match;
  Length distance;
  if (match.distance != nullptr && match.distance->max_m) {
    distance.min_m = match.distance->max_m;
    turned.distance = &distance;
  }
  MakeCalls("away_from", turned, detail, composer);
}

}  // namespace

std::vector<Procedure> SpaceProcedures() {
  return {{"space_at", SpaceAt},
          {"more_space", MoreSpace},
          {"own_sides", OwnSides},
          {"bare_distance", BareDistance},
          {"not_away_from", NotAwayFrom}};
}

}  // namespace flair::translator
