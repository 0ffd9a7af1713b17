// SPDX-License-Identifier: GPL-3.0-or-later
// Directions: facing, opposite, in front of, parallel, at a right angle.
#include <algorithm>

#include "translator_worker/grammar/rules/contact.h"
#include "translator_worker/grammar/rules/rule.h"
#include "translator_worker/grammar/rules/space.h"
#include "translator_worker/grammar/sides.h"

namespace flair::translator {
namespace {

Call Two(const char* type, const Placed& mover, const Placed& other, Composer& composer) {
  return Call(type).Text("object", composer.id(mover)).Text("target", composer.id(other));
}

void EmitFacing(const Placed& mover, const Placed& other, bool both, Composer& composer) {
  if (composer.IsCeiling(mover)) {
    // "Above the table, pointing at the screen": where it hangs has been said.
    const auto placed = [](const Call& call) { return call.type == "ceiling_above"; };
    if (std::any_of(composer.calls().begin(), composer.calls().end(), placed)) return;
    composer.EmitFirst({Two("ceiling_above", mover, other, composer)});
  } else if (composer.IsWall(mover)) {
    composer.EmitFirst({Two("on_wall_facing", mover, other, composer)});
  } else if (both) {
    composer.EmitFirst({Two("facing", mover, other, composer).Flag("both", true)});
  } else {
    composer.EmitFirst({Two("facing", mover, other, composer)});
  }
}

void Facing(const Match& match, std::string_view tag, Composer& composer) {
  if (composer.RefuseUnnamed(*match.b)) return;
  const std::vector<Placed> movers = composer.Movers(match.a);
  for (const Target& target : composer.Targets(*match.b, movers, tag != "not")) {
    for (const Placed& mover : movers) {
      const std::string& id = composer.id(mover);
      if (target.kind == RefKind::kFeature) {
        if (mover.side == "back") {
          composer.Refuse("not_expressible", "no call turns a back to a door or window; say what the front faces");
        } else if (tag == "not") {
          composer.EmitFirst({Call("clear_of_feature").Text("object", id).Text("feature", target.name)});
        } else if (target.name == "door") {
          composer.EmitFirst({Call("faces_feature").Text("object", id).Text("feature", target.name)});
        } else {
          composer.EmitFirst({Call("faces_feature").Text("object", id).Text("feature", target.name),
                              Call("close_to_feature").Text("object", id).Text("feature", target.name)});
        }
      } else if (target.kind == RefKind::kRoom) {
        composer.EmitFirst({Call("facing_into_room").Text("object", id)});
      } else if (target.kind == RefKind::kWall && mover.side == "back") {
        composer.EmitFirst({Call("against_wall").Text("object", id).Text("side", "back")});
      } else if (target.objects.empty()) {
        composer.Refuse("unknown_sentence", "it can face an object, a door, a window or the room");
      }
      for (const Placed& other : target.objects) {
        if (mover.side == "back") {
          composer.Refuse("not_expressible", "no call turns a back to an object; say what the front faces");
        } else if (tag == "not") {
          composer.EmitFirst({Two("not_facing", mover, other, composer)});
        } else {
          EmitFacing(mover, other, tag == "both", composer);
        }
      }
    }
    if (!target.objects.empty()) composer.SetPair(movers, target.objects);
  }
}

// "On the other side of the desk from the chair": it faces the chair.
void Across(const Match& match, std::string_view tag, Composer& composer) {
  Facing({match.a, match.c, nullptr, nullptr, match.length}, tag, composer);
}

// "Its back to the shelf", "its front to the shelf".
void SideTo(const Match& match, std::string_view tag, Composer& composer) {
  const std::string& side = match.a->references.front().side;
  if (side == "left" || side == "right" || side == "sides" || side == "side") {
    composer.Refuse("not_expressible", "only where fronts face can be asked for");
    return;
  }
  Facing(match, tag, composer);
}

// "On opposite long sides of the table": at its two sides. "On the opposite side": facing it.
void OnOpposite(const Match& match, std::string_view tag, Composer& composer) {
  const std::string& side = match.b->references.front().side;
  if (side != "sides" && side != "long_both" && side != "short_both") {
    Facing(match, tag, composer);
    return;
  }
  const std::vector<Placed> movers = composer.Movers(match.a);
  Flank(movers, composer.TargetObjects(*match.b, movers), composer);
}

// Two groups of which each member is meant with each of the other: two objects, or "the racks and the desk".
struct TwoGroups {
  std::vector<Placed> first;
  std::vector<Placed> second;
};

// Both empty, with a remark, when it is not two.
TwoGroups GroupsOf(const Match& match, Composer& composer) {
  if (match.a != nullptr && match.a->references.size() == 2) {
    TwoGroups groups;
    for (const size_t i : {0, 1}) {
      Mention one;
      one.references = {match.a->references[i]};
      (i == 0 ? groups.first : groups.second) = composer.Movers(&one);
    }
    if (!groups.first.empty() && !groups.second.empty()) return groups;
  }
  std::vector<Placed> all = composer.Movers(match.a);
  if (all.size() < 2) all = composer.subjects();
  if (all.size() == 2) return {{all[0]}, {all[1]}};
  composer.Refuse("unknown_sentence", "two objects can face each other; name them");
  return {};
}

void EachOther(const Match& match, std::string_view, Composer& composer) {
  const TwoGroups groups = GroupsOf(match, composer);
  for (const Placed& one : groups.first) {
    for (const Placed& other : groups.second) EmitFacing(one, other, true, composer);
  }
  if (!groups.first.empty()) composer.SetPair(groups.first, groups.second);
}

// "on the wall opposite X".
void OnWallOpposite(const Match& match, std::string_view, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  for (const Placed& mover : movers) {
    if (!composer.IsWall(mover)) composer.EmitFirst({Call("against_wall").Text("object", composer.id(mover))});
  }
  for (const Placed& other : composer.TargetObjects(*match.c, movers)) {
    for (const Placed& mover : movers) {
      EmitFacing(mover, other, false, composer);
    }
    composer.SetPair(movers, {other});
  }
}

// "Visible from all sides": nothing stands there.
void SeenFromSides(const Match& match, std::string_view, Composer& composer) {
  std::vector<Placed> sided;
  for (const Placed& placed : composer.Movers(match.a)) {
    sided.push_back({placed.object, match.b != nullptr ? match.b->references.front().side : "all"});
  }
  KeepSpace(std::move(sided), nullptr, composer);
}

// "On the opposite side of the room from the couch": far from it.
void AcrossRoom(const Match& match, std::string_view, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  for (const Placed& mover : movers) {
    for (const Placed& other : composer.TargetObjects(*match.c, movers)) KeepDistance(mover, other, nullptr, composer);
  }
}

// tag is the type.
void Direction(const Match& match, std::string_view tag, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  for (const Target& target : composer.Targets(*match.b, movers)) {
    if (target.kind == RefKind::kWall && tag == "parallel") {
      for (const Placed& mover : movers) composer.EmitFirst({Call("near_wall").Text("object", composer.id(mover))});
    } else if (target.objects.empty()) {
      composer.Refuse("unknown_sentence", "directions are stated between objects");
    }
    for (const Placed& other : target.objects) {
      for (const Placed& mover : movers) composer.EmitFirst({Two(std::string(tag).c_str(), mover, other, composer)});
    }
    if (!target.objects.empty()) composer.SetPair(movers, target.objects);
  }
}

// tag is the type.
void ParallelPairs(const Match& match, std::string_view tag, Composer& composer) {
  std::vector<Placed> movers = composer.Movers(match.a);
  if (movers.size() < 2) movers = composer.subjects();
  for (size_t i = 1; i < movers.size(); ++i) {
    composer.EmitFirst({Two(std::string(tag).c_str(), movers[i], movers[0], composer)});
  }
  if (movers.size() < 2) composer.Refuse("unknown_sentence", "a direction needs two objects; name them");
}

// "Behind the bench and facing the same direction": as the bench, else all of them as one of them.
void SameDirection(const Match& match, std::string_view, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  if (movers.size() != 1 || composer.pair_targets().empty()) {
    ParallelPairs(match, "parallel", composer);
    return;
  }
  for (const Placed& other : composer.pair_targets()) {
    composer.EmitFirst({Two("parallel", movers.front(), other, composer)});
  }
}

void NotFacingPair(const Match& match, std::string_view, Composer& composer) {
  // "The backs of the sofa and the table": no call is about them.
  if (match.a != nullptr && match.a->references.front().side == "back") {
    composer.Refuse("not_expressible", "only where fronts face can be asked for");
    return;
  }
  const TwoGroups groups = GroupsOf(match, composer);
  for (const Placed& one : groups.first) {
    for (const Placed& other : groups.second) {
      composer.EmitFirst({Two("not_facing", one, other, composer)});
      composer.EmitFirst({Two("not_facing", other, one, composer)});
    }
  }
}

void Angle(const Match& match, std::string_view, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  if (match.b != nullptr) composer.SetPair(movers, composer.TargetObjects(*match.b, movers));
  composer.Refuse("not_expressible", "only parallel, facing, right angles and places in front can be asked for");
}

void IntoRoom(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& mover : composer.Movers(match.a)) {
    composer.EmitFirst({Call("facing_into_room").Text("object", composer.id(mover))});
  }
}

}  // namespace

std::vector<Rule> AngleRules() {
  return {
      {"A? visible_from B.side", SeenFromSides},
      {"A? facing/visible_from B", Facing},
      {"A? facing ,? in_front_of B", Facing},
      {"A? facing centered of? B", Facing},
      {"A? opposite centered of? B", Facing},
      {"A? not facing/opposite B", Facing, "not"},
      {"A? facing_away B", Facing, "not"},
      {"A? opposite B", Facing},
      {"A? on opposite B.side", OnOpposite},
      {"A? opposite/across B.object away_from C.object", Across},
      {"A? centered_to B", Angle},
      {"A? centered_to both_ways", Angle},
      {"A.side to B.object", SideTo},
      {"A.side not to B.object", SideTo, "not"},
      {"A? facing_each_other", EachOther},
      {"A? facing both_ways", EachOther},
      {"A? opposite both_ways", EachOther},
      {"A? on/against/along B.wall opposite/facing C", OnWallOpposite},
      {"A? on? opposite B.wall away_from/of/opposite C", OnWallOpposite},
      {"A? not facing_each_other", NotFacingPair},
      {"A? not facing/opposite both_ways", NotFacingPair},
      {"A? perpendicular both_ways?", ParallelPairs, "perpendicular"},
      {"A? same_direction B", Direction, "parallel"},
      {"A? parallel B", Direction, "parallel"},
      {"A? parallel both_ways?", ParallelPairs, "parallel"},
      {"A? perpendicular B", Direction, "perpendicular"},
      {"A? not_angle B", Angle},
      {"A? into_room", IntoRoom},
      {"A? into_room B.object", Facing},
      {"away_from A.object ,? facing B.thing", Facing},
      {"away_from A.object ,? B.object seen", Facing},
      {"facing B.thing away_from A.object", Facing},
      {"A? same_direction both_ways?", SameDirection},
      {"C.vague? away_from A.object into_room", IntoRoom},
      {"A? on? opposite B.room away_from C.object", AcrossRoom},
      {"away_from A.object ,? not facing B.thing", Facing, "not"},
      {"A? seen all_sides", SeenFromSides},
  };
}

}  // namespace flair::translator
