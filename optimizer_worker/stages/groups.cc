// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/groups.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "fmt/format.h"
#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/stages/place_groups.h"
#include "optimizer_worker/stages/solve_input.h"

namespace flair::optimizer {
namespace {

// A table and its seats; more would be a room, not a group.
constexpr size_t kMostMembers = 17;
// An island of desks or what is side by side in a row; more are rows of themselves.
constexpr size_t kMostInBlock = 12;

// Pieces of the same make: they have the same name but for a number, and are as large to a hand's breadth or two.
using Make = std::tuple<std::string, int, int, bool>;
Make MakeOf(const Object& object) {
  const auto rounded = [](double size_m) { return static_cast<int>(std::lround(size_m / 0.25)); };
  const size_t end = object.name.find_last_not_of("0123456789_ ");
  return {object.name.substr(0, end + 1), rounded(object.footprint.width_m), rounded(object.footprint.depth_m),
          object.walk_over};
}

class GroupFinder {
 public:
  explicit GroupFinder(const SolveInput& input)
      : input_(input), scene_(input.scene), parent_(scene_.objects.size(), -1) {}

  Groups Find() {
    FindBlocks();
    FindParents();
    CutOddOnes();
    Gather();
    FindPatterns();
    Finish();
    return std::move(groups_);
  }

 private:
  bool MayJoin(int object) const {
    const Object& what = scene_.objects[object];
    return what.kind == ObjectKind::kFloor && !input_.pinned[object] &&
           (what.role != ObjectRole::kTertiary || !what.walk_over);
  }

  // Pieces of a make and a zone that calls put side to side, named sides, or in a row: an island of desks, lockers.
  void FindBlocks() {
    block_.resize(parent_.size());
    for (size_t i = 0; i < block_.size(); ++i) block_[i] = static_cast<int>(i);
    for (const v1::ConstraintEdge& edge : input_.graph.edges()) {
      const auto sides = std::ranges::count_if(edge.arguments(), [](const auto& argument) {
        return argument.name() == "object_side" || argument.name() == "target_side";
      });
      const std::vector<int> named = NamedObjects(edge, scene_);
      if (edge.type() != "row" && (edge.type() != "next_to" || sides != 2)) continue;
      for (size_t k = 0; k + 1 < named.size(); ++k) JoinBlocks(named[k], named[k + 1]);
    }
  }
  void JoinBlocks(int a, int b) {
    const Object &one = scene_.objects[a], &other = scene_.objects[b];
    if (one.zone != other.zone || MakeOf(one) != MakeOf(other) || !MayJoin(a) || !MayJoin(b)) return;
    const int from = block_[a], to = block_[b];
    std::replace(block_.begin(), block_.end(), std::max(from, to), std::min(from, to));
  }
  bool AreInBlock(int a, int b) const {
    return block_[a] == block_[b] &&
           static_cast<size_t>(std::count(block_.begin(), block_.end(), block_[a])) <= kMostInBlock;
  }
  bool IsInBlock(int object) const {
    const auto size = static_cast<size_t>(std::count(block_.begin(), block_.end(), block_[object]));
    return size > 1 && size <= kMostInBlock;
  }
  // Whether its first piece has others of its make in the group.
  bool IsBlock(const Group& group) const {
    return std::any_of(group.objects.begin() + 1, group.objects.end(),
                       [&](int o) { return AreInBlock(group.objects[0], o); });
  }

  // Largest first: each belongs to the one before it that it is tied to most. Many of a make do not belong to each
  // other, unless in a block: they make rows.
  void FindParents() {
    for (int i = 0; i < static_cast<int>(parent_.size()); ++i) {
      if (MayJoin(i)) order_.push_back(i);
    }
    // What stands side by side keeps together, even where the chairs before it are larger.
    std::stable_sort(order_.begin(), order_.end(), [&](int a, int b) {
      const auto rank = [&](int o) { return std::pair(IsInBlock(o), scene_.objects[o].footprint.area_m2()); };
      return rank(a) > rank(b);
    });
    for (int object : order_) ++common_[MakeOf(scene_.objects[object])];
    std::map<int, size_t> members;
    std::map<int, int> root;
    for (size_t i = 0; i < order_.size(); ++i) {
      const int object = order_[i];
      double most = 0;
      for (size_t k = 0; k < i; ++k) {
        const bool alike = MakeOf(scene_.objects[order_[k]]) == MakeOf(scene_.objects[object]);
        const bool row = alike && common_[MakeOf(scene_.objects[object])] >= kFewestAlike;
        const bool block = AreInBlock(order_[k], object);
        const double tie = block ? HUGE_VAL : input_.linked.TieOf(order_[k], object);
        if (tie <= most || (row && !block) || members[root[order_[k]]] >= kMostMembers) continue;
        most = tie;
        parent_[object] = order_[k];
      }
      root[object] = parent_[object] < 0 ? object : root[parent_[object]];
      ++members[root[object]];
    }
    JoinLoneOnes(members, root);
  }

  // What stands beside a smaller piece of a larger one's group belongs to that group: the refrigerator at the end of a
  // run, the second bed at the nightstand between two.
  void JoinLoneOnes(const std::map<int, size_t>& members, const std::map<int, int>& root) {
    for (size_t i = 0; i < order_.size(); ++i) {
      const int object = order_[i];
      if (members.at(root.at(object)) > 1 || common_[MakeOf(scene_.objects[object])] >= kFewestAlike) continue;
      double most = 0;
      for (size_t k = i + 1; k < order_.size(); ++k) {
        const double tie = input_.linked.TieOf(object, order_[k]);
        const int other = root.at(order_[k]);
        const bool larger = std::find(order_.begin(), order_.begin() + static_cast<int>(i), other) !=
                            order_.begin() + static_cast<int>(i);
        if (tie <= most || !larger || members.at(other) + 1 > kMostMembers) continue;
        most = tie;
        parent_[object] = order_[k];
      }
    }
  }

  // Where most of a make stand for themselves, all do: one of twelve chairs at the wall is not the coffee table's.
  void CutOddOnes() {
    std::map<Make, std::vector<int>> like;
    for (int object : order_) like[MakeOf(scene_.objects[object])].push_back(object);
    for (const auto& [make, objects] : like) {
      const auto tied = std::ranges::count_if(
          objects, [&](int o) { return parent_[o] >= 0 || std::count(block_.begin(), block_.end(), block_[o]) > 1; });
      if (objects.size() < kFewestAlike || 2 * static_cast<size_t>(tied) >= objects.size()) continue;
      for (int object : objects) parent_[object] = -1;
    }
  }

  // Each tree becomes a group, parents before children, children by tie.
  void Gather() {
    groups_.of.assign(parent_.size(), -1);
    for (int root : order_) {
      if (parent_[root] >= 0) continue;
      Group group{{root}, {}, {}};
      for (size_t i = 0; i < group.objects.size(); ++i) {
        for (int child : order_) {
          if (parent_[child] == group.objects[i]) group.objects.push_back(child);
        }
      }
      AddGroup(std::move(group));
    }
  }

  void AddGroup(Group group) {
    for (int object : group.objects) groups_.of[object] = static_cast<int>(groups_.all.size());
    groups_.all.push_back(std::move(group));
  }

  using Kit = std::vector<Make>;
  Kit KitOf(const Group& group) const {
    Kit kit;
    for (int object : group.objects) kit.push_back(MakeOf(scene_.objects[object]));
    return kit;
  }

  // Groups whose first pieces are of one make. What only few of them have, as one desk of thirty its cupboard, leaves
  // the group, so that the rest are alike.
  void FindPatterns() {
    std::map<Make, std::vector<int>> clusters;
    for (int g = 0; g < static_cast<int>(groups_.all.size()); ++g) {
      clusters[MakeOf(scene_.objects[groups_.all[g].objects[0]])].push_back(g);
    }
    for (const auto& [make, cluster] : clusters) {
      const bool blocks = std::ranges::any_of(cluster, [&](int g) { return IsBlock(groups_.all[g]); });
      if (cluster.size() < (blocks ? 2 : kFewestAlike) && !AreParallel(cluster)) continue;
      std::map<Kit, size_t> counts;
      for (int g : cluster) ++counts[KitOf(groups_.all[g])];
      const auto common = std::max_element(counts.begin(), counts.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
      std::vector<int> pattern;
      for (int g : cluster) {
        if ((blocks && IsPart(KitOf(groups_.all[g]), common->first)) || Reduce(g, common->first)) pattern.push_back(g);
      }
      // Rows are often zones of their own.
      std::sort(pattern.begin(), pattern.end(), [&](int a, int b) {
        const int first = groups_.all[a].objects[0], second = groups_.all[b].objects[0];
        return std::pair(scene_.objects[first].zone, first) < std::pair(scene_.objects[second].zone, second);
      });
      Chain(pattern);
      if (pattern.size() >= std::min(blocks ? size_t{2} : kFewestAlike, cluster.size()))
        groups_.patterns.push_back(std::move(pattern));
    }
  }

  // The last island has fewer desks.
  static bool IsPart(Kit few, Kit all) {
    std::sort(few.begin(), few.end());
    std::sort(all.begin(), all.end());
    return std::includes(all.begin(), all.end(), few.begin(), few.end());
  }

  // Two or three that are each called parallel to another, such as twin beds.
  bool AreParallel(const std::vector<int>& cluster) const {
    std::set<int> parallel;
    for (const v1::ConstraintEdge& edge : input_.graph.edges()) {
      if (edge.type() != "parallel") continue;
      std::vector<int> named = NamedObjects(edge, scene_);
      const auto is_first = [&](int object) {
        return std::ranges::any_of(cluster, [&](int g) { return groups_.all[g].objects[0] == object; });
      };
      if (std::ranges::all_of(named, is_first)) parallel.insert(named.begin(), named.end());
    }
    return parallel.size() == cluster.size();
  }

  // Within a zone, from one end of a row to the other: each next to one that it is tied to.
  void Chain(std::vector<int>& pattern) const {
    const auto tie = [&](int a, int b) {
      const int first = groups_.all[a].objects[0], second = groups_.all[b].objects[0];
      return scene_.objects[first].zone == scene_.objects[second].zone ? input_.linked.TieOf(first, second) : 0.0;
    };
    for (size_t i = 0; i < pattern.size(); ++i) {
      const auto ties = [&](int g) {
        return std::count_if(pattern.begin() + static_cast<int>(i), pattern.end(),
                             [&](int o) { return o != g && tie(g, o) > 0; });
      };
      const int zone = scene_.objects[groups_.all[pattern[i]].objects[0]].zone;
      size_t next = i;
      for (size_t k = i + 1; k < pattern.size(); ++k) {
        if (scene_.objects[groups_.all[pattern[k]].objects[0]].zone != zone) break;
        const double gain = i == 0 ? 0 : tie(pattern[i - 1], pattern[k]) - tie(pattern[i - 1], pattern[next]);
        if (gain > 0 || (gain == 0 && ties(pattern[k]) < ties(pattern[next]))) next = k;
      }
      std::rotate(pattern.begin() + static_cast<int>(i), pattern.begin() + static_cast<int>(next),
                  pattern.begin() + static_cast<int>(next) + 1);
    }
  }

  // Makes a group consist of `kit`, if it has all of that; what is too much stands for itself.
  bool Reduce(int g, const Kit& kit) {
    std::vector<int> kept, rest;
    for (int object : groups_.all[g].objects) {
      const bool wanted = kept.size() < kit.size() && MakeOf(scene_.objects[object]) == kit[kept.size()];
      (wanted ? kept : rest).push_back(object);
    }
    if (kept.size() < kit.size()) return false;
    groups_.all[g].objects = std::move(kept);
    for (int object : rest) AddGroup({{object}, {}, {}});
    return true;
  }

  // What makes two groups have the same arrangements: their pieces, and the calls among them.
  std::string SignatureOf(const Group& group) const {
    std::string text;
    for (int object : group.objects) {
      const Object& what = scene_.objects[object];
      text += fmt::format("{} {} {};", what.footprint.width_m, what.footprint.depth_m, what.walk_over);
    }
    std::vector<std::string> calls;
    for (int edge : group.edges) calls.push_back(CallText(input_, group, edge));
    std::sort(calls.begin(), calls.end());
    for (const std::string& call : calls) text += call;
    return text;
  }

  void FindEdges() {
    for (int e = 0; e < input_.graph.edges_size(); ++e) {
      const std::vector<int> named = NamedObjects(input_.graph.edges(e), scene_);
      if (named.empty() || groups_.of[named[0]] < 0) continue;
      const int group = groups_.of[named[0]];
      const bool inside = std::ranges::all_of(named, [&](int o) { return groups_.of[o] == group; });
      if (inside) groups_.all[group].edges.push_back(e);
    }
  }

  void Finish() {
    FindEdges();
    std::map<std::string, std::vector<Arrangement>> known;
    for (Group& group : groups_.all) {
      group.block = IsBlock(group);
      if (group.objects.size() == 1) {
        group.arrangements = {{Pose<double>()}};
        continue;
      }
      const auto [place, is_new] = known.try_emplace(SignatureOf(group));
      if (is_new) place->second = ArrangeGroup(input_, group);
      group.arrangements = place->second;
    }
  }

  const SolveInput& input_;
  const Scene& scene_;
  std::vector<int> parent_, order_;
  // Per object, the first of those of its block.
  std::vector<int> block_;
  std::map<Make, size_t> common_;
  Groups groups_;
};

}  // namespace

int Groups::LeaderOf(const Scene& scene, int object) const {
  if (of.empty() || of[object] < 0) return object;
  const int group = of[object];
  const auto pattern = std::ranges::find_if(patterns, [&](const std::vector<int>& alike) {
    return std::find(alike.begin(), alike.end(), group) != alike.end();
  });
  const std::vector<int> together = pattern == patterns.end() ? std::vector<int>{group} : *pattern;
  for (int g : together) {
    for (int member : all[g].objects) {
      if (scene.objects[member].role == ObjectRole::kPrimary) return member;
    }
  }
  return all[together[0]].objects[0];
}

Groups FindGroups(const SolveInput& input) { return GroupFinder(input).Find(); }

BoundingBox BoxOf(const Scene& scene, const Group& group, const Arrangement& arrangement) {
  std::vector<Vec2<double>> points;
  for (size_t k = 0; k < arrangement.size(); ++k) {
    for (const Vec2<double>& corner : Corners(scene.objects[group.objects[k]].footprint, arrangement[k])) {
      points.push_back(corner);
    }
  }
  return BoundsOf(points);
}

void PoseGroup(const Arrangement& arrangement, const Pose<double>& first, std::vector<Pose<double>>& poses) {
  const Frame<double> frame = FrameOf(first);
  poses.resize(arrangement.size());
  poses[0] = first;
  for (size_t k = 1; k < arrangement.size(); ++k) {
    const Vec2<double> p = frame.ToRoom(arrangement[k].x_m, arrangement[k].y_m);
    poses[k] = {p.x, p.y, first.theta_rad + arrangement[k].theta_rad};
  }
}

}  // namespace flair::optimizer
