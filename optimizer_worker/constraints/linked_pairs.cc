// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/linked_pairs.h"

#include <array>
#include <string_view>

#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/registry.h"

namespace flair::optimizer {
namespace {

// Types that put two objects together. Facing alone does too: a chair that faces a desk is meant to be used there.
constexpr std::array<std::string_view, 8> kLinking = {"next_to", "facing", "in_front_of",   "surround",
                                                      "between", "row",    "perpendicular", "on"};

}  // namespace

void LinkedPairs::AddEdge(const Scene& scene, const v1::ConstraintEdge& edge) {
  const ConstraintFacts* facts = FindConstraint(edge.type());
  if (facts == nullptr) return;
  if (facts->name == "on_wall_above") {
    const absl::StatusOr<Arguments> arguments = Arguments::Resolve(*facts, edge, scene);
    if (arguments.ok()) ++above_[arguments->Object("target")];
  }
  bool linking = false;
  for (std::string_view type : kLinking) linking = linking || facts->name == type;
  if (!linking) return;
  const std::vector<int> objects = NamedObjects(edge, scene);
  for (size_t i = 0; i < objects.size(); ++i) {
    for (size_t j = i + 1; j < objects.size(); ++j) Link(objects[i], objects[j]);
  }
}

}  // namespace flair::optimizer
