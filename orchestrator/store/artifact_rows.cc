// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/artifact_rows.h"

namespace flair::orchestrator {
namespace {

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

absl::StatusOr<std::unique_ptr<ArtifactRows>> ArtifactRows::Open(const std::string& path) {
  auto database = Database::Open(path, kArtifactSchema);
  if (!database.ok()) return database.status();
  return std::unique_ptr<ArtifactRows>(new ArtifactRows(*std::move(database)));
}

absl::Status ArtifactRows::PutAll(std::span<const SealedArtifact* const> artifacts) {
  auto transaction = Transaction::Begin(*database_);
  if (!transaction.ok()) return transaction.status();
  for (const SealedArtifact* artifact : artifacts) {
    // Bytes that were damaged are mended by this.
    const absl::Status status =
        database_
            ->Prepare(
                "INSERT INTO artifacts VALUES (?, (SELECT last FROM marks), ?) ON CONFLICT (id) DO UPDATE SET "
                "stored_after = excluded.stored_after, bytes = excluded.bytes")
            .Bind(artifact->ref.id())
            .BindBytes(artifact->bytes)
            .Run();
    if (!status.ok()) return status;
  }
  return transaction->Commit();
}

absl::StatusOr<std::optional<std::string>> ArtifactRows::Get(const std::string& id) {
  const auto lock = database_->lock();
  Statement select = database_->Prepare("SELECT bytes FROM artifacts WHERE id = ?");
  const absl::StatusOr<bool> row = select.Bind(id).Step();
  if (!row.ok()) return row.status();
  if (!*row) return std::nullopt;
  return select.Bytes(0);
}

absl::StatusOr<std::vector<std::string>> ArtifactRows::FindIds(const std::string& prefix) {
  const auto lock = database_->lock();
  // Ids are digits up to f.
  return database_->Prepare("SELECT id FROM artifacts WHERE id >= ? AND id < ?")
      .Bind(prefix)
      .Bind(prefix + "g")
      .Texts();
}

absl::Status ArtifactRows::Flush() { return database_->FlushLog(); }

absl::Status ArtifactRows::SetMark(int64_t mark) {
  const auto lock = database_->lock();
  return database_->Prepare("UPDATE marks SET last = max(last, ?)").Bind(mark).Run();
}

absl::StatusOr<bool> ArtifactRows::Delete(const std::string& id, int64_t mark) {
  const auto lock = database_->lock();
  const absl::Status status =
      database_->Prepare("DELETE FROM artifacts WHERE id = ? AND stored_after < ?").Bind(id).Bind(mark).Run();
  if (!status.ok()) return status;
  return database_->changes() > 0;
}

}  // namespace flair::orchestrator
