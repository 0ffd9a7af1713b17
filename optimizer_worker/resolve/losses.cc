// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/resolve/losses.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "evaluation/metrics/walk_grid.h"
#include "fmt/format.h"
#include "optimizer_worker/constraints/arguments.h"
#include "optimizer_worker/constraints/measure/walls.h"
#include "room/geometry/polygon.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {
namespace {

// As near, and as parallel, as satisfies against_wall.
constexpr double kFlush_m = 0.03, kFlushCos = 0.998;
// Less is the raster's.
constexpr double kLeastShare = 0.02;

double OffWall(const Room& room, const Footprint& footprint, const Pose<double>& pose, Side side) {
  const Frame<double> frame = FrameOf(pose);
  const Vec2<double> middle = MiddleOf(footprint, frame, side);
  double least_m = 1e300;
  for (const Wall& wall : room.walls) {
    const bool along = wall.Offset(middle) >= 0 && wall.Offset(middle) <= wall.length_m;
    if (!along || Dot(NormalOf(frame, side), wall.inward_normal) > -kFlushCos) continue;
    least_m = std::min(least_m, std::abs(wall.Height(middle)));
  }
  return least_m;
}

// The side that is flush on a wall, the back first.
std::optional<Side> SideAtWall(const Scene& scene, int object, const Pose<double>& pose) {
  for (const Side side : {Side::kBack, Side::kLeft, Side::kRight, Side::kFront}) {
    if (OffWall(scene.room, scene.objects[object].footprint, pose, side) <= kFlush_m) return side;
  }
  return std::nullopt;
}

// Where one can walk, and which fronts one gets to.
struct Ways {
  evaluation::WalkResult walk;
  std::vector<char> front_reached;
};

class Loser {
 public:
  Loser(const SolveInput& input, const PartialLayout& before, const PartialLayout& after,
        const std::vector<int>& touched)
      : input_(input), scene_(input.scene), before_(before), after_(after), grid_(input.fine_walk_grid.get()) {
    for (int i = 0; i < static_cast<int>(scene_.objects.size()); ++i) {
      if (!IsSolid(scene_.objects[i]) || !after.placed[i]) continue;
      if (!before.placed[i] || !(before.layout[i] == after.layout[i])) moved_.push_back(i);
      if (before.placed[i] && !std::ranges::binary_search(touched, i)) third_.push_back(i);
    }
  }

  std::vector<v1::Diagnostic> Losses() {
    if (moved_.empty()) return {};
    for (int object : third_) TellOffWall(object);
    const Ways was = WaysIn(before_, -1), is = WaysIn(after_, -1);
    const double lost = was.walk.reachable_share - is.walk.reachable_share;
    if (lost > kLeastShare) {
      const int blocker = BlockerOf([&](const Ways& ways) { return ways.walk.reachable_share; }, lost / 2, is);
      const std::string how =
          is.walk.door_free || !was.walk.door_free
              ? fmt::format("{:.0f} % of the free floor can be reached from the door, {:.0f} % before",
                            100 * is.walk.reachable_share, 100 * was.walk.reachable_share)
              : "nobody gets in by the door any more";
      Tell("way_blocked", blocker, how + InTheWay(blocker));
    }
    for (int object : third_) {
      if (!was.front_reached[object] || is.front_reached[object]) continue;
      const int blocker = BlockerOf([&](const Ways& ways) { return ways.front_reached[object]; }, 0.5, is);
      if (blocker >= 0 && input_.linked.BelongsAt(object, blocker, Side::kFront)) continue;
      Tell("front_blocked", object,
           fmt::format("nobody gets to the front of {} any more{}", Name(object), InTheWay(blocker)));
    }
    return std::move(told_);
  }

 private:
  std::string Name(int object) const { return NameForPeople(scene_, object); }
  std::string InTheWay(int blocker) const {
    return blocker < 0 ? "" : fmt::format(": {} is in the way", Name(blocker));
  }

  void Tell(const char* code, int subject, std::string message) {
    v1::Diagnostic& diagnostic = told_.emplace_back();
    diagnostic.set_severity(v1::SEVERITY_WARNING);
    diagnostic.set_code(code);
    if (subject >= 0) diagnostic.set_subject_id(scene_.objects[subject].id);
    diagnostic.set_message(std::move(message));
  }

  void TellOffWall(int object) {
    const Pose<double>& pose = after_.layout[object];
    const std::optional<Side> side = SideAtWall(scene_, object, before_.layout[object]);
    if (!side || SideAtWall(scene_, object, pose)) return;
    const double off_m = OffWall(scene_.room, scene_.objects[object].footprint, pose, *side);
    const std::string by = off_m < 1e3 ? fmt::format(": it is {:.2f} m off", off_m) : ": it is turned";
    Tell("off_wall", object, fmt::format("{} no longer stands against a wall{}", Name(object), by));
  }

  Ways WaysIn(const PartialLayout& state, int without) {
    std::vector<evaluation::Obstacle> obstacles;
    std::vector<int> standing;
    for (int i = 0; i < static_cast<int>(scene_.objects.size()); ++i) {
      if (i == without || !state.placed[i] || !IsSolid(scene_.objects[i])) continue;
      obstacles.push_back({state.layout[i], scene_.objects[i].footprint});
      standing.push_back(i);
    }
    Ways ways{grid_.Measure(obstacles), std::vector<char>(scene_.objects.size(), 0)};
    for (size_t k = 0; k < standing.size(); ++k) ways.front_reached[standing[k]] = grid_.front_reachable()[k];
    return ways;
  }

  // Of those that moved, the one without which `measure` rises most, by `least` at least; -1 when there is none.
  template <typename Measure>
  int BlockerOf(const Measure& measure, double least, const Ways& now) {
    int blocker = -1;
    for (int object : moved_) {
      const double gain = measure(WaysIn(after_, object)) - measure(now);
      if (gain < least) continue;
      least = std::nextafter(gain, 2.0);
      blocker = object;
    }
    return blocker;
  }

  const SolveInput& input_;
  const Scene& scene_;
  const PartialLayout& before_;
  const PartialLayout& after_;
  evaluation::WalkGrid grid_;
  // Solid pieces that stand elsewhere than before, and those that no edit is about.
  std::vector<int> moved_, third_;
  std::vector<v1::Diagnostic> told_;
};

}  // namespace

void HoldWalls(const SolveInput& input, const PartialLayout& before, const std::vector<int>& touched,
               v1::LayoutGraph& graph) {
  IdSet ids;
  for (const v1::ConstraintEdge& edge : graph.edges()) ids.insert(edge.id());
  for (int i = 0; i < static_cast<int>(input.scene.objects.size()); ++i) {
    const Object& object = input.scene.objects[i];
    if (!IsSolid(object) || !before.placed[i] || input.pinned[i] || std::ranges::binary_search(touched, i)) continue;
    const std::optional<Side> side = SideAtWall(input.scene, i, before.layout[i]);
    if (!side) continue;
    v1::ConstraintEdge& edge = *graph.add_edges();
    edge = EdgeFromText("against_wall", fmt::format("object={} side={}", object.id, std::string(SideName(*side))));
    edge.set_weight(1);
    for (int k = 1; edge.id().empty() || ids.contains(edge.id()); ++k) edge.set_id(fmt::format("wall_{}_{}", i, k));
  }
}

std::vector<v1::Diagnostic> LossesOf(const SolveInput& input, const PartialLayout& before, const PartialLayout& after,
                                     const std::vector<int>& touched) {
  return Loser(input, before, after, touched).Losses();
}

}  // namespace flair::optimizer
