// SPDX-License-Identifier: GPL-3.0-or-later
// Why a call that is missed cannot simply be met: what is in the way where it would hold.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "flair/v1/solved_layout.pb.h"
#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/linked_pairs.h"
#include "room/conversion/conversion.h"
#include "room/scene/scene.h"

namespace flair::cli {

class Hindrances {
 public:
  // Borrows all.
  Hindrances(const v1::SolvedLayout& layout, const Scene& scene, const PartialLayout& where);

  // Of a missed call whose own piece is `object`: "the dresser is in the way where it would hold", or "where it would
  // hold, "SENTENCE" would not", of the place with the least in the way, the nearest of those. Empty when nothing is,
  // or no place is found.
  std::string Of(int edge, int object) const;
  const optimizer::LinkedPairs& linked() const { return linked_; }

 private:
  double ValueOf(int edge, const Layout& layout) const;
  std::vector<Pose<double>> PlacesFor(int edge, int object) const;
  std::optional<std::vector<std::string>> InTheWay(const PartialLayout& moved, int object) const;
  bool BreaksAt(int edge, int object, const PartialLayout& moved) const;
  std::string Quoted(int edge) const;

  const v1::SolvedLayout& layout_;
  const Scene& scene_;
  const PartialLayout& where_;
  const optimizer::LinkedPairs linked_;
  // Per edge; null for one that cannot be reckoned alone.
  std::vector<std::unique_ptr<optimizer::Cost>> costs_;
};

}  // namespace flair::cli
