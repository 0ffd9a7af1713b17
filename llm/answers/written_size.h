// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/descriptor.h>

#include <nlohmann/json_fwd.hpp>
#include <optional>

namespace flair::llm {

// An object whose size is written in one member, with the size in members of its own: "dimensions": "1.6 x 2 x 0.5 m",
// "size": [1.6, 2, 0.5], "size_cm": {"w": 160, "d": 200, "h": 50}, or "w", "d" and "h" beside the name. Width comes
// first, then depth, then height, unless letters or words say otherwise, also in the name: "size (HxWxD)"; a unit
// behind the last number is that of all. Nothing when the type has no width and depth, when the object has them
// already, and when the meaning is not certain.
std::optional<nlohmann::json> WithWrittenSize(const nlohmann::json& object, const google::protobuf::Descriptor& type);

}  // namespace flair::llm
