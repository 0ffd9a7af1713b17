// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "absl/status/statusor.h"

namespace flair::renderer {

// JSON that strangers wrote: at most 64 levels deep, whole. INVALID_ARGUMENT says where it goes wrong.
absl::StatusOr<nlohmann::json> ParseLimitedJson(std::string_view text);

// Members of an object that may be missing or of another type, none of which throws.
// The member, null when `json` is no object or has none.
const nlohmann::json* Find(const nlohmann::json& json, const char* name);
// Its elements, none when it is no array.
const nlohmann::json& ArrayOf(const nlohmann::json& json, const char* name);
std::string_view TextOf(const nlohmann::json& json, const char* name);
// A whole number in [0, 2^53]; nothing otherwise.
std::optional<size_t> CountOf(const nlohmann::json& json, const char* name);
// Finite; nothing otherwise.
std::optional<double> NumberOf(const nlohmann::json& json, const char* name);

}  // namespace flair::renderer
