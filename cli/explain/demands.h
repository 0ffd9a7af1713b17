// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cli/explain/layout_note.h"
#include "room/scene/scene.h"

namespace flair::cli {

// What was asked of one object, or of none that is known (`object` -1).
struct AssignedDemand {
  int object = -1;
  Demand demand;
};

// Every sentence and every call of no sentence, in their order, once for each object that it places.
std::vector<AssignedDemand> CollectDemands(const v1::SolvedLayout& layout, const Scene& scene);

// Whether a call of that type ties its object's place to another object's.
bool DrawsNear(const std::string& type);

}  // namespace flair::cli
