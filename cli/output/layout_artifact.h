// SPDX-License-Identifier: GPL-3.0-or-later
// Graphs and layouts that no job made, as artifact files.
#pragma once

#include <string>

#include "flair/v1/artifact.pb.h"

namespace flair::cli {

// A layout or a graph as the bytes of an artifact with its id, made by `flair` of the given build and, as the
// producer's method, by the command given.
std::string LayoutArtifactBytes(const v1::SolvedLayout& layout, const std::string& command, const std::string& build);
std::string GraphArtifactBytes(const v1::LayoutGraph& graph, const std::string& command, const std::string& build);

}  // namespace flair::cli
