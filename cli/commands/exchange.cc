// SPDX-License-Identifier: GPL-3.0-or-later
// flair-dev import and flair-dev export: to and from the format of the released implementation.
#include <cstdio>
#include <filesystem>

#include "cli/bench/bench.h"
#include "cli/commands/commands.h"
#include "cli/exit_code.h"
#include "cli/input/artifact_file.h"
#include "cli/input/options.h"
#include "cli/output/artifact_text.h"
#include "cli/output/output_folder.h"
#include "evaluation/readers/flairgpt_calls.h"
#include "fmt/format.h"
#include "room/validation/validate.h"
#include "worker_runtime/bootstrap/build_id.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

struct ImportFlairGptArguments : Options {
  using Options::Options;
  std::string& in = Required("ROOM", "Its .json");
  std::string& out = Required("-o,--out FILE", "Where the graph (.pb) goes");
  bool& complete = Flag("--complete", "Add relations that follow from use, as a design does");
};

absl::Status ImportFlairGpt(const ImportFlairGptArguments& arguments) {
  ASSIGN_OR_RETURN(const std::string text, ReadFile(arguments.in));
  RETURN_IF_ERROR(CheckOutputFile(arguments.out));
  absl::StatusOr<v1::LayoutGraph> graph = evaluation::ReadFlairGptRoom(text);
  if (!graph.ok()) return InvalidArgument("{}: {}", arguments.in, graph.status().message());
  if (arguments.complete) RETURN_IF_ERROR(CompleteGraph(*graph));
  if (const absl::Status good = Validate(*graph); !good.ok()) {
    return InvalidArgument("{}: not a graph that can be solved: {}", arguments.in, good.message());
  }
  RETURN_IF_ERROR(WriteOutputFile(arguments.out, GraphArtifactBytes(*graph, "import flairgpt", runtime::BuildName())));
  for (const v1::Diagnostic& diagnostic : graph->diagnostics())
    fmt::print(stderr, "left out: {}\n", diagnostic.message());
  fmt::print(stderr, "{}: {}, {}, {} left out\n", arguments.out, Counted(graph->object_list().objects_size(), "object"),
             Counted(graph->edges_size(), "constraint"), Counted(graph->diagnostics_size(), "call"));
  fmt::print(stderr, "next       flair solve {} --out layout.pb --stats\n", arguments.out);
  return absl::OkStatus();
}

struct ExportFlairGptArguments : Options {
  using Options::Options;
  std::string& in = Required("LAYOUT", "A layout: layout.pb or layout.json of a design");
  std::string& out = Required("-o,--out FILE", "Where the .json goes");
  std::string& name = Text("--name", "Name of the problem (that of FILE)");
};

absl::Status ExportFlairGpt(const ExportFlairGptArguments& arguments) {
  ASSIGN_OR_RETURN(const v1::Artifact artifact, ReadArtifact(arguments.in));
  if (!artifact.has_solved_layout()) {
    return InvalidArgument("{}: not a layout; give a layout.pb of flair solve", arguments.in);
  }
  RETURN_IF_ERROR(CheckOutputFile(arguments.out));
  const std::string name =
      arguments.name.empty() ? std::filesystem::path(arguments.out).stem().string() : arguments.name;
  // How long somebody took is not in a layout.
  RETURN_IF_ERROR(WriteOutputFile(arguments.out, evaluation::WriteFlairGptLayout(artifact.solved_layout(), name, 0)));
  fmt::print(stderr, "{}: poses of {}, named \"{}\"\n", arguments.out,
             Counted(artifact.solved_layout().placements_size(), "object"), name);
  return absl::OkStatus();
}

}  // namespace

void AddImport(const Commands& program) {
  program
      .Group("import", "Import problems of other systems as graphs; ./flair-dev import answers is a script beside it.")
      .Add("flairgpt", "Import a recorded problem of the released implementation.", ImportFlairGpt);
}

void AddExportFlairGpt(const Commands& program) {
  program.Group("export", "Export layouts in the format of the released implementation.")
      .Add("flairgpt", "Export poses as the released implementation writes them.", ExportFlairGpt);
}

}  // namespace flair::cli
