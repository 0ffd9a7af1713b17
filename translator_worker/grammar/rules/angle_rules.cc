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
        if (tag == "not" || mover.side == "back") {
          composer.EmitFirst({Two("not_facing", mover, other, composer)});
        } else {
          EmitFacing(mover, other, tag == "both", composer);
        }
      }
    }
    if (!target.objects.empty()) composer.SetPair(movers, target.objects);
  }
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

// "Within reach of the table but not in front": of the table.
void NotInFront(const Match&, std::string_view, Composer& composer) {
  if (composer.pair_targets().empty()) composer.Refuse("unknown_sentence", "say in front of what");
  for (const Placed& mover : composer.pair_movers()) {
    for (const Placed& other : composer.pair_targets()) KeepDistance(mover, other, nullptr, composer);
  }
}

// "On the opposite side of the room from the couch": far from it.
void AcrossRoom(const Match& match, std::string_view, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  for (const Placed& mover : movers) {
    for (const Placed& other : composer.TargetObjects(*match.c, movers)) KeepDistance(mover, other, nullptr, composer);
  }
}

// tag "after": the figure stands after the place, so it is how far away the mover stands.
void InFrontOf(const Match& match, std::string_view tag, Composer& composer) {
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
  const bool may_be_own = match.a == nullptr && match.distance != nullptr && !of_partner;
  for (const Target& target : composer.Targets(*match.b, may_be_own ? std::vector<Placed>{} : movers)) {
    if (target.kind == RefKind::kFeature) {
      for (const Placed& mover : movers) {
        composer.EmitFirst({Call("close_to_feature").Text("object", composer.id(mover)).Text("feature", target.name)});
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
      if ((own && match.distance != nullptr) || (match.a == nullptr && (own || (at_least && tag != "after")))) {
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
          composer.EmitFirst({Two("on_wall_near", mover, other, composer)});
          continue;
        }
        Call call = Two("in_front_of", mover, other, composer);
        const bool exact = match.distance != nullptr && match.distance->exact;
        if (exact) call.Number("distance_m", match.distance->Nominal());
        composer.EmitFirst({std::move(call)});
        if (match.distance != nullptr && !exact) KeepDistance(mover, other, match.distance, composer);
      }
    }
    composer.SetPair(movers, target.objects);
  }
}

// "In front of the desk, with at least 0.5 m behind it".
void InFrontWithSpaceBehind(const Match& match, std::string_view, Composer& composer) {
  Match place = match;
  place.distance = nullptr;
  place.c = nullptr;
  InFrontOf(place, "", composer);
  for (const Placed& mover : composer.Movers(match.a)) {
    composer.EmitFirst({Call("accessible")
                            .Text("object", composer.id(mover))
                            .Texts("sides", {"back"})
                            .Number("min_clearance_m", match.distance->Nominal())});
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
  composer.Refuse("not_expressible", "only parallel, facing and right angles can be asked for");
}

void IntoRoom(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& mover : composer.Movers(match.a)) {
    composer.EmitFirst({Call("facing_into_room").Text("object", composer.id(mover))});
  }
}

}  // namespace

std::vector<Rule> AngleRules() {
  return {
      {"A? facing/visible_from B", Facing},
      {"A? facing ,? in_front_of B", Facing},
      {"A? facing centered of? B", Facing},
      {"A? opposite centered of? B", Facing},
      {"A? not facing/opposite B", Facing, "not"},
      {"A? facing_away B", Facing, "not"},
      {"A? opposite B", Facing},
      {"A? on opposite B.side", OnOpposite},
      {"A? facing_each_other", EachOther},
      {"A? facing both_ways", EachOther},
      {"A? opposite both_ways", EachOther},
      {"A? on/against/along B.wall opposite/facing C", OnWallOpposite},
      {"A? on? opposite B.wall away_from/of/opposite C", OnWallOpposite},
      {"A? D? in_front_of B", InFrontOf},
      {"A? in_front_of B D", InFrontOf, "after"},
      {"A? in_front_of B , space? D", InFrontOf, "after"},
      {"A? not facing_each_other", NotFacingPair},
      {"A? not facing/opposite both_ways", NotFacingPair},
      {"A? perpendicular both_ways?", ParallelPairs, "perpendicular"},
      {"A? in_front_of B , D space? behind C.pronoun", InFrontWithSpaceBehind},
      {"A? in_front_of B ,? D space? apart/away", InFrontOf},
      {"A? in_front_of B , D space? away_from C", InFrontOf},
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
      {"A? visible_from B.side", SeenFromSides},
      {"A? seen all_sides", SeenFromSides},
      {"not in_front", NotInFront},
  };
}

}  // namespace flair::translator
