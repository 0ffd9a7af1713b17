// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the reference implementation's recorded problems: a JSON file with room, fixed objects, zones, objects and
// constraint calls becomes a LayoutGraph.
#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "flair/v1/layout_graph.pb.h"

namespace flair::evaluation {

// The problem as a graph. Object ids are "floor_<index>" and "item_<index>" with the recording's own indices. Calls
// that name absent objects, features or functions become diagnostics, as the recording is a model's and models err;
// heights, which it lacks, take one plausible value per kind. INVALID_ARGUMENT when the text is not such a file.
absl::StatusOr<v1::LayoutGraph> ReadFlairGptRoom(const std::string& json);

}  // namespace flair::evaluation
