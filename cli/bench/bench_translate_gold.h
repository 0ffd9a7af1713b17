// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/status/statusor.h"
#include "flair/v1/layout_graph.pb.h"
#include "nlohmann/json.hpp"

namespace flair::cli {

// A labelled call {"function", "objects", "params"} in our words, with no more arguments than it states. Objects are
// indices, "t3" is a tertiary one. INVALID_ARGUMENT and NOT_FOUND say which name or value the room does not know.
absl::StatusOr<v1::ConstraintEdge> ReadGoldCall(const nlohmann::json& call, const v1::LayoutGraph& room);

// Id of the object with a labelled index.
absl::StatusOr<std::string> ReadGoldObject(const nlohmann::json& index, const v1::LayoutGraph& room);

}  // namespace flair::cli
