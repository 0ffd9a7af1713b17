// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/artifact_file.h"

#include <google/protobuf/descriptor.h>

#include <algorithm>
#include <deque>
#include <map>
#include <set>
#include <utility>

#include "cli/input/message_text.h"
#include "cli/output/artifact_text.h"
#include "cli/output/output_folder.h"
#include "fmt/format.h"
#include "orchestrator/store/artifact_id.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"

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
      return InvalidArgument(
          "{0}: a recorded FlairGPT problem, not an artifact; first: flair-dev import flairgpt {0} --out graph.pb",
          name);
    }
    return status;
  }
  if (artifact.content_case() != v1::Artifact::CONTENT_NOT_SET) return artifact;
  return InvalidArgument(
      "{}: an artifact without content; expected one of brief, room, zone_plan, object_list, style_sheet, "
      "raw_constraint_list, constraint_list, completed_constraint_list, layout_graph, solved_layout, "
      "preview, report",
      name);
}

absl::Status BadId(const std::string& name, const v1::Artifact& artifact) {
  return DataLoss("{}: corrupt: its bytes have the id {}, but it says {}. If you changed it on purpose, clear its id",
                  name, orchestrator::ComputeArtifactId(artifact), artifact.id().empty() ? "none" : artifact.id());
}

std::string MakerOf(const v1::Producer& producer) {
  if (producer.program().empty()) return "";
  return fmt::format("of {}, {}, version {}", producer.program(), producer.method(), producer.version());
}

using google::protobuf::Descriptor;

// Whether a text has, outside of all others, a field that artifacts have and messages of the other type have not.
bool SeemsArtifact(ArtifactForm form, const std::string& text, const Descriptor& other) {
  const Descriptor& artifact = *v1::Artifact::descriptor();
  const size_t start = FindJsonField(text, {});
  for (int i = 0; i < artifact.field_count(); ++i) {
    const std::string& name = artifact.field(i)->name();
    if (other.FindFieldByName(name) != nullptr) continue;
    if (form == ArtifactForm::kJson && FindJsonField(text, {{name}}) != start) return true;
    for (const char* mark : {" {", "{", ":"}) {
      if (form == ArtifactForm::kProtobufText && ("\n" + text).find("\n" + name + mark) != std::string::npos)
        return true;
    }
  }
  return false;
}

constexpr char kExample[] = "a Brief, such as: text: \"A bedroom.\" object_list { objects { id: \"bed\" ... } }";

// A brief whose text is given elsewhere may be without one.
std::vector<validation::Problem> ProblemsBesidesText(v1::Brief brief) {
  if (brief.text().empty()) brief.set_text("A room.");
  return FindProblems(brief);
}

// What a folder holds, by id, with the artifacts that are not what they say left out.
std::map<std::string, v1::Artifact> Beside(const std::filesystem::path& folder) {
  std::map<std::string, v1::Artifact> artifacts;
  for (int kind = 1; kind < v1::ArtifactKind_ARRAYSIZE; ++kind) {
    const std::string stem = FileStem(static_cast<v1::ArtifactKind>(kind));
    std::error_code error;
    const std::filesystem::path path = folder / (stem + ".pb");
    if (stem.empty() || !std::filesystem::is_regular_file(path, error)) continue;
    absl::StatusOr<v1::Artifact> artifact = ReadArtifact(path);
    if (artifact.ok()) artifacts[artifact->id()] = *std::move(artifact);
  }
  return artifacts;
}

std::optional<v1::Brief> BriefOf(const v1::Artifact& layout, const std::filesystem::path& folder) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(folder / "brief.pb", error)) return std::nullopt;
  const std::map<std::string, v1::Artifact> artifacts = Beside(folder);
  std::set<std::string> seen;
  std::deque<std::string> ids(layout.made_from_ids().begin(), layout.made_from_ids().end());
  for (; !ids.empty(); ids.pop_front()) {
    const auto found = artifacts.find(ids.front());
    if (found == artifacts.end() || !seen.insert(ids.front()).second) continue;
    if (found->second.has_brief()) return found->second.brief();
    ids.insert(ids.end(), found->second.made_from_ids().begin(), found->second.made_from_ids().end());
  }
  return std::nullopt;
}

}  // namespace

bool IsEdited(const v1::Artifact& artifact) {
  return artifact.producer().program() == kEditor && artifact.producer().method() == kEditedByHand;
}

void MarkEdited(v1::Artifact& artifact) {
  const std::string before = artifact.id();
  auto& made_from = *artifact.mutable_made_from_ids();
  const bool has_parent = std::ranges::find(made_from, before) != made_from.end();
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
  ASSIGN_OR_RETURN(v1::Artifact artifact, is_binary ? ParseBinaryArtifact(name, bytes) : ParseText(name, form, bytes));
  ArtifactFile file{.artifact = std::move(artifact), .edited = false, .stated_id = "", .whole = {}, .good = {}};
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
  ASSIGN_OR_RETURN(const std::string bytes, ReadFile(path));
  return ParseArtifactFile(path, bytes);
}

absl::StatusOr<v1::Artifact> ReadArtifact(const std::filesystem::path& path) {
  ASSIGN_OR_RETURN(ArtifactFile file, ReadArtifactFile(path));
  if (!file.whole.ok()) return file.whole;
  if (!file.good.ok()) return file.good;
  return std::move(file.artifact);
}

absl::Status CheckArtifactId(const v1::Artifact& artifact, const std::filesystem::path& path) {
  if (artifact.id() == orchestrator::ComputeArtifactId(artifact)) return absl::OkStatus();
  return BadId(path.string(), artifact);
}

absl::StatusOr<bool> ReadArtifactOr(const std::filesystem::path& path, v1::Artifact& artifact,
                                    google::protobuf::Message& alone,
                                    const std::function<std::vector<validation::Problem>()>& problems) {
  ASSIGN_OR_RETURN(const std::string bytes, ReadFile(path));
  const ArtifactForm form = FormOf(path, bytes);
  const bool is_text = form != ArtifactForm::kBinary && !bytes.empty();
  if (!is_text || SeemsArtifact(form, bytes, *alone.GetDescriptor())) {
    absl::StatusOr<v1::Artifact> read = ReadArtifact(path);
    if (read.ok()) artifact = *std::move(read);
    // Bytes that are no artifact at all may be the message.
    const bool may_be_alone = absl::IsDataLoss(read.status()) && LeadingId(bytes).empty() && !is_text &&
                              ForeignKind(bytes).empty() && !bytes.empty() && alone.ParseFromString(bytes);
    if (!may_be_alone) return read.ok() ? absl::StatusOr<bool>(true) : read.status();
    RETURN_IF_ERROR(ListProblems(path.string(), problems()));
    return false;
  }
  const TextForm text_form = form == ArtifactForm::kJson ? TextForm::kJson : TextForm::kProtobufText;
  absl::Status status = ParseMessageText(text_form, path.string(), bytes, alone);
  if (status.ok()) status = LocateProblems(text_form, path.string(), bytes, alone, problems());
  if (!status.ok()) return status;
  return false;
}

absl::StatusOr<v1::Brief> ReadBrief(const std::string& flag, const std::string& path) {
  v1::Artifact artifact;
  v1::Brief brief;
  const absl::StatusOr<bool> is_artifact = ReadArtifactOr(path, artifact, brief, [&brief] {
    if (brief.has_room()) CompleteRoom(*brief.mutable_room());
    return ProblemsBesidesText(brief);
  });
  if (!is_artifact.ok()) {
    const absl::Status& status = is_artifact.status();
    const std::string advice = absl::IsInvalidArgument(status) ? fmt::format("; should hold {}", kExample) : "";
    return absl::Status(status.code(), fmt::format("{}: {}{}", flag, std::string(status.message()), advice));
  }
  if (!*is_artifact) return brief;
  if (artifact.has_brief()) return artifact.brief();
  return InvalidArgument("{}: {}: an artifact without a brief; expected brief.pb or brief.json of a design, or a Brief",
                         flag, path);
}

absl::StatusOr<LayoutFile> ReadLayoutFile(const std::filesystem::path& path) {
  ASSIGN_OR_RETURN(v1::Artifact artifact, ReadArtifact(path));
  if (!artifact.has_solved_layout()) {
    return InvalidArgument("{}: not a layout; give the layout.pb of a design", path.string());
  }
  LayoutFile file{.artifact = std::move(artifact), .brief = {}};
  file.brief = BriefOf(file.artifact, path.parent_path());
  return file;
}

}  // namespace flair::cli
