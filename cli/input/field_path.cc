// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/field_path.h"

#include <algorithm>
#include <charconv>

#include "fmt/format.h"

namespace flair::cli {
namespace {

absl::Status NoPath(std::string_view path, size_t at, std::string_view why) {
  return absl::InvalidArgumentError(
      fmt::format("\"{}\": {} at character {}; a path is such as solved_layout.placements[3].theta_rad or "
                  "object_list.objects[desk].width_m",
                  path.substr(0, 200), why, at + 1));
}

bool IsNameCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

}  // namespace

absl::StatusOr<std::vector<PathStep>> ParseFieldPath(std::string_view path) {
  std::vector<PathStep> steps;
  for (size_t at = 0; at < path.size() || at == 0;) {
    if (!steps.empty() && path[at] == '[') {
      const size_t end = path.find(']', at);
      if (end == std::string_view::npos) return NoPath(path, at, "a \"[\" without \"]\"");
      if (end == at + 1) return NoPath(path, at, "nothing between \"[\" and \"]\"");
      steps.push_back({std::string(path.substr(at + 1, end - at - 1)), true});
      at = end + 1;
      continue;
    }
    if (!steps.empty() && path[at] != '.') return NoPath(path, at, "neither \".\" nor \"[\"");
    if (!steps.empty()) ++at;
    const size_t start = at;
    while (at < path.size() && IsNameCharacter(path[at])) ++at;
    if (at == start) return NoPath(path, at, "no name");
    steps.push_back({std::string(path.substr(start, at - start)), false});
  }
  return steps;
}

std::string PathText(const std::vector<PathStep>& steps, size_t count) {
  std::string text;
  for (size_t i = 0; i < std::min(count, steps.size()); ++i) {
    if (steps[i].in_brackets) {
      text += fmt::format("[{}]", steps[i].text);
    } else {
      text += (text.empty() ? "" : ".") + steps[i].text;
    }
  }
  return text;
}

int IndexOf(const PathStep& step) {
  int index = -1;
  const char* const end = step.text.data() + step.text.size();
  const auto [rest, error] = std::from_chars(step.text.data(), end, index);
  return error == std::errc() && rest == end && index >= 0 ? index : -1;
}

}  // namespace flair::cli
