// SPDX-License-Identifier: GPL-3.0-or-later
// flair-dev bench resolve: measures edits of solved layouts.
#include <cstdio>
#include <memory>

#include "CLI/CLI.hpp"
#include "cli/bench/resolve_bench.h"
#include "cli/commands/commands.h"
#include "cli/input/command_line.h"
#include "fmt/format.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

struct BenchResolveArguments {
  std::string problems;
  int per_kind = 4;
  int compare_every = 0;
  bool list = false;
};

absl::Status BenchResolve(const BenchResolveArguments& arguments) {
  const absl::StatusOr<std::vector<ProblemFile>> files = ListProblemFiles(arguments.problems);
  if (!files.ok()) return files.status();
  v1::SolveOptions options;
  options.set_thread_count(1);
  std::vector<ResolveMeasure> all;
  size_t failures = 0;
  for (const ProblemFile& file : *files) {
    const absl::StatusOr<BenchProblem> problem = ReadBenchProblem(file);
    absl::StatusOr<std::vector<ResolveMeasure>> measures =
        problem.ok() ? MeasureResolves(*problem, options, arguments.per_kind, arguments.compare_every)
                     : problem.status();
    if (!measures.ok()) {
      ++failures;
      fmt::print(stderr, "{}: {}\n", file.path.string(), std::string(measures.status().message()));
      continue;
    }
    for (ResolveMeasure& measure : *measures) {
      if (arguments.list) {
        fmt::print("{:<28}{:<60}{:>8.1f} ms {:>3} moved, {} -> {}{}\n", measure.room, measure.edit, 1e3 * measure.cpu_s,
                   measure.moved_count, measure.held_before, measure.held_after,
                   measure.held_anew >= 0 ? fmt::format(" (anew {})", measure.held_anew) : "");
      }
      all.push_back(std::move(measure));
    }
  }
  if (!all.empty()) fmt::print("{}", ResolveTable(all));
  std::fflush(stdout);
  if (failures == 0) return absl::OkStatus();
  return absl::UnknownError(
      fmt::format("{} of {} could not be measured", failures, Counted(std::ssize(*files), "problem")));
}

}  // namespace

void AddBenchResolve(CLI::App& program, absl::Status& result) {
  auto arguments = std::make_shared<BenchResolveArguments>();
  CLI::App* command = program.get_subcommand("bench")->add_subcommand(
      "resolve", "Edit solved layouts of a folder's problems: times, moves, constraints that hold.");
  command->add_option("DIR", arguments->problems, "Folder (or file) of graphs, layouts or recorded FlairGPT problems")
      ->required();
  command
      ->add_option("--per-kind", arguments->per_kind,
                   "Objects and constraints of a room to edit in each way, 1 to 1000 (4)")
      ->type_name("N")
      ->check(WholeNumber(1, 1000));
  command
      ->add_option("--compare-every", arguments->compare_every,
                   "Compare every Nth edit with a solve from nothing, 0 to 1000000 (0: none)")
      ->type_name("N")
      ->check(WholeNumber(0, 1000000));
  command->add_flag("--list", arguments->list, "Every edit, a line each");
  command->callback([arguments, &result] { result = BenchResolve(*arguments); });
}

}  // namespace flair::cli
