// SPDX-License-Identifier: GPL-3.0-or-later
// The functions of the reference implementation under the names of our constraint types.
#pragma once

#include <string>
#include <vector>

namespace flair::evaluation {

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
