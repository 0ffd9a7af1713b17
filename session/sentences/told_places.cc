// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/sentences/told_places.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "absl/strings/match.h"
#include "absl/strings/str_join.h"
#include "room/conversion/conversion.h"
#include "session/layouts/directions.h"

namespace flair::session {
namespace {

// As far as people see no difference.
constexpr double kAlike_m = 0.3;

const WordMeanings& Relations() {
  static const WordMeanings relations("told: ");
  return relations;
}

// What a place is told by, seen from above: a window and a corner have no depth.
struct Spot {
  Vec2<double> middle;
  double theta_rad = 0, half_width_m = 0, half_depth_m = 0;
  // Of an object; empty for a part of the room.
  std::string id = {};
};

// Where a piece is from a spot.
struct Seen {
  // Beside its middle to the right of who looks ahead from there, and ahead of it.
  double across_m = 0, ahead_m = 0;
  // Between them, about.
  double gap_m = 0;
};

Seen SeenFrom(const Spot& spot, const v1::Object& object, const v1::Placement& at) {
  const double dx = at.x_m() - spot.middle.x, dy = at.y_m() - spot.middle.y;
  const double cos = std::cos(spot.theta_rad), sin = std::sin(spot.theta_rad);
  Seen seen{dx * cos + dy * sin, dy * cos - dx * sin, 0};
  const double away_m = std::hypot(std::max(0.0, std::abs(seen.across_m) - spot.half_width_m),
                                   std::max(0.0, std::abs(seen.ahead_m) - spot.half_depth_m));
  seen.gap_m = std::max(0.0, away_m - std::min(object.width_m(), object.depth_m()) / 2);
  return seen;
}

// Left and right are those of the plan where they lie across the piece, else those of who sits or lies there.
bool IsBeside(const std::string& relation, const Spot& spot, const Seen& seen, const v1::Placement& at) {
  constexpr double kSlanted = 0.5;
  const double in_plan_m = at.x_m() - spot.middle.x;
  const double aside_m = std::abs(std::cos(spot.theta_rad)) > kSlanted ? in_plan_m : seen.across_m;
  return (relation == "left" ? -aside_m : aside_m) > kAlike_m / 2;
}

// How far it is from standing so; nothing when it does not.
std::optional<double> AwayFromBeing(const std::string& relation, const Spot& spot, const v1::Object& object,
                                    const v1::Placement& at) {
  constexpr double kAbove_m = 0.4, kBeside_m = 1.2, kNear_m = 1.5;
  const Seen seen = SeenFrom(spot, object, at);
  const bool is_hung = object.kind() == v1::OBJECT_KIND_WALL || object.kind() == v1::OBJECT_KIND_CEILING;
  const bool of_room = spot.id.empty();
  bool is_so = seen.gap_m <= kNear_m;
  if (relation == "above") is_so = is_hung && seen.gap_m <= kAbove_m;
  if (relation == "below") is_so = !is_hung && seen.gap_m <= kAbove_m;
  if (relation == "on") {
    is_so = of_room ? is_hung && seen.gap_m <= kAbove_m
                    : object.host_id() == spot.id ||
                          (object.kind() == v1::OBJECT_KIND_SURFACE && object.host_id().empty() && seen.gap_m == 0);
  }
  const bool in_line = std::abs(seen.across_m) <= spot.half_width_m + kAlike_m && seen.gap_m <= kBeside_m;
  if (!of_room && relation == "before") is_so = in_line && seen.ahead_m > spot.half_depth_m - kAlike_m;
  if (!of_room && relation == "behind") is_so = in_line && seen.ahead_m < kAlike_m - spot.half_depth_m;
  if (relation == "left" || relation == "right") is_so = seen.gap_m <= kBeside_m && IsBeside(relation, spot, seen, at);
  return is_so ? std::optional(seen.gap_m) : std::nullopt;
}

ObjectIds StandingAt(const ObjectIds& ids, const std::string& relation, const std::vector<Spot>& spots,
                     const v1::SolvedLayout& layout) {
  std::vector<std::pair<double, std::string>> found;
  for (const std::string& id : ids) {
    const v1::Object* const object = ObjectOf(layout, id);
    const v1::Placement* const at = PlaceOf(layout, id);
    if (object == nullptr || at == nullptr) continue;
    std::optional<double> least_m;
    for (const Spot& spot : spots) {
      const std::optional<double> away_m = AwayFromBeing(relation, spot, *object, *at);
      if (spot.id != id && away_m.has_value() && (!least_m.has_value() || *away_m < *least_m)) least_m = away_m;
    }
    if (least_m.has_value()) found.emplace_back(*least_m, id);
  }
  ObjectIds there;
  if (found.empty()) return there;
  const double least_m = std::ranges::min(found).first;
  for (const auto& [away_m, id] : found) {
    if (away_m <= least_m + kAlike_m) there.push_back(id);
  }
  return there;
}

Spot SpotOf(const Wall& wall, double begin_m, double end_m) {
  return {wall.PointAt((begin_m + end_m) / 2), wall.BackHeading(), (end_m - begin_m) / 2};
}

// The walls of a name, all of them for "the wall"; "north east" is said of a corner of both.
std::vector<size_t> WallsCalled(const Room& room, const std::string& name) {
  std::vector<size_t> walls;
  for (size_t i = 0; i < room.walls.size(); ++i) {
    const std::string called = WallName(room, room.walls[i]);
    if (name.empty() || called == "the " + name + " wall" || room.walls[i].name == name) walls.push_back(i);
  }
  return walls;
}

bool IsCornerOf(const Wall& one, const Wall& next, const std::string& name) {
  return name.empty() || (absl::StrContains(name, one.name) && absl::StrContains(name, next.name));
}

}  // namespace

std::optional<ToldPlace> ReadToldPlace(const Tokens& tokens, Span span) {
  static const WordMeanings before("words before a told place");
  for (size_t at = span.begin + 1; at < span.end; ++at) {
    const size_t begin = at + before.LengthAt(tokens, at);
    for (size_t end = span.end; end > begin; --end) {
      const std::string* const relation = Relations().Find(tokens, {begin, end});
      if (relation != nullptr) return ToldPlace{*relation, {span.begin, at}, {end, span.end}};
    }
  }
  return std::nullopt;
}

ObjectIds StandingThere(const ObjectIds& ids, const std::string& relation, const ObjectIds& at,
                        const v1::SolvedLayout& layout) {
  std::vector<Spot> spots;
  for (const std::string& id : at) {
    const v1::Placement* const place = PlaceOf(layout, id);
    const v1::Object* const object = ObjectOf(layout, id);
    if (place == nullptr || object == nullptr) continue;
    spots.push_back(
        {{place->x_m(), place->y_m()}, place->theta_rad(), object->width_m() / 2, object->depth_m() / 2, id});
  }
  return StandingAt(ids, relation, spots, layout);
}

std::optional<ObjectIds> StandingThere(const ObjectIds& ids, const std::string& relation, const Tokens& tokens,
                                       Span part, const v1::SolvedLayout& layout) {
  static const WordMeanings targets("target: ");
  const absl::StatusOr<Room> room = RoomFromProto(layout.graph().room());
  if (part.empty() || !room.ok()) return std::nullopt;
  std::vector<std::string> words;
  for (size_t i = part.begin; i < part.end; ++i) words.push_back(tokens[i].text);
  if (words.front() == "the" || words.front() == "a") words.erase(words.begin());
  if (words.empty()) return std::nullopt;
  const std::string kind = words.back();
  words.pop_back();
  const std::string* const target = targets.Find(tokens, part);
  std::vector<Spot> spots;
  if (target != nullptr && (*target == "window" || *target == "door")) {
    for (const Opening& one : room->openings) {
      if ((one.kind == OpeningKind::kWindow) != (*target == "window")) continue;
      spots.push_back(SpotOf(room->walls[one.wall], one.offset_m, one.offset_m + one.width_m));
    }
  } else if (target != nullptr && *target == "middle") {
    spots.push_back({MiddleOf(*room)});
  } else if (kind == "wall") {
    for (const size_t i : WallsCalled(*room, target != nullptr ? "" : absl::StrJoin(words, " "))) {
      spots.push_back(SpotOf(room->walls[i], 0, room->walls[i].length_m));
    }
  } else if (kind == "corner") {
    for (size_t i = 0; i < room->walls.size(); ++i) {
      const Wall& next = room->walls[(i + 1) % room->walls.size()];
      if (IsCornerOf(room->walls[i], next, absl::StrJoin(words, " "))) spots.push_back({next.start});
    }
  } else {
    return std::nullopt;
  }
  return StandingAt(ids, relation, spots, layout);
}

ObjectIds StandingFarthest(const ObjectIds& ids, const std::string& side, const v1::SolvedLayout& layout) {
  const auto towards = [&](const std::string& id) {
    const v1::Placement& at = *PlaceOf(layout, id);
    return side == "west" ? -at.x_m() : side == "east" ? at.x_m() : side == "south" ? -at.y_m() : at.y_m();
  };
  ObjectIds there;
  double most_m = -INFINITY;
  for (const std::string& id : ids) most_m = std::max(most_m, towards(id));
  std::ranges::copy_if(ids, std::back_inserter(there),
                       [&](const std::string& id) { return towards(id) > most_m - kAlike_m; });
  return there;
}

}  // namespace flair::session
