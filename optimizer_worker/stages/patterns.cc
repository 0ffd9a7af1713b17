// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/patterns.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "optimizer_worker/solver/hard_cost.h"
#include "optimizer_worker/solver/search.h"
#include "optimizer_worker/stages/pattern_slots.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {
namespace {

// Hard terms up to this are rounding.
constexpr double kNoOverlap = 1e-9, kOverlap_m = 1e-6;
// So many of the best of each heading are kept for a closer look; so many of those become starts.
constexpr int kKeptOfHeading = 4;
constexpr size_t kStarts = 4;
constexpr double kAlike_rad = 0.1;
// So many companions of a pattern are placed to judge it.
constexpr size_t kCompanions = 3;
// How often all pairs may change places.
constexpr int kExchanges = 4;
// Behind whoever sits there: what half a way takes, or less where that does not fit.
constexpr double kBehind_m[] = {0.3, 0.15, 0};
// How many arrangements of a group are tried.
constexpr size_t kArrangements = 2;

struct Pattern {
  std::vector<Pose<double>> poses;
  double cost = 0;
};

// Whether calls put their first pieces, or of islands and parts of rows any, beside each other.
bool AreTied(const SolveInput& input, const Group& a, const Group& b) {
  const auto heads = [](const Group& group) { return group.block ? group.objects.size() : 1; };
  for (size_t i = 0; i < heads(a); ++i) {
    for (size_t k = 0; k < heads(b); ++k) {
      if (input.linked.TieOf(a.objects[i], b.objects[k]) > 0) return true;
    }
  }
  return false;
}

class PatternPlacer {
 public:
  PatternPlacer(const SolveInput& input, const StageSpec& stage, const std::vector<int>& groups)
      : input_(input), stage_(stage), groups_(groups) {
    for (int g : groups) {
      const std::vector<int>& objects = input.groups.all[g].objects;
      objects_.insert(objects_.end(), objects.begin(), objects.end());
      for (int other : groups) {
        const bool tied = other != g && AreTied(input, input.groups.all[g], input.groups.all[other]);
        const int first = input.groups.all[other].objects[0];
        tied_ = tied_ || tied;
        close_ = close_ || (tied && input.scene.objects[objects[0]].zone == input.scene.objects[first].zone);
      }
    }
  }

  // The best few places of the pattern among what stands, best first.
  std::vector<PartialLayout> Place(const PartialLayout& before, size_t most) {
    const std::vector<Vec2<double>> centers = ZoneCenters(input_.scene, before.placed, before.layout);
    const SceneCosts costs = BindCosts(input_, centers);
    const SearchInput search_input = SearchInputOf(input_, centers, &input_.walk_grid.get());
    const std::vector<int> companions = Companions(before);
    std::vector<int> free = objects_;
    free.insert(free.end(), companions.begin(), companions.end());
    LayoutSearch search(search_input, MakeProblem(input_, costs, {stage_.kind, stage_.zone, free}, before),
                        before.layout);
    Problem& problem = search.problem();
    HardCost hard(input_.scene, input_.keep_out, problem);
    hard.Prepare(input_.groups.all[groups_[0]].objects, problem, before.layout);
    for (int object : objects_) problem.SetPlaced(object, true);
    problem.Hold(objects_, before.layout, true);
    Rank(search, hard);
    for (Pattern& pattern : best_) {
      Layout layout = before.layout;
      for (size_t k = 0; k < objects_.size(); ++k) layout[objects_[k]] = pattern.poses[k];
      Exchange(problem, layout);
      for (size_t k = 0; k < objects_.size(); ++k) pattern.poses[k] = layout[objects_[k]];
      search.set_layout(layout);
      Random random(RestartSeed(input_.settings, stage_, 0));
      search.Construct(companions, 0, random);
      pattern.cost = search.Score() + DisorderOf(input_, groups_, layout);
      for (int object : companions) problem.SetPlaced(object, false);
    }
    // Rows along the walls of a room that is no rectangle may cross.
    std::erase_if(best_, [&](const Pattern& pattern) {
      Layout layout = before.layout;
      for (size_t k = 0; k < objects_.size(); ++k) layout[objects_[k]] = pattern.poses[k];
      return !FindViolations(input_.scene, input_.keep_out, objects_, layout, kOverlap_m).empty();
    });
    std::stable_sort(best_.begin(), best_.end(), [](const Pattern& a, const Pattern& b) { return a.cost < b.cost; });
    std::vector<PartialLayout> placed;
    for (size_t i = 0; i < std::min(most, best_.size()); ++i) {
      PartialLayout& layout = placed.emplace_back(before);
      for (size_t k = 0; k < objects_.size(); ++k) layout.Place(objects_[k], best_[i].poses[k]);
    }
    return placed;
  }

 private:
  // What else is to be placed and calls name with the pattern, largest first: the teacher's desk belongs before the
  // rows.
  std::vector<int> Companions(const PartialLayout& before) const {
    std::vector<int> companions;
    for (int object : stage_.objects) {
      const auto is_partner = [&](int member) {
        const std::vector<int>& partners = input_.partners[member];
        return std::find(partners.begin(), partners.end(), object) != partners.end();
      };
      if (before.placed[object] || std::find(objects_.begin(), objects_.end(), object) != objects_.end()) continue;
      if (std::any_of(objects_.begin(), objects_.end(), is_partner)) companions.push_back(object);
    }
    std::stable_sort(companions.begin(), companions.end(), [&](int a, int b) {
      return input_.scene.objects[a].footprint.area_m2() > input_.scene.objects[b].footprint.area_m2();
    });
    if (companions.size() > kCompanions) companions.resize(kCompanions);
    return companions;
  }

  // Among places with room behind the seats, and with ways between those that nothing puts side by side; without where
  // there are none.
  void Rank(LayoutSearch& search, const HardCost& hard) {
    size_t arrangements = kArrangements;
    for (int g : groups_) arrangements = std::min(arrangements, input_.groups.all[g].arrangements.size());
    for (const Ways ways : {Ways::kAllRound, Ways::kSideways, Ways::kNone}) {
      for (double room_m : kBehind_m) {
        for (size_t a = 0; a < arrangements && (ways == Ways::kNone || !close_); ++a) {
          if (ways == Ways::kAllRound && (tied_ || !SitsAcross(a))) continue;
          ForEachPattern(input_.scene.room, Roomy(a, room_m), static_cast<int>(groups_.size()), ways,
                         [&](const auto& slots) { Try(slots, a, search, hard); });
        }
        if (!best_.empty()) return;
      }
    }
  }

  // Groups that are tied to each other change places while that helps.
  void Exchange(Problem& problem, Layout& layout) const {
    const std::vector<Group>& all = input_.groups.all;
    if (!tied_) return;
    const auto cost = [&](int a, int b) {
      double sum = 0;
      for (int g : {a, b}) {
        for (int object : all[g].objects) sum += problem.Around(object, layout, HUGE_VAL);
      }
      return sum;
    };
    const auto swap = [&](int a, int b) {
      for (size_t k = 0; k < all[a].objects.size(); ++k)
        std::swap(layout[all[a].objects[k]], layout[all[b].objects[k]]);
    };
    bool better = true;
    for (int round = 0; better && round < kExchanges; ++round) {
      better = false;
      for (size_t i = 0; i < groups_.size(); ++i) {
        for (size_t k = 0; k < i; ++k) {
          if (all[groups_[k]].objects.size() != all[groups_[i]].objects.size()) continue;
          const double before = cost(groups_[k], groups_[i]);
          swap(groups_[k], groups_[i]);
          if (cost(groups_[k], groups_[i]) < before - kNoOverlap) {
            better = true;
          } else {
            swap(groups_[k], groups_[i]);
          }
        }
      }
    }
  }

  // Whether members stand at opposite sides of the first piece, as chairs do at a table: it has no back that another
  // one could stand against.
  bool SitsAcross(size_t arrangement) const {
    const Group& group = input_.groups.all[groups_[0]];
    const BoundingBox own = BoxOf(input_.scene, group, group.arrangements[arrangement]);
    const Footprint& first = input_.scene.objects[group.objects[0]].footprint;
    const double u = first.width_m / 2 + kOverlap_m, v = first.depth_m / 2 + kOverlap_m;
    return (own.min.x < -u && own.max.x > u) || (own.min.y < -v && own.max.y > v);
  }

  // The box round every one of the groups, so much larger where members stand before the first piece.
  BoundingBox Roomy(size_t arrangement, double room_m) const {
    BoundingBox box{{0, 0}, {0, 0}};
    for (int g : groups_) {
      const Group& group = input_.groups.all[g];
      const BoundingBox own = BoxOf(input_.scene, group, group.arrangements[arrangement]);
      const Footprint& first = input_.scene.objects[group.objects[0]].footprint;
      const double u = first.width_m / 2 + kOverlap_m, v = first.depth_m / 2 + kOverlap_m;
      box.min.x = std::min(box.min.x, own.min.x - (own.min.x < -u ? room_m : 0));
      box.max.x = std::max(box.max.x, own.max.x + (own.max.x > u ? room_m : 0));
      box.min.y = std::min(box.min.y, own.min.y - (own.min.y < -v ? room_m : 0));
      box.max.y = std::max(box.max.y, own.max.y + (own.max.y > v ? room_m : 0));
    }
    return box;
  }

  // Takes the first of those slots that nothing is in the way of, as it would be for the first group. Groups that are
  // tied may begin at either end, and at either end of the rows.
  void Try(std::vector<Pose<double>> slots, size_t arrangement, LayoutSearch& search, const HardCost& hard) {
    for (int turn = 0; turn < (tied_ ? 4 : 1); ++turn) {
      if (turn == 2) std::reverse(slots.begin(), slots.end());
      if (turn % 2 == 1) {
        TurnRows();
      } else if (!Free(slots, arrangement, hard)) {
        return;
      }
      all_.clear();
      for (size_t k = 0; k < groups_.size(); ++k) {
        PoseGroup(input_.groups.all[groups_[k]].arrangements[arrangement], free_[k], one_);
        all_.insert(all_.end(), one_.begin(), one_.end());
      }
      Offer(search);
    }
  }

  // Reverses every row of free_.
  void TurnRows() {
    for (auto first = free_.begin(); first != free_.end();) {
      const auto last = std::find_if(first, free_.end(), [&](const Pose<double>& slot) {
        return std::abs(FrameOf(*first).ToObject(Center(slot)).y) > kOverlap_m ||
               AngleBetween(first->theta_rad, slot.theta_rad) > kAlike_rad;
      });
      std::reverse(first, last);
      first = last;
    }
  }

  // The first free of `slots` into free_; false when they are too few.
  bool Free(const std::vector<Pose<double>>& slots, size_t arrangement, const HardCost& hard) {
    free_.clear();
    for (size_t i = 0; i < slots.size() && free_.size() < groups_.size(); ++i) {
      PoseGroup(input_.groups.all[groups_[0]].arrangements[arrangement], slots[i], one_);
      if (hard.At(one_, kNoOverlap) <= kNoOverlap) free_.push_back(slots[i]);
      if (free_.size() + slots.size() - i <= groups_.size() && free_.size() < groups_.size()) return false;
    }
    return free_.size() == groups_.size();
  }

  // Keeps all_ among the best that look its way, by what it costs and how one can walk.
  void Offer(LayoutSearch& search) {
    const auto looks_alike = [&](const Pattern& other) {
      return AngleBetween(other.poses[0].theta_rad, all_[0].theta_rad) < kAlike_rad;
    };
    const auto worst = std::find_if(best_.rbegin(), best_.rend(), looks_alike);
    const bool full = std::count_if(best_.begin(), best_.end(), looks_alike) >= kKeptOfHeading;
    const double limit = full ? worst->cost : HUGE_VAL;
    double cost = search.problem().AroundHeld(all_, limit);
    if (cost >= limit) return;
    Layout layout = search.layout();
    for (size_t k = 0; k < objects_.size(); ++k) layout[objects_[k]] = all_[k];
    cost += DisorderOf(input_, groups_, layout);
    if (cost >= limit) return;
    search.set_layout(layout);
    cost += search.WalkPenalty();
    if (cost >= limit) return;
    if (full) best_.erase(std::next(worst).base());
    const auto place = std::upper_bound(best_.begin(), best_.end(), cost,
                                        [](double value, const Pattern& other) { return value < other.cost; });
    best_.insert(place, {all_, cost});
  }

  const SolveInput& input_;
  const StageSpec& stage_;
  const std::vector<int>& groups_;
  std::vector<int> objects_;
  std::vector<Pattern> best_;
  std::vector<Pose<double>> all_, one_, free_;
  // Whether calls put some of the groups beside each other.
  bool tied_ = false;
  // Whether they do so within a zone: side by side.
  bool close_ = false;
};

bool IsIn(const StageSpec& stage, int object) {
  return std::find(stage.objects.begin(), stage.objects.end(), object) != stage.objects.end();
}

double AreaOf(const SolveInput& input, const std::vector<int>& groups) {
  double area = 0;
  for (int g : groups) {
    for (int object : input.groups.all[g].objects) area += input.scene.objects[object].footprint.area_m2();
  }
  return area;
}

// As it is, and with the other primaries placed before the patterns: the counter of a café has its wall then.
std::vector<PartialLayout> WithOthersFirst(const SolveInput& input, const StageSpec& stage,
                                           const std::vector<std::vector<int>>& patterns, const PartialLayout& before) {
  std::vector<int> others;
  for (int object : stage.objects) {
    const bool is_in_pattern = std::any_of(patterns.begin(), patterns.end(), [&](const std::vector<int>& pattern) {
      return std::find(pattern.begin(), pattern.end(), input.groups.of[object]) != pattern.end();
    });
    const bool primary = input.scene.objects[object].role == ObjectRole::kPrimary;
    if (primary && !is_in_pattern && !before.placed[object]) others.push_back(object);
  }
  if (others.empty()) return {before};
  const std::vector<Vec2<double>> centers = ZoneCenters(input.scene, before.placed, before.layout);
  const SceneCosts costs = BindCosts(input, centers);
  const SearchInput search_input = SearchInputOf(input, centers, &input.walk_grid.get());
  LayoutSearch search(search_input, MakeProblem(input, costs, {stage.kind, stage.zone, others}, before), before.layout);
  Random random(RestartSeed(input.settings, stage, 0));
  search.Construct(others, 0, random);
  PartialLayout ahead = before;
  for (int object : others) ahead.Place(object, search.layout()[object]);
  return {before, ahead};
}

}  // namespace

std::vector<PartialLayout> PlacePatterns(const SolveInput& input, const StageSpec& stage, const PartialLayout& before) {
  std::vector<PartialLayout> starts = {before};
  if (input.OutOfTime() || input.Cancelled()) return starts;
  std::vector<std::vector<int>> patterns = input.groups.patterns;
  std::stable_sort(patterns.begin(), patterns.end(),
                   [&](const auto& a, const auto& b) { return AreaOf(input, a) > AreaOf(input, b); });
  for (std::vector<int>& pattern : patterns) {
    std::erase_if(pattern, [&](int g) {
      const std::vector<int>& objects = input.groups.all[g].objects;
      return input.groups.all[g].arrangements.empty() ||
             std::any_of(objects.begin(), objects.end(), [&](int o) { return !IsIn(stage, o) || before.placed[o]; });
    });
    if (pattern.size() < 2) continue;
    if (starts.size() == 1) starts = WithOthersFirst(input, stage, patterns, starts[0]);
    std::vector<PartialLayout> next;
    for (const PartialLayout& start : starts) {
      const size_t most = starts.size() < kStarts ? kStarts / starts.size() : 1;
      std::vector<PartialLayout> placed = PatternPlacer(input, stage, pattern).Place(start, most);
      if (placed.empty()) placed.push_back(start);
      std::move(placed.begin(), placed.end(), std::back_inserter(next));
    }
    starts = std::move(next);
  }
  return starts;
}

}  // namespace flair::optimizer
