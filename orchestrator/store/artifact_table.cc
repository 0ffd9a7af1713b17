// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/artifact_table.h"

namespace flair::orchestrator {
namespace {

v1::ArtifactRef ReadRef(const Statement& row) {
  v1::ArtifactRef ref;
  ref.set_id(row.Text(0));
  ref.set_kind(static_cast<v1::ArtifactKind>(row.Int(1)));
  ref.set_size_bytes(row.Int(2));
  return ref;
}

}  // namespace

absl::StatusOr<std::vector<v1::ArtifactRef>> ArtifactTable::OfJob(const std::string& job_id) {
  const auto lock = database_.lock();
  Statement select = database_.Prepare(
      "SELECT artifact_id, kind, size_bytes FROM job_artifacts WHERE job_id = ? ORDER BY stage_index");
  select.Bind(job_id);
  std::vector<v1::ArtifactRef> refs;
  while (true) {
    absl::StatusOr<bool> row = select.Step();
    if (!row.ok()) return row.status();
    if (!*row) return refs;
    refs.push_back(ReadRef(select));
  }
}

absl::Status ArtifactTable::Attach(const std::string& job_id, int stage_index, const v1::ArtifactRef& artifact) {
  const auto lock = database_.lock();
  return database_.Prepare("INSERT OR REPLACE INTO job_artifacts VALUES (?, ?, ?, ?, ?)")
      .Bind(job_id)
      .Bind(stage_index)
      .Bind(artifact.id())
      .Bind(artifact.kind())
      .Bind(artifact.size_bytes())
      .Run();
}

absl::StatusOr<std::optional<v1::ArtifactRef>> ArtifactTable::FindResult(const std::string& key) {
  const auto lock = database_.lock();
  Statement select = database_.Prepare("SELECT artifact_id, kind, size_bytes FROM results WHERE key = ?");
  absl::StatusOr<bool> row = select.Bind(key).Step();
  if (!row.ok()) return row.status();
  if (!*row) return std::nullopt;
  return ReadRef(select);
}

absl::Status ArtifactTable::SetResult(const std::string& key, const v1::ArtifactRef& artifact) {
  const auto lock = database_.lock();
  return database_.Prepare("INSERT OR REPLACE INTO results VALUES (?, ?, ?, ?)")
      .Bind(key)
      .Bind(artifact.id())
      .Bind(artifact.kind())
      .Bind(artifact.size_bytes())
      .Run();
}

}  // namespace flair::orchestrator
