// SPDX-License-Identifier: GPL-3.0-or-later
// The notation in which a model writes calls: near(sofa, bookshelf, max_distance_m=1).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace flair::translator {

// Calls of one sentence that are read; the rest is left out.
inline constexpr size_t kMostCalls = 40;

// An argument as it is written.
struct WrittenArgument {
  // Empty when it is given by its place.
  std::string name;
  // Several for a list in brackets.
  std::vector<std::string> values;
  bool in_brackets = false;
};

// A call as it is written; nothing of it is known to be right.
struct WrittenCall {
  std::string function;
  std::vector<WrittenArgument> arguments;
};

// What one text of an answer says.
struct WrittenCalls {
  std::vector<WrittenCall> calls;
  // "none(why)": that no function says it, and why.
  bool none = false;
  std::string why;
};

// Reads one call, several one after the other, or none. Takes quotes, "name: value", lists in any brackets, spaces, a
// semicolon or point at the end, code marks, and a missing last bracket. INVALID_ARGUMENT says what is no call, and
// what would be right. Pure; any text is good input.
absl::StatusOr<WrittenCalls> ReadCallText(std::string_view text);

}  // namespace flair::translator
