// SPDX-License-Identifier: GPL-3.0-or-later
// flair graph: the layout graph itself as a diagram.
#include <cstdio>
#include <filesystem>

#include "cli/commands/commands.h"
#include "cli/exit_code.h"
#include "cli/graph/layout_diagram.h"
#include "cli/input/artifact_source.h"
#include "cli/output/output_folder.h"
#include "cli/progress/progress.h"
#include "fmt/format.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

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
  return absl::InvalidArgumentError(
      fmt::format("--out: {}: its extension chooses the format: svg, png, pdf, dot", out));
}

absl::StatusOr<Diagram> ReadDiagram(const GraphArguments& arguments) {
  ASSIGN_OR_RETURN(const v1::Artifact artifact, OpenArtifact(arguments.graph, arguments.source));
  if (artifact.has_solved_layout()) return DiagramOf(artifact.solved_layout());
  if (artifact.has_layout_graph()) return DiagramOf(artifact.layout_graph());
  return absl::InvalidArgumentError(
      fmt::format("{}: neither a layout nor a graph; give the layout.pb or graph.pb of a design", arguments.graph));
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

void AddGraph(const Commands& program) {
  program.Add("graph", "Draw the layout graph: objects, parts of the room, and the calls between them.", Graph,
              "Coloured boxes are zones, as on the plan. Calls about one object are rows in it, calls between two are "
              "links, calls of a group have a box. Green is satisfied, red violated, dashed grey dropped. In an SVG, "
              "tooltips show the sentence behind a call. Needs Graphviz (apt-get install graphviz), except for .dot.");
}

}  // namespace flair::cli
