// SPDX-License-Identifier: GPL-3.0-or-later
// flair bench: measures the solver on folders of problems.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>

#include "cli/bench/solve_measure.h"
#include "cli/bench/solve_table.h"
#include "cli/commands/commands.h"
#include "cli/exit_code.h"
#include "cli/output/layout_artifact.h"
#include "cli/output/output_folder.h"
#include "evaluation/readers/flairgpt_room.h"
#include "fmt/format.h"

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
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return FileError(fmt::format("{}: {}", folder.string(), error.message()));
  const absl::Status status = WriteOutputFile(
      folder / (measure.name + ".json"), evaluation::WriteFlairGptLayout(measure.layout, measure.name, measure.cpu_s));
  if (!status.ok()) return status;
  return WriteOutputFile(folder / (measure.name + ".pb"), LayoutArtifactBytes(measure.layout));
}

// Solves the files in order, a line each. Those that cannot be read or solved are named and skipped; `failures` counts.
absl::StatusOr<std::vector<SolveMeasure>> MeasureAll(const BenchArguments& arguments,
                                                     const std::vector<std::filesystem::path>& files, int& failures) {
  std::vector<SolveMeasure> measures;
  for (const std::filesystem::path& file : files) {
    const bool chosen = arguments.only.empty() || std::find(arguments.only.begin(), arguments.only.end(),
                                                            file.stem().string()) != arguments.only.end();
    if (!chosen) continue;
    const absl::StatusOr<BenchProblem> problem = ReadBenchProblem(file);
    absl::StatusOr<SolveMeasure> measure =
        problem.ok() ? MeasureSolve(*problem, OptionsOf(arguments), arguments.repeats) : problem.status();
    if (!measure.ok()) {
      ++failures;
      fmt::print(stderr, "{}: {}\n", file.filename().string(), std::string(measure.status().message()));
      continue;
    }
    fmt::print("{}", SolveTableRow(*measure));
    std::fflush(stdout);
    if (!arguments.out.empty()) {
      if (absl::Status status = WriteLayout(*measure, arguments.out); !status.ok()) return status;
    }
    measures.push_back(*std::move(measure));
  }
  return measures;
}

absl::Status BenchSolve(const BenchArguments& arguments) {
  const absl::StatusOr<std::vector<std::filesystem::path>> files = ListProblemFiles(arguments.problems);
  if (!files.ok()) return files.status();
  fmt::print("{}", SolveTableHeader());
  int failures = 0;
  const absl::StatusOr<std::vector<SolveMeasure>> measures = MeasureAll(arguments, *files, failures);
  if (!measures.ok()) return measures.status();
  if (!measures->empty()) fmt::print("{}", SolveTableSummary(*measures));
  std::fflush(stdout);
  if (!arguments.json.empty()) {
    if (absl::Status status = WriteOutputFile(arguments.json, SolveMeasuresToJson(*measures)); !status.ok()) {
      return status;
    }
  }
  if (failures > 0) return absl::InvalidArgumentError(fmt::format("{} of the files could not be measured", failures));
  if (measures->empty()) return absl::NotFoundError("--only names none of the files");
  return absl::OkStatus();
}

}  // namespace

void AddBench(CLI::App& program, absl::Status& result) {
  auto arguments = std::make_shared<BenchArguments>();
  CLI::App* bench = program.add_subcommand("bench", "Measure the solver.");
  bench->require_subcommand(1);
  CLI::App* command = bench->add_subcommand("solve", "Solve every problem of a folder: times, costs, measures.");
  command->add_option("DIR", arguments->problems, "Folder of graphs (.pb) or recorded FlairGPT problems (.json)")
      ->required();
  command->add_option("-o,--out", arguments->out, "Folder for the layouts, as .pb and in the FlairGPT format")
      ->type_name("DIR");
  command->add_option("--json", arguments->json, "All figures, for programs")->type_name("FILE");
  command->add_option("--only", arguments->only, "These files only, without their ending")->type_name("NAME");
  command->add_option("--threads", arguments->threads, "1 to 256; changes no result")
      ->type_name("N")
      ->capture_default_str()
      ->check(CLI::Range(1, 256));
  command->add_option("--repeat", arguments->repeats, "Solves of each problem; the median counts")
      ->type_name("N")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  command->add_option("--seed", arguments->seed, "Another seed, another layout")
      ->capture_default_str()
      ->check(CLI::Range(int64_t{0}, (int64_t{1} << 53) - 1));
  command->add_option("--restarts", arguments->restarts, "Most restarts per stage, 1 to 10000")
      ->type_name("N")
      ->check(CLI::Range(1, 10000));
  command->callback([arguments, &result] { result = BenchSolve(*arguments); });
}

}  // namespace flair::cli
