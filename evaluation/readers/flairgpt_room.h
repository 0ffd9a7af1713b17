// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the reference implementation's recorded problems: a JSON file with room, fixed objects, zones, objects and
// constraint calls becomes a LayoutGraph.
#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "flair/v1/layout_graph.pb.h"
#include "flair/v1/solved_layout.pb.h"
#include "nlohmann/json_fwd.hpp"

namespace flair::evaluation {

// The problem as a graph. Object ids are "floor_<index>" and "item_<index>" with the recording's own indices. Calls
// that name absent objects, features or functions become diagnostics, as the recording is a model's and models err;
// heights, which it lacks, take one plausible value per kind. INVALID_ARGUMENT when the text is not such a file.
absl::StatusOr<v1::LayoutGraph> ReadFlairGptRoom(const std::string& json);

// The same of a text that was parsed already.
absl::StatusOr<v1::LayoutGraph> ReadFlairGptProblem(const nlohmann::json& problem);

// Layouts of the reference implementation's problems: the one that a recording holds, and ours as its judge reads them.

// The layout that was recorded with a problem, by the released implementation; `graph` is what ReadFlairGptRoom made of
// the same text. Graph and placements only. NOT_FOUND when the recording has no layout or not all of one.
absl::StatusOr<v1::SolvedLayout> ReadFlairGptSolution(const std::string& json, const v1::LayoutGraph& graph);

// A layout as the judge reads it, indented. `name` is the problem's name; `seconds` what the solve took. Objects keep
// the index that they were imported with; those of other graphs are numbered in their order, tertiaries by themselves.
std::string WriteFlairGptLayout(const v1::SolvedLayout& layout, const std::string& name, double seconds);

}  // namespace flair::evaluation
