// SPDX-License-Identifier: GPL-3.0-or-later
// flair explain: why everything in a layout stands where it stands.
#include <cstdio>
#include <memory>

#include "CLI/CLI.hpp"
#include "cli/commands/commands.h"
#include "cli/explain/note_json.h"
#include "cli/explain/note_text.h"
#include "cli/input/artifact_source.h"
#include "cli/output/artifact_text.h"
#include "fmt/format.h"
#include "orchestrator/store/artifact_id.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

struct ExplainArguments {
  std::string file;
  SourceFlags source;
  std::string object;
  bool json = false;
  bool all = false;
};

absl::StatusOr<v1::Artifact> ReadLayout(const std::string& file, const SourceFlags& source) {
  absl::StatusOr<v1::Artifact> artifact = OpenArtifact(file, source);
  if (!artifact.ok()) return artifact.status();
  if (artifact->has_solved_layout()) return artifact;
  const char* const advice = artifact->has_layout_graph() ? "; first: flair solve" : "";
  return absl::InvalidArgumentError(
      fmt::format("{}: a {}; expected a solved layout{}", file, KindName(orchestrator::KindOf(*artifact)), advice));
}

absl::Status Explain(const ExplainArguments& arguments) {
  ASSIGN_OR_RETURN(const v1::Artifact artifact, ReadLayout(arguments.file, arguments.source));
  const absl::StatusOr<LayoutNote> note = MakeLayoutNote(artifact.solved_layout());
  if (!note.ok()) {
    return absl::InvalidArgumentError(fmt::format("{}: {}", arguments.file, std::string(note.status().message())));
  }
  const NoteStyle style = {.all = arguments.all};
  if (arguments.object.empty()) {
    fmt::print("{}", arguments.json ? NoteJson(*note) : NoteText(*note, style));
    return absl::OkStatus();
  }
  ASSIGN_OR_RETURN(const ObjectNote* object, FindObject(*note, arguments.object));
  fmt::print("{}", arguments.json ? ObjectJson(*object) : ObjectText(*object, style));
  return absl::OkStatus();
}

}  // namespace

void AddExplain(CLI::App& program, absl::Status& result) {
  auto arguments = std::make_shared<ExplainArguments>();
  CLI::App* command = program.add_subcommand("explain", "Say why everything in a layout stands where it stands.");
  command
      ->add_option("LAYOUT", arguments->file,
                   "A solved layout: a file (.pb, .json or .textproto), digits of its id, or JOB/solve")
      ->required();
  AddSourceFlags(*command, arguments->source);
  command->add_option("--object", arguments->object,
                      "Only this one, by id or name such as \"dining chair 2\", in full");
  command->add_flag("--all", arguments->all,
                    "Every demand of every object, held or not; else what has a reason and what is not met");
  command->add_flag("--json", arguments->json, "As JSON, with every demand");
  command->footer(
      "By zone: where each object stands, the sentences that put it there with their reasons, what is not "
      "met and by how much (\"!\"), what follows from its place, and what was left out.\n"
      "\n"
      "Try: flair explain out/bedroom/layout.pb --object desk");
  command->callback([arguments, &result] {
    result = Explain(*arguments);
    std::fflush(stdout);
  });
}

}  // namespace flair::cli
