// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/bench.h"

#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <numeric>

#include "cli/input/artifact_file.h"
#include "cli/output/output_folder.h"
#include "cli/output/text.h"
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
  if (error) return NotFound("{}: {}", path.string(), error.message());
  if (files.empty()) return NotFound("{}: no .json or .pb files in it", path.string());
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
    return InvalidArgument("neither a graph, nor a layout, nor a recorded problem: {}", recorded.status().message());
  }
  problem.graph = *std::move(recorded);
  absl::StatusOr<v1::SolvedLayout> solution = evaluation::ReadFlairGptSolution(text, problem.graph);
  if (solution.ok()) problem.recorded = *std::move(solution);
  return problem;
}

namespace {

double Seconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

double ProcessCpu_s() { return Seconds(CLOCK_PROCESS_CPUTIME_ID); }
double ThreadCpu_s() { return Seconds(CLOCK_THREAD_CPUTIME_ID); }
double Wall_s() { return Seconds(CLOCK_MONOTONIC); }

double Memory_MiB() {
  std::ifstream pages("/proc/self/statm");
  double all = 0, resident = 0;
  pages >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

double PeakMemory_MiB() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

double Quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, static_cast<size_t>(share * static_cast<double>(values.size())))];
}

double Mean(const std::vector<double>& values) {
  if (values.empty()) return 0;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::optional<double> NumberAt(const Record& record, const std::string& at) {
  const Record::json_pointer place(at);
  return record.contains(place) ? std::optional(record.at(place).get<double>()) : std::nullopt;
}

std::vector<double> NumbersAt(const std::vector<Record>& records, const std::string& at, double factor) {
  std::vector<double> numbers;
  for (const Record& record : records) {
    if (const std::optional<double> number = NumberAt(record, at)) numbers.push_back(factor * *number);
  }
  return numbers;
}

std::string CellOf(const Record& record, const Figure& figure) {
  const std::optional<double> number = NumberAt(record, figure.at);
  return number.has_value() ? fmt::format("{:.{}f}", figure.factor * *number, figure.digits) : "-";
}

std::string RecordText(const Record& record) { return JsonText(record, 1) + "\n"; }

}  // namespace flair::cli
