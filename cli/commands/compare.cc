// SPDX-License-Identifier: GPL-3.0-or-later
// flair compare: several optimizers on the same graphs.
#include <cstdio>
#include <filesystem>
#include <vector>

#include "absl/strings/str_replace.h"
#include "cli/commands/commands.h"
#include "cli/compare/trial.h"
#include "cli/diff/difference.h"
#include "cli/embedded/embedded_services.h"
#include "cli/exit_code.h"
#include "cli/graph/layout_diagram.h"
#include "cli/input/artifact_shelf.h"
#include "cli/input/job_options.h"
#include "cli/output/output_folder.h"
#include "cli/output/report_text.h"
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
  return InvalidArgument(
      "{}: not a graph; give the graph.pb of a design or of flair-dev import flairgpt, or a folder of designs", name);
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
  if (!arguments.picture.empty()) RETURN_IF_ERROR(DrawPicture(arguments, contest));
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
    return InvalidArgument(
        "--optimizer: {}; give it for each of two to {} optimizers, such as "
        "--optimizer own --optimizer 127.0.0.1:50053",
        arguments.optimizers.size(), kMostOptimizers);
  }
  ASSIGN_OR_RETURN(const v1::SolveOptions options, ReadSolveFlags(arguments.solve));
  // All must be there before the first begins to work.
  for (const std::string& optimizer : arguments.optimizers) {
    if (AddressOf(optimizer).empty()) continue;
    RETURN_IF_ERROR(ConnectToStage(kOptimizerStage, optimizer).status());
  }
  const bool is_folder = fs::is_directory(arguments.graph);
  if (!arguments.picture.empty()) {
    if (is_folder) return InvalidArgument("--picture: {} is a folder; a picture shows one graph", arguments.graph);
    RETURN_IF_ERROR(CheckPicture({arguments.picture, arguments.size_px, {}, {}}));
  }
  return is_folder ? CompareFolder(arguments, options) : CompareOne(arguments, options);
}

struct DiffArguments : Options {
  using Options::Options;
  std::string& a = Required("A", fmt::format("An artifact: {}", kSourceHelp));
  std::string& b = Required("B", "A later one of the same kind");
  std::string& format = Word("--format FORMAT", {"text", "json"}, "Format: text or json (text)");
  std::string& picture =
      Text("--picture FILE", "Layouts: both plans in one picture, with the differences marked; png jpg tif svg pdf");
  std::optional<int>& size_px =
      Whole("--size PX", 256, 8192, "Longer side of the picture in pixels, 256 to 8192 (2400)");
  SourceFlags source{command()};
  RendererFlags renderer{command()};
};

// "14 of 15 constraints hold, OOB 0.00 %, OOR 0.12 %, cost 3.25".
std::string MeasuresOf(const v1::SolvedLayout& layout) {
  return fmt::format("{}, cost {:.2f}", LayoutLine(layout), layout.total_cost());
}

// The picture without its plans.
PlansBeside PictureOf(const DiffArguments& arguments) {
  return {.picture = arguments.picture, .size_px = arguments.size_px, .renderer = arguments.renderer, .plans = {}};
}

absl::Status DrawPicture(const DiffArguments& arguments, const v1::Artifact& a, const v1::Artifact& b,
                         const Difference& difference) {
  PlansBeside plans = PictureOf(arguments);
  plans.plans.push_back({a.solved_layout(), "A   " + arguments.a, MeasuresOf(a.solved_layout()), {}});
  plans.plans.push_back({b.solved_layout(), "B   " + arguments.b, MeasuresOf(b.solved_layout()), {}});
  for (const ObjectFate& fate : difference.fates) {
    v1::ObjectChange& change = plans.plans.back().changes.emplace_back();
    change.set_before_object_id(fate.a_id);
    change.set_after_object_id(fate.b_id);
    change.set_words(absl::StrReplaceAll(fate.words, {{"->", "→"}}));
  }
  return DrawPlansBeside(plans);
}

absl::Status Diff(const DiffArguments& arguments) {
  if (!arguments.picture.empty()) RETURN_IF_ERROR(CheckPicture(PictureOf(arguments)));
  ASSIGN_OR_RETURN(const v1::Artifact a, OpenArtifact(arguments.a, arguments.source));
  ASSIGN_OR_RETURN(const v1::Artifact b, OpenArtifact(arguments.b, arguments.source));
  const absl::StatusOr<Difference> difference = CompareArtifacts(a, b);
  if (!difference.ok()) return About(fmt::format("{} and {}", arguments.a, arguments.b), difference.status());
  if (!arguments.picture.empty()) {
    if (!a.has_solved_layout()) {
      return InvalidArgument("--picture: {} is not a layout; only layouts can be drawn", arguments.a);
    }
    RETURN_IF_ERROR(DrawPicture(arguments, a, b, *difference));
  }
  fmt::print("{}", arguments.format == "json" ? DifferenceJson(*difference, arguments.a, arguments.b)
                                              : Printable(DifferenceText(*difference, arguments.a, arguments.b)));
  return difference->content_is_same ? absl::OkStatus() : DiffersStatus();
}

struct GraphArguments : Options {
  using Options::Options;
  std::string& graph = Required("LAYOUT", fmt::format("A layout, or a graph not solved yet: {}", kSourceHelp));
  std::string& out = Required("-o,--out FILE", "Where it goes; the extension chooses the format: svg png pdf dot");
  SourceFlags source{command()};
};

absl::StatusOr<std::string> FormatOf(const std::string& out) {
  const std::string ending = std::filesystem::path(out).extension().string();
  for (const char* format : {"svg", "png", "pdf", "dot"}) {
    if (ending == std::string(".") + format) return format;
  }
  return InvalidArgument("--out: {}: its extension chooses the format: svg, png, pdf, dot", out);
}

absl::StatusOr<Diagram> ReadDiagram(const GraphArguments& arguments) {
  ASSIGN_OR_RETURN(const v1::Artifact artifact, OpenArtifact(arguments.graph, arguments.source));
  if (artifact.has_solved_layout()) return DiagramOf(artifact.solved_layout());
  if (artifact.has_layout_graph()) return DiagramOf(artifact.layout_graph());
  return InvalidArgument("{}: neither a layout nor a graph; give the layout.pb or graph.pb of a design",
                         arguments.graph);
}

absl::Status Graph(const GraphArguments& arguments) {
  ASSIGN_OR_RETURN(const std::string format, FormatOf(arguments.out));
  ASSIGN_OR_RETURN(const Diagram diagram, ReadDiagram(arguments));
  RETURN_IF_ERROR(CheckOutputFile(arguments.out));
  absl::StatusOr<std::string> bytes = DotText(diagram);
  if (format != "dot") {
    const SlowNote note("drawing");
    bytes = RunDot(*bytes, format);
    if (!bytes.ok()) return bytes.status();
  }
  RETURN_IF_ERROR(WriteOutputFile(arguments.out, *bytes));
  fmt::print(stderr, "{}: {}, {}, {}\n", arguments.out, Counted(std::ssize(diagram.nodes), "node"),
             Counted(std::ssize(diagram.links), "link"), Counted(std::ssize(diagram.groups), "group"));
  return absl::OkStatus();
}

}  // namespace

void AddCompare(const Commands& program) {
  program.Add("compare", "Compare several optimizers on the same graph.", Compare,
              "Flair evaluates all answers itself: costs, verdicts and measures. For constraints of unknown types it "
              "shows the optimizer's own verdicts, marked *. For a folder there is a line per design (graph.pb) and "
              "optimizer, and medians.");
}

// flair diff: what differs between two artifacts of a kind, by meaning.

void AddDiff(const Commands& program) {
  program.Add("diff", "Show what differs between two artifacts of the same kind.", Diff,
              "Items are matched by meaning: sentences by their words, calls by type and arguments, objects by id or "
              "name. + added, - removed, ~ changed, < better (lower cost, now satisfied), > worse. "
              "Exits with 0 when the contents are the same, whoever made them, and with 7 when they differ. "
              "Examples:\n"
              "  flair diff out/a/layout.pb out/b/layout.pb --picture difference.png\n"
              "  flair diff out/a/constraints_raw.pb out/a/constraints.pb");
}

// flair graph: the layout graph itself as a diagram.

void AddGraph(const Commands& program) {
  program.Add("graph", "Draw the layout graph: objects, parts of the room, and the calls between them.", Graph,
              "Coloured boxes are zones, as on the plan. Calls about one object are rows in it, calls between two are "
              "links, calls of a group have a box. Green is satisfied, red violated, dashed grey dropped. In an SVG, "
              "tooltips show the sentence behind a call. Needs Graphviz (apt-get install graphviz), except for .dot.");
}

}  // namespace flair::cli
