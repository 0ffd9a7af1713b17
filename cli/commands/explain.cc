// SPDX-License-Identifier: GPL-3.0-or-later
// flair explain: why everything in a layout stands where it stands.
#include <cstdio>

#include "cli/commands/commands.h"
#include "cli/explain/layout_note.h"
#include "cli/input/artifact_source.h"
#include "cli/output/artifact_text.h"
#include "cli/session/stage_calls.h"
#include "fmt/format.h"
#include "orchestrator/store/artifact_id.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

struct ExplainArguments : Options {
  using Options::Options;
  std::string& file =
      Required("LAYOUT", "A solved layout: a file (.pb, .json or .textproto), digits of its id, or JOB/solve");
  SourceFlags source{command()};
  std::string& object = Text("--object", "Only this one, by id or name such as \"dining chair 2\", in full");
  bool& all = Flag("--all", "Every demand of every object, held or not; else what has a reason and what is not met");
  bool& json = Flag("--json", "As JSON, with every demand");
  std::string& optimizer = Text("--optimizer HOST:PORT", "Word constraints as this server does, not as ours");
};

absl::Status Explain(const ExplainArguments& arguments) {
  ASSIGN_OR_RETURN(const v1::Artifact artifact, OpenArtifact(arguments.file, arguments.source));
  if (!artifact.has_solved_layout()) {
    const char* const advice = artifact.has_layout_graph() ? "; first: flair solve" : "";
    return absl::InvalidArgumentError(fmt::format("{}: a {}; expected a solved layout{}", arguments.file,
                                                  KindName(orchestrator::KindOf(artifact)), advice));
  }
  ASSIGN_OR_RETURN(const v1::ConstraintCatalog catalog, CallListConstraintTypes(arguments.optimizer));
  const absl::StatusOr<Note> note = MakeLayoutNote(artifact.solved_layout(), catalog);
  if (!note.ok()) {
    return absl::InvalidArgumentError(fmt::format("{}: {}", arguments.file, std::string(note.status().message())));
  }
  const NoteStyle style = {.all = arguments.all};
  if (arguments.object.empty()) {
    fmt::print("{}", arguments.json ? NoteJson(*note) : NoteText(*note, style));
    return absl::OkStatus();
  }
  ASSIGN_OR_RETURN(const Note object, FindObject(*note, arguments.object));
  fmt::print("{}", arguments.json ? NoteJson(object) : ObjectText(object, style));
  return absl::OkStatus();
}

}  // namespace

void AddExplain(const Commands& program) {
  program.Add(
      "explain", "Say why everything in a layout stands where it stands.", Explain,
      "By zone: where each object stands, the sentences that put it there with their reasons, what is not "
      "met and by how much (\"!\"), what follows from its place, and what was left out. In brackets are the ids of "
      "constraints, as flair resolve --edit \"drop e12\" takes them.\n"
      "\n"
      "Try: flair explain out/bedroom/layout.pb --object desk");
}

}  // namespace flair::cli
