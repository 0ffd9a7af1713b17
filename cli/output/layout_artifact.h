// SPDX-License-Identifier: GPL-3.0-or-later
// Graphs and layouts that no job made, as artifact files.
#pragma once

#include <string>

#include "flair/v1/artifact.pb.h"

namespace flair::cli {

// A layout as the bytes of an artifact with its id. `made_from_id` may be empty.
std::string LayoutArtifactBytes(const v1::SolvedLayout& layout, const std::string& made_from_id = "");
std::string GraphArtifactBytes(const v1::LayoutGraph& graph);

}  // namespace flair::cli
