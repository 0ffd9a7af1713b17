// SPDX-License-Identifier: GPL-3.0-or-later
// The calls of a recorded problem as constraint edges.
#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/layout_graph.pb.h"
#include "nlohmann/json.hpp"

namespace flair::evaluation {

// One recorded call as edges (without ids), against the objects that `graph` holds already; more than one when it names
// several partners at once. Where a wall or a piece of furniture is named in place of a door, window or socket, the
// call is read as the one that is about walls or furniture. NOT_FOUND or INVALID_ARGUMENT with the reason when it means
// nothing: an unknown function, an absent object, zone or feature.
absl::StatusOr<std::vector<v1::ConstraintEdge>> ReadFlairGptCall(const nlohmann::json& call,
                                                                 const v1::LayoutGraph& graph);

}  // namespace flair::evaluation
