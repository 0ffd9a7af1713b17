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

struct ProblemFile {
  // The file's name without its ending; that of its folder for the graph in a folder of a design.
  std::string name;
  std::filesystem::path path;
};

struct BenchProblem {
  std::string name;
  v1::LayoutGraph graph;
  // What the file says that somebody else made of it; placements only.
  std::optional<v1::SolvedLayout> recorded;
};

// The files of a folder that may hold problems, by name: .json and .pb, and the graph.pb of folders in it (what
// `flair design --out` writes). `path` itself when it is a file. NOT_FOUND when there are none.
absl::StatusOr<std::vector<ProblemFile>> ListProblemFiles(const std::filesystem::path& path);

// A graph of ours, the graph of a layout of ours (.pb or .json), or a recorded FlairGPT problem (.json).
// INVALID_ARGUMENT when it is none of these.
absl::StatusOr<BenchProblem> ReadBenchProblem(const ProblemFile& file);

}  // namespace flair::cli
