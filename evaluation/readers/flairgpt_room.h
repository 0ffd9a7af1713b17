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

// What is wrong with a file that should be a recorded problem, field by field, before it is read.

// The text as JSON. INVALID_ARGUMENT with line and column where it stops being that.
absl::StatusOr<nlohmann::json> ParseFlairGptText(const std::string& text);

// INVALID_ARGUMENT when the problem's room, fixed objects, zones or objects cannot be read: up to five faults, each as
// field, value and what would be right. What its calls say is not looked at, only that they are lists: a model wrote
// them. A size of 0 is fine, it stands for none; so are fixed objects without wall or position, which nobody placed.
absl::Status CheckFlairGptProblem(const nlohmann::json& problem);

// Layouts of the reference implementation's problems: the one that a recording holds, and ours as its judge reads them.

// The layout that was recorded with a problem, by the released implementation; `graph` is what ReadFlairGptRoom made of
// the same text. Graph and placements only. NOT_FOUND when the recording has no layout or not all of one.
absl::StatusOr<v1::SolvedLayout> ReadFlairGptSolution(const std::string& json, const v1::LayoutGraph& graph);

// A layout as the judge reads it, indented. `name` is the problem's name; `seconds` what the solve took. Objects keep
// the index that they were imported with; those of other graphs are numbered in their order, tertiaries by themselves.
std::string WriteFlairGptLayout(const v1::SolvedLayout& layout, const std::string& name, double seconds);

}  // namespace flair::evaluation
