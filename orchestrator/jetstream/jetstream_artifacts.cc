// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/jetstream/jetstream_artifacts.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/strings/numbers.h"
#include "orchestrator/store/artifact_id.h"

namespace flair::orchestrator {
namespace {

// Well below the 1 MiB that servers take by default.
constexpr size_t kPieceBytes = 512 * 1024;
// Pieces on their way at once.
constexpr size_t kPiecesAtOnce = 16;
// What a manifest may say, against damaged ones: 4 GiB.
constexpr int kMostPieces = 8192;

constexpr std::string_view kWhole = "whole\n";
constexpr std::string_view kPieces = "pieces ";

std::string PieceKey(const std::string& id, size_t number) { return fmt::format("{}.{}", id, number); }

absl::Status Damaged(const std::string& id) {
  return absl::DataLossError(fmt::format("artifact {}: damaged: what the queue's servers have is not it", id));
}

}  // namespace

JetStreamArtifacts::JetStreamArtifacts(std::unique_ptr<QueueParts> parts)
    : parts_(std::move(parts)), artifacts_(parts_->api, parts_->names.Bucket("artifacts")) {}

absl::Status JetStreamArtifacts::PutAll(std::span<const SealedArtifact> artifacts) {
  // Most are small and new: one way to the servers and back for all of those.
  std::vector<const SealedArtifact*> small;
  std::vector<const SealedArtifact*> others;
  std::vector<NatsRequest> requests;
  for (const SealedArtifact& artifact : artifacts) {
    if (artifact.bytes.size() > kPieceBytes) {
      others.push_back(&artifact);
      continue;
    }
    small.push_back(&artifact);
    requests.push_back(artifacts_.NewRequest(artifact.ref.id(), std::string(kWhole) + artifact.bytes));
  }
  const std::vector<absl::StatusOr<StoredAck>> acks = parts_->api.PublishAll(requests);
  for (size_t i = 0; i < small.size(); ++i) {
    if (absl::IsAborted(acks[i].status())) {
      others.push_back(small[i]);
    } else if (!acks[i].ok()) {
      return acks[i].status();
    }
  }
  for (const SealedArtifact* artifact : others) {
    if (absl::Status status = PutOne(*artifact); !status.ok()) return status;
  }
  return absl::OkStatus();
}

absl::Status JetStreamArtifacts::PutOne(const SealedArtifact& artifact) {
  const std::string& id = artifact.ref.id();
  const absl::StatusOr<std::string> known = Read(id);
  if (known.ok() && *known == artifact.bytes) return absl::OkStatus();
  if (!known.ok() && !absl::IsNotFound(known.status()) && !absl::IsDataLoss(known.status())) return known.status();
  return Write(id, artifact.bytes);
}

absl::Status JetStreamArtifacts::Write(const std::string& id, const std::string& bytes) {
  if (bytes.size() <= kPieceBytes) return artifacts_.Put(id, std::string(kWhole) + bytes).status();
  const size_t count = (bytes.size() + kPieceBytes - 1) / kPieceBytes;
  for (size_t first = 0; first < count; first += kPiecesAtOnce) {
    std::vector<NatsRequest> pieces;
    for (size_t i = first; i < std::min(count, first + kPiecesAtOnce); ++i) {
      pieces.push_back({artifacts_.SubjectOf(PieceKey(id, i)), bytes.substr(i * kPieceBytes, kPieceBytes), {}});
    }
    for (const absl::StatusOr<StoredAck>& ack : parts_->api.PublishAll(pieces)) {
      if (!ack.ok()) return ack.status();
    }
  }
  return artifacts_.Put(id, fmt::format("{}{}\n", kPieces, count)).status();
}

absl::StatusOr<std::string> JetStreamArtifacts::Read(const std::string& id) {
  absl::StatusOr<Bucket::Entry> entry = artifacts_.Get(id);
  if (absl::IsNotFound(entry.status())) {
    return absl::NotFoundError(fmt::format("artifact {}: not in this store", id));
  }
  if (!entry.ok()) return entry.status();
  std::string_view value = entry->value;
  if (value.starts_with(kWhole)) return std::string(value.substr(kWhole.size()));
  int count = 0;
  if (!value.starts_with(kPieces) || !absl::SimpleAtoi(entry->value.substr(kPieces.size()), &count) || count < 1 ||
      count > kMostPieces) {
    return Damaged(id);
  }
  std::string bytes;
  for (int i = 0; i < count; ++i) {
    const absl::StatusOr<Bucket::Entry> piece = artifacts_.Get(PieceKey(id, static_cast<size_t>(i)));
    if (absl::IsNotFound(piece.status())) return Damaged(id);
    if (!piece.ok()) return piece.status();
    bytes += piece->value;
  }
  return bytes;
}

absl::StatusOr<v1::Artifact> JetStreamArtifacts::Get(const std::string& id) {
  if (!IsArtifactId(id)) {
    return absl::InvalidArgumentError(
        fmt::format("artifact_id: \"{}\" is not an id; expected 64 characters 0-9 and a-f", id.substr(0, 80)));
  }
  const absl::StatusOr<std::string> bytes = Read(id);
  if (!bytes.ok()) return bytes.status();
  v1::Artifact artifact;
  if (!AreBytesOf(*bytes, id) || !artifact.ParseFromString(*bytes)) return Damaged(id);
  return artifact;
}

}  // namespace flair::orchestrator
