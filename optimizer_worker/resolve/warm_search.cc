// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/resolve/warm_search.h"

#include <algorithm>
#include <cmath>

#include "optimizer_worker/stages/floor_stages.h"
#include "optimizer_worker/stages/tertiary.h"
#include "room/geometry/pose.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::optimizer {
namespace {

constexpr int kFloorRounds = 4;
constexpr int kTertiaryRounds = 2;
constexpr int kPlaceRestarts = 2;
// Objects this near to a trouble that its own objects cannot end are moved too.
constexpr double kNeighbour_m = 0.6;
// Nothing moves for a gain of less than this; a tenth of what a missed constraint costs.
constexpr double kWorthMoving = 0.05;
// Moves smaller than these are taken back.
constexpr double kNoMove_m = 1e-3;
constexpr double kNoTurn_rad = 2e-3;

class WarmSearch {
 public:
  WarmSearch(const SolveInput& input, const WarmStart& start)
      : input_(input),
        start_(start),
        floor_(Flags(FreeStage(input, StageKind::kPolish).objects)),
        tertiary_(Flags(FreeStage(input, StageKind::kTertiary).objects)),
        result_{start.state, {}, {}} {}

  absl::StatusOr<WarmResult> Run() {
    // What the user has moved takes along what stands on it.
    Follow(input_, start_.before, start_.touched, result_.state);
    BringAlong();
    PlaceNewcomers();
    RETURN_IF_ERROR(SettleFloor());
    GiveWay();
    PutBack();
    RETURN_IF_ERROR(SettleTertiaries());
    return std::move(result_);
  }

 private:
  std::vector<char> Flags(const std::vector<int>& objects) const {
    std::vector<char> flags(input_.scene.objects.size(), 0);
    for (int object : objects) flags[object] = 1;
    return flags;
  }

  void Record(const StageSpec& stage, const RestartResult& result, int restarts, absl::Time began) {
    v1::StageOutcome& outcome = result_.outcomes.emplace_back();
    outcome.set_stage(std::string(StageName(stage.kind)));
    outcome.set_restart_count(restarts);
    outcome.set_best_restart(std::clamp(result.restart, 0, restarts - 1));
    outcome.set_evaluation_count(result.evaluations);
    outcome.set_seed(static_cast<int64_t>(RestartSeed(input_.settings, stage, 0)));
    outcome.set_cost(result.score);
    result_.durations.push_back(absl::Now() - began);
  }

  // Moves what belongs to an object that the user has moved along with it as one piece, chairs with their table, where
  // that mends more than it spoils: all of it, or else piece by piece. What is left to mend is for the search.
  void BringAlong() {
    for (int leader : start_.touched) {
      const bool moved = start_.before.placed[leader] && result_.state.placed[leader] &&
                         !(start_.before.layout[leader] == result_.state.layout[leader]);
      if (!moved || !IsSolid(input_.scene.objects[leader])) continue;
      std::vector<int> belongings;
      for (int partner : input_.partners[leader]) {
        const bool smaller =
            input_.scene.objects[partner].footprint.area_m2() < input_.scene.objects[leader].footprint.area_m2();
        const bool free = floor_[partner] && IsSolid(input_.scene.objects[partner]);
        if (smaller && free && start_.before.placed[partner] && !IsTouched(partner)) belongings.push_back(partner);
      }
      if (belongings.empty() || Bring(leader, belongings) || belongings.size() == 1) continue;
      for (int one : belongings) Bring(leader, {one});
    }
  }
  bool IsTouched(int object) const { return std::ranges::binary_search(start_.touched, object); }
  bool Bring(int leader, const std::vector<int>& belongings) {
    PartialLayout brought = result_.state;
    for (int object : belongings) {
      brought.layout[object] =
          Carried(start_.before.layout[leader], brought.layout[leader], start_.before.layout[object]);
    }
    Follow(input_, result_.state, belongings, brought);
    const auto now = Trouble(FindViolations(input_, result_.state, start_.baseline));
    if (!(Trouble(FindViolations(input_, brought, start_.baseline)) < now)) return false;
    result_.state = std::move(brought);
    return true;
  }

  // Gives the floor objects without a pose one, among those that stand.
  void PlaceNewcomers() {
    StageSpec stage{StageKind::kSecondary, -1, {}};
    for (int object : start_.touched) {
      if (floor_[object] && !result_.state.placed[object]) stage.objects.push_back(object);
    }
    if (!stage.objects.empty()) result_.state = Furnished(stage, result_.state);
  }
  PartialLayout Furnished(const StageSpec& stage, const PartialLayout& before) {
    const absl::Time began = absl::Now();
    std::vector<RestartResult> results;
    for (int restart = 0; restart < kPlaceRestarts; ++restart) {
      results.push_back(FurnishRestart(input_, stage, before, restart));
    }
    const RestartResult& best = results[BestOf(results)];
    Record(stage, best, kPlaceRestarts, began);
    return best.state;
  }

  // What still stands in something goes by the shortest way to where it stands free, or is placed anew: the smallest
  // first, and first what no edit is about.
  void GiveWay() {
    auto trouble = Trouble(FindViolations(input_, result_.state, start_.baseline));
    if (trouble.first == 0) return;
    std::vector<int> colliding = FindViolations(input_, result_.state, start_.baseline).colliding;
    std::erase_if(colliding, [&](int object) { return !floor_[object] || !result_.state.placed[object]; });
    std::ranges::sort(colliding, {}, [&](int object) {
      return std::pair(IsTouched(object), input_.scene.objects[object].footprint.area_m2());
    });
    for (int object : colliding) {
      std::vector<PartialLayout> tries = PlacesBeside(object);
      PartialLayout without = result_.state;
      without.placed[object] = 0;
      tries.push_back(Furnished({StageKind::kSecondary, -1, {object}}, without));
      Follow(input_, result_.state, std::span(&object, 1), tries.back());
      // Near places come first, and are taken where they end it.
      for (PartialLayout& one : tries) {
        const auto then = Trouble(FindViolations(input_, one, start_.baseline));
        if (then.first >= trouble.first) continue;
        trouble = then;
        result_.state = std::move(one);
        if (trouble.first == 0) return;
      }
    }
  }

  // The state with an object where it stands free, turned as it is: by the ways of up to kAside_m in its own
  // directions, of the nearest few.
  std::vector<PartialLayout> PlacesBeside(int object) const {
    constexpr double kStep_m = 0.02, kAside_m = 0.6;
    constexpr size_t kMost = 4;
    std::vector<int> standing;
    for (int i = 0; i < static_cast<int>(floor_.size()); ++i) {
      if (result_.state.placed[i] && IsSolid(input_.scene.objects[i])) standing.push_back(i);
    }
    const Pose<double> from = result_.state.layout[object];
    std::vector<PartialLayout> places;
    for (double far_m = kStep_m; far_m <= kAside_m && places.size() < kMost; far_m += kStep_m) {
      for (int eighth = 0; eighth < 8; ++eighth) {
        const double angle = from.theta_rad + eighth * kPi / 4;
        PartialLayout place = result_.state;
        place.layout[object] = {from.x_m + far_m * std::cos(angle), from.y_m + far_m * std::sin(angle), from.theta_rad};
        const auto left = FindViolations(input_.scene, input_.keep_out, standing, place.layout, kFits_m);
        const auto names_it = [&](const Violation& one) { return one.object == object || one.other == object; };
        if (std::ranges::any_of(left, names_it)) continue;
        Follow(input_, result_.state, std::span(&object, 1), place);
        places.push_back(std::move(place));
      }
    }
    return places;
  }

  // The floor objects that may move and are to blame: those that collide, and those that broken edges name.
  std::vector<int> ToBlame(const Violations& violations) const {
    std::vector<char> blamed = Flags(violations.colliding);
    for (int edge : violations.broken) {
      for (int object : ObjectsOfEdge(input_, edge)) blamed[object] = 1;
    }
    std::vector<int> objects;
    for (size_t i = 0; i < blamed.size(); ++i) {
      if (blamed[i] && floor_[i] && result_.state.placed[i]) objects.push_back(static_cast<int>(i));
    }
    return objects;
  }

  // How bad it is for the floor: depth of collisions, then weight of broken edges and of floor that is cut off.
  std::pair<double, double> Trouble(const Violations& violations) const {
    double weight = WalkWeights().unreachable_floor * violations.unreachable_share;
    for (int edge : violations.broken) {
      const std::vector<int> named = ObjectsOfEdge(input_, edge);
      const bool on_floor =
          std::ranges::all_of(named, [&](int object) { return IsSolid(input_.scene.objects[object]); });
      if (on_floor) weight += input_.graph.edges(edge).weight();
    }
    return {violations.depth_m > kFits_m ? violations.depth_m : 0.0, weight};
  }

  bool Near(int object, const std::vector<int>& others) const {
    const Layout& layout = result_.state.layout;
    const auto box = [&](int i) { return Box<double>(input_.scene.objects[i].footprint, FrameOf(layout[i])); };
    return std::ranges::any_of(
        others, [&](int other) { return other == object || Separate(box(object), box(other)).gap_m < kNeighbour_m; });
  }

  // Adds those to blame to `free`; when all of them are free already and things still collide, their neighbours.
  bool Grow(const Violations& violations, std::vector<char>& free) const {
    const std::vector<int> blamed = ToBlame(violations);
    bool grown = false;
    for (int object : blamed) {
      grown = grown || !free[object];
      free[object] = 1;
    }
    if (grown || blamed.empty() || violations.depth_m <= kFits_m) return grown;
    for (size_t i = 0; i < free.size(); ++i) {
      if (free[i] || !floor_[i] || !result_.state.placed[i] || !Near(static_cast<int>(i), blamed)) continue;
      free[i] = 1;
      grown = true;
    }
    return grown;
  }

  absl::Status SettleFloor() {
    std::vector<char> free = Flags(start_.touched);
    Violations violations = FindViolations(input_, result_.state, start_.baseline);
    Grow(violations, free);
    for (int round = 0; round < kFloorRounds; ++round) {
      if (input_.Cancelled()) return absl::CancelledError("cancelled while solving again");
      StageSpec stage{StageKind::kPolish, -1, {}};
      for (size_t i = 0; i < free.size(); ++i) {
        if (free[i] && floor_[i] && result_.state.placed[i]) stage.objects.push_back(static_cast<int>(i));
      }
      if (stage.objects.empty() || (round > 0 && input_.OutOfTime())) return absl::OkStatus();
      const std::pair<double, double> before = Trouble(violations);
      Polish(stage, round, violations);
      const std::pair<double, double> after = Trouble(violations);
      // What more freedom has not mended once, it will not mend: not every constraint survives every edit.
      const bool in_vain = round > 0 && after.first == 0 && after == before;
      if (after == std::pair<double, double>{0, 0} || in_vain || !Grow(violations, free)) return absl::OkStatus();
    }
    return absl::OkStatus();
  }

  // One round; keeps what it finds when it is better, and says in `violations` how things stand then.
  void Polish(const StageSpec& stage, int round, Violations& violations) {
    const absl::Time began = absl::Now();
    const PartialLayout before = result_.state;
    RestartResult polished = PolishRestart(input_, stage, before, round);
    TakeBackSmallMoves(stage, before, polished.state);
    Follow(input_, before, stage.objects, polished.state);
    const Violations after = FindViolations(input_, polished.state, start_.baseline);
    const auto trouble_before = Trouble(violations), trouble_after = Trouble(after);
    bool better = trouble_after < trouble_before;
    if (trouble_after == trouble_before) {
      better = ScoreOf(input_, stage, polished.state) < ScoreOf(input_, stage, before) - kWorthMoving;
    }
    Record(stage, polished, 1, began);
    if (!better) return;
    result_.state = std::move(polished.state);
    violations = after;
  }

  // Puts those back exactly that have hardly moved, if that breaks nothing.
  void TakeBackSmallMoves(const StageSpec& stage, const PartialLayout& before, PartialLayout& after) const {
    PartialLayout taken_back = after;
    bool any = false;
    for (int object : stage.objects) {
      const Pose<double>& from = before.layout[object];
      const Pose<double>& to = after.layout[object];
      if (from == to || Distance(Center(from), Center(to)) > kNoMove_m ||
          AngleBetween(from.theta_rad, to.theta_rad) > kNoTurn_rad) {
        continue;
      }
      taken_back.layout[object] = from;
      any = true;
    }
    if (!any) return;
    const auto now = Trouble(FindViolations(input_, after, start_.baseline));
    if (Trouble(FindViolations(input_, taken_back, start_.baseline)) <= now) after = std::move(taken_back);
  }

  // Puts pieces that no edit is about back where they stood, one by one, where nothing needed them to move.
  void PutBack() {
    auto trouble = Trouble(FindViolations(input_, result_.state, start_.baseline));
    for (int object = 0; object < static_cast<int>(floor_.size()); ++object) {
      const Pose<double>& from = start_.before.layout[object];
      const bool moved = floor_[object] && !IsTouched(object) && start_.before.placed[object] &&
                         !(result_.state.layout[object] == from);
      if (!moved) continue;
      PartialLayout back = result_.state;
      back.layout[object] = from;
      Follow(input_, result_.state, std::span(&object, 1), back);
      const auto then = Trouble(FindViolations(input_, back, start_.baseline));
      if (then > trouble) continue;
      result_.state = std::move(back);
      trouble = then;
    }
  }

  // Tertiaries that have no place, lie in the way, or whose edges are broken.
  bool GrowTertiaries(const Violations& violations, std::vector<char>& free) const {
    bool grown = false;
    const auto add = [&](int object) {
      if (!tertiary_[object] || free[object]) return;
      free[object] = 1;
      grown = true;
    };
    for (int object : violations.astray) add(object);
    for (int edge : violations.broken) {
      for (int object : ObjectsOfEdge(input_, edge)) add(object);
    }
    return grown;
  }

  absl::Status SettleTertiaries() {
    std::vector<char> free(input_.scene.objects.size(), 0);
    for (int object : start_.touched) {
      const bool in_the_air = tertiary_[object] && result_.state.placed[object] &&
                              input_.scene.objects[object].kind == ObjectKind::kSurface &&
                              CarrierOf(input_.scene, object, result_.state) < 0;
      free[object] = tertiary_[object] && !in_the_air;
      if (!in_the_air) continue;
      const auto lost = start_.lost_carriers.find(object);
      PutOnLikeTop(input_, object, lost == start_.lost_carriers.end() ? nullptr : &lost->second, result_.state);
    }
    Violations violations = FindViolations(input_, result_.state, start_.baseline);
    GrowTertiaries(violations, free);
    for (int round = 0; round < kTertiaryRounds; ++round) {
      if (input_.Cancelled()) return absl::CancelledError("cancelled while solving again");
      StageSpec stage{StageKind::kTertiary, -1, {}};
      for (size_t i = 0; i < free.size(); ++i) {
        if (free[i]) stage.objects.push_back(static_cast<int>(i));
      }
      if (stage.objects.empty()) return absl::OkStatus();
      Replace(stage, violations);
      if (!GrowTertiaries(violations, free)) return absl::OkStatus();
    }
    return absl::OkStatus();
  }

  // Places the stage's tertiaries anew, all of them; keeps that when it is better or some had no place.
  void Replace(const StageSpec& stage, Violations& violations) {
    const absl::Time began = absl::Now();
    PartialLayout without = result_.state;
    bool complete = true;
    for (int object : stage.objects) {
      complete = complete && result_.state.placed[object];
      without.placed[object] = 0;
      without.layout[object] = FarAway(object);
    }
    const RestartResult placed = TertiaryRestart(input_, stage, without, 0);
    Record(stage, placed, 1, began);
    const Violations after = FindViolations(input_, placed.state, start_.baseline);
    const size_t now = violations.astray.size() + violations.broken.size();
    const size_t then = after.astray.size() + after.broken.size();
    const bool better =
        !complete || then < now ||
        (then == now && ScoreOf(input_, stage, placed.state) < ScoreOf(input_, stage, result_.state) - kWorthMoving);
    if (!better) return;
    result_.state = placed.state;
    violations = after;
  }

  const SolveInput& input_;
  const WarmStart& start_;
  std::vector<char> floor_, tertiary_;
  WarmResult result_;
};

}  // namespace

absl::StatusOr<WarmResult> SearchWarm(const SolveInput& input, const WarmStart& start) {
  return WarmSearch(input, start).Run();
}

}  // namespace flair::optimizer
