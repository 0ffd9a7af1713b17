// SPDX-License-Identifier: GPL-3.0-or-later
// flair-dev import and flair-dev export: to and from the format of the released implementation.
#include <cstdio>
#include <filesystem>
#include <memory>

#include "CLI/CLI.hpp"
#include "cli/commands/commands.h"
#include "cli/input/artifact_file.h"
#include "cli/input/files.h"
#include "cli/output/artifact_text.h"
#include "cli/output/output_folder.h"
#include "evaluation/readers/flairgpt_room.h"
#include "fmt/format.h"
#include "room/validation/validate.h"
#include "worker_runtime/bootstrap/build_id.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

struct ExchangeArguments {
  std::string in;
  std::string out;
  std::string name;
};

absl::Status ImportFlairGpt(const ExchangeArguments& arguments) {
  const absl::StatusOr<std::string> text = ReadFile(arguments.in);
  if (!text.ok()) return text.status();
  if (absl::Status status = CheckOutputFile(arguments.out); !status.ok()) return status;
  const absl::StatusOr<v1::LayoutGraph> graph = evaluation::ReadFlairGptRoom(*text);
  if (!graph.ok()) {
    return absl::InvalidArgumentError(fmt::format("{}: {}", arguments.in, std::string(graph.status().message())));
  }
  if (const absl::Status good = Validate(*graph); !good.ok()) {
    return absl::InvalidArgumentError(
        fmt::format("{}: no graph that can be solved: {}", arguments.in, std::string(good.message())));
  }
  if (absl::Status status =
          WriteOutputFile(arguments.out, GraphArtifactBytes(*graph, "import flairgpt", runtime::BuildName()));
      !status.ok())
    return status;
  for (const v1::Diagnostic& diagnostic : graph->diagnostics())
    fmt::print(stderr, "left out: {}\n", diagnostic.message());
  fmt::print(stderr, "{}: {}, {}, {} left out\n", arguments.out, Counted(graph->object_list().objects_size(), "object"),
             Counted(graph->edges_size(), "constraint"), Counted(graph->diagnostics_size(), "call"));
  fmt::print(stderr, "next       flair solve {} --out layout.pb --stats\n", arguments.out);
  return absl::OkStatus();
}

absl::Status ExportFlairGpt(const ExchangeArguments& arguments) {
  const absl::StatusOr<v1::Artifact> artifact = ReadArtifact(arguments.in);
  if (!artifact.ok()) return artifact.status();
  if (!artifact->has_solved_layout()) {
    return absl::InvalidArgumentError(fmt::format("{}: not a layout; give what flair solve wrote", arguments.in));
  }
  if (absl::Status status = CheckOutputFile(arguments.out); !status.ok()) return status;
  const std::string name =
      arguments.name.empty() ? std::filesystem::path(arguments.out).stem().string() : arguments.name;
  // How long somebody took is not in a layout.
  const std::string json = evaluation::WriteFlairGptLayout(artifact->solved_layout(), name, 0);
  if (absl::Status status = WriteOutputFile(arguments.out, json); !status.ok()) return status;
  fmt::print(stderr, "{}: poses of {}, named \"{}\"\n", arguments.out,
             Counted(artifact->solved_layout().placements_size(), "object"), name);
  return absl::OkStatus();
}

}  // namespace

void AddImport(CLI::App& program, absl::Status& result) {
  auto arguments = std::make_shared<ExchangeArguments>();
  CLI::App* command = program.add_subcommand("import", "Problems of other systems as graphs.");
  command->require_subcommand(1);
  CLI::App* flairgpt = command->add_subcommand("flairgpt", "A recorded problem of the released implementation.");
  flairgpt->add_option("ROOM", arguments->in, "Its .json")->required();
  flairgpt->add_option("-o,--out", arguments->out, "Where the graph (.pb) goes")->required()->type_name("FILE");
  flairgpt->callback([arguments, &result] { result = ImportFlairGpt(*arguments); });
  AddImportAnswers(*command, result);
}

void AddExportFlairGpt(CLI::App& program, absl::Status& result) {
  auto arguments = std::make_shared<ExchangeArguments>();
  CLI::App* command = program.add_subcommand("export", "Layouts in the format of the released implementation.");
  command->require_subcommand(1);
  CLI::App* flairgpt = command->add_subcommand("flairgpt", "Poses as the released implementation writes them.");
  flairgpt->add_option("LAYOUT", arguments->in, "A layout: layout.pb or layout.json of a design")->required();
  flairgpt->add_option("-o,--out", arguments->out, "Where the .json goes")->required()->type_name("FILE");
  flairgpt->add_option("--name", arguments->name, "Name of the problem; that of FILE when left out");
  flairgpt->callback([arguments, &result] { result = ExportFlairGpt(*arguments); });
}

}  // namespace flair::cli
