// SPDX-License-Identifier: GPL-3.0-or-later
// flair compare: several optimizers on the same graphs.
#include <cstdio>
#include <filesystem>
#include <vector>

#include "cli/commands/commands.h"
#include "cli/compare/trial.h"
#include "cli/embedded/embedded_services.h"
#include "cli/exit_code.h"
#include "cli/input/artifact_source.h"
#include "cli/input/job_options.h"
#include "cli/output/output_folder.h"
#include "cli/output/text.h"
#include "cli/progress/progress.h"
#include "cli/session/stage_calls.h"
#include "fmt/format.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMostGraphs = 1000;
constexpr size_t kMostOptimizers = 8;

struct CompareArguments : Options {
  using Options::Options;
  std::string& graph = Required("GRAPH", fmt::format("A graph: {}; or a folder of designs", kSourceHelp));
  std::vector<std::string>& optimizers =
      List("--optimizer WHICH", "HOST:PORT, or own for the built-in one; give it two to eight times");
  bool& all = Flag("--all", "Also list the constraints that hold with all of them");
  std::string& format = Word("--format FORMAT", {"text", "json"}, "Format: text or json (text)");
  std::string& picture = Text("--picture FILE", "The plans side by side; png jpg tif svg pdf");
  std::optional<int>& size_px =
      Whole("--size PX", 256, 8192, "Longer side of the picture in pixels, 256 to 8192 (2400)");
  SolveFlags solve{command()};
  SourceFlags source{command()};
  RendererFlags renderer{command()};
};

// "own" and "embedded" are the one in this process.
std::string AddressOf(const std::string& optimizer) {
  return optimizer == "own" || optimizer == "embedded" ? "" : optimizer;
}

absl::StatusOr<Contest> Run(const CompareArguments& arguments, const std::string& name, const v1::LayoutGraph& graph,
                            const v1::SolveOptions& options) {
  v1::SolveRequest request;
  request.set_request_id("flair-compare");
  *request.mutable_layout_graph() = graph;
  *request.mutable_options() = options;
  Contest contest{.name = name, .graph = graph, .seed = options.seed()};
  for (const std::string& optimizer : arguments.optimizers) {
    const SlowNote note(fmt::format("{}: {}", name, optimizer));
    absl::StatusOr<Trial> trial = RunTrial(request, AddressOf(optimizer));
    if (!trial.ok()) {
      // What ConnectToStage says has the address already.
      const std::string message(trial.status().message());
      return absl::Status(trial.status().code(),
                          message.find(optimizer) == std::string::npos ? optimizer + ": " + message : message);
    }
    contest.trials.push_back(*std::move(trial));
  }
  return contest;
}

absl::Status CheckGraph(const std::string& name, const v1::Artifact& artifact) {
  if (artifact.has_layout_graph()) return absl::OkStatus();
  return absl::InvalidArgumentError(fmt::format(
      "{}: not a graph; give the graph.pb of a design or of flair-dev import flairgpt, or a folder of designs", name));
}

absl::Status DrawPicture(const CompareArguments& arguments, const Contest& contest) {
  PlansBeside plans{.picture = arguments.picture, .size_px = arguments.size_px, .renderer = arguments.renderer};
  for (size_t i = 0; i < contest.trials.size(); ++i) {
    const Trial& trial = contest.trials[i];
    plans.plans.push_back(
        {trial.layout,
         fmt::format("{}   {}", LetterOf(i), arguments.optimizers[i]),
         fmt::format("{} {} · {} of {} · OOB {:.2f} % · OOR {:.2f} % · {:.1f} s", trial.producer.program(),
                     trial.producer.method(), trial.held_count,
                     Counted(std::ssize(trial.verdicts), "constraint holds", "constraints hold"),
                     trial.layout.metrics().oob_percent(), trial.layout.metrics().oor_percent(), trial.seconds),
         {}});
  }
  return DrawPlansBeside(plans);
}

absl::Status CompareOne(const CompareArguments& arguments, const v1::SolveOptions& options) {
  ASSIGN_OR_RETURN(const v1::Artifact graph, OpenArtifact(arguments.graph, arguments.source));
  RETURN_IF_ERROR(CheckGraph(arguments.graph, graph));
  ASSIGN_OR_RETURN(const Contest contest, Run(arguments, arguments.graph, graph.layout_graph(), options));
  if (!arguments.picture.empty()) {
    RETURN_IF_ERROR(DrawPicture(arguments, contest));
  }
  if (arguments.format == "json") {
    fmt::print("{}\n", JsonText(ContestJson(contest, arguments.optimizers), 2));
  } else {
    fmt::print("{}", Printable(ContestText(contest, arguments.optimizers, arguments.all)));
  }
  return absl::OkStatus();
}

// What cannot be compared is told, and the others are compared.
absl::Status CompareFolder(const CompareArguments& arguments, const v1::SolveOptions& options) {
  ASSIGN_OR_RETURN(const std::vector<fs::path> folders, FindFoldersWith(arguments.graph, "graph.pb", kMostGraphs));
  std::vector<Contest> contests;
  absl::Status last;
  for (const fs::path& folder : folders) {
    const std::string name =
        folder == fs::path(arguments.graph) ? "." : folder.lexically_relative(arguments.graph).string();
    const absl::StatusOr<v1::Artifact> graph = OpenArtifact(folder / "graph.pb", arguments.source);
    absl::Status status = graph.ok() ? CheckGraph(folder / "graph.pb", *graph) : graph.status();
    if (status.ok()) {
      absl::StatusOr<Contest> contest = Run(arguments, name, graph->layout_graph(), options);
      status = contest.status();
      if (contest.ok()) contests.push_back(*std::move(contest));
    }
    if (status.ok()) continue;
    fmt::print(stderr, "{}: {}\n", name, std::string(status.message()));
    last = status;
  }
  if (contests.empty()) return last;
  if (arguments.format == "json") {
    nlohmann::json all = nlohmann::json::array();
    for (const Contest& contest : contests) all.push_back(ContestJson(contest, arguments.optimizers));
    fmt::print("{}\n", JsonText(all, 2));
  } else {
    fmt::print("{}", Printable(ContestsTable(contests, arguments.optimizers)));
  }
  if (contests.size() == folders.size()) return absl::OkStatus();
  return absl::Status(last.code(), fmt::format("{} of {} could not be compared", folders.size() - contests.size(),
                                               Counted(std::ssize(folders), "graph")));
}

absl::Status Compare(const CompareArguments& arguments) {
  if (arguments.optimizers.size() < 2 || arguments.optimizers.size() > kMostOptimizers) {
    return absl::InvalidArgumentError(
        fmt::format("--optimizer: {}; give it for each of two to {} optimizers, such as "
                    "--optimizer own --optimizer 127.0.0.1:50053",
                    arguments.optimizers.size(), kMostOptimizers));
  }
  ASSIGN_OR_RETURN(const v1::SolveOptions options, ReadSolveFlags(arguments.solve));
  // All must be there before the first begins to work.
  for (const std::string& optimizer : arguments.optimizers) {
    if (AddressOf(optimizer).empty()) continue;
    RETURN_IF_ERROR(ConnectToStage(kOptimizerStage, optimizer).status());
  }
  const bool is_folder = fs::is_directory(arguments.graph);
  if (!arguments.picture.empty()) {
    if (is_folder) {
      return absl::InvalidArgumentError(
          fmt::format("--picture: {} is a folder; a picture shows one graph", arguments.graph));
    }
    RETURN_IF_ERROR(CheckPicture({arguments.picture, arguments.size_px, {}, {}}));
  }
  return is_folder ? CompareFolder(arguments, options) : CompareOne(arguments, options);
}

}  // namespace

void AddCompare(const Commands& program) {
  program.Add("compare", "Compare several optimizers on the same graph.", Compare,
              "Flair evaluates all answers itself: costs, verdicts and measures. For constraints of unknown types it "
              "shows the optimizer's own verdicts, marked *. For a folder there is a line per design (graph.pb) and "
              "optimizer, and medians.");
}

}  // namespace flair::cli
