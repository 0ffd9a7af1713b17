// SPDX-License-Identifier: GPL-3.0-or-later
// flair solve: a layout from a graph, for trying other seeds, options and edited graphs.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

#include "CLI/CLI.hpp"
#include "cli/commands/commands.h"
#include "cli/input/artifact_source.h"
#include "cli/input/solve_flags.h"
#include "cli/output/artifact_text.h"
#include "cli/output/layout_remarks.h"
#include "cli/output/output_folder.h"
#include "cli/output/solve_text.h"
#include "cli/session/stage_call.h"
#include "fmt/format.h"
#include "optimizer_worker/solver/nlopt_solver.h"
#include "optimizer_worker/stages/solve_layout.h"
#include "orchestrator/pipeline/summary.h"
#include "orchestrator/store/artifact_id.h"
#include "worker_runtime/files/files.h"

namespace flair::cli {
namespace {

struct SolveArguments {
  std::string graph;
  SourceFlags source;
  std::string out;
  std::string optimizer;
  SolveFlags flags;
  bool stats = false;
};

// What all layouts of one solve have in common.
v1::Artifact MakeArtifact(const v1::Artifact& graph, const v1::SolveRequest& request, const v1::Producer& producer) {
  v1::Artifact artifact;
  artifact.add_made_from_ids(graph.id());
  *artifact.mutable_producer() = producer;
  // The number of threads changes no result, so it is none of what the layout was made with.
  v1::SolveOptions options = request.options();
  options.clear_thread_count();
  artifact.set_options_digest(runtime::Sha256Hex(runtime::CanonicalBytes(options)));
  return artifact;
}

// "layout.pb" is followed by "layout-2.pb", "layout-3.pb".
std::string PathOfVariant(const std::string& out, int number) {
  if (number == 1) return out;
  const std::filesystem::path path(out);
  return (path.parent_path() / fmt::format("{}-{}{}", path.stem().string(), number, path.extension().string()))
      .string();
}

// The layout first, then its complete runner-ups, with the terms that runner-ups lack.
std::vector<v1::SolvedLayout> LayoutsOf(const v1::SolveResponse& response, const v1::SolveRequest& request) {
  std::vector<v1::SolvedLayout> layouts = {response.solved_layout()};
  const optimizer::NloptSolver solver;
  for (int i = 0; i < response.solved_layout().runner_ups_size(); ++i) {
    if (!IsComplete(response.solved_layout().runner_ups(i))) continue;
    v1::SolvedLayout& variant = layouts.emplace_back(VariantOf(response.solved_layout(), i));
    v1::EvaluateRequest evaluate;
    *evaluate.mutable_layout_graph() = variant.graph();
    *evaluate.mutable_placements() = variant.placements();
    *evaluate.mutable_options() = request.options();
    const absl::StatusOr<v1::EvaluateResponse> terms = optimizer::EvaluateLayout(evaluate, solver);
    // Another optimizer's library may be unknown here.
    if (!terms.ok()) continue;
    *variant.mutable_term_outcomes() = terms->term_outcomes();
    double total = 0;
    for (const v1::EdgeOutcome& edge : variant.edge_outcomes()) total += edge.weighted_cost();
    for (const v1::TermOutcome& term : variant.term_outcomes()) total += term.cost() * term.factor();
    variant.set_total_cost(total);
  }
  return layouts;
}

absl::Status Solve(const SolveArguments& arguments) {
  const absl::StatusOr<v1::Artifact> graph = OpenArtifact(arguments.graph, arguments.source);
  if (!graph.ok()) return graph.status();
  if (!graph->has_layout_graph()) {
    return absl::InvalidArgumentError(
        fmt::format("{}: not a graph; give the graph.pb of a design or of flair-dev import flairgpt", arguments.graph));
  }
  if (absl::Status status = CheckOutputFile(arguments.out); !status.ok()) return status;
  absl::StatusOr<v1::SolveOptions> options = ReadSolveFlags(arguments.flags);
  if (!options.ok()) return options.status();
  v1::SolveRequest request;
  request.set_request_id("flair-solve");
  *request.mutable_layout_graph() = graph->layout_graph();
  *request.mutable_options() = *std::move(options);
  const absl::StatusOr<v1::SolveResponse> response = CallSolve(request, arguments.optimizer);
  if (!response.ok()) return response.status();

  std::vector<std::string> files;
  const std::vector<v1::SolvedLayout> layouts = LayoutsOf(*response, request);
  for (size_t i = 0; i < layouts.size(); ++i) {
    v1::Artifact artifact = MakeArtifact(*graph, request, response->producer());
    *artifact.mutable_solved_layout() = layouts[i];
    artifact.set_id(orchestrator::ComputeArtifactId(artifact));
    if (i == 0) {
      fmt::print(stderr, "{}{}\n", arguments.out.empty() ? "" : arguments.out + ": ",
                 orchestrator::Summarize(artifact));
    }
    if (arguments.out.empty()) continue;
    const std::string path = PathOfVariant(arguments.out, static_cast<int>(i) + 1);
    if (absl::Status status = WriteOutputFile(path, ArtifactBytes(artifact)); !status.ok()) return status;
    files.push_back(std::filesystem::path(path).filename().string());
  }
  fmt::print(stderr, "{}", LayoutRemarks(layouts.front()));
  if (arguments.stats) fmt::print("{}", SolveStats(*response));
  if (request.options().variant_count() > 1) {
    fmt::print("{}{}", arguments.stats ? "\n" : "", VariantsTable(response->solved_layout(), files));
    std::fflush(stdout);
  }
  if (static_cast<int>(layouts.size()) < request.options().variant_count()) {
    fmt::print(stderr,
               "{:<11}{} of {} layouts: no more were found that differ visibly; more --restarts may find some\n",
               "variants", layouts.size(), request.options().variant_count());
  }
  if (arguments.out.empty()) {
    fmt::print(stderr, "{:<11}--out FILE keeps the layout\n", "next");
  } else {
    fmt::print(stderr, "{:<11}flair render {} --out plan.png\n", "next", arguments.out);
  }
  return absl::OkStatus();
}

}  // namespace

void AddSolve(CLI::App& program, absl::Status& result) {
  auto arguments = std::make_shared<SolveArguments>();
  CLI::App* command = program.add_subcommand("solve", "Place the objects of a graph again.");
  command
      ->add_option("GRAPH", arguments->graph,
                   "A graph: graph.pb or graph.json of a design, digits of its id, or JOB/translation; may be edited")
      ->required();
  AddSourceFlags(*command, arguments->source);
  command->add_option("-o,--out", arguments->out, "Where the layout (.pb) goes; variants beside it, as FILE-2, FILE-3")
      ->type_name("FILE");
  command->add_flag("--stats", arguments->stats, "Print stages, terms, missed constraints and measures");
  AddSolveFlags(*command, arguments->flags);
  command->add_option("--optimizer", arguments->optimizer, "Use this one instead of an own one")
      ->type_name("HOST:PORT");
  command->callback([arguments, &result] { result = Solve(*arguments); });
}

}  // namespace flair::cli
