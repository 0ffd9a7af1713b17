// SPDX-License-Identifier: GPL-3.0-or-later
// flair-dev bench restarts: how soon restarts find the best primary layout.
#include <cstdio>
#include <memory>

#include "CLI/CLI.hpp"
#include "cli/bench/restarts_measure.h"
#include "cli/commands/commands.h"
#include "cli/input/command_line.h"
#include "cli/output/output_folder.h"
#include "fmt/format.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

struct BenchRestartsArguments {
  std::string problems;
  std::string json;
  int restarts = 64;
  int64_t seed = 0;
};

absl::Status BenchRestarts(const BenchRestartsArguments& arguments) {
  const absl::StatusOr<std::vector<ProblemFile>> files = ListProblemFiles(arguments.problems);
  if (!files.ok()) return files.status();
  if (absl::Status status = CheckOutputFile(arguments.json); !status.ok()) return status;
  v1::SolveOptions options;
  options.set_seed(arguments.seed);
  std::vector<RestartsMeasure> measures;
  size_t failures = 0;
  for (const ProblemFile& file : *files) {
    const absl::StatusOr<BenchProblem> problem = ReadBenchProblem(file);
    absl::StatusOr<RestartsMeasure> measure =
        problem.ok() ? MeasureRestarts(*problem, options, arguments.restarts) : problem.status();
    if (measure.ok()) {
      measures.push_back(*std::move(measure));
    } else {
      ++failures;
      fmt::print(stderr, "{}: {}\n", file.path.string(), std::string(measure.status().message()));
    }
  }
  if (!measures.empty()) {
    fmt::print("{}", RestartsTable(measures));
    if (!arguments.json.empty()) {
      const absl::Status status = WriteOutputFile(arguments.json, RestartsToJson(measures));
      if (!status.ok()) return status;
    }
  }
  if (failures == 0) return absl::OkStatus();
  return absl::UnknownError(
      fmt::format("{} of {} could not be measured", failures, Counted(std::ssize(*files), "problem")));
}

}  // namespace

void AddBenchRestarts(CLI::App& program, absl::Status& result) {
  auto arguments = std::make_shared<BenchRestartsArguments>();
  CLI::App* command = program.get_subcommand("bench")->add_subcommand(
      "restarts", "After how many restarts the best primary layout of many is found.");
  command->add_option("DIR", arguments->problems, "Folder (or file) of graphs, layouts or recorded FlairGPT problems")
      ->required();
  command
      ->add_option("--restarts", arguments->restarts, "Restarts of the primary stage of each problem, 1 to 10000 (64)")
      ->type_name("N")
      ->check(WholeNumber(1, 10000));
  command->add_option("--seed", arguments->seed, "Other restarts (0)")->type_name("N")->check(Seed());
  command->add_option("--json", arguments->json, "Curve and every restart, for programs")->type_name("FILE");
  command->callback([arguments, &result] { result = BenchRestarts(*arguments); });
}

}  // namespace flair::cli
