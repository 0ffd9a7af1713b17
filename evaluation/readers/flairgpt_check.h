// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with a file that should be a recorded problem, field by field, before it is read.
#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "nlohmann/json.hpp"

namespace flair::evaluation {

// The text as JSON. INVALID_ARGUMENT with line and column where it stops being that.
absl::StatusOr<nlohmann::json> ParseFlairGptText(const std::string& text);

// INVALID_ARGUMENT when the problem's room, fixed objects, zones or objects cannot be read: up to five faults, each as
// field, value and what would be right. What its calls say is not looked at, only that they are lists: a model wrote
// them. A size of 0 is fine, it stands for none; so are fixed objects without wall or position, which nobody placed.
absl::Status CheckFlairGptProblem(const nlohmann::json& problem);

}  // namespace flair::evaluation
