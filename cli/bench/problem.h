// SPDX-License-Identifier: GPL-3.0-or-later
// Problems to measure with, from files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/layout_graph.pb.h"
#include "flair/v1/solved_layout.pb.h"

namespace flair::cli {

struct BenchProblem {
  // The file's name without its ending.
  std::string name;
  v1::LayoutGraph graph;
  // What the file says that somebody else made of it; placements only.
  std::optional<v1::SolvedLayout> recorded;
};

// The files of a folder that may hold problems (.json and .pb), by name; `path` itself when it is a file. NOT_FOUND
// when there are none.
absl::StatusOr<std::vector<std::filesystem::path>> ListProblemFiles(const std::filesystem::path& path);

// A graph of ours (.pb or .json) or a recorded FlairGPT problem (.json). INVALID_ARGUMENT when it is neither.
absl::StatusOr<BenchProblem> ReadBenchProblem(const std::filesystem::path& path);

}  // namespace flair::cli
