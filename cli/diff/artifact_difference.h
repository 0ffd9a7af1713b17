// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/status/statusor.h"
#include "cli/diff/difference.h"

namespace flair::cli {

// Compares two artifacts by what they mean. INVALID_ARGUMENT when they are of different kinds; the two kinds of
// constraint lists go together.
absl::StatusOr<Difference> CompareArtifacts(const v1::Artifact& a, const v1::Artifact& b);

// For people: a line per section and one per change. `a` and `b` are the names that they were given by.
std::string DifferenceText(const Difference& difference, const std::string& a, const std::string& b);

// For programs: kind, a, b, content_is_same, origin_is_same, and sections with their changes.
std::string DifferenceJson(const Difference& difference, const std::string& a, const std::string& b);

}  // namespace flair::cli
