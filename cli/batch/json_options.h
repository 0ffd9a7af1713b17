// SPDX-License-Identifier: GPL-3.0-or-later
// Messages as people write them in JSON: only what they want to change, enums by their short words.
#pragma once

#include <google/protobuf/message.h>

#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "nlohmann/json_fwd.hpp"

namespace flair::cli {

// Whether a JSON text nests at most `most` deep; those that read it do so by recursion.
bool NestsWithin(std::string_view json, int most);

// Sets the fields of `message` that the JSON object names and leaves the others as they are; parts that are messages
// are changed likewise, lists are replaced. Enums may be short words: "birdseye" for PREVIEW_VIEW_BIRDSEYE.
// INVALID_ARGUMENT begins with `path` and the field: "solve.max_restart_count: is "x"; expected ...".
absl::Status SetFromJson(const nlohmann::json& object, std::string_view path, google::protobuf::Message& message);

}  // namespace flair::cli
