// SPDX-License-Identifier: GPL-3.0-or-later
// What people give to the commands: artifacts in all their forms, and paths to their parts.
#include <google/protobuf/stubs/logging.h>

#include <string>

#include "cli/input/artifact_file.h"
#include "cli/inspect/inspection.h"
#include "cli/output/artifact_text.h"
#include "orchestrator/store/artifact_id.h"
#include "tests/fixtures/bedroom.h"
#include "tests/fuzz/targets.h"

namespace flair::fuzz {
namespace {

// The same artifact comes back, and nobody takes it for changed.
void RequireSame(const v1::Artifact& artifact, const char* name, const std::string& bytes) {
  const absl::StatusOr<cli::ArtifactFile> again = cli::ParseArtifactFile(name, bytes);
  Require(again.ok(), "what was written is read again");
  Require(again->artifact.id() == artifact.id() && !again->edited, "what is read again is the same");
  Require(again->whole.ok() && again->good.ok(), "what is read again is as good");
}

void ReadAs(const char* name, const std::string& bytes) {
  const absl::StatusOr<cli::ArtifactFile> file = cli::ParseArtifactFile(name, bytes);
  if (!file.ok()) {
    Require(absl::IsDataLoss(file.status()) || absl::IsInvalidArgument(file.status()), "a refusal has its code");
    Require(std::string(file.status().message()).starts_with(name), "a refusal names the file");
    Require(file.status().message().size() < 20000, "a refusal is a readable text");
    return;
  }
  const v1::Artifact& artifact = file->artifact;
  Require(file->edited == (cli::IsEdited(artifact) && file->stated_id != artifact.id()), "what was edited says so");
  if (!file->whole.ok() || !file->good.ok()) return;
  Require(artifact.id() == orchestrator::ComputeArtifactId(artifact), "a good artifact has the id of its bytes");
  RequireSame(artifact, "again.pb", cli::ArtifactBytes(artifact));
  RequireSame(artifact, "again.json", cli::ToJson(artifact));
  RequireSame(artifact, "again.textproto", cli::ToText(artifact));
}

}  // namespace

void ReadArtifact(std::string_view bytes) {
  // The parsers report every bad character to stderr by default.
  [[maybe_unused]] static const auto old_handler = google::protobuf::SetLogHandler(nullptr);
  for (const char* name : {"f.pb", "f.json", "f.textproto"}) ReadAs(name, std::string(bytes));
}

void SelectField(std::string_view bytes) {
  static const v1::Artifact graph = [] {
    v1::Artifact artifact;
    *artifact.mutable_layout_graph() = testing::BedroomGraph();
    artifact.add_made_from_ids("first");
    return artifact;
  }();
  const absl::StatusOr<cli::FieldView> view = cli::FindField(graph, std::string(bytes));
  if (!view.ok()) {
    Require(absl::IsInvalidArgument(view.status()), "a wrong path is INVALID_ARGUMENT");
    Require(std::string(view.status().message()).starts_with("--field"), "a refusal names what was given");
    return;
  }
  Require(view->parent != nullptr && view->field != nullptr, "a path leads to a field");
  cli::FieldText(*view, cli::FieldFormat::kText);
  Require(cli::FieldText(*view, cli::FieldFormat::kJson).ends_with("\n"), "JSON ends its line");
}

}  // namespace flair::fuzz
