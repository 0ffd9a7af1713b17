// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/jetstream/open.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/strings/numbers.h"
#include "orchestrator/batch/job_rules.h"
#include "orchestrator/jetstream/jetstream_work_queue.h"
#include "orchestrator/jetstream/queue_parts.h"
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
  return DataLoss("artifact {}: damaged: the bytes on the queue's servers do not match the id", id);
}

// Artifacts in a bucket of NATS servers. A small one is one value under its id, "whole\n" and its bytes; a large one is
// cut into pieces, ID.0, ID.1, ..., and "pieces COUNT\n" under its id comes last, so that what is there is whole. What
// is read must have the id.
class JetStreamArtifacts final : public ArtifactStore {
 public:
  explicit JetStreamArtifacts(std::unique_ptr<QueueParts> parts)
      : parts_(std::move(parts)), artifacts_(parts_->streams, parts_->names.Bucket("artifacts")) {}

  absl::Status PutAll(std::span<const SealedArtifact> artifacts) override {
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
      requests.push_back(
          WithExpected(artifacts_.SubjectOf(artifact.ref.id()), std::string(kWhole) + artifact.bytes, 0));
    }
    const std::vector<absl::StatusOr<uint64_t>> acks = parts_->streams.PublishAll(requests);
    for (size_t i = 0; i < small.size(); ++i) {
      if (absl::IsAborted(acks[i].status())) {
        others.push_back(small[i]);
      } else if (!acks[i].ok()) {
        return acks[i].status();
      }
    }
    // Also where it is there: who deletes it, since nobody had it, sees that it is wanted again.
    for (const SealedArtifact* artifact : others) RETURN_IF_ERROR(Write(artifact->ref.id(), artifact->bytes));
    return absl::OkStatus();
  }

  absl::StatusOr<v1::Artifact> Get(const std::string& id) override {
    if (!IsArtifactId(id)) {
      return InvalidArgument("artifact_id: \"{}\" is not an id; expected 64 characters 0-9 and a-f", id.substr(0, 80));
    }
    ASSIGN_OR_RETURN(const std::string bytes, Read(id));
    v1::Artifact artifact;
    if (!AreBytesOf(bytes, id) || !artifact.ParseFromString(bytes)) return Damaged(id);
    return artifact;
  }

  // The servers have what they have said yes to, on replica_count of them; they write to their disks by themselves.
  absl::Status Flush(std::span<const v1::ArtifactRef>) override { return absl::OkStatus(); }
  // Sequences of the bucket's stream.
  absl::StatusOr<int64_t> Mark() override {
    ASSIGN_OR_RETURN(const uint64_t last, parts_->streams.LastSequence(artifacts_.stream()));
    return static_cast<int64_t>(last);
  }

  absl::StatusOr<int64_t> Delete(std::span<const std::string> ids, int64_t mark) override {
    int64_t deleted = 0;
    for (size_t first = 0; first < ids.size(); first += kDeletedAtOnce) {
      ASSIGN_OR_RETURN(const int64_t some, DeleteSome(ids.subspan(first, std::min(kDeletedAtOnce, ids.size() - first)),
                                                      static_cast<uint64_t>(std::max<int64_t>(0, mark))));
      deleted += some;
    }
    return deleted;
  }

 private:
  absl::StatusOr<std::string> Read(const std::string& id) {
    ASSIGN_OR_RETURN(const std::optional<Bucket::Entry> entry, IfFound(artifacts_.Get(id)));
    if (!entry.has_value()) return NotFound("artifact {}: not in this store", id);
    std::string_view value = entry->value;
    if (value.starts_with(kWhole)) return std::string(value.substr(kWhole.size()));
    int count = 0;
    if (!value.starts_with(kPieces) || !absl::SimpleAtoi(entry->value.substr(kPieces.size()), &count) || count < 1 ||
        count > kMostPieces) {
      return Damaged(id);
    }
    std::string bytes;
    for (int i = 0; i < count; ++i) {
      ASSIGN_OR_RETURN(const std::optional<Bucket::Entry> piece,
                       IfFound(artifacts_.Get(PieceKey(id, static_cast<size_t>(i)))));
      if (!piece.has_value()) return Damaged(id);
      bytes += piece->value;
    }
    return bytes;
  }

  absl::StatusOr<int64_t> DeleteSome(std::span<const std::string> ids, uint64_t mark) {
    std::vector<Bucket::Revision> removals;
    const std::vector<absl::StatusOr<Bucket::Entry>> entries = artifacts_.GetAll(ids);
    for (size_t i = 0; i < ids.size(); ++i) {
      if (absl::IsNotFound(entries[i].status())) continue;
      if (!entries[i].ok()) return entries[i].status();
      if (entries[i]->revision > mark) continue;
      // The value that says how many pieces there are goes last, as it came.
      if (entries[i]->value.starts_with(kPieces)) {
        RETURN_IF_ERROR(parts_->streams.Purge(artifacts_.stream(), artifacts_.SubjectOf(ids[i] + ".*"), mark + 1));
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

  absl::Status Write(const std::string& id, const std::string& bytes) {
    if (bytes.size() <= kPieceBytes) return artifacts_.Put(id, std::string(kWhole) + bytes).status();
    const size_t count = (bytes.size() + kPieceBytes - 1) / kPieceBytes;
    for (size_t first = 0; first < count; first += kPiecesAtOnce) {
      std::vector<NatsRequest> pieces;
      for (size_t i = first; i < std::min(count, first + kPiecesAtOnce); ++i) {
        pieces.push_back({artifacts_.SubjectOf(PieceKey(id, i)), bytes.substr(i * kPieceBytes, kPieceBytes), {}});
      }
      RETURN_IF_ERROR(parts_->streams.PublishEach(pieces));
    }
    return artifacts_.Put(id, fmt::format("{}{}\n", kPieces, count)).status();
  }

  const std::unique_ptr<QueueParts> parts_;
  Bucket artifacts_;
};

// How long a status is known after it was reported.
constexpr absl::Duration kStatusLife = absl::Seconds(10);

StreamOptions BucketStream(const std::string& bucket, int replica_count) {
  return {
      .name = "KV_" + bucket, .subject = "$KV." + bucket + ".>", .replica_count = replica_count, .latest_only = true};
}

// Makes the streams and buckets of a queue that are not there. Those that are stay as they are.
absl::Status MakeQueueStreams(Streams& streams, const QueueNames& names, int replica_count) {
  StreamOptions status = BucketStream(names.Bucket("status"), replica_count);
  status.life = kStatusLife;
  std::vector<StreamOptions> all = {
      {.name = names.queue_stream(), .subject = names.AllOf("*"), .replica_count = replica_count, .work_queue = true},
      {.name = names.ends_stream(),
       .subject = names.End("*", "*", "*", "*"),
       .replica_count = replica_count,
       .latest_only = true},
      status};
  for (const char* bucket : {"jobs", "batches", "requests", "index"}) {
    all.push_back(BucketStream(names.Bucket(bucket), replica_count));
  }
  for (const StreamOptions& stream : all) RETURN_IF_ERROR(streams.Make(stream));
  return absl::OkStatus();
}

absl::StatusOr<std::unique_ptr<QueueParts>> Connect(const config::v1::QueueConfig& config,
                                                    const config::v1::TlsConfig* tls, const runtime::Clock& clock) {
  RETURN_IF_ERROR(CheckQueueConfig(config, tls));
  ASSIGN_OR_RETURN(std::unique_ptr<NatsConnection> connection, NatsConnection::Open(config, tls));
  return std::make_unique<QueueParts>(std::move(connection), config, clock);
}

int ReplicaCount(const config::v1::QueueConfig& config) { return std::max(1, config.replica_count()); }

}  // namespace

absl::StatusOr<std::unique_ptr<WorkQueue>> OpenJetStreamQueue(const config::v1::QueueConfig& config,
                                                              const config::v1::TlsConfig* tls,
                                                              const runtime::Clock& clock) {
  ASSIGN_OR_RETURN(std::unique_ptr<QueueParts> parts, Connect(config, tls, clock));
  RETURN_IF_ERROR(MakeQueueStreams(parts->streams, parts->names, ReplicaCount(config)));
  return JetStreamWorkQueue::Open(std::move(parts));
}

absl::StatusOr<std::unique_ptr<ArtifactStore>> OpenJetStreamArtifacts(const config::v1::QueueConfig& config,
                                                                      const config::v1::TlsConfig* tls,
                                                                      const runtime::Clock& clock) {
  ASSIGN_OR_RETURN(std::unique_ptr<QueueParts> parts, Connect(config, tls, clock));
  RETURN_IF_ERROR(parts->streams.Make(BucketStream(parts->names.Bucket("artifacts"), ReplicaCount(config))));
  return std::make_unique<JetStreamArtifacts>(std::move(parts));
}

}  // namespace flair::orchestrator
