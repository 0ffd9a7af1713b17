// SPDX-License-Identifier: GPL-3.0-or-later
// The calls of a recorded problem as constraint edges.
#pragma once

#include <string>
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

// The functions of the reference implementation under the names of our constraint types.

// What a recorded argument stands for.
enum class FlairGptKind {
  kFloorObject,
  kItem,
  kFloorObjects,
  kZone,
  kFeature,
  kSide,
  kSides,
  kCorner,
  kNumber,
  kFlag,
  // Has no part in what the call says.
  kIgnored,
};

struct FlairGptParameter {
  // Ours; empty for kIgnored.
  std::string name;
  FlairGptKind kind = FlairGptKind::kIgnored;
  bool required = false;
};

// A function: our type, and its parameters in the order of its positional arguments.
struct FlairGptFunction {
  std::string type;
  std::vector<FlairGptParameter> parameters;
  // Further arguments do not change what the call says.
  bool ignores_others = false;
};

// The name under which FindFlairGptFunction knows a function of another version, or a slip whose meaning is clear.
std::string CanonicalFlairGptName(std::string name);

// Null when the reference has no such function, or one that has no type here.
const FlairGptFunction* FindFlairGptFunction(const std::string& canonical_name);

// Position of the parameter that a recorded keyword names; -1 when it names none.
int PositionOfKeyword(const std::string& keyword, const FlairGptFunction& function);

}  // namespace flair::evaluation
