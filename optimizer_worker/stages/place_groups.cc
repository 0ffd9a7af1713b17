// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/place_groups.h"

#include <algorithm>
#include <cmath>

#include "optimizer_worker/solver/candidates.h"
#include "optimizer_worker/solver/hard_cost.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {
namespace {

constexpr CandidateDensity kOfGroups{.wall_samples = 3, .floor_samples = 20, .partner_samples = 1};

class GroupPlacer {
 public:
  GroupPlacer(const SolveInput& input, const SearchInput& search_input, LayoutSearch& search)
      : input_(input),
        search_input_(search_input),
        search_(search),
        hard_(input.scene, input.keep_out, search.problem()) {}

  void Place(const Group& group, double noise, Random& random) {
    if (group.objects.size() == 1 || group.arrangements.empty() || search_input_.Stopped()) {
      search_.Construct(group.objects, noise, random);
      return;
    }
    Context(group);
    const double together = Together(group, noise, random);
    const std::vector<Pose<double>> best = best_;
    search_.Construct(group.objects, noise, random);
    Layout layout = search_.layout();
    if (CostOf(group, layout) <= together) return;
    for (size_t k = 0; k < best.size(); ++k) layout[group.objects[k]] = best[k];
    search_.set_layout(layout);
  }

 private:
  double CostOf(const Group& group, const Layout& layout) {
    std::vector<Pose<double>> poses;
    for (int object : group.objects) poses.push_back(layout[object]);
    search_.problem().Hold(group.objects, layout, false);
    return search_.problem().AroundHeld(poses, HUGE_VAL);
  }

  // What stands, and what of it the group's objects are named with.
  void Context(const Group& group) {
    placed_.clear();
    partners_.clear();
    for (int i = 0; i < search_.problem().object_count(); ++i) {
      if (search_.problem().placed(i)) placed_.push_back(i);
    }
    for (int object : group.objects) {
      for (int partner : input_.partners[object]) {
        if (search_.problem().placed(partner)) partners_.push_back(partner);
      }
    }
    std::sort(partners_.begin(), partners_.end());
    partners_.erase(std::unique(partners_.begin(), partners_.end()), partners_.end());
  }

  // The least cost of the group as one piece, its poses in best_.
  double Together(const Group& group, double noise, Random& random) {
    Problem& problem = search_.problem();
    hard_.Prepare(group.objects, problem, search_.layout());
    for (int object : group.objects) problem.SetPlaced(object, true);
    problem.Hold(group.objects, search_.layout(), true);
    double least = HUGE_VAL;
    best_.clear();
    for (const Arrangement& arrangement : group.arrangements) {
      Propose(group, arrangement, random);
      for (const Pose<double>& candidate : candidates_) {
        PoseGroup(arrangement, candidate, poses_);
        double cost = noise > 0 ? noise * random.Uniform() : 0.0;
        cost += hard_.At(poses_, least - cost);
        if (cost >= least) continue;
        cost += problem.AroundHeld(poses_, least - cost);
        if (cost >= least) continue;
        least = cost;
        best_ = poses_;
      }
    }
    for (int object : group.objects) problem.SetPlaced(object, false);
    return least;
  }

  // Poses of the first piece: its own, and those that bring the box round the group to walls and partners.
  void Propose(const Group& group, const Arrangement& arrangement, Random& random) {
    candidates_.clear();
    CandidateContext context{input_.scene, search_.layout(), placed_, partners_, search_input_.zone_centers};
    ProposeCandidates(context, group.objects[0], kOfGroups, random, candidates_);
    const BoundingBox box = BoxOf(input_.scene, group, arrangement);
    const Footprint footprint{box.width_m(), box.height_m()};
    context.box = &footprint;
    const size_t own = candidates_.size();
    ProposeCandidates(context, group.objects[0], kOfGroups, random, candidates_);
    const Vec2<double> center = box.Center();
    for (size_t i = own; i < candidates_.size(); ++i) {
      const Vec2<double> p = FrameOf(candidates_[i]).ToRoom(-center.x, -center.y);
      candidates_[i].x_m = p.x;
      candidates_[i].y_m = p.y;
    }
  }

  const SolveInput& input_;
  const SearchInput& search_input_;
  LayoutSearch& search_;
  HardCost hard_;
  std::vector<int> placed_, partners_;
  std::vector<Pose<double>> candidates_, poses_, best_;
};

}  // namespace

void PlaceGroups(const SolveInput& input, const SearchInput& search_input, std::span<const Group> groups, double noise,
                 Random& random, LayoutSearch& search) {
  GroupPlacer placer(input, search_input, search);
  for (const Group& group : groups) placer.Place(group, noise, random);
}

}  // namespace flair::optimizer
