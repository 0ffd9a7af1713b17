// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/artifact_id.h"

#include <algorithm>

#include "absl/strings/ascii.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

// The id comes first in an artifact's bytes, as field 1: a tag, its length, its characters. What it is the digest of
// are the bytes after it.
constexpr size_t kIdLength = 64;
constexpr char kIdField[] = {(v1::Artifact::kIdFieldNumber << 3) | 2, kIdLength};
static_assert(v1::Artifact::kIdFieldNumber == 1);

std::string IdField(std::string_view id) { return std::string(kIdField, sizeof kIdField).append(id); }

}  // namespace

SealedArtifact SealArtifact(v1::Artifact& artifact) {
  // The bytes with an id of zeros, whose place the digest of what follows then takes.
  artifact.set_id(std::string(kIdLength, '0'));
  SealedArtifact sealed;
  sealed.bytes = runtime::CanonicalBytes(artifact);
  constexpr size_t kContent = sizeof kIdField + kIdLength;
  artifact.set_id(runtime::Sha256Hex(std::string_view(sealed.bytes).substr(kContent)));
  sealed.bytes.replace(sizeof kIdField, kIdLength, artifact.id());
  sealed.ref.set_id(artifact.id());
  sealed.ref.set_kind(KindOf(artifact));
  sealed.ref.set_size_bytes(static_cast<int64_t>(sealed.bytes.size()));
  return sealed;
}

bool AreBytesOf(std::string_view bytes, std::string_view id) {
  const std::string field = IdField(id);
  return bytes.starts_with(field) && runtime::Sha256Hex(bytes.substr(field.size())) == id;
}

absl::StatusOr<v1::Artifact> ParseArtifact(const std::string& bytes, std::string_view id, std::string_view place) {
  v1::Artifact artifact;
  if (AreBytesOf(bytes, id) && artifact.ParseFromString(bytes)) return artifact;
  return DataLoss("{}: damaged: its {} bytes are not those of the artifact with that id", place, bytes.size());
}

std::string ComputeArtifactId(v1::Artifact artifact) {
  artifact.clear_id();
  return runtime::Sha256Hex(runtime::CanonicalBytes(artifact));
}

v1::ArtifactKind KindOf(const v1::Artifact& artifact) {
  // The members of the oneof are numbered from 16 in the order of the enum, which counts from 1.
  if (artifact.content_case() == v1::Artifact::CONTENT_NOT_SET) return v1::ARTIFACT_KIND_UNSPECIFIED;
  const int kind = static_cast<int>(artifact.content_case()) - static_cast<int>(v1::Artifact::kBrief) + 1;
  return static_cast<v1::ArtifactKind>(kind);
}

bool IsArtifactId(std::string_view id) {
  return id.size() == 64 &&
         std::ranges::all_of(id, [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
}

v1::Brief BriefOf(const v1::JobSpec& spec) {
  v1::Brief brief = spec.brief();
  const absl::string_view trimmed = absl::StripAsciiWhitespace(spec.brief().text());
  if (trimmed.size() != spec.brief().text().size()) brief.set_text(std::string(trimmed));
  return brief;
}

std::string ResultKey(std::string_view stage, std::string_view revision, std::string_view options_digest,
                      const std::vector<std::string>& input_ids, std::string_view job_id) {
  std::string text;
  const auto append = [&text](std::string_view part) {
    text += std::to_string(part.size());
    text += ':';
    text += part;
  };
  append(stage);
  append(revision);
  append(options_digest);
  for (const std::string& id : input_ids) append(id);
  if (!job_id.empty()) append(job_id);
  return runtime::Sha256Hex(text);
}

}  // namespace flair::orchestrator
