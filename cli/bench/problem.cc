// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/problem.h"

#include <algorithm>

#include "cli/input/files.h"
#include "evaluation/readers/flairgpt_room.h"
#include "fmt/format.h"

namespace flair::cli {

absl::StatusOr<std::vector<std::filesystem::path>> ListProblemFiles(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_regular_file(path, error)) return std::vector<std::filesystem::path>{path};
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(path, error)) {
    const std::string ending = entry.path().extension().string();
    if (ending == ".json" || ending == ".pb") files.push_back(entry.path());
  }
  if (error) return absl::NotFoundError(fmt::format("{}: {}", path.string(), error.message()));
  if (files.empty()) return absl::NotFoundError(fmt::format("{}: no .json or .pb files in it", path.string()));
  std::sort(files.begin(), files.end());
  return files;
}

absl::StatusOr<BenchProblem> ReadBenchProblem(const std::filesystem::path& path) {
  absl::StatusOr<std::string> text = ReadFile(path);
  if (!text.ok()) return text.status();
  BenchProblem problem{path.stem().string(), {}, std::nullopt};
  absl::StatusOr<v1::LayoutGraph> recorded = evaluation::ReadFlairGptRoom(*text);
  if (recorded.ok()) {
    problem.graph = *std::move(recorded);
    absl::StatusOr<v1::SolvedLayout> solution = evaluation::ReadFlairGptSolution(*text, problem.graph);
    if (solution.ok()) problem.recorded = *std::move(solution);
    return problem;
  }
  const absl::StatusOr<v1::Artifact> artifact = ReadArtifact(path);
  if (artifact.ok() && artifact->has_layout_graph()) {
    problem.graph = artifact->layout_graph();
    return problem;
  }
  return absl::InvalidArgumentError(fmt::format("{}: neither a graph nor a recorded problem ({})", path.string(),
                                                std::string(recorded.status().message())));
}

}  // namespace flair::cli
