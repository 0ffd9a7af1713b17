// SPDX-License-Identifier: GPL-3.0-or-later
// Directions: facing, opposite, parallel, at a right angle.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "fmt/format.h"
#include "translator_worker/grammar/frames.h"
#include "translator_worker/grammar/rules/shared.h"

namespace flair::translator {
namespace {

Call Two(const char* type, const Placed& mover, const Placed& other, Composer& composer) {
  return Call(type).Text("object", composer.id(mover)).Text("target", composer.id(other));
}

void EmitFacing(const Placed& mover, const Placed& other, bool both, Composer& composer) {
  if (composer.IsWall(mover)) {
    composer.Relate("on_wall_facing", mover, other);
  } else if (both) {
    composer.EmitFirst({Two("facing", mover, other, composer).Flag("both", true)});
  } else {
    composer.Relate("facing", mover, other);
  }
}

void Facing(const Match& match, std::string_view detail, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  for (const Target& target : composer.Targets(*match.b, movers, detail != "not")) {
    for (const Placed& mover : movers) {
      const std::string& id = composer.id(mover);
      if (target.kind == RefKind::kFeature) {
        if (mover.side == "back") {
          composer.Refuse("not_expressible", "no call turns a back to a door or window; say what the front faces");
        } else if (target.name == "door") {
          composer.EmitFirst({Call("faces_feature").Text("object", id).Text("feature", target.name)});
        } else {
          composer.EmitFirst({Call("faces_feature").Text("object", id).Text("feature", target.name),
                              Call("close_to_feature").Text("object", id).Text("feature", target.name)});
        }
      } else if (target.kind == RefKind::kRoom) {
        composer.EmitFirst({Call("facing_into_room").Text("object", id)});
      } else if (target.objects.empty()) {
        composer.Refuse("unknown_sentence", "it can face an object, a door, a window or the room");
      }
      for (const Placed& other : target.objects) {
        if (mover.side == "back") {
          composer.Refuse("not_expressible", "no call turns a back to an object; say what the front faces");
        } else if (detail == "not") {
          composer.Relate("not_facing", mover, other);
        } else {
          EmitFacing(mover, other, detail == "both", composer);
        }
      }
    }
    if (!target.objects.empty()) composer.SetPair(movers, target.objects);
  }
}

// "On the other side of the desk from the chair": it faces the chair.
void Across(const Match& match, std::string_view detail, Composer& composer) {
  Facing({match.a, match.c, nullptr, nullptr, match.length}, detail, composer);
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
    if (!composer.IsWall(mover)) composer.Place("against_wall", mover);
  }
  for (const Placed& other : composer.TargetObjects(*match.c, movers)) {
    for (const Placed& mover : movers) {
      EmitFacing(mover, other, false, composer);
    }
    composer.SetPair(movers, {other});
  }
}

// detail is the type.
void Direction(const Match& match, std::string_view detail, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  for (const Target& target : composer.Targets(*match.b, movers)) {
    if (target.kind == RefKind::kWall && detail == "parallel") {
      for (const Placed& mover : movers) composer.Place("near_wall", mover);
    } else if (target.objects.empty()) {
      composer.Refuse("unknown_sentence", "directions are stated between objects");
    }
    for (const Placed& other : target.objects) {
      for (const Placed& mover : movers) composer.Relate(std::string(detail), mover, other);
    }
    if (!target.objects.empty()) composer.SetPair(movers, target.objects);
  }
}

// detail is the type. "Behind the bench and parallel": to the bench, else all of them to one of them.
void ParallelPairs(const Match& match, std::string_view detail, Composer& composer) {
  std::vector<Placed> movers = composer.Movers(match.a);
  if (movers.size() == 1 && !composer.pair_targets().empty()) {
    for (const Placed& other : composer.pair_targets()) composer.Relate(std::string(detail), movers.front(), other);
    return;
  }
  if (movers.size() < 2) movers = composer.subjects();
  for (size_t i = 1; i < movers.size(); ++i) {
    composer.Relate(std::string(detail), movers[i], movers[0]);
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
      composer.Relate("not_facing", one, other);
      composer.Relate("not_facing", other, one);
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
    composer.Place("facing_into_room", mover);
  }
}

}  // namespace

std::vector<Meaning> DirectionMeanings() {
  return {
      {"angle", Angle},
      {"facing", Facing},
      {"across", Across},
      {"side_to", Facing},
      {"each_other", EachOther},
      {"on_wall_opposite", OnWallOpposite},
      {"direction", Direction},
      {"parallel_pairs", ParallelPairs},
      {"not_facing_pair", NotFacingPair},
      {"into_room", IntoRoom},
  };
}

}  // namespace flair::translator
