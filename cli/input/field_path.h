// SPDX-License-Identifier: GPL-3.0-or-later
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

}  // namespace flair::cli
