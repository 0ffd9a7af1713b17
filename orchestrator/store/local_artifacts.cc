// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/local_artifacts.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace flair::orchestrator {
namespace {

// Up to some 100 kB a row is written and read sooner than a file is opened.
constexpr size_t kSmallBytes = 64 * 1024;

// Of jobs that run, and of those that ended before they were flushed.
constexpr size_t kMostRemembered = 4096;

}  // namespace

absl::StatusOr<std::unique_ptr<LocalArtifacts>> LocalArtifacts::Open(const std::string& folder) {
  if (absl::Status status = ArtifactFiles::MakeFolder(folder); !status.ok()) return status;
  auto rows = ArtifactRows::Open(folder + "/small.db");
  if (!rows.ok()) return rows.status();
  return std::unique_ptr<LocalArtifacts>(new LocalArtifacts(folder, *std::move(rows)));
}

absl::Status LocalArtifacts::PutAll(std::span<const SealedArtifact> artifacts) {
  std::vector<const SealedArtifact*> small;
  for (const SealedArtifact& artifact : artifacts) {
    if (artifact.bytes.size() <= kSmallBytes) {
      small.push_back(&artifact);
    } else if (absl::Status status = files_.PutAll(std::span(&artifact, 1)); !status.ok()) {
      return status;
    }
  }
  if (small.empty()) return absl::OkStatus();
  if (absl::Status status = rows_->PutAll(small); !status.ok()) return status;
  RememberRows(small);
  return absl::OkStatus();
}

void LocalArtifacts::RememberRows(std::span<const SealedArtifact* const> artifacts) {
  std::lock_guard lock(mutex_);
  if (new_rows_.size() > kMostRemembered) new_rows_.clear();
  for (const SealedArtifact* artifact : artifacts) new_rows_.insert(artifact->ref.id());
}

std::vector<v1::ArtifactRef> LocalArtifacts::WithoutRows(std::span<const v1::ArtifactRef> artifacts) {
  std::lock_guard lock(mutex_);
  std::vector<v1::ArtifactRef> others;
  for (const v1::ArtifactRef& artifact : artifacts) {
    if (new_rows_.erase(artifact.id()) == 0) others.push_back(artifact);
  }
  return others;
}

absl::StatusOr<v1::Artifact> LocalArtifacts::Get(const std::string& id) {
  if (!IsArtifactId(id)) return files_.Get(id);
  const absl::StatusOr<std::optional<std::string>> bytes = rows_->Get(id);
  if (!bytes.ok()) return bytes.status();
  return bytes->has_value() ? ParseArtifact(**bytes, id, "small.db: artifact " + id) : files_.Get(id);
}

absl::Status LocalArtifacts::Flush(std::span<const v1::ArtifactRef> artifacts) {
  // Of other small ones there are no files either, which are left out.
  if (absl::Status status = files_.Flush(WithoutRows(artifacts)); !status.ok()) return status;
  return rows_->Flush();
}

absl::StatusOr<int64_t> LocalArtifacts::Mark() {
  const absl::StatusOr<int64_t> mark = files_.Mark();
  if (!mark.ok()) return mark;
  const absl::Status status = rows_->SetMark(*mark);
  return status.ok() ? mark : status;
}

absl::StatusOr<int64_t> LocalArtifacts::Delete(std::span<const std::string> ids, int64_t mark) {
  int64_t deleted_count = 0;
  for (const std::string& id : ids) {
    const absl::StatusOr<int64_t> files = files_.Delete(std::span(&id, 1), mark);
    if (!files.ok()) return files.status();
    const absl::StatusOr<bool> row = rows_->Delete(id, mark);
    if (!row.ok()) return row.status();
    if (*files > 0 || *row) ++deleted_count;
  }
  return deleted_count;
}

absl::StatusOr<std::vector<std::string>> LocalArtifacts::FindIds(const std::string& prefix) {
  absl::StatusOr<std::vector<std::string>> ids = rows_->FindIds(prefix);
  if (!ids.ok()) return ids;
  std::ranges::copy(files_.FindIds(prefix), std::back_inserter(*ids));
  std::ranges::sort(*ids);
  ids->erase(std::unique(ids->begin(), ids->end()), ids->end());
  return ids;
}

}  // namespace flair::orchestrator
