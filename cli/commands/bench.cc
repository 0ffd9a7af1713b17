// SPDX-License-Identifier: GPL-3.0-or-later
// flair-dev bench solve, resolve, restarts: measures the solver on folders of problems.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <optional>

#include "cli/bench/complete_graph.h"
#include "cli/bench/problem.h"
#include "cli/bench/resolve_bench.h"
#include "cli/bench/restarts_measure.h"
#include "cli/bench/solve_bench.h"
#include "cli/bench/statistics.h"
#include "cli/commands/commands.h"
#include "cli/exit_code.h"
#include "cli/input/message_text.h"
#include "cli/output/artifact_text.h"
#include "cli/output/output_folder.h"
#include "evaluation/readers/flairgpt_room.h"
#include "fmt/format.h"
#include "worker_runtime/bootstrap/build_id.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

struct BenchArguments : Options {
  using Options::Options;
  std::string& problems = Required("DIR", "Folder (or file) of graphs, layouts or recorded FlairGPT problems");
};

// Measures every problem. Those that cannot be read or measured are named and returned.
std::vector<BenchFailure> MeasureEach(const std::vector<ProblemFile>& files,
                                      const std::function<absl::Status(BenchProblem&)>& measure) {
  // The lines on standard output show how far it is, unless they go elsewhere.
  const bool show_progress = isatty(STDERR_FILENO) && !isatty(STDOUT_FILENO);
  const char* const clear_line = show_progress ? "\r\033[K" : "";
  std::vector<BenchFailure> failures;
  for (size_t i = 0; i < files.size(); ++i) {
    if (show_progress) fmt::print(stderr, "{}{}/{} {}", clear_line, i + 1, files.size(), files[i].name);
    absl::StatusOr<BenchProblem> problem = ReadBenchProblem(files[i]);
    const absl::Status status = problem.ok() ? measure(*problem) : problem.status();
    if (status.ok()) continue;
    const BenchFailure& failure = failures.emplace_back(files[i].path.string(), std::string(status.message()));
    fmt::print(stderr, "{}{}: {}\n", clear_line, failure.file, failure.reason);
  }
  fmt::print(stderr, "{}", clear_line);
  return failures;
}

absl::Status AllMeasured(const std::vector<BenchFailure>& failures, const std::vector<ProblemFile>& files) {
  if (failures.empty()) return absl::OkStatus();
  return absl::UnknownError(
      fmt::format("{} of {} could not be measured", failures.size(), Counted(std::ssize(files), "problem")));
}

struct BenchSolveArguments : BenchArguments {
  using BenchArguments::BenchArguments;
  std::string& out = Text("-o,--out DIR", "Folder for the layouts, as .pb and in the FlairGPT format");
  std::string& json = Text("--json FILE", "All figures, for programs");
  std::vector<std::string>& only = List("--only NAME", "These problems only, by file name without ending");
  int& threads = Whole("--threads N", 1, 256, 1, "Threads of the solver, 1 to 256 (1); changes no result");
  int& repeats = Whole("--repeat N", 1, 1000, 1, "Solves of each problem, 1 to 1000 (1); the median counts");
  int64_t& seed = SeedNumber("Seed; another seed, another layout (0)");
  std::optional<int>& restarts =
      Whole("--restarts N", 1, 10000, "Most restarts per stage, 1 to 10000 (by the stage's size)");
  bool& complete = Flag("--complete", "Add what follows from how one uses the pieces, as a design does");
};

// NAME.json for the judge of the reference data, NAME.pb for flair render and flair inspect.
absl::Status WriteLayout(const SolveMeasure& measure, const std::filesystem::path& folder) {
  if (folder.empty()) return absl::OkStatus();
  RETURN_IF_ERROR(WriteOutputFile(folder / (measure.name + ".json"),
                                  evaluation::WriteFlairGptLayout(measure.layout, measure.name, measure.cpu_s)));
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

absl::Status KeepOnly(const std::vector<std::string>& names, std::vector<ProblemFile>& files) {
  constexpr size_t kShownNames = 10;
  for (const std::string& name : names) {
    if (std::ranges::find(files, name, &ProblemFile::name) != files.end()) continue;
    std::vector<std::string> known;
    for (const ProblemFile& file : files) known.push_back(file.name);
    return absl::NotFoundError(
        fmt::format("--only: {}: no such problem in the folder; there are {}", name, ListNames(known, kShownNames)));
  }
  if (names.empty()) return absl::OkStatus();
  std::erase_if(files, [&](const ProblemFile& file) { return std::ranges::find(names, file.name) == names.end(); });
  return absl::OkStatus();
}

absl::Status BenchSolve(const BenchSolveArguments& arguments) {
  ASSIGN_OR_RETURN(std::vector<ProblemFile> files, ListProblemFiles(arguments.problems));
  RETURN_IF_ERROR(KeepOnly(arguments.only, files));
  RETURN_IF_ERROR(MakeFolder(arguments.out));
  RETURN_IF_ERROR(CheckOutputFile(arguments.json));
  v1::SolveOptions options;
  options.set_seed(arguments.seed);
  options.set_thread_count(arguments.threads);
  if (arguments.restarts) options.set_max_restart_count(*arguments.restarts);
  size_t name_width = 0;
  for (const ProblemFile& file : files) name_width = std::max(name_width, file.name.size());
  const TextTable table = SolveTable(name_width);
  fmt::print("{}{}", SolveLegend(), table.Header());
  const double memory_before_MiB = Memory_MiB();
  std::vector<SolveMeasure> measures;
  const std::vector<BenchFailure> failures = MeasureEach(files, [&](BenchProblem& problem) {
    if (arguments.complete) RETURN_IF_ERROR(CompleteGraph(problem.graph));
    ASSIGN_OR_RETURN(SolveMeasure measure, MeasureSolve(problem, options, arguments.repeats));
    fmt::print("{}", table.Row(SolveCells(measure)));
    std::fflush(stdout);
    measures.push_back(std::move(measure));
    return WriteLayout(measures.back(), arguments.out);
  });
  if (!measures.empty()) fmt::print("{}", SolveSummary(measures, memory_before_MiB));
  std::fflush(stdout);
  if (!arguments.json.empty()) {
    RETURN_IF_ERROR(WriteOutputFile(arguments.json, SolveMeasuresToJson(measures, failures, memory_before_MiB)));
  }
  if (!arguments.out.empty() && !measures.empty()) {
    fmt::print("layouts are in {0}: NAME.json for the judge, NAME.pb for flair render {0}/NAME.pb --out NAME.png\n",
               arguments.out);
  }
  return AllMeasured(failures, files);
}

struct BenchResolveArguments : BenchArguments {
  using BenchArguments::BenchArguments;
  int& per_kind =
      Whole("--per-kind N", 1, 1000, 4, "Objects and constraints of a room to edit in each way, 1 to 1000 (4)");
  int& compare_every = Whole("--compare-every N", 0, 1000000, 0,
                             "Compare every Nth edit with a solve from nothing, 0 to 1000000 (0: none)");
  bool& list = Flag("--list", "Every edit, a line each");
};

absl::Status BenchResolve(const BenchResolveArguments& arguments) {
  ASSIGN_OR_RETURN(const std::vector<ProblemFile> files, ListProblemFiles(arguments.problems));
  v1::SolveOptions options;
  options.set_thread_count(1);
  std::vector<ResolveMeasure> all;
  const std::vector<BenchFailure> failures = MeasureEach(files, [&](const BenchProblem& problem) -> absl::Status {
    ASSIGN_OR_RETURN(std::vector<ResolveMeasure> measures,
                     MeasureResolves(problem, options, arguments.per_kind, arguments.compare_every));
    for (ResolveMeasure& measure : measures) {
      if (arguments.list) {
        fmt::print("{:<28}{:<60}{:>8.1f} ms {:>3} moved, {} -> {}{}\n", measure.room, measure.edit, 1e3 * measure.cpu_s,
                   measure.moved_count, measure.held_before, measure.held_after,
                   measure.held_anew >= 0 ? fmt::format(" (anew {})", measure.held_anew) : "");
      }
      all.push_back(std::move(measure));
    }
    return absl::OkStatus();
  });
  if (!all.empty()) fmt::print("{}", ResolveTable(all));
  return AllMeasured(failures, files);
}

struct BenchRestartsArguments : BenchArguments {
  using BenchArguments::BenchArguments;
  int& restarts = Whole("--restarts N", 1, 10000, 64, "Restarts of the primary stage of each problem, 1 to 10000 (64)");
  int64_t& seed = SeedNumber("Other restarts (0)");
  std::string& json = Text("--json FILE", "Curve and every restart, for programs");
};

absl::Status BenchRestarts(const BenchRestartsArguments& arguments) {
  ASSIGN_OR_RETURN(const std::vector<ProblemFile> files, ListProblemFiles(arguments.problems));
  RETURN_IF_ERROR(CheckOutputFile(arguments.json));
  v1::SolveOptions options;
  options.set_seed(arguments.seed);
  std::vector<RestartsMeasure> measures;
  const std::vector<BenchFailure> failures = MeasureEach(files, [&](const BenchProblem& problem) -> absl::Status {
    ASSIGN_OR_RETURN(RestartsMeasure measure, MeasureRestarts(problem, options, arguments.restarts));
    measures.push_back(std::move(measure));
    return absl::OkStatus();
  });
  if (!measures.empty()) fmt::print("{}", RestartsTable(measures));
  if (!measures.empty() && !arguments.json.empty()) {
    RETURN_IF_ERROR(WriteOutputFile(arguments.json, RestartsToJson(measures)));
  }
  return AllMeasured(failures, files);
}

}  // namespace

void AddBench(const Commands& program) {
  const Commands bench = program.Group("bench", "Measure the solver.");
  bench.Add("solve", "Solve every problem of a folder: times, costs, measures.", BenchSolve);
  AddBenchRender(bench);
  bench.Add("resolve", "Edit solved layouts of a folder's problems: times, moves, constraints that hold.",
            BenchResolve);
  bench.Add("restarts", "After how many restarts the best primary layout of many is found.", BenchRestarts);
  AddBenchTranslate(bench);
}

}  // namespace flair::cli
