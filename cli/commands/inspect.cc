// SPDX-License-Identifier: GPL-3.0-or-later
// flair inspect: any artifact, readable; from and into all its forms. flair explain: why everything in a layout stands
// where it stands.
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <memory>

#include "cli/commands/commands.h"
#include "cli/explain/layout_note.h"
#include "cli/input/artifact_shelf.h"
#include "cli/inspect/inspection.h"
#include "cli/output/artifact_text.h"
#include "cli/output/output_folder.h"
#include "cli/output/report_text.h"
#include "cli/output/text.h"
#include "cli/session/stage_calls.h"
#include "fmt/format.h"
#include "orchestrator/store/artifact_id.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

struct InspectArguments : Options {
  using Options::Options;
  std::string& source =
      Required("ARTIFACT", fmt::format("An artifact: {}; or a JOB alone: its state and artifacts", kSourceHelp));
  std::string& format = Text("--format FORMAT", "Format: text is a summary; json and textproto have everything (text)");
  bool& json = Flag("--json", "As --format json", {"--format"});
  std::string& field =
      Text("--field PATH", "Only this part, such as solved_layout.placements[3].theta_rad or placements[desk]");
  bool& calls = Flag("--calls", "Show what a language model was asked and answered", {"--field"});
  bool& provenance =
      Flag("--provenance", "Show everything it was made from, back to the brief", {"--field", "--calls"});
  bool& all = Flag("--all", "Print all rows of long tables");
  std::string& out =
      Text("-o,--out FILE", "Write it to FILE; the extension chooses the form: .pb, .json or .textproto");
  SourceFlags from{command()};
};

// What is asked for and in which form; "binary" for a file only.
std::string FormatOf(const InspectArguments& arguments) {
  if (arguments.json) return "json";
  if (!arguments.format.empty()) return arguments.format;
  const std::string ending = std::filesystem::path(arguments.out).extension().string();
  if (ending == ".json") return "json";
  if (ending == ".textproto" || ending == ".txtpb" || ending == ".pbtxt") return "textproto";
  if (ending == ".pb" && arguments.field.empty() && !arguments.calls && !arguments.provenance) return "binary";
  return "text";
}

absl::Status CheckFormat(const std::string& format) {
  if (format.empty() || format == "text" || format == "json" || format == "textproto") return absl::OkStatus();
  return InvalidArgument("--format: \"{}\"; one of text, json, textproto", format);
}

// What stays good of an artifact that is not whole or not good: nothing that others would take for good.
absl::StatusOr<std::string> Binary(const ArtifactFile& file) {
  if (!file.whole.ok()) return file.whole;
  if (!file.good.ok()) return file.good;
  return ArtifactBytes(file.artifact);
}

absl::StatusOr<std::string> Render(const InspectArguments& arguments, const std::string& format,
                                   const FoundSource& found, ArtifactFinder& finder) {
  const v1::Artifact& artifact = found.file.artifact;
  if (!arguments.field.empty()) {
    ASSIGN_OR_RETURN(const FieldView view, FindField(artifact, arguments.field));
    return FieldText(view, format == "json" ? FieldFormat::kJson : FieldFormat::kText);
  }
  if (arguments.provenance) {
    const std::vector<ProvenanceStep> steps = FindProvenance(artifact, finder);
    return format == "json" ? ProvenanceJson(steps) : Printable(ProvenanceText(steps, finder.SearchedPlaces()));
  }
  if (arguments.calls) {
    return artifact.model_calls().empty() ? "No model was asked for it.\n" : ModelCallTexts(artifact);
  }
  if (format == "binary") return Binary(found.file);
  if (format == "json") return ToJson(artifact);
  if (format == "textproto") return ToText(artifact);
  return Printable(InspectionText(arguments.source, found.file, finder, arguments.all ? SIZE_MAX : kMostRows));
}

absl::Status Give(const InspectArguments& arguments, const std::string& text) {
  if (!arguments.out.empty()) return WriteOutputFile(arguments.out, text);
  // Bytes for a program may pass; a terminal is spared them.
  fmt::print("{}", ::isatty(STDOUT_FILENO) != 0 ? Printable(text) : text);
  return absl::OkStatus();
}

absl::Status Inspect(const InspectArguments& arguments) {
  RETURN_IF_ERROR(CheckFormat(arguments.format));
  const std::string format = FormatOf(arguments);
  if (!arguments.out.empty()) RETURN_IF_ERROR(CheckOutputFile(arguments.out));
  ASSIGN_OR_RETURN(const std::unique_ptr<ArtifactShelf> shelf, OpenShelf(arguments.from));
  ASSIGN_OR_RETURN(const FoundSource found, FindSource(arguments.source, *shelf));
  if (found.is_job) {
    if (!arguments.field.empty() || arguments.provenance || arguments.calls || format == "binary") {
      return InvalidArgument("{0}: a job; say which of its artifacts, such as {0}/solve", arguments.source);
    }
    return Give(arguments, format == "json"        ? ToJson(found.job)
                           : format == "textproto" ? ToText(found.job)
                                                   : Printable(JobText(found.job, *shelf)));
  }
  ArtifactFinder finder(found.path, *shelf);
  ASSIGN_OR_RETURN(const std::string text, Render(arguments, format, found, finder));
  RETURN_IF_ERROR(Give(arguments, text));
  return found.file.whole.ok() ? found.file.good : found.file.whole;
}

struct ExplainArguments : Options {
  using Options::Options;
  std::string& file =
      Required("LAYOUT", "A solved layout: a file (.pb, .json or .textproto), digits of its id, or JOB/solve");
  SourceFlags source{command()};
  std::string& object = Text("--object", "Only this one, by id or name such as \"dining chair 2\", in full");
  bool& all = Flag("--all", "Every constraint of every object; by default those with a reason and those violated");
  bool& json = Flag("--json", "As JSON, with every constraint");
  std::string& optimizer = Text("--optimizer HOST:PORT", "Describe constraints in the words of this server");
};

absl::Status Explain(const ExplainArguments& arguments) {
  ASSIGN_OR_RETURN(const v1::Artifact artifact, OpenArtifact(arguments.file, arguments.source));
  if (!artifact.has_solved_layout()) {
    const char* const advice = artifact.has_layout_graph() ? "; first: flair solve" : "";
    return InvalidArgument("{}: a {}; expected a solved layout{}", arguments.file,
                           KindName(orchestrator::KindOf(artifact)), advice);
  }
  ASSIGN_OR_RETURN(const v1::ConstraintCatalog catalog, CallListConstraintTypes(arguments.optimizer));
  const absl::StatusOr<Note> note = MakeLayoutNote(artifact.solved_layout(), catalog);
  if (!note.ok()) return InvalidArgument("{}: {}", arguments.file, note.status().message());
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

void AddInspect(const Commands& program) {
  program.Add("inspect", "Show an artifact or a job: contents, producer, inputs.", Inspect,
              "JSON and textproto may be edited by hand; any command that reads artifacts takes the file. Faults are "
              "reported with file and line. An edited artifact gets a new id and names the original as its input. "
              "Exits with 5 when the id is not the digest of the bytes, with 2 when the content is not valid.");
}

void AddExplain(const Commands& program) {
  program.Add("explain", "Explain why everything in a layout stands where it does.", Explain,
              "By zone: where each object stands, the sentences that put it there with their reasons, what is violated "
              "and by how much (\"!\"), what follows from its place, and what was left out. In brackets are the ids of "
              "constraints, for flair resolve --edit \"drop e12\".\n"
              "\n"
              "Try: flair explain out/bedroom/layout.pb --object desk");
}

}  // namespace flair::cli
