// SPDX-License-Identifier: GPL-3.0-or-later
// The calls of a recorded problem as constraint edges.
#pragma once

#include "absl/status/statusor.h"
#include "flair/v1/layout_graph.pb.h"
#include "nlohmann/json.hpp"

namespace flair::evaluation {

// One recorded call as an edge (without id), against the objects that `graph` holds already. NOT_FOUND or
// INVALID_ARGUMENT with the reason when it means nothing: an unknown function, an absent object, zone or feature.
absl::StatusOr<v1::ConstraintEdge> ReadFlairGptCall(const nlohmann::json& call, const v1::LayoutGraph& graph);

}  // namespace flair::evaluation
