// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/artifact_table.h"

#include "orchestrator/store/artifact_id.h"
#include "orchestrator/store/digest_functions.h"

namespace flair::orchestrator {
namespace {

v1::ArtifactRef ReadRef(const Statement& row) {
  v1::ArtifactRef ref;
  ref.set_id(DigestHex(row.Bytes(0)));
  ref.set_kind(static_cast<v1::ArtifactKind>(row.Int(1)));
  ref.set_size_bytes(row.Int(2));
  return ref;
}

}  // namespace

ArtifactHolder::ArtifactHolder(const v1::Job& job)
    : job_id(job.id()), brief(BriefDigest(job.spec())), caller(job.owner()) {}

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

absl::Status ArtifactTable::Attach(const ArtifactHolder& holder, int stage_index, const v1::ArtifactRef& artifact) {
  const auto lock = database_.lock();
  return database_.Prepare("INSERT OR REPLACE INTO job_artifacts VALUES (?, ?, ?, ?, ?, ?, ?)")
      .Bind(holder.job_id)
      .Bind(stage_index)
      .BindBytes(DigestBytes(artifact.id()))
      .Bind(artifact.kind())
      .Bind(artifact.size_bytes())
      .BindBytes(holder.brief)
      .Bind(holder.caller)
      .Run();
}

absl::StatusOr<std::optional<v1::ArtifactRef>> ArtifactTable::FindResult(const std::string& brief,
                                                                         const std::string& key) {
  const auto lock = database_.lock();
  Statement select = database_.Prepare("SELECT artifact_id, kind, size_bytes FROM results WHERE brief = ? AND key = ?");
  absl::StatusOr<bool> row = select.BindBytes(brief).BindBytes(DigestBytes(key)).Step();
  if (!row.ok()) return row.status();
  if (!*row) return std::nullopt;
  return ReadRef(select);
}

absl::StatusOr<bool> ArtifactTable::HasResults(const std::string& brief) {
  const auto lock = database_.lock();
  return database_.Prepare("SELECT 1 FROM results WHERE brief = ? LIMIT 1").BindBytes(brief).Step();
}

absl::Status ArtifactTable::SetResult(const std::string& brief, const std::string& key,
                                      const v1::ArtifactRef& artifact) {
  const auto lock = database_.lock();
  return database_.Prepare("INSERT OR REPLACE INTO results VALUES (?, ?, ?, ?, ?)")
      .BindBytes(brief)
      .BindBytes(DigestBytes(key))
      .BindBytes(DigestBytes(artifact.id()))
      .Bind(artifact.kind())
      .Bind(artifact.size_bytes())
      .Run();
}

}  // namespace flair::orchestrator
