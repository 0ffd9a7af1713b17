// SPDX-License-Identifier: GPL-3.0-or-later
// flair solve: a layout from a graph, for trying other seeds, options and edited graphs.
#include <cstdio>
#include <memory>
#include <optional>

#include "cli/commands/commands.h"
#include "cli/input/files.h"
#include "cli/output/artifact_text.h"
#include "cli/output/output_folder.h"
#include "cli/session/stage_call.h"
#include "fmt/format.h"
#include "orchestrator/pipeline/summary.h"
#include "orchestrator/store/artifact_id.h"
#include "orchestrator/store/sha256.h"

namespace flair::cli {
namespace {

struct SolveArguments {
  std::string graph;
  std::string out;
  std::string optimizer;
  int64_t seed = 0;
  std::optional<int> threads;
  std::optional<int> restarts;
};

// An edited graph has no valid id any more; the layout then names the id that its bytes have.
std::string OriginId(const v1::Artifact& graph) { return orchestrator::ComputeArtifactId(graph); }

absl::Status Solve(const SolveArguments& arguments) {
  const absl::StatusOr<v1::Artifact> graph = ReadArtifact(arguments.graph);
  if (!graph.ok()) return graph.status();
  if (!graph->has_layout_graph()) {
    return absl::InvalidArgumentError(fmt::format("{}: not a graph; give the graph.pb of a design", arguments.graph));
  }
  v1::SolveRequest request;
  request.set_request_id("flair-solve");
  *request.mutable_layout_graph() = graph->layout_graph();
  request.mutable_options()->set_seed(arguments.seed);
  if (arguments.restarts) request.mutable_options()->set_max_restart_count(*arguments.restarts);
  const std::string digest = orchestrator::Sha256Hex(orchestrator::CanonicalBytes(request.options()));
  if (arguments.threads) request.mutable_options()->set_thread_count(*arguments.threads);
  const absl::StatusOr<v1::SolveResponse> response = CallSolve(request, arguments.optimizer);
  if (!response.ok()) return response.status();

  v1::Artifact layout;
  layout.add_made_from_ids(OriginId(*graph));
  *layout.mutable_producer() = response->producer();
  layout.set_options_digest(digest);
  *layout.mutable_solved_layout() = response->solved_layout();
  layout.set_id(orchestrator::ComputeArtifactId(layout));
  if (absl::Status status = WriteOutputFile(arguments.out, ArtifactBytes(layout)); !status.ok()) return status;
  fmt::print(stderr, "{}: {}\n", arguments.out, orchestrator::Summarize(layout));
  return absl::OkStatus();
}

}  // namespace

void AddSolve(CLI::App& program, absl::Status& result) {
  auto arguments = std::make_shared<SolveArguments>();
  CLI::App* command = program.add_subcommand("solve", "Place the objects of a graph again.");
  command->add_option("GRAPH", arguments->graph, "graph.pb or graph.json of a design; may be edited")->required();
  command->add_option("-o,--out", arguments->out, "Where the layout (.pb) goes")->required()->type_name("FILE");
  command->add_option("--seed", arguments->seed, "Another seed, another layout")
      ->capture_default_str()
      ->check(CLI::Range(int64_t{0}, (int64_t{1} << 53) - 1));
  command->add_option("--threads", arguments->threads, "1 to 256 (all cores); changes no result")
      ->type_name("N")
      ->check(CLI::Range(1, 256));
  command->add_option("--restarts", arguments->restarts, "Most restarts per stage, 1 to 10000")
      ->type_name("N")
      ->check(CLI::Range(1, 10000));
  command->add_option("--optimizer", arguments->optimizer, "Use this one instead of an own one")
      ->type_name("HOST:PORT");
  command->callback([arguments, &result] { result = Solve(*arguments); });
}

}  // namespace flair::cli
