// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "orchestrator/batch/artifact_store.h"
#include "orchestrator/jetstream/queue_parts.h"

namespace flair::orchestrator {

// Artifacts in a bucket of NATS servers. A small one is one value under its id, "whole\n" and its bytes; a large one is
// cut into pieces, ID.0, ID.1, ..., and "pieces COUNT\n" under its id comes last, so that what is there is whole. What
// is read must have the id.
class JetStreamArtifacts final : public ArtifactStore {
 public:
  explicit JetStreamArtifacts(std::unique_ptr<QueueParts> parts);

  absl::Status PutAll(std::span<const SealedArtifact> artifacts) override;
  absl::StatusOr<v1::Artifact> Get(const std::string& id) override;
  // The servers have what they have said yes to, on replica_count of them; they write to their disks by themselves.
  absl::Status Flush(std::span<const v1::ArtifactRef>) override { return absl::OkStatus(); }
  // Sequences of the bucket's stream.
  absl::StatusOr<int64_t> Mark() override;
  absl::StatusOr<int64_t> Delete(std::span<const std::string> ids, int64_t mark) override;

 private:
  absl::StatusOr<std::string> Read(const std::string& id);
  absl::StatusOr<int64_t> DeleteSome(std::span<const std::string> ids, uint64_t mark);
  absl::Status Write(const std::string& id, const std::string& bytes);

  const std::unique_ptr<QueueParts> parts_;
  Bucket artifacts_;
};

}  // namespace flair::orchestrator
