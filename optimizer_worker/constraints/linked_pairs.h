// SPDX-License-Identifier: GPL-3.0-or-later
// Which objects belong together: a chair at its desk, a coffee table before its sofa. What belongs to an object does
// not block the way to it.
#pragma once

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "flair/v1/layout_graph.pb.h"
#include "room/scene/scene.h"

namespace flair::optimizer {

class LinkedPairs {
 public:
  LinkedPairs() = default;
  // Links what next_to, facing, in_front_of, surround, between, row, perpendicular and on calls put together.
  template <typename Edges>
  LinkedPairs(const Scene& scene, const Edges& edges) {
    for (const v1::ConstraintEdge& edge : edges) AddEdge(scene, edge);
  }

  void Link(int a, int b) { pairs_.insert(std::minmax(a, b)); }
  // Symmetric.
  bool Linked(int a, int b) const { return pairs_.contains(std::minmax(a, b)); }
  // How many on_wall_above calls hang something above `target`: several share the place.
  int CountAbove(int target) const {
    const auto found = above_.find(target);
    return found == above_.end() ? 0 : found->second;
  }

 private:
  void AddEdge(const Scene& scene, const v1::ConstraintEdge& edge);

  std::set<std::pair<int, int>> pairs_;
  std::map<int, int> above_;
};

}  // namespace flair::optimizer
