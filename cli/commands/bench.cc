// SPDX-License-Identifier: GPL-3.0-or-later
// flair-dev bench: measures the solver on folders of problems.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>

#include "CLI/CLI.hpp"
#include "cli/bench/problem.h"
#include "cli/bench/solve_bench.h"
#include "cli/bench/statistics.h"
#include "cli/commands/commands.h"
#include "cli/exit_code.h"
#include "cli/input/command_line.h"
#include "cli/output/artifact_text.h"
#include "cli/output/output_folder.h"
#include "evaluation/readers/flairgpt_room.h"
#include "fmt/format.h"
#include "worker_runtime/bootstrap/build_id.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

struct BenchArguments {
  std::string problems;
  std::string out;
  std::string json;
  std::vector<std::string> only;
  int threads = 1;
  int64_t seed = 0;
  int repeats = 1;
  std::optional<int> restarts;
};

v1::SolveOptions OptionsOf(const BenchArguments& arguments) {
  v1::SolveOptions options;
  options.set_seed(arguments.seed);
  options.set_thread_count(arguments.threads);
  if (arguments.restarts) options.set_max_restart_count(*arguments.restarts);
  return options;
}

// NAME.json for the judge of the reference data, NAME.pb for flair render and flair inspect.
absl::Status WriteLayout(const SolveMeasure& measure, const std::filesystem::path& folder) {
  const absl::Status status = WriteOutputFile(
      folder / (measure.name + ".json"), evaluation::WriteFlairGptLayout(measure.layout, measure.name, measure.cpu_s));
  if (!status.ok()) return status;
  return WriteOutputFile(folder / (measure.name + ".pb"),
                         LayoutArtifactBytes(measure.layout, "bench solve", runtime::BuildName()));
}

// A folder that can be written; made when missing.
absl::Status MakeFolder(const std::filesystem::path& folder) {
  if (folder.empty()) return absl::OkStatus();
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return FileError(fmt::format("--out: {}: {}", folder.string(), error.message()));
  return CheckOutputFile(folder / "layout.pb");
}

struct BenchResults {
  std::vector<SolveMeasure> measures;
  std::vector<BenchFailure> failures;
};

// Solves the files in order and prints a line each. Those that cannot be read or solved are named and skipped.
absl::StatusOr<BenchResults> MeasureAll(const BenchArguments& arguments, const std::vector<ProblemFile>& files) {
  BenchResults results;
  size_t name_width = 0;
  for (const ProblemFile& file : files) name_width = std::max(name_width, file.name.size());
  const TextTable table = SolveTable(name_width);
  fmt::print("{}", SolveLegend());
  fmt::print("{}", table.Header());
  // The table's lines show how far it is, unless they go elsewhere.
  const bool show_progress = isatty(STDERR_FILENO) && !isatty(STDOUT_FILENO);
  for (size_t i = 0; i < files.size(); ++i) {
    if (show_progress) fmt::print(stderr, "\r\033[K{}/{} {}", i + 1, files.size(), files[i].name);
    const absl::StatusOr<BenchProblem> problem = ReadBenchProblem(files[i]);
    absl::StatusOr<SolveMeasure> measure =
        problem.ok() ? MeasureSolve(*problem, OptionsOf(arguments), arguments.repeats) : problem.status();
    if (!measure.ok()) {
      const BenchFailure& failure =
          results.failures.emplace_back(files[i].path.string(), std::string(measure.status().message()));
      fmt::print(stderr, "{}{}: {}\n", show_progress ? "\r\033[K" : "", failure.file, failure.reason);
      continue;
    }
    fmt::print("{}", table.Row(SolveCells(*measure)));
    std::fflush(stdout);
    if (!arguments.out.empty()) {
      if (absl::Status status = WriteLayout(*measure, arguments.out); !status.ok()) return status;
    }
    results.measures.push_back(*std::move(measure));
  }
  if (show_progress) fmt::print(stderr, "\r\033[K");
  return results;
}

// At most ten.
std::string Names(const std::vector<ProblemFile>& files) {
  std::string names;
  for (size_t i = 0; i < std::min<size_t>(10, files.size()); ++i) names += (i > 0 ? ", " : "") + files[i].name;
  return files.size() <= 10 ? names : fmt::format("{} and {} more", names, files.size() - 10);
}

absl::Status KeepOnly(const std::vector<std::string>& names, std::vector<ProblemFile>& files) {
  for (const std::string& name : names) {
    const bool known = std::any_of(files.begin(), files.end(), [&](const auto& file) { return file.name == name; });
    if (!known)
      return absl::NotFoundError(
          fmt::format("--only: {}: no such problem in the folder; there are {}", name, Names(files)));
  }
  if (names.empty()) return absl::OkStatus();
  std::erase_if(
      files, [&](const ProblemFile& file) { return std::find(names.begin(), names.end(), file.name) == names.end(); });
  return absl::OkStatus();
}

absl::Status BenchSolve(const BenchArguments& arguments) {
  absl::StatusOr<std::vector<ProblemFile>> files = ListProblemFiles(arguments.problems);
  if (!files.ok()) return files.status();
  if (absl::Status status = KeepOnly(arguments.only, *files); !status.ok()) return status;
  if (absl::Status status = MakeFolder(arguments.out); !status.ok()) return status;
  if (absl::Status status = CheckOutputFile(arguments.json); !status.ok()) return status;
  const double memory_before_MiB = Memory_MiB();
  const absl::StatusOr<BenchResults> results = MeasureAll(arguments, *files);
  if (!results.ok()) return results.status();
  const auto& [measures, failures] = *results;
  if (!measures.empty()) fmt::print("{}", SolveSummary(measures, memory_before_MiB));
  std::fflush(stdout);
  if (!arguments.json.empty()) {
    const absl::Status status =
        WriteOutputFile(arguments.json, SolveMeasuresToJson(measures, failures, memory_before_MiB));
    if (!status.ok()) return status;
  }
  if (!arguments.out.empty() && !measures.empty()) {
    fmt::print("layouts are in {0}: NAME.json for the judge, NAME.pb for flair render {0}/NAME.pb --out NAME.png\n",
               arguments.out);
  }
  if (failures.empty()) return absl::OkStatus();
  return absl::UnknownError(
      fmt::format("{} of {} could not be measured", failures.size(), Counted(std::ssize(*files), "problem")));
}

}  // namespace

void AddBench(CLI::App& program, absl::Status& result) {
  auto arguments = std::make_shared<BenchArguments>();
  CLI::App* bench = program.add_subcommand("bench", "Measure the solver.");
  bench->require_subcommand(1);
  CLI::App* command = bench->add_subcommand("solve", "Solve every problem of a folder: times, costs, measures.");
  command->add_option("DIR", arguments->problems, "Folder (or file) of graphs, layouts or recorded FlairGPT problems")
      ->required();
  command->add_option("-o,--out", arguments->out, "Folder for the layouts, as .pb and in the FlairGPT format")
      ->type_name("DIR");
  command->add_option("--json", arguments->json, "All figures, for programs")->type_name("FILE");
  command->add_option("--only", arguments->only, "These problems only, by file name without ending")->type_name("NAME");
  command->add_option("--threads", arguments->threads, "Threads of the solver, 1 to 256 (1); changes no result")
      ->type_name("N")
      ->check(WholeNumber(1, 256));
  command->add_option("--repeat", arguments->repeats, "Solves of each problem, 1 to 1000 (1); the median counts")
      ->type_name("N")
      ->check(WholeNumber(1, 1000));
  command->add_option("--seed", arguments->seed, "Seed; another seed, another layout (0)")
      ->type_name("N")
      ->check(Seed());
  command->add_option("--restarts", arguments->restarts, "Most restarts per stage, 1 to 10000 (by the stage's size)")
      ->type_name("N")
      ->check(WholeNumber(1, 10000));
  command->callback([arguments, &result] { result = BenchSolve(*arguments); });
}

}  // namespace flair::cli
