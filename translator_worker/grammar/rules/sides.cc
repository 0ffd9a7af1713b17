// SPDX-License-Identifier: GPL-3.0-or-later
// Which sides of an object words mean.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "fmt/format.h"
#include "translator_worker/grammar/meanings.h"
#include "translator_worker/grammar/rules/shared.h"

namespace flair::translator {
namespace {

using Sides = std::vector<std::string>;

// The one side that the last call about the object names; empty when there is none.
std::string SideSpokenOf(const Composer& composer, const std::string& id) {
  for (size_t i = composer.calls().size(); i > 0; --i) {
    const Call& call = composer.calls()[i - 1];
    if (call.arguments.size() < 2 || call.arguments[0].value().text() != id) continue;
    const v1::Argument& second = call.arguments[1];
    if (second.name() == "side") return second.value().text();
  }
  return "";
}

// People get at what is longer than wide from a long side, at everything else from the front.
std::string UsualSide(const Placed& placed, const Composer& composer) {
  constexpr double kMuchLonger = 1.25;
  const v1::Object& object = composer.object(placed.object);
  return composer.PlacedIs("beds", placed) || object.depth_m() > kMuchLonger * object.width_m() ? "side" : "front";
}

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

std::vector<std::string> SidesOf(Composer& composer, const Placed& placed) {
  const std::string& word = placed.side;
  if (word.empty() || word == "front" || word == "back" || word == "left" || word == "right")
    return word.empty() ? Sides{} : Sides{word};
  const v1::Object& object = composer.object(placed.object);
  const Sides lateral = {"left", "right"};
  const Sides axial = {"front", "back"};
  const auto open = [&](Sides taken) {
    composer.Note("side_left_open",
                  fmt::format("{} of several sides of {} {} meant; {} taken", taken.size() == 1 ? "one" : "two",
                              object.name(), taken.size() == 1 ? "is" : "are", fmt::join(taken, " and ")));
    return taken;
  };
  if (word == "sides") return lateral;
  if (word == "axial") return axial;
  if (word == "all") return {"front", "back", "left", "right"};
  if (word == "three") return {"front", "left", "right"};
  if (word == "two_any") return open({"front", "left"});
  if (word == "opposite_two") return open(lateral);
  if (word == "side" || word == "lateral_one") return open({"left"});
  if (word == "other") {
    const std::string other = OppositeSide(SideSpokenOf(composer, object.id()));
    return other.empty() ? open({"left"}) : Sides{other};
  }
  // Sides of a length: "lengths:1.800" are both of them.
  bool wide = object.width_m() > object.depth_m();
  if (word.starts_with("length")) {
    const double length = std::atof(word.c_str() + word.find(':') + 1);
    wide = std::abs(length - object.width_m()) <= std::abs(length - object.depth_m());
  }
  const Sides& pair = wide != word.starts_with("short") ? axial : lateral;
  return word.ends_with("both") || word.starts_with("lengths") ? pair : open({pair.front()});
}

std::vector<std::string> OpenSidesOf(Composer& composer, const Placed& placed, const std::vector<Placed>& all) {
  const bool alone = std::ranges::none_of(all, [&](const Placed& other) {
    return other.object == placed.object && !other.side.empty() && other.side != placed.side;
  });
  if (placed.side == "side" && alone) return SidesOf(composer, {placed.object, UsualSide(placed, composer)});
  return SidesOf(composer, placed);
}

std::string OneSide(Composer& composer, const Placed& placed) {
  const std::string& word = placed.side;
  if (word == "sides" || word == "all" || word == "side" || word == "axial" || word.ends_with("both")) return "";
  const Sides sides = SidesOf(composer, placed);
  // "A long side against a wall": of front and back the back.
  const bool either = word == "long_one" || word == "short_one";
  if (either && sides.front() == "front") return "back";
  return sides.size() == 1 ? sides.front() : "";
}

std::string OppositeSide(const std::string& side) {
  if (side == "left") return "right";
  if (side == "right") return "left";
  if (side == "front") return "back";
  return side == "back" ? "front" : "";
}

bool AreOwnSides(const Mention& place, const Composer& composer) {
  const Reference& reference = place.references.front();
  const std::string& side = reference.side;
  const bool own = reference.kind == RefKind::kPronoun && reference.name.empty();
  if (!own || composer.scope() != v1::SENTENCE_SCOPE_INTRA) return false;
  // "5 cm on each side and at the back": as much there.
  const bool more =
      composer.topic().size() == 1 && !composer.calls().empty() && composer.calls().back().type == "accessible";
  return more || side == "sides" || side == "all" || side == "opposite_two" || side.ends_with("both");
}

std::vector<Procedure> SpaceProcedures() {
  return {{"space_at", SpaceAt},
          {"more_space", MoreSpace},
          {"own_sides", OwnSides},
          {"bare_distance", BareDistance},
          {"not_away_from", NotAwayFrom}};
}

}  // namespace flair::translator
