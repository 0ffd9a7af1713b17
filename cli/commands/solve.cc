// SPDX-License-Identifier: GPL-3.0-or-later
// flair solve: a layout from a graph, for trying other seeds, options and edited graphs.
#include <cstdio>
#include <filesystem>
#include <vector>

#include "cli/commands/commands.h"
#include "cli/input/artifact_source.h"
#include "cli/input/job_options.h"
#include "cli/inspect/content_text.h"
#include "cli/output/artifact_text.h"
#include "cli/output/output_folder.h"
#include "cli/output/solve_text.h"
#include "cli/session/stage_calls.h"
#include "cli/session/pictures.h"
#include "fmt/format.h"
#include "orchestrator/pipeline/summary.h"
#include "orchestrator/store/artifact_id.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

struct SolveArguments : Options {
  using Options::Options;
  std::string& graph = Required(
      "GRAPH", "A graph: graph.pb or graph.json of a design, digits of its id, or JOB/translation; may be edited");
  SourceFlags source{command()};
  std::string& out = Text("-o,--out FILE", "Where the layout (.pb) goes; variants beside it, as FILE-2, FILE-3");
  bool& stats = Flag("--stats", "Print stages, terms, missed constraints and measures");
  SolveFlags flags{command()};
  std::string& optimizer = Text("--optimizer HOST:PORT", "Use this server instead of one in this process");
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

absl::Status Solve(const SolveArguments& arguments) {
  ASSIGN_OR_RETURN(const v1::Artifact graph, OpenArtifact(arguments.graph, arguments.source));
  if (!graph.has_layout_graph()) {
    return absl::InvalidArgumentError(
        fmt::format("{}: not a graph; give the graph.pb of a design or of flair-dev import flairgpt", arguments.graph));
  }
  RETURN_IF_ERROR(CheckOutputFile(arguments.out));
  ASSIGN_OR_RETURN(v1::SolveOptions options, ReadSolveFlags(arguments.flags));
  v1::SolveRequest request;
  request.set_request_id("flair-solve");
  *request.mutable_layout_graph() = graph.layout_graph();
  *request.mutable_options() = std::move(options);
  ASSIGN_OR_RETURN(const v1::SolveResponse response, CallSolve(request, arguments.optimizer));

  std::vector<std::string> files;
  const std::vector<v1::SolvedLayout> layouts = VariantLayouts(response.solved_layout(), request.options());
  for (size_t i = 0; i < layouts.size(); ++i) {
    v1::Artifact artifact = MakeArtifact(graph, request, response.producer());
    *artifact.mutable_solved_layout() = layouts[i];
    artifact.set_id(orchestrator::ComputeArtifactId(artifact));
    if (i == 0) {
      fmt::print(stderr, "{}{}\n", arguments.out.empty() ? "" : arguments.out + ": ",
                 orchestrator::Summarize(artifact));
    }
    if (arguments.out.empty()) continue;
    const std::string path = VariantPath(arguments.out, static_cast<int>(i) + 1);
    RETURN_IF_ERROR(WriteOutputFile(path, ArtifactBytes(artifact)));
    files.push_back(std::filesystem::path(path).filename().string());
  }
  fmt::print(stderr, "{}", LayoutRemarks(layouts.front()));
  if (arguments.stats) fmt::print("{}", SolveStats(response));
  if (request.options().variant_count() > 1) {
    fmt::print("{}{}", arguments.stats ? "\n" : "", VariantsTable(response.solved_layout(), files));
  }
  if (static_cast<int>(layouts.size()) < request.options().variant_count()) {
    fmt::print(stderr, "{:<11}{}\n", "variants", FewerVariants(layouts.size(), request.options().variant_count()));
  }
  if (arguments.out.empty()) {
    fmt::print(stderr, "{:<11}--out FILE keeps the layout\n", "next");
  } else {
    fmt::print(stderr, "{:<11}flair render {} --out plan.png\n", "next", arguments.out);
  }
  return absl::OkStatus();
}

}  // namespace

void AddSolve(const Commands& program) { program.Add("solve", "Place the objects of a graph again.", Solve); }

}  // namespace flair::cli
