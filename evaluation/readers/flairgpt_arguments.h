// SPDX-License-Identifier: GPL-3.0-or-later
// The arguments of recorded calls as ours.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "evaluation/readers/flairgpt_calls.h"
#include "flair/v1/layout_graph.pb.h"
#include "nlohmann/json.hpp"

namespace flair::evaluation {

// No index of an object is larger.
inline constexpr double kLargestIndex = 1e6;

// Words of a name in lower case, one blank between them: "Dining_Area" is "dining area".
std::string FlairGptWords(const std::string& name);

// Id that ReadFlairGptRoom gives to an object.
std::string FlairGptObjectId(bool tertiary, int index);

// Reads against the room, zones and objects of a graph, which it borrows.
class FlairGptArguments {
 public:
  explicit FlairGptArguments(const v1::LayoutGraph& graph) : graph_(graph) {}

  // The argument for `parameter`; nothing when the value leaves it to its default. `object_id` is the call's first
  // object, whose proportions say which sides are its long ones. NOT_FOUND and INVALID_ARGUMENT say what is wrong.
  absl::StatusOr<std::optional<v1::Argument>> Read(const FlairGptParameter& parameter, const nlohmann::json& value,
                                                   const std::string& object_id) const;

  // By index or by name.
  absl::StatusOr<std::string> ObjectId(const nlohmann::json& value, bool tertiary) const;

 private:
  absl::StatusOr<std::string> Feature(const nlohmann::json& value) const;
  absl::StatusOr<std::string> ZoneId(const nlohmann::json& value) const;
  absl::StatusOr<std::vector<std::string>> Sides(const nlohmann::json& value, const std::string& object_id) const;
  absl::StatusOr<std::vector<std::string>> Objects(const nlohmann::json& value) const;

  const v1::LayoutGraph& graph_;
};

}  // namespace flair::evaluation
