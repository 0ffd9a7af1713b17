// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/local_artifacts.h"

#include <fmt/format.h>

#include <algorithm>

namespace flair::orchestrator {
namespace {

// Up to some 100 kB a row is written and read sooner than a file is opened.
constexpr size_t kSmallBytes = 64 * 1024;

constexpr std::string_view kArtifactSchema[] = {R"sql(
-- Rows go where the last one went, and only the index of the ids is written at random.
CREATE TABLE artifacts (
  id TEXT NOT NULL UNIQUE,
  stored_after INTEGER NOT NULL,  -- the mark that was the last one when it was last stored
  bytes BLOB NOT NULL
);
-- One row.
CREATE TABLE marks (
  last INTEGER NOT NULL,
  flush_count INTEGER NOT NULL
);
INSERT INTO marks VALUES (0, 0);
)sql"};

}  // namespace

absl::StatusOr<std::unique_ptr<LocalArtifacts>> LocalArtifacts::Open(const std::string& folder) {
  RETURN_IF_ERROR(ArtifactFiles::MakeFolder(folder));
  ASSIGN_OR_RETURN(auto rows, Database::Open(folder + "/small.db", kArtifactSchema));
  return std::unique_ptr<LocalArtifacts>(new LocalArtifacts(folder, std::move(rows)));
}

absl::Status LocalArtifacts::PutAll(std::span<const SealedArtifact> artifacts) {
  std::vector<const SealedArtifact*> small;
  for (const SealedArtifact& artifact : artifacts) {
    if (artifact.bytes.size() <= kSmallBytes) {
      small.push_back(&artifact);
    } else {
      RETURN_IF_ERROR(files_.PutAll(std::span(&artifact, 1)));
    }
  }
  if (small.empty()) return absl::OkStatus();
  ASSIGN_OR_RETURN(Transaction transaction, Transaction::Begin(*rows_));
  for (const SealedArtifact* artifact : small) {
    // Bytes that were damaged are repaired by this.
    RETURN_IF_ERROR(
        rows_->Run("INSERT INTO artifacts VALUES (?, (SELECT last FROM marks), ?) ON CONFLICT (id) DO UPDATE SET "
                   "stored_after = excluded.stored_after, bytes = excluded.bytes",
                   artifact->ref.id(), Blob{artifact->bytes}));
  }
  return transaction.Commit();
}

absl::StatusOr<v1::Artifact> LocalArtifacts::Get(const std::string& id) {
  // Nothing that was stored has no bytes.
  ASSIGN_OR_RETURN(const std::string bytes, rows_->FirstText("SELECT bytes FROM artifacts WHERE id = ?", id));
  return bytes.empty() ? files_.Get(id) : ParseArtifact(bytes, id, "small.db: artifact " + id);
}

absl::Status LocalArtifacts::Flush(std::span<const v1::ArtifactRef> artifacts) {
  RETURN_IF_ERROR(files_.Flush(artifacts));
  // A commit that is flushed takes all earlier ones to the disk with it.
  ASSIGN_OR_RETURN(Transaction transaction, Transaction::Begin(*rows_, Transaction::Durability::kPowerLoss));
  RETURN_IF_ERROR(rows_->Run("UPDATE marks SET flush_count = flush_count + 1"));
  return transaction.Commit();
}

absl::StatusOr<int64_t> LocalArtifacts::Mark() {
  ASSIGN_OR_RETURN(const int64_t mark, files_.Mark());
  RETURN_IF_ERROR(rows_->Run("UPDATE marks SET last = max(last, ?)", mark));
  return mark;
}

absl::StatusOr<int64_t> LocalArtifacts::Delete(std::span<const std::string> ids, int64_t mark) {
  int64_t deleted_count = 0;
  for (const std::string& id : ids) {
    ASSIGN_OR_RETURN(const int64_t files, files_.Delete(std::span(&id, 1), mark));
    ASSIGN_OR_RETURN(const int64_t rows,
                     rows_->RunAndCount("DELETE FROM artifacts WHERE id = ? AND stored_after < ?", id, mark));
    if (files > 0 || rows > 0) ++deleted_count;
  }
  return deleted_count;
}

absl::StatusOr<std::vector<std::string>> LocalArtifacts::FindIds(const std::string& prefix) {
  // Ids are digits up to f.
  ASSIGN_OR_RETURN(auto ids, rows_->Texts("SELECT id FROM artifacts WHERE id >= ? AND id < ?", prefix, prefix + "g"));
  std::ranges::copy(files_.FindIds(prefix), std::back_inserter(ids));
  std::ranges::sort(ids);
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

}  // namespace flair::orchestrator
