// SPDX-License-Identifier: GPL-3.0-or-later
// Paths to parts of messages, and where in a JSON text such a part is.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace flair::cli {

// One step of the way to a part of a message: a field by name, or an item of a list by number or id.
struct PathStep {
  std::string text;  // "objects", "3", "desk"
  bool in_brackets = false;
};

// "layout_graph.object_list.objects[3].width_m" in steps. INVALID_ARGUMENT when it is no path.
absl::StatusOr<std::vector<PathStep>> ParseFieldPath(std::string_view path);

// The first `count` steps as a path.
std::string PathText(const std::vector<PathStep>& steps, size_t count);

// The number in brackets, from 0 on; -1 when it is no number.
int IndexOf(const PathStep& step);

// Where in a JSON text the field begins, as a byte offset; of the innermost part on the way to it that is there. Field
// names may be those of the .proto files or in camel case. Looks once through what lies before; 0 for what is no JSON.
size_t FindJsonField(std::string_view json, const std::vector<PathStep>& path);

// The line of a byte, from 1 on.
int LineAt(std::string_view text, size_t offset);

}  // namespace flair::cli
