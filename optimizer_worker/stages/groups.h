// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces that are used together, found from the calls that put them beside each other: a table with its chairs, a bed
// with its nightstands, a run of cupboards. They get their first places as one piece; groups that are alike (thirty
// desks, twenty tables, ten mats) as one pattern of rows. See docs/decisions/0032.
#pragma once

#include <vector>

#include "room/scene/scene.h"

namespace flair::optimizer {

struct SolveInput;

// Poses of a group's objects in the frame of its first.
using Arrangement = std::vector<Pose<double>>;

struct Group {
  // The one to which the others belong comes first, and every other one after one that it stands beside.
  std::vector<int> objects;
  // The graph's edges that name objects of the group and no others.
  std::vector<int> edges;
  // Ways to stand together, none empty, nothing overlaps: where the first stands free, and with its back or sides at
  // walls, where they differ.
  std::vector<Arrangement> arrangements;
  // Whether it has several of its first piece's make: an island of desks.
  bool block = false;
};

struct Groups {
  std::vector<Group> all;
  // Per object, its group; -1 for what has none: pinned, or not on the floor.
  std::vector<int> of;
  // Groups (indices in `all`) that are alike: kFewestAlike each, or fewer that calls make parallel.
  std::vector<std::vector<int>> patterns;

  // The object that says in which stage and zone an object is placed: the first primary of its group or of those that
  // are alike, else the first object.
  int LeaderOf(const Scene& scene, int object) const;
};

// So many alike make a pattern.
inline constexpr size_t kFewestAlike = 4;

// The groups of a problem. Those of the same make have the same arrangements. Deterministic.
Groups FindGroups(const SolveInput& input);

// What the objects of a group cover in the frame of its first.
BoundingBox BoxOf(const Scene& scene, const Group& group, const Arrangement& arrangement);

// Where the objects of an arrangement are when the first is at `first`.
void PoseGroup(const Arrangement& arrangement, const Pose<double>& first, std::vector<Pose<double>>& poses);

}  // namespace flair::optimizer
