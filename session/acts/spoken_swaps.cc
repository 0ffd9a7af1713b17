// SPDX-License-Identifier: GPL-3.0-or-later
// Two pieces in each other's place, each square to the wall that it comes to.
#include <algorithm>
#include <cmath>
#include <utility>

#include "fmt/format.h"
#include "room/conversion/conversion.h"
#include "session/acts/layout_acts.h"
#include "session/layouts/comparing.h"
#include "session/layouts/edits.h"
#include "session/sentences/answers.h"
#include "session/sentences/spoken.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::session {
namespace {

using runtime::CallContext;

constexpr double kSquare_rad = 0.03;

// A place to go to, and the wall that the back is to be at; none in the middle of the room.
struct Goal {
  v1::Placement at;
  const Wall* wall = nullptr;
};

bool IsOver(const Wall& wall, const v1::Placement& at) {
  const double offset_m = wall.Offset(Vec2<double>{at.x_m(), at.y_m()});
  return offset_m >= 0 && offset_m <= wall.length_m;
}

double HeightOver(const Wall& wall, const v1::Placement& at) { return wall.Height(Vec2<double>{at.x_m(), at.y_m()}); }

// Whether something stands along some wall of the room or across it.
bool IsSquare(const Room& room, const v1::Placement& at) {
  return std::ranges::any_of(room.walls, [&](const Wall& wall) {
    return std::abs(std::remainder(at.theta_rad() - wall.BackHeading(), M_PI / 2)) < kSquare_rad;
  });
}

// Where `one` may stand in the place of `other`: at the walls that are behind or beside that, the nearest first; as it
// stands itself where there are none.
std::vector<Goal> GoalsOf(const v1::Object& one, const v1::Object& other, const v1::Placement& at, const Room& room) {
  constexpr double kAtWall_m = 0.4;
  std::vector<Goal> goals;
  const auto add = [&](const Wall& wall, double back_m) {
    Goal& goal = goals.emplace_back(Goal{at, &wall});
    const double side_m = std::min(one.width_m(), wall.length_m) / 2;
    const double offset_m = wall.Offset(Vec2<double>{at.x_m(), at.y_m()});
    const Vec2<double> foot = wall.PointAt(std::clamp(offset_m, side_m, wall.length_m - side_m));
    const Vec2<double> to = foot + (one.depth_m() / 2 + back_m) * wall.inward_normal;
    goal.at.set_object_id(one.id());
    goal.at.set_x_m(to.x);
    goal.at.set_y_m(to.y);
    goal.at.set_theta_rad(wall.BackHeading());
  };
  std::vector<std::pair<double, const Wall*>> near;
  for (const Wall& wall : room.walls) {
    if (!IsOver(wall, at)) continue;
    const double turn = std::remainder(at.theta_rad() - wall.BackHeading(), 2 * M_PI);
    const bool across = std::abs(std::cos(turn)) < std::abs(std::sin(turn));
    const double gap_m = HeightOver(wall, at) - (across ? other.width_m() : other.depth_m()) / 2;
    // Where its back is comes first.
    const bool is_back = std::abs(turn) < M_PI / 4;
    if (gap_m < kAtWall_m) near.emplace_back(is_back ? gap_m - kAtWall_m : gap_m, &wall);
  }
  std::ranges::stable_sort(near, {}, &std::pair<double, const Wall*>::first);
  for (const auto& [order, wall] : near) {
    const double turn = std::remainder(at.theta_rad() - wall->BackHeading(), 2 * M_PI);
    // Backs come to stand where backs were.
    const bool as_it_was = std::abs(turn) < kSquare_rad;
    add(*wall, as_it_was ? std::max(0.0, HeightOver(*wall, at) - other.depth_m() / 2) : 0.0);
  }
  if (goals.empty()) {
    Goal& goal = goals.emplace_back(Goal{at, nullptr});
    goal.at.set_object_id(one.id());
    if (!room.walls.empty()) {
      const double along = room.walls.front().BackHeading();
      goal.at.set_theta_rad(along + std::round((at.theta_rad() - along) / (M_PI / 2)) * (M_PI / 2));
    }
  }
  return goals;
}

// Whether the pieces have come to their goals, about, square and at their walls.
bool AreThere(const v1::SolvedLayout& layout, const Room& room, const std::vector<const Goal*>& goals) {
  constexpr double kOffWall_m = 0.1, kFarthest_m = 1.2;
  return std::ranges::all_of(goals, [&](const Goal* goal) {
    const v1::Placement* const is = PlaceOf(layout, goal->at.object_id());
    if (is == nullptr || !IsSquare(room, *is)) return false;
    if (std::hypot(is->x_m() - goal->at.x_m(), is->y_m() - goal->at.y_m()) > kFarthest_m) return false;
    return goal->wall == nullptr ||
           std::abs(HeightOver(*goal->wall, *is) - HeightOver(*goal->wall, goal->at)) < kOffWall_m;
  });
}

// Whether what is used at one of the pieces, such as the chair of a desk, has been left behind.
bool LeavesSeats(const v1::SolvedLayout& before, const v1::SolvedLayout& after, const IdSet& ids) {
  const auto key = [](const v1::Finding& one) { return one.object_id() + " " + one.partner_id(); };
  IdSet known;
  for (const v1::Finding& one : before.metrics().findings()) known.insert(key(one));
  const auto is_seat = [&](const std::string& id) {
    const v1::Object* const object = ObjectOf(after, id);
    return object != nullptr && object->seat() && !ids.contains(id);
  };
  return std::ranges::any_of(after.metrics().findings(), [&](const v1::Finding& one) {
    if (one.kind() != v1::FINDING_KIND_USE_NOT_MET || known.contains(key(one))) return false;
    return (ids.contains(one.object_id()) && is_seat(one.partner_id())) ||
           (ids.contains(one.partner_id()) && is_seat(one.object_id()));
  });
}

}  // namespace

absl::StatusOr<Acted> LayoutActs::SwapSpoken(const Standing& standing, const Spoken& spoken, CallContext& call) const {
  const v1::SolvedLayout& shown = standing.shown;
  ASSIGN_OR_RETURN(const Room room, RoomFromProto(shown.graph().room()));
  const std::string a_id = spoken.what.ids.front();
  std::string b_id = spoken.other.ids.empty() ? "" : spoken.other.ids.front();
  const bool is_more = spoken.other.ids.size() > 1 && !spoken.other.is_one;
  if (spoken.what.ids.size() != 1 || is_more || b_id.empty() || b_id == a_id)
    return InvalidArgument("name two pieces to swap");
  const v1::Object &a = *ObjectOf(shown, a_id), &b = *ObjectOf(shown, b_id);
  const std::string names = fmt::format("{} and {}", TheOnes(shown, {a_id}), TheOnes(shown, {b_id}));
  if (a.kind() != b.kind()) return InvalidArgument("{} do not stand in the same way and cannot swap places", names);
  const std::vector<Goal> of_a = GoalsOf(a, b, *PlaceOf(shown, b_id), room);
  const std::vector<Goal> of_b = GoalsOf(b, a, *PlaceOf(shown, a_id), room);
  std::optional<Acted> swapped;
  std::string wrong;
  const auto is_good = [&](const Acted& acted, const Goal& to_a, const Goal& to_b) {
    return !HasMoreFaults(acted.layout, shown) && AreThere(acted.layout, room, {&to_a, &to_b}) &&
           !LeavesSeats(shown, acted.layout, {a_id, b_id});
  };
  for (const Goal& to_a : of_a) {
    for (const Goal& to_b : of_b) {
      if (swapped.has_value()) break;
      v1::MoveObjects move;
      *move.add_placements() = to_a.at;
      *move.add_placements() = to_b.at;
      if (wrong.empty()) {
        ASSIGN_OR_RETURN(const Acted there, Move(standing, move, call));
        wrong = NewFault(shown, there.layout);
      }
      constexpr double kBeside_m = 1.2;
      ASSIGN_OR_RETURN(Acted near, MovedNearBy(standing, move, kBeside_m, call));
      if (!is_good(near, to_a, to_b)) {
        ASSIGN_OR_RETURN(near, SolvedFrom(standing, move, call));
      }
      if (is_good(near, to_a, to_b)) swapped = std::move(near);
    }
  }
  if (!swapped.has_value()) return InvalidArgument("{} cannot swap places: {}", names, wrong);
  swapped->answer = fmt::format("Swapped {}.", names) + MovedToo(swapped->layout, swapped->moved_ids, {a_id, b_id}) +
                    AtACost(shown, swapped->layout, IdSetOf(swapped->moved_ids));
  return *std::move(swapped);
}

}  // namespace flair::session
