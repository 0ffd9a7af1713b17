// SPDX-License-Identifier: GPL-3.0-or-later
// Which objects belong together, and where: a chair at the front of its desk, a coffee table before its sofa. What
// belongs at a side of an object does not block the way to that side.
#pragma once

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "flair/v1/layout_graph.pb.h"
#include "room/geometry/polygon.h"
#include "room/scene/scene.h"

namespace flair::optimizer {

class Arguments;

// A surround call of more seats is refused.
inline constexpr int kMostSeats = 16;

class LinkedPairs {
 public:
  LinkedPairs() = default;
  // Links what next_to, in_front_of, surround, between, row, perpendicular and on calls put together, at the sides that
  // the calls name; beside without a side is anywhere but before a front. To face something is to look at it, and to
  // stand before it is no reason to bar its front: such a pair belongs before the fronts only when it is used so, as a
  // chair at its desk, or a table before its sofa. Where sentences are marked as uses (`Sentence.use`), those say so;
  // where none is, of calls within a step those that also put the two beside each other.
  LinkedPairs(const Scene& scene, const v1::LayoutGraph& graph);

  // Both belong to each other at all sides.
  void Link(int a, int b);
  // Whether `other` belongs at that side of `object`.
  bool BelongsAt(int object, int other, Side side) const;
  // Sum of the weights of the calls that put the two beside each other, within a step: 0 for none.
  double TieOf(int a, int b) const;
  // How many on_wall_above calls hang something above `target`: several share the place.
  int CountAbove(int target) const;

 private:
  using SideSet = unsigned;

  // What the graph knows about a call: whether it is a use.
  enum class Known { kNothing, kUse, kNoUse };

  void AddEdge(const Scene& scene, const v1::ConstraintEdge& edge, Known use);
  void AddGroup(const Arguments& arguments);
  void Place(int object, int other, SideSet sides) { sides_[{object, other}] |= sides; }
  void Tie(int a, int b, double weight) { ties_[std::minmax(a, b)] += weight; }
  void TieAll(const std::vector<int>& objects, double weight);

  // (object, other) -> sides of the object where the other belongs.
  std::map<std::pair<int, int>, SideSet> sides_;
  std::map<std::pair<int, int>, double> ties_;
  std::map<int, int> above_;
};

}  // namespace flair::optimizer
