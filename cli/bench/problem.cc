// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/problem.h"

#include <algorithm>

#include "cli/input/artifact_file.h"
#include "cli/input/files.h"
#include "evaluation/readers/flairgpt_room.h"
#include "fmt/format.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {

namespace fs = std::filesystem;

absl::StatusOr<std::vector<ProblemFile>> ListProblemFiles(const fs::path& path) {
  std::error_code error;
  if (fs::is_regular_file(path, error)) return std::vector<ProblemFile>{{path.stem().string(), path}};
  std::vector<ProblemFile> files;
  for (const auto& entry : fs::directory_iterator(path, error)) {
    const fs::path file = entry.path();
    if (file.extension() == ".json" || file.extension() == ".pb") files.push_back({file.stem().string(), file});
    const fs::path graph = file / "graph.pb";
    std::error_code absent;
    if (entry.is_directory(absent) && fs::is_regular_file(graph, absent)) {
      files.push_back({file.filename().string(), graph});
    }
  }
  if (error) return absl::NotFoundError(fmt::format("{}: {}", path.string(), error.message()));
  if (files.empty()) return absl::NotFoundError(fmt::format("{}: no .json or .pb files in it", path.string()));
  std::sort(files.begin(), files.end(), [](const ProblemFile& a, const ProblemFile& b) { return a.path < b.path; });
  return files;
}

absl::StatusOr<BenchProblem> ReadBenchProblem(const ProblemFile& file) {
  ASSIGN_OR_RETURN(std::string text, ReadFile(file.path));
  BenchProblem problem{file.name, {}, std::nullopt};
  const absl::StatusOr<v1::Artifact> artifact = ReadArtifact(file.path);
  if (artifact.ok() && artifact->has_layout_graph()) {
    problem.graph = artifact->layout_graph();
    return problem;
  }
  if (artifact.ok() && artifact->has_solved_layout()) {
    problem.graph = artifact->solved_layout().graph();
    problem.recorded = artifact->solved_layout();
    return problem;
  }
  if (artifact.ok()) return absl::InvalidArgumentError("an artifact, but neither a graph nor a layout");
  absl::StatusOr<v1::LayoutGraph> recorded = evaluation::ReadFlairGptRoom(text);
  if (!recorded.ok()) {
    return absl::InvalidArgumentError(fmt::format("neither a graph, nor a layout, nor a recorded problem: {}",
                                                  std::string(recorded.status().message())));
  }
  problem.graph = *std::move(recorded);
  absl::StatusOr<v1::SolvedLayout> solution = evaluation::ReadFlairGptSolution(text, problem.graph);
  if (solution.ok()) problem.recorded = *std::move(solution);
  return problem;
}

}  // namespace flair::cli
