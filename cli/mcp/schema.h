// SPDX-License-Identifier: GPL-3.0-or-later
// The part of JSON Schema that our tools are described in.
#pragma once

#include <string>

#include "absl/status/status.h"
#include "nlohmann/json.hpp"

namespace flair::cli::mcp {

// Whether a value is as its schema says: type, enum, minimum, maximum, exclusiveMinimum, minLength, maxLength, items,
// maxItems, properties, required, additionalProperties. INVALID_ARGUMENT names the place, the value and what would be
// right. Unknown keywords hold.
absl::Status CheckAgainst(const nlohmann::json& schema, const nlohmann::json& value, const std::string& path = "");

// `json` with every object {"use": NAME} in it replaced by the member NAME of `shared`; its other members go over those
// of what is used.
nlohmann::json WithShared(const nlohmann::json& json, const nlohmann::json& shared);

}  // namespace flair::cli::mcp
