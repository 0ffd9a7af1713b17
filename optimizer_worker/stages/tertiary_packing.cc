// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "optimizer_worker/constraints/whole_room.h"
#include "optimizer_worker/stages/tertiary.h"

namespace flair::optimizer {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kTouches_m = 1e-9;
// How many of an object's places are tried below each of the ones before it, and how many steps a search may take.
constexpr size_t kBreadth = 4;
constexpr int kSteps = 40;
// The same when the cheap places leave no room for all: what counts is that they fit.
constexpr int kStepsToFit = 100;
// For all clusters of a layout.
constexpr int kMostSteps = 600;
// What is further away than this from a cluster of overlapping objects is not in its way.
constexpr double kNear_m = 0.5;

// Of what is in each other's way; infinite for two of which neither can be in the other's.
double GapOf(const Scene& scene, int a, int b, const Layout& layout) {
  const auto gap = [&](const Footprint& first, const Footprint& second) {
    return Separate(Box<double>(first, FrameOf(layout[a])), Box<double>(second, FrameOf(layout[b]))).gap_m;
  };
  const Footprint& first = scene.objects[a].footprint;
  const Footprint& second = scene.objects[b].footprint;
  if (const std::optional<Footprint> below = OpeningBelow(scene, a, b)) return gap(first, *below);
  if (const std::optional<Footprint> below = OpeningBelow(scene, b, a)) return gap(*below, second);
  return CanCollide(scene, a, b) ? gap(first, second) : kNever;
}

bool IsTooLarge(const Scene& scene, int object, const PartialLayout& state) {
  if (scene.objects[object].kind != ObjectKind::kSurface) return false;
  const int carrier = CarrierOf(scene, object, state);
  return carrier < 0 || !FitsOn(scene, object, carrier);
}

bool Contains(const std::vector<int>& objects, int object) {
  return std::find(objects.begin(), objects.end(), object) != objects.end();
}

// One cluster of overlapping objects: finds the cheapest places of its objects among everything else.
class Packing {
 public:
  // Objects in `ignored` are in nobody's way; `anywhere` frees things from their tops. Borrows all.
  Packing(const SolveInput& input, Problem& problem, const PartialLayout& state, std::vector<int> group,
          const std::vector<int>& ignored, bool strict, bool anywhere = false)
      : input_(input),
        problem_(problem),
        before_(state),
        layout_(state.layout),
        group_(std::move(group)),
        ignored_(ignored),
        strict_(strict) {
    for (int object : group_) {
      const bool stands = input.scene.objects[object].kind == ObjectKind::kSurface && !anywhere;
      carriers_.push_back(stands ? CarrierOf(input.scene, object, state) : -1);
    }
  }

  // The best layout found into `state`; false when there is none. Takes what it needs off `steps_left`.
  bool Run(int& steps_left, PartialLayout& state) {
    for (int object : group_) TakeOut(object);
    Search(kBreadth, kSteps, steps_left);
    first_only_ = true;
    if (best_ == kNever) Search(std::numeric_limits<size_t>::max(), kStepsToFit, steps_left);
    for (int object : group_) problem_.SetPlaced(object, true);
    if (best_ == kNever) return false;
    state.layout = best_layout_;
    return true;
  }

 private:
  struct Choice {
    Pose<double> pose;
    double cost;
  };

  // One search per order, of `steps` each.
  void Search(size_t breadth, int steps, int& steps_left) {
    breadth_ = breadth;
    for (const std::vector<int>& order : Orders()) {
      const int allowed = std::min(steps, steps_left);
      steps_ = allowed;
      Extend(order, 0, 0);
      steps_left -= allowed - std::max(steps_, 0);
      if (first_only_ && best_ < kNever) return;
    }
  }

  void TakeOut(int object) {
    problem_.SetPlaced(object, false);
    layout_[object] = FarAway(object);
  }

  int CarrierOfMember(int object) const {
    return carriers_[static_cast<size_t>(std::find(group_.begin(), group_.end(), object) - group_.begin())];
  }

  // As they come, the largest first, the smallest first; carriers always before what they carry.
  std::vector<std::vector<int>> Orders() const {
    const auto area = [&](int object) { return input_.scene.objects[object].footprint.area_m2(); };
    std::vector<std::vector<int>> orders(3, group_);
    std::stable_sort(orders[1].begin(), orders[1].end(), [&](int a, int b) { return area(a) > area(b); });
    std::stable_sort(orders[2].begin(), orders[2].end(), [&](int a, int b) { return area(a) < area(b); });
    for (std::vector<int>& order : orders) CarriersFirst(order);
    return orders;
  }
  void CarriersFirst(std::vector<int>& order) const {
    for (size_t moved = 0; moved < order.size() * order.size(); ++moved) {
      bool sorted = true;
      for (size_t i = 0; i < order.size() && sorted; ++i) {
        const auto carrier = std::find(order.begin() + static_cast<long>(i), order.end(), CarrierOfMember(order[i]));
        if (carrier == order.end()) continue;
        std::rotate(order.begin() + static_cast<long>(i), carrier, carrier + 1);
        sorted = false;
      }
      if (sorted) return;
    }
  }

  // The places in which `object` is in nobody's way, the cheapest first, none of `limit` or more.
  std::vector<Choice> ChoicesFor(int object, double limit) {
    std::vector<int> others;
    for (int other = 0; other < problem_.object_count(); ++other) {
      if (other != object && problem_.placed(other) && CanMeet(object, other)) others.push_back(other);
    }
    const PlaceContext context{input_, layout_, others, CarrierOfMember(object), before_.layout[object]};
    std::vector<Choice> choices;
    problem_.SetPlaced(object, true);
    for (const Pose<double>& pose : ExactPlaces(context, object)) {
      layout_[object] = pose;
      const bool free = std::ranges::none_of(
          others, [&](int other) { return GapOf(input_.scene, object, other, layout_) < -kTouches_m; });
      if (!free) continue;
      const double cost = problem_.Around(object, layout_, limit);
      if (cost < limit) choices.push_back({pose, cost});
    }
    TakeOut(object);
    std::stable_sort(choices.begin(), choices.end(), [](const Choice& a, const Choice& b) { return a.cost < b.cost; });
    // A full top is filled from its corners: what stands in the middle leaves strips that nothing fits into.
    const int carrier = CarrierOfMember(object);
    if (first_only_ && carrier >= 0) {
      const auto from_middle = [&middle = layout_[carrier]](const Choice& choice) {
        return std::hypot(choice.pose.x_m - middle.x_m, choice.pose.y_m - middle.y_m);
      };
      std::stable_sort(choices.begin(), choices.end(),
                       [&](const Choice& a, const Choice& b) { return from_middle(a) > from_middle(b); });
    }
    return choices;
  }

  bool CanMeet(int a, int b) const {
    if (Contains(ignored_, b)) return false;
    if (!strict_ && (IsFlat(input_.scene.objects[a]) || IsFlat(input_.scene.objects[b]))) return false;
    return CanCollide(input_.scene, a, b) || OpeningBelow(input_.scene, a, b);
  }

  void Extend(const std::vector<int>& order, size_t depth, double cost) {
    if (depth == order.size()) {
      best_ = cost;
      best_layout_ = layout_;
      return;
    }
    if (--steps_ < 0) return;
    const int object = order[depth];
    const std::vector<Choice> choices = ChoicesFor(object, best_ - cost);
    for (size_t k = 0; k < std::min(choices.size(), breadth_); ++k) {
      if (cost + choices[k].cost >= best_ || (first_only_ && best_ < kNever)) return;
      problem_.SetPlaced(object, true);
      layout_[object] = choices[k].pose;
      Extend(order, depth + 1, cost + choices[k].cost);
      TakeOut(object);
    }
  }

  const SolveInput& input_;
  Problem& problem_;
  const PartialLayout& before_;
  Layout layout_, best_layout_;
  std::vector<int> group_;
  std::vector<int> carriers_;
  const std::vector<int>& ignored_;
  bool strict_, first_only_ = false;
  double best_ = kNever;
  size_t breadth_ = kBreadth;
  int steps_ = 0;
};

// Which of the stage's objects may be moved, and what is in whose way.
class OverlapClusters {
 public:
  OverlapClusters(const SolveInput& input, const StageSpec& stage, const PartialLayout& state, bool strict)
      : input_(input), state_(state), strict_(strict) {
    for (int object : stage.objects) {
      if (input.scene.objects[object].kind != ObjectKind::kFloor && state.placed[object]) movable_.push_back(object);
    }
  }

  // The first movable object that is in anything's way and all that are in its or each other's, without those in
  // `given_up`; empty when there is none.
  std::vector<int> First(const std::vector<int>& given_up) const {
    for (int object : movable_) {
      if (Contains(given_up, object) || !Overlaps(object, given_up)) continue;
      std::vector<int> group = {object};
      for (size_t next = 0; next < group.size(); ++next) {
        for (int other : movable_) {
          if (Contains(group, other) || Contains(given_up, other)) continue;
          if (InTheWay(input_.scene, group[next], other, state_.layout, strict_)) group.push_back(other);
        }
      }
      return WithRiders(std::move(group));
    }
    return {};
  }

  // Whether anything but `given_up` is in its way.
  bool Overlaps(int object, const std::vector<int>& given_up) const {
    for (int other = 0; other < static_cast<int>(state_.placed.size()); ++other) {
      if (!Contains(given_up, other) && state_.placed[other] &&
          InTheWay(input_.scene, object, other, state_.layout, strict_))
        return true;
    }
    return false;
  }

  // The group and all movable objects near it that could be in its way.
  std::vector<int> Wider(std::vector<int> group, const std::vector<int>& given_up) const {
    const std::vector<int> core = group;
    for (int other : movable_) {
      const bool near = std::ranges::any_of(
          core, [&](int object) { return GapOf(input_.scene, object, other, state_.layout) < kNear_m; });
      if (near && !Contains(group, other) && !Contains(given_up, other)) group.push_back(other);
    }
    return WithRiders(std::move(group));
  }

 private:
  std::vector<int> WithRiders(std::vector<int> group) const {
    for (size_t next = 0; next < group.size(); ++next) {
      for (int other : movable_) {
        if (input_.scene.objects[other].host == group[next] && !Contains(group, other)) group.push_back(other);
      }
    }
    return group;
  }

  const SolveInput& input_;
  const PartialLayout& state_;
  bool strict_;
  std::vector<int> movable_;
};

}  // namespace

bool InTheWay(const Scene& scene, int a, int b, const Layout& layout, bool strict) {
  if (!strict && (IsFlat(scene.objects[a]) || IsFlat(scene.objects[b]))) return false;
  return GapOf(scene, a, b, layout) < -kTouches_m;
}

void SeparateClusters(const SolveInput& input, const StageSpec& stage, Problem& problem, PartialLayout& state) {
  int steps_left = kMostSteps;
  for (const bool strict : {true, false}) {
    const OverlapClusters clusters(input, stage, state, strict);
    std::vector<int> given_up;
    const auto pack = [&](const std::vector<int>& members) {
      return Packing(input, problem, state, members, given_up, strict).Run(steps_left, state);
    };
    while (!input.Cancelled() && steps_left > 0) {
      const std::vector<int> group = clusters.First(given_up);
      if (group.empty()) break;
      if (pack(group)) continue;
      const std::vector<int> wider = clusters.Wider(group, given_up);
      if (wider.size() > group.size() && pack(wider)) continue;
      // The rest may fit without the largest.
      given_up.push_back(*std::max_element(group.begin(), group.end(), [&](int a, int b) {
        return input.scene.objects[a].footprint.area_m2() < input.scene.objects[b].footprint.area_m2();
      }));
    }
    // And that beside the rest after all; what is larger than its top, at worst beside that.
    const std::vector<int> left = std::move(given_up);
    given_up.clear();
    for (int object : left) {
      if (!clusters.Overlaps(object, {}) || pack({object}) || !IsTooLarge(input.scene, object, state)) continue;
      // A cloth stays where it hangs over; things may lie on it.
      if (strict && IsFlat(input.scene.objects[object])) continue;
      Packing(input, problem, state, {object}, given_up, strict, true).Run(steps_left, state);
    }
  }
}

}  // namespace flair::optimizer
