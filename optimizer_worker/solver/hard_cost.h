// SPDX-License-Identifier: GPL-3.0-or-later
// The hard terms around one solid object, or around several that are moved as one piece (bounds, doors, overlaps), as
// Problem would sum them, but much faster: most candidate poses are far from most obstacles, and all sines and cosines
// are worked out once per object.
#pragma once

#include <span>
#include <vector>

#include "optimizer_worker/solver/problem.h"
#include "optimizer_worker/solver/separation.h"

namespace flair::optimizer {

class HardCost {
 public:
  // Reads the weights of bounds, doors and overlaps among the problem's terms. Borrows all.
  HardCost(const Scene& scene, const KeepOut& keep_out, const Problem& problem);

  // Fixes the poses of all but `objects`; to be called before At whenever one of them has moved.
  void Prepare(std::span<const int> objects, const Problem& problem, const Layout& layout);
  // Sum of the hard terms of those objects at `poses`, except between them; may stop early with any number above
  // `limit`. Those that are not solid have none.
  double At(std::span<const Pose<double>> poses, double limit) const;

 private:
  struct Weights {
    double bounds = 0;
    double doors = 0;
    std::vector<std::pair<int, double>> others;
  };
  struct Neighbour {
    Box<double> box;
    Vec2<double> center;
    double reach_m;
    double weight;
  };
  struct Area {
    const ConvexPiece* piece;
    BoundingBox box;
  };

  struct Moving {
    int object;
    double reach_m;
    std::vector<Neighbour> neighbours;
  };

  double One(const Moving& moving, const Pose<double>& pose, double limit) const;

  const Scene& scene_;
  const KeepOut& keep_out_;
  std::vector<Weights> weights_;
  std::vector<Area> doors_;
  std::vector<Moving> moving_;
};

}  // namespace flair::optimizer
