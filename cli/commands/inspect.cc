// SPDX-License-Identifier: GPL-3.0-or-later
// flair inspect: any artifact, readable.
#include <cstdio>
#include <filesystem>
#include <memory>

#include "cli/commands/commands.h"
#include "cli/exit_code.h"
#include "cli/input/files.h"
#include "cli/output/artifact_text.h"
#include "cli/output/layout_remarks.h"
#include "cli/output/models_text.h"
#include "fmt/format.h"
#include "orchestrator/pipeline/summary.h"
#include "orchestrator/store/artifact_id.h"
#include "room/validation/validate.h"

namespace flair::cli {
namespace {

struct InspectArguments {
  std::string file;
  bool json = false;
  bool text = false;
  bool calls = false;
};

// The file beside `path` that holds the artifact of that id; empty when none does.
std::string NeighbourWithId(const std::filesystem::path& path, const std::string& id) {
  std::error_code error;
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  std::string found;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (entry.path().extension() != ".pb") continue;
    const absl::StatusOr<v1::Artifact> artifact = ReadArtifact(entry.path());
    const std::string name = entry.path().filename().string();
    if (artifact.ok() && artifact->id() == id && (found.empty() || name < found)) found = name;
  }
  return found;
}

void ShowSummary(const v1::Artifact& artifact, const std::filesystem::path& path, bool whole) {
  const v1::ArtifactKind kind = orchestrator::KindOf(artifact);
  fmt::print("{:<11}{}: {}\n", "what", KindName(kind), orchestrator::Summarize(artifact));
  fmt::print("{:<11}{} ({})\n", "id", artifact.id(), whole ? "matches its bytes" : "does NOT match its bytes: corrupt");
  const v1::Producer& producer = artifact.producer();
  if (!producer.program().empty()) {
    fmt::print("{:<11}{}, {}, version {}{}\n", "made by", producer.program(), producer.method(), producer.version(),
               producer.build().empty() ? "" : ", build " + producer.build());
  }
  if (!artifact.options_digest().empty()) fmt::print("{:<11}{}\n", "options", artifact.options_digest());
  for (int i = 0; i < artifact.made_from_ids_size(); ++i) {
    const std::string neighbour = NeighbourWithId(path, artifact.made_from_ids(i));
    fmt::print("{:<11}{}{}\n", i == 0 ? "made from" : "", artifact.made_from_ids(i),
               neighbour.empty() ? "" : "  " + neighbour);
  }
  if (const std::string models = orchestrator::SummarizeModels(artifact); !models.empty()) {
    fmt::print("{:<11}{}\n{}", "model", models, ModelCallLines(artifact));
  }
  if (artifact.has_solved_layout()) fmt::print("{}", LayoutRemarks(artifact.solved_layout()));
  if (const absl::Status status = Validate(artifact); !status.ok()) {
    fmt::print("{:<11}{}\n", "remark", std::string(status.message()));
  }
  fmt::print("{:<11}flair inspect {} --json | --text{}\n", "more", path.string(),
             artifact.model_calls().empty() ? "" : " | --calls");
}

absl::Status Inspect(const InspectArguments& arguments) {
  const absl::StatusOr<v1::Artifact> artifact = ReadArtifact(arguments.file);
  if (!artifact.ok()) return artifact.status();
  const absl::Status whole = CheckArtifactId(*artifact, arguments.file);
  if (arguments.json) {
    fmt::print("{}", ToJson(*artifact));
  } else if (arguments.text) {
    fmt::print("{}", ToText(*artifact));
  } else if (arguments.calls) {
    fmt::print("{}", artifact->model_calls().empty() ? "No model was asked for it.\n" : ModelCallTexts(*artifact));
  } else {
    ShowSummary(*artifact, arguments.file, whole.ok());
  }
  std::fflush(stdout);
  return whole;
}

}  // namespace

void AddInspect(CLI::App& program, absl::Status& result) {
  auto arguments = std::make_shared<InspectArguments>();
  CLI::App* command = program.add_subcommand("inspect", "Show an artifact, who made it and what it was made from.");
  command->add_option("FILE", arguments->file, "An artifact, .pb or .json")->required();
  CLI::Option* json = command->add_flag("--json", arguments->json, "All of it as JSON");
  CLI::Option* text = command->add_flag("--text", arguments->text, "All of it as protobuf text")->excludes(json);
  command->add_flag("--calls", arguments->calls, "What a language model was asked for it, and its answers")
      ->excludes(json)
      ->excludes(text);
  command->footer("Checks that the id is the digest of the bytes; ends with 5 when it is not.");
  command->callback([arguments, &result] { result = Inspect(*arguments); });
}

}  // namespace flair::cli
