// SPDX-License-Identifier: GPL-3.0-or-later
// Whether one gets into the room, and to what one sits, lies or works at.
#include <algorithm>
#include <cmath>
#include <optional>

#include "absl/strings/match.h"
#include "evaluation/metrics/measures.h"
#include "evaluation/metrics/walk_grid.h"
#include "fmt/format.h"

namespace flair::evaluation {
namespace {

// With less of the floor in reach one stands in the door.
constexpr double kLeastShare = 0.1;
// The middle of somebody who sits down or gets into bed, from any side, is no further off.
constexpr double kAt_m = 2 * kPersonRadius_m;

struct Walk {
  double floor_share = 1;
  // One per piece of use.
  std::vector<bool> reached;
};

class WayFinder {
 public:
  explicit WayFinder(const LayoutView& view) : view_(view), grid_(view.scene.room, 2 * kPersonRadius_m, kFineCell_m) {
    for (size_t i = 0; i < view.scene.objects.size(); ++i) {
      const Object& object = view.scene.objects[i];
      if (!view.Has(i) || !IsSolid(object)) continue;
      solid_.push_back(i);
      if (object.seat || object.sat_at || absl::EndsWith(object.category, "bed")) used_.push_back(i);
    }
  }

  UsesOfWays Find() {
    const auto& openings = view_.scene.room.openings;
    const auto door = std::ranges::find(openings, OpeningKind::kDoor, &Opening::kind);
    UsesOfWays uses;
    uses.asked = static_cast<int>(used_.size()) + (door == openings.end() ? 0 : 1);
    if (uses.asked == 0) return uses;
    const Walk now = WalkWithout({});
    if (door != openings.end() && now.floor_share < kLeastShare) {
      const auto opens = [](const Walk& walk) { return walk.floor_share >= kLeastShare; };
      // No other use is told beside it: all of them wait for it.
      uses.unmet.push_back(Told("nobody gets into the room", Blocker(opens), fmt::format(" of {}", DoorName(*door))));
      uses.unmet.back().set_partner_id(door->id);
      return uses;
    }
    uses.met = uses.asked;
    for (size_t k = 0; k < used_.size(); ++k) {
      if (now.reached[k]) continue;
      --uses.met;
      const int piece = static_cast<int>(used_[k]);
      const auto reaches = [k](const Walk& walk) { return walk.reached[k]; };
      const std::string what = fmt::format("nobody gets to {}", NameForPeople(view_.scene, piece));
      v1::Finding told = Told(what, Blocker(reaches), "");
      told.set_partner_id(told.object_id());
      told.set_object_id(view_.scene.objects[used_[k]].id);
      uses.unmet.push_back(std::move(told));
    }
    return uses;
  }

 private:
  std::string DoorName(const Opening& door) const {
    const auto doors = std::ranges::count(view_.scene.room.openings, OpeningKind::kDoor, &Opening::kind);
    return doors == 1 ? "the door" : NameForPeople(view_.scene.room, door);
  }

  Walk WalkWithout(std::optional<size_t> left_out) {
    std::vector<Obstacle> obstacles;
    for (const size_t i : solid_) {
      if (i != left_out) obstacles.push_back({view_.layout[i], view_.scene.objects[i].footprint});
    }
    Walk walk{grid_.Measure(obstacles).reachable_share, {}};
    for (const size_t i : used_) walk.reached.push_back(IsReached(i));
    return walk;
  }

  bool IsReached(size_t piece) const {
    const Footprint& footprint = view_.scene.objects[piece].footprint;
    const Footprint around{footprint.width_m + 2 * kAt_m, footprint.depth_m + 2 * kAt_m};
    const Frame<double> frame = FrameOf(view_.layout[piece]);
    bool reached = false;
    grid_.ForReached(Corners(around, frame), [&](int, int, const Vec2<double>& p) {
      const Vec2<double> at = frame.ToObject(p);
      reached |= std::abs(at.x) <= around.width_m / 2 && std::abs(at.y) <= around.depth_m / 2;
    });
    return reached;
  }

  // The piece without which it is so and most of the floor is in reach; -1 when there is none.
  template <typename IsSo>
  int Blocker(const IsSo& is_so) {
    int blocker = -1;
    double most = -1;
    for (const size_t i : solid_) {
      const Walk walk = WalkWithout(i);
      if (!is_so(walk) || walk.floor_share <= most) continue;
      most = walk.floor_share;
      blocker = static_cast<int>(i);
    }
    return blocker;
  }

  v1::Finding Told(const std::string& what, int blocker, const std::string& of) const {
    v1::Finding finding;
    finding.set_kind(v1::FINDING_KIND_USE_NOT_MET);
    finding.set_message(what);
    if (blocker < 0) return finding;
    finding.set_object_id(view_.scene.objects[static_cast<size_t>(blocker)].id);
    finding.set_message(fmt::format("{}: {} is in the way{}", what, NameForPeople(view_.scene, blocker), of));
    return finding;
  }

  const LayoutView& view_;
  WalkGrid grid_;
  std::vector<size_t> solid_, used_;
};

}  // namespace

UsesOfWays FindUsesOfWays(const LayoutView& view) { return WayFinder(view).Find(); }

}  // namespace flair::evaluation
