// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "absl/status/statusor.h"

namespace flair::cli {

// What Graphviz's program `dot` makes of `text` as "svg", "png" or "pdf". A process of its own: nothing of Graphviz is
// loaded by other commands, and a graph that it cannot cope with harms nobody. The same text gives the same bytes.
// FAILED_PRECONDITION when there is no `dot`, DEADLINE_EXCEEDED when it takes more than two minutes, INTERNAL with what
// it said otherwise.
absl::StatusOr<std::string> RunDot(const std::string& text, const std::string& format);

}  // namespace flair::cli
