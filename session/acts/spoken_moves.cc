// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked in words of where pieces stand: further to the left, the other way round, in each other's place.
#include <algorithm>
#include <cmath>
#include <utility>

#include "fmt/format.h"
#include "room/conversion/conversion.h"
#include "session/acts/layout_acts.h"
#include "session/layouts/comparing.h"
#include "session/layouts/directions.h"
#include "session/layouts/edits.h"
#include "session/layouts/placing.h"
#include "session/sentences/answers.h"
#include "session/sentences/names.h"
#include "session/sentences/spoken.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::session {
namespace {

using runtime::CallContext;

constexpr double kUsualMove_m = 0.3, kLeastMove_m = 0.02, kNearBy_m = 0.7, kTurned_rad = 0.1;

std::string Centimetres(double length_m) {
  return length_m < 1 ? fmt::format("{:.0f} cm", length_m * 100) : fmt::format("{:.2f} m", length_m);
}

// "to the west", "towards the window".
std::string WayText(const Spoken& spoken) {
  if (!spoken.target.kind.empty()) {
    return fmt::format("{} {}", spoken.is_away ? "away from" : "towards", spoken.target.said);
  }
  return spoken.way == "forward" ? "forward" : spoken.way == "back" ? "back" : "to the " + spoken.way;
}

v1::MoveObjects Shifted(const v1::SolvedLayout& layout, const ObjectIds& ids, const Vec2<double>& way, double by_m) {
  v1::MoveObjects move;
  for (const std::string& id : ids) {
    v1::Placement& to = *move.add_placements();
    to = *PlaceOf(layout, id);
    Vec2<double> along = way;
    if (ObjectOf(layout, id)->kind() == v1::OBJECT_KIND_WALL) {
      // What hangs on a wall stays on it.
      const Vec2<double> wall{std::cos(to.theta_rad()), std::sin(to.theta_rad())};
      const double share = wall.x * way.x + wall.y * way.y;
      along = {wall.x * share, wall.y * share};
    }
    to.set_x_m(to.x_m() + along.x * by_m);
    to.set_y_m(to.y_m() + along.y * by_m);
  }
  return move;
}

}  // namespace

absl::StatusOr<Acted> LayoutActs::MovedAndSettled(const Standing& standing, const v1::MoveObjects& move,
                                                  CallContext& call) const {
  ASSIGN_OR_RETURN(Acted moved, Move(standing, move, call));
  if (!HasMoreFaults(moved.layout, standing.shown)) return moved;
  const Standing now{moved.layout, standing.settled, moved.pending, moved.by_hand};
  absl::StatusOr<Acted> settled = Solved(now, {}, call);
  if (!settled.ok()) return moved;
  settled->moved_ids = MovedIds(standing.shown, settled->layout);
  // What was asked must not be undone by that.
  const bool stays = std::ranges::all_of(move.placements(), [&](const v1::Placement& to) {
    const v1::Placement* const at = PlaceOf(settled->layout, to.object_id());
    return at != nullptr && std::hypot(at->x_m() - to.x_m(), at->y_m() - to.y_m()) < kLeastMove_m &&
           std::abs(std::remainder(at->theta_rad() - to.theta_rad(), 2 * M_PI)) < kTurned_rad;
  });
  return stays && !HasMoreFaults(settled->layout, standing.shown) ? settled : moved;
}

absl::StatusOr<Acted> LayoutActs::MovedNearBy(const Standing& standing, const v1::MoveObjects& move, double farthest_m,
                                              CallContext& call) const {
  ASSIGN_OR_RETURN(Acted there, Move(standing, move, call));
  if (!HasMoreFaults(there.layout, standing.shown)) return there;
  v1::MoveObjects free = move;
  if (PutWhereFree(standing.shown, farthest_m, *free.mutable_placements())) {
    ASSIGN_OR_RETURN(Acted near, Move(standing, free, call));
    if (!HasMoreFaults(near.layout, standing.shown)) return near;
  }
  ASSIGN_OR_RETURN(Acted settled, MovedAndSettled(standing, move, call));
  if (!HasMoreFaults(settled.layout, standing.shown)) return settled;
  return MovedAndSettled(standing, free, call);
}

absl::StatusOr<Acted> LayoutActs::MoveSpoken(const Standing& standing, const Spoken& spoken, CallContext& call) const {
  const v1::SolvedLayout& shown = standing.shown;
  ASSIGN_OR_RETURN(const Scene scene, SceneFromProto(shown.graph()));
  const v1::Placement& first = *PlaceOf(shown, spoken.what.ids.front());
  std::optional<Vec2<double>> way =
      spoken.target.kind.empty() ? WayOf(spoken.way, first) : WayTo(spoken.target, scene, shown, first);
  if (!way.has_value()) return InvalidArgument("{} is not there to move to", spoken.target.said);
  const double away_m = std::hypot(way->x, way->y);
  *way = {way->x / away_m, way->y / away_m};
  if (spoken.is_away) *way = {-way->x, -way->y};
  if (!spoken.target.kind.empty()) *way = AlongWall(*way, scene.room, first, *ObjectOf(shown, first.object_id()));
  double by_m = spoken.length_m.value_or(kUsualMove_m);
  if (!spoken.target.kind.empty() && !spoken.is_away) by_m = std::min(by_m, away_m);
  const std::string name = TheOnes(shown, spoken.what.ids);
  const auto try_by = [&](double length_m) {
    return Move(standing, Shifted(shown, spoken.what.ids, *way, length_m), call);
  };
  ASSIGN_OR_RETURN(Acted acted, try_by(by_m));
  const std::string wrong = NewFault(shown, acted.layout);
  if (acted.moved_ids.empty()) return InvalidArgument("{} hangs on its wall and cannot move that way", name);
  if (HasMoreFaults(acted.layout, shown) && spoken.length_m.has_value()) {
    ASSIGN_OR_RETURN(acted, MovedAndSettled(standing, Shifted(shown, spoken.what.ids, *way, by_m), call));
  }
  double done_m = by_m;
  if (HasMoreFaults(acted.layout, shown)) {
    // As far as it goes.
    double least_m = 0, most_m = by_m;
    std::optional<Acted> best;
    while (most_m - least_m > kLeastMove_m / 2) {
      const double middle_m = (least_m + most_m) / 2;
      ASSIGN_OR_RETURN(Acted one, try_by(middle_m));
      if (HasMoreFaults(one.layout, shown)) {
        most_m = middle_m;
      } else {
        least_m = middle_m;
        best = std::move(one);
      }
    }
    if (!best.has_value() || least_m < kLeastMove_m) {
      return InvalidArgument("{} cannot go {}: {}", name, WayText(spoken), wrong);
    }
    acted = *std::move(best);
    done_m = least_m;
  }
  acted.answer = fmt::format("Moved {} {} {}", name, Centimetres(done_m), WayText(spoken));
  acted.answer += done_m < by_m && spoken.length_m.has_value() ? fmt::format(", not further: {}.", wrong) : ".";
  acted.answer += MovedToo(acted.layout, acted.moved_ids, IdSetOf(spoken.what.ids));
  acted.answer += AtACost(shown, acted.layout, IdSetOf(acted.moved_ids));
  return acted;
}

absl::StatusOr<Acted> LayoutActs::SetOffSpoken(const Standing& standing, const Spoken& spoken,
                                               CallContext& call) const {
  const v1::SolvedLayout& shown = standing.shown;
  const std::string id = spoken.what.ids.front();
  if (spoken.target.ids.empty() || spoken.target.ids.front() == id) {
    return InvalidArgument("{} is not there to stand beside", spoken.target.said);
  }
  const std::string other_id = spoken.target.ids.front();
  const v1::Object &one = *ObjectOf(shown, id), &other = *ObjectOf(shown, other_id);
  const v1::Placement& at = *PlaceOf(shown, other_id);
  const std::optional<Vec2<double>> way = WayOf(spoken.way, at);
  if (!way.has_value() || one.kind() == v1::OBJECT_KIND_WALL) {
    return InvalidArgument("{} cannot stand so", TheOnes(shown, {id}));
  }
  v1::MoveObjects move;
  v1::Placement& to = *move.add_placements();
  to = *PlaceOf(shown, id);
  // Half of a piece along the way.
  const auto reach_m = [&](const v1::Object& object, double theta_rad) {
    const double across = way->x * std::cos(theta_rad) + way->y * std::sin(theta_rad);
    const double ahead = way->y * std::cos(theta_rad) - way->x * std::sin(theta_rad);
    return (std::abs(across) * object.width_m() + std::abs(ahead) * object.depth_m()) / 2;
  };
  const double away_m = reach_m(one, to.theta_rad()) + reach_m(other, at.theta_rad()) + *spoken.length_m;
  to.set_x_m(at.x_m() + way->x * away_m);
  to.set_y_m(at.y_m() + way->y * away_m);
  ASSIGN_OR_RETURN(Acted acted, MovedAndSettled(standing, move, call));
  const std::string where =
      fmt::format("{} {} of {}", Centimetres(*spoken.length_m), spoken.way, TheOnes(shown, {other_id}));
  if (HasMoreFaults(acted.layout, shown)) {
    return InvalidArgument("{} cannot stand {}: {}", TheOnes(shown, {id}), where, NewFault(shown, acted.layout));
  }
  acted.answer = fmt::format("{} stands {}.", Capital(TheOnes(shown, {id})), where) +
                 MovedToo(acted.layout, acted.moved_ids, {id}) + AtACost(shown, acted.layout, IdSetOf(acted.moved_ids));
  return acted;
}

absl::StatusOr<Acted> LayoutActs::TurnSpoken(const Standing& standing, const Spoken& spoken, CallContext& call) const {
  const v1::SolvedLayout& shown = standing.shown;
  ASSIGN_OR_RETURN(const Scene scene, SceneFromProto(shown.graph()));
  const std::string name = TheOnes(shown, spoken.what.ids);
  const bool by = spoken.act.starts_with("turn by");
  const bool around = spoken.way == "around" || spoken.act.ends_with("around");
  double angle_deg = spoken.angle_deg.value_or(around ? 180 : 90);
  if (spoken.way == "right") angle_deg = -angle_deg;
  v1::MoveObjects move;
  for (const std::string& id : spoken.what.ids) {
    if (ObjectOf(shown, id)->kind() == v1::OBJECT_KIND_WALL) {
      return InvalidArgument("{} hangs on its wall and cannot be turned", name);
    }
    v1::Placement& to = *move.add_placements();
    to = *PlaceOf(shown, id);
    if (by) {
      to.set_theta_rad(to.theta_rad() + angle_deg * M_PI / 180);
      continue;
    }
    const std::optional<Vec2<double>> way =
        spoken.way.empty() ? WayTo(spoken.target, scene, shown, to) : WayOf(spoken.way, to);
    if (!way.has_value()) return InvalidArgument("{} is not there to turn to", spoken.target.said);
    to.set_theta_rad(std::atan2(-way->x, way->y));
  }
  ASSIGN_OR_RETURN(Acted acted, MovedNearBy(standing, move, kNearBy_m, call));
  if (HasMoreFaults(acted.layout, shown)) {
    ASSIGN_OR_RETURN(acted, SolvedFrom(standing, move, call));
    const v1::Placement &to = move.placements(0), &at = *PlaceOf(acted.layout, to.object_id());
    if (HasMoreFaults(acted.layout, shown) ||
        std::abs(std::remainder(at.theta_rad() - to.theta_rad(), 2 * M_PI)) > kTurned_rad ||
        std::hypot(at.x_m() - to.x_m(), at.y_m() - to.y_m()) > kNearBy_m) {
      ASSIGN_OR_RETURN(const Acted there, Move(standing, move, call));
      return InvalidArgument("there is no room to turn {}: {}", name, NewFault(shown, there.layout));
    }
  }
  if (!by) {
    acted.answer = fmt::format("Turned {} {}.", name,
                               spoken.way.empty() ? "towards " + spoken.target.said : "to the " + spoken.way);
  } else {
    acted.answer = fmt::format("Turned {} by {:.0f} degrees{}.", name, std::abs(angle_deg),
                               spoken.way == "left"    ? " to the left"
                               : spoken.way == "right" ? " to the right"
                                                       : "");
  }
  acted.answer += MovedToo(acted.layout, acted.moved_ids, IdSetOf(spoken.what.ids));
  acted.answer += AtACost(shown, acted.layout, IdSetOf(acted.moved_ids));
  return acted;
}

absl::StatusOr<Acted> LayoutActs::SolvedFrom(const Standing& standing, const v1::MoveObjects& move,
                                             CallContext& call) const {
  v1::SolvedLayout from = standing.shown;
  RETURN_IF_ERROR(Place(from, move.placements(), "placements"));
  ASSIGN_OR_RETURN(from, Evaluated(std::move(from), call));
  EditList edits;
  ObjectIds by_hand = standing.by_hand;
  for (const v1::Placement& to : move.placements()) {
    edits.Add()->mutable_resize_object()->set_object_id(to.object_id());
    std::erase(by_hand, to.object_id());
  }
  ASSIGN_OR_RETURN(Acted acted, Solved({from, &from, {}, by_hand}, edits, call));
  acted.moved_ids = MovedIds(standing.shown, acted.layout);
  return acted;
}

}  // namespace flair::session
