// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/artifact_file.h"

#include <algorithm>
#include <utility>

#include "cli/input/artifact_form.h"
#include "cli/input/binary_artifact.h"
#include "cli/input/files.h"
#include "cli/input/message_text.h"
#include "fmt/format.h"
#include "orchestrator/store/artifact_id.h"
#include "room/validation/validate.h"

namespace flair::cli {
namespace {

constexpr char kEditor[] = "flair";
constexpr char kEditedByHand[] = "edited by hand";

TextForm TextFormOf(ArtifactForm form) {
  return form == ArtifactForm::kJson ? TextForm::kJson : TextForm::kProtobufText;
}

// As the problems that `flair-dev import flairgpt` reads.
bool LooksRecorded(const std::string& json) {
  return json.find("\"fixed_objects\"") != std::string::npos && json.find("\"calls\"") != std::string::npos;
}

absl::StatusOr<v1::Artifact> ParseText(const std::string& name, ArtifactForm form, const std::string& text) {
  v1::Artifact artifact;
  if (absl::Status status = ParseMessageText(TextFormOf(form), name, text, artifact); !status.ok()) {
    if (form == ArtifactForm::kJson && LooksRecorded(text)) {
      return absl::InvalidArgumentError(fmt::format(
          "{0}: a recorded FlairGPT problem, no artifact; first: flair-dev import flairgpt {0} --out graph.pb", name));
    }
    return status;
  }
  if (artifact.content_case() != v1::Artifact::CONTENT_NOT_SET) return artifact;
  return absl::InvalidArgumentError(
      fmt::format("{}: an artifact without content; expected one of brief, room, zone_plan, object_list, style_sheet, "
                  "raw_constraint_list, constraint_list, layout_graph, solved_layout, preview, report",
                  name));
}

absl::Status BadId(const std::string& name, const v1::Artifact& artifact) {
  return absl::DataLossError(
      fmt::format("{}: corrupt: its bytes have the id {}, but it says {}. Who changed it on purpose clears its id",
                  name, orchestrator::ComputeArtifactId(artifact), artifact.id().empty() ? "none" : artifact.id()));
}

std::string MakerOf(const v1::Producer& producer) {
  if (producer.program().empty()) return "";
  return fmt::format("of {}, {}, version {}", producer.program(), producer.method(), producer.version());
}

}  // namespace

bool IsEdited(const v1::Artifact& artifact) {
  return artifact.producer().program() == kEditor && artifact.producer().method() == kEditedByHand;
}

void MarkEdited(v1::Artifact& artifact) {
  const std::string before = artifact.id();
  auto& made_from = *artifact.mutable_made_from_ids();
  const bool has_parent = std::find(made_from.begin(), made_from.end(), before) != made_from.end();
  if (orchestrator::IsArtifactId(before) && !has_parent) {
    *made_from.Add() = before;
    std::rotate(made_from.pointer_begin(), made_from.pointer_end() - 1, made_from.pointer_end());
  }
  v1::Producer producer;
  producer.set_program(kEditor);
  producer.set_method(kEditedByHand);
  producer.set_version(IsEdited(artifact) ? artifact.producer().version() : MakerOf(artifact.producer()));
  *artifact.mutable_producer() = std::move(producer);
  // Neither the stage's options nor the model made what it is now.
  artifact.clear_options_digest();
  artifact.clear_model_calls();
  artifact.set_id(orchestrator::ComputeArtifactId(artifact));
}

absl::StatusOr<ArtifactFile> ParseArtifactFile(const std::filesystem::path& path, const std::string& bytes) {
  const std::string name = path.string();
  const ArtifactForm form = FormOf(path, bytes);
  const std::string foreign = form == ArtifactForm::kBinary ? "" : ForeignKind(bytes);
  const bool is_binary = form == ArtifactForm::kBinary || bytes.empty() || (!foreign.empty() && foreign != "text");
  absl::StatusOr<v1::Artifact> artifact = is_binary ? ParseBinaryArtifact(name, bytes) : ParseText(name, form, bytes);
  if (!artifact.ok()) return artifact.status();
  ArtifactFile file{.artifact = *std::move(artifact), .edited = false, .stated_id = "", .whole = {}, .good = {}};
  file.stated_id = file.artifact.id();
  const std::vector<validation::Problem> problems = FindProblems(file.artifact);
  file.good =
      is_binary ? ListProblems(name, problems) : LocateProblems(TextFormOf(form), name, bytes, file.artifact, problems);
  const bool has_its_id =
      is_binary ? IsWhole(file.artifact, bytes) : file.stated_id == orchestrator::ComputeArtifactId(file.artifact);
  if (has_its_id) return file;
  if (is_binary && !file.stated_id.empty()) {
    file.whole = BadId(name, file.artifact);
    return file;
  }
  MarkEdited(file.artifact);
  file.edited = true;
  return file;
}

absl::StatusOr<ArtifactFile> ReadArtifactFile(const std::filesystem::path& path) {
  const absl::StatusOr<std::string> bytes = ReadFile(path);
  if (!bytes.ok()) return bytes.status();
  return ParseArtifactFile(path, *bytes);
}

absl::StatusOr<v1::Artifact> ReadArtifact(const std::filesystem::path& path) {
  absl::StatusOr<ArtifactFile> file = ReadArtifactFile(path);
  if (!file.ok()) return file.status();
  if (!file->whole.ok()) return file->whole;
  if (!file->good.ok()) return file->good;
  return std::move(file->artifact);
}

absl::Status CheckArtifactId(const v1::Artifact& artifact, const std::filesystem::path& path) {
  if (artifact.id() == orchestrator::ComputeArtifactId(artifact)) return absl::OkStatus();
  return BadId(path.string(), artifact);
}

}  // namespace flair::cli
