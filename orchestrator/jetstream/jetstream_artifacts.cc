// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/jetstream/jetstream_artifacts.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/strings/numbers.h"
#include "orchestrator/store/artifact_id.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

// Well below the 1 MiB that servers take by default.
constexpr size_t kPieceBytes = 512 * 1024;
// Pieces on their way at once.
constexpr size_t kPiecesAtOnce = 16;
// What a manifest may say, against damaged ones: 4 GiB.
constexpr int kMostPieces = 8192;

// Artifacts that are deleted at once; they are in memory then.
constexpr size_t kDeletedAtOnce = 16;

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
  // Also where it is there: who deletes it, since nobody had it, sees that it is wanted again.
  for (const SealedArtifact* artifact : others) {
    RETURN_IF_ERROR(Write(artifact->ref.id(), artifact->bytes));
  }
  return absl::OkStatus();
}

absl::Status JetStreamArtifacts::Write(const std::string& id, const std::string& bytes) {
  if (bytes.size() <= kPieceBytes) return artifacts_.Put(id, std::string(kWhole) + bytes).status();
  const size_t count = (bytes.size() + kPieceBytes - 1) / kPieceBytes;
  for (size_t first = 0; first < count; first += kPiecesAtOnce) {
    std::vector<NatsRequest> pieces;
    for (size_t i = first; i < std::min(count, first + kPiecesAtOnce); ++i) {
      pieces.push_back({artifacts_.SubjectOf(PieceKey(id, i)), bytes.substr(i * kPieceBytes, kPieceBytes), {}});
    }
    RETURN_IF_ERROR(parts_->api.PublishEach(pieces));
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
  ASSIGN_OR_RETURN(const std::string bytes, Read(id));
  v1::Artifact artifact;
  if (!AreBytesOf(bytes, id) || !artifact.ParseFromString(bytes)) return Damaged(id);
  return artifact;
}

absl::StatusOr<int64_t> JetStreamArtifacts::Mark() {
  ASSIGN_OR_RETURN(const uint64_t last, parts_->reader.LastSequence(artifacts_.stream()));
  return static_cast<int64_t>(last);
}

absl::StatusOr<int64_t> JetStreamArtifacts::Delete(std::span<const std::string> ids, int64_t mark) {
  int64_t deleted = 0;
  for (size_t first = 0; first < ids.size(); first += kDeletedAtOnce) {
    ASSIGN_OR_RETURN(const int64_t some, DeleteSome(ids.subspan(first, std::min(kDeletedAtOnce, ids.size() - first)),
                                                    static_cast<uint64_t>(std::max<int64_t>(0, mark))));
    deleted += some;
  }
  return deleted;
}

absl::StatusOr<int64_t> JetStreamArtifacts::DeleteSome(std::span<const std::string> ids, uint64_t mark) {
  std::vector<Bucket::Revision> removals;
  const std::vector<absl::StatusOr<Bucket::Entry>> entries = artifacts_.GetAll(ids);
  for (size_t i = 0; i < ids.size(); ++i) {
    if (absl::IsNotFound(entries[i].status())) continue;
    if (!entries[i].ok()) return entries[i].status();
    if (entries[i]->revision > mark) continue;
    // The value that says how many pieces there are goes last, as it came.
    if (entries[i]->value.starts_with(kPieces)) {
      const nlohmann::json pieces = {{"filter", artifacts_.SubjectOf(ids[i] + ".*")}, {"seq", mark + 1}};
      RETURN_IF_ERROR(parts_->api.Call("STREAM.PURGE." + artifacts_.stream(), pieces).status());
    }
    removals.push_back({ids[i], entries[i]->revision});
  }
  int64_t deleted = 0;
  for (const absl::StatusOr<bool>& removed : artifacts_.RemoveAll(removals)) {
    RETURN_IF_ERROR(removed.status());
    deleted += *removed ? 1 : 0;
  }
  return deleted;
}

}  // namespace flair::orchestrator
