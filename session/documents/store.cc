// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/documents/store.h"

#include <set>
#include <string_view>
#include <utility>

#include "google/protobuf/util/time_util.h"
#include "orchestrator/store/local_artifacts.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::session {
namespace {

using orchestrator::Database;
using orchestrator::SealedArtifact;
using orchestrator::Statement;
using orchestrator::Transaction;
using store::v1::DocumentRecord;

constexpr std::string_view kSchema[] = {R"sql(
CREATE TABLE documents (
  id TEXT PRIMARY KEY,
  request_id TEXT NOT NULL UNIQUE,
  revision INTEGER NOT NULL,
  update_time_us INTEGER NOT NULL,
  record BLOB NOT NULL               -- DocumentRecord
) WITHOUT ROWID;
CREATE INDEX documents_by_time ON documents (update_time_us);
CREATE TABLE layouts (
  document_id TEXT NOT NULL,
  artifact_id TEXT NOT NULL,
  bytes BLOB NOT NULL,
  UNIQUE (document_id, artifact_id)
);
)sql"};

// Of this connection alone, and gone with it.
constexpr char kBin[] = R"sql(
CREATE TEMP TABLE deleted_documents AS SELECT * FROM documents WHERE FALSE;
CREATE TEMP TABLE deleted_layouts AS SELECT * FROM layouts WHERE FALSE;
)sql";

absl::StatusOr<DocumentRecord> ReadRecord(const Statement& row) {
  DocumentRecord record;
  if (!record.ParseFromString(row.Text(0))) return orchestrator::Damaged("documents.db", "a document cannot be read");
  return record;
}

absl::Status NoDocument(const std::string& id) {
  return NotFound("document_id: no document \"{}\" here", id.substr(0, 80));
}

// Ids of the layouts that a record needs.
std::set<std::string> NamedLayouts(const DocumentRecord& record) {
  std::set<std::string> ids;
  for (const store::v1::LayoutState& state : record.states()) {
    ids.insert(state.layout_id());
    ids.insert(state.settled_layout_id());
    ids.insert(state.other_variants_layout_id());
  }
  ids.insert(record.variants_layout_id());
  return ids;
}

}  // namespace

absl::StatusOr<std::unique_ptr<DocumentStore>> DocumentStore::Open(const std::string& folder) {
  RETURN_IF_ERROR(orchestrator::ArtifactFiles::MakeFolder(folder));
  ASSIGN_OR_RETURN(std::unique_ptr<Database> database, Database::Open(folder + "/documents.db", kSchema));
  RETURN_IF_ERROR(database->Execute(kBin));
  return std::unique_ptr<DocumentStore>(new DocumentStore(std::move(database)));
}

absl::StatusOr<DocumentRecord> DocumentStore::Get(const std::string& id) {
  const auto lock = database_->lock();
  Statement select = database_->Prepare("SELECT record FROM documents WHERE id = ?", id);
  ASSIGN_OR_RETURN(const bool found, select.Step());
  if (!found) return NoDocument(id);
  return ReadRecord(select);
}

absl::StatusOr<std::optional<DocumentRecord>> DocumentStore::FindByRequest(const std::string& request_id) {
  const auto lock = database_->lock();
  Statement select = database_->Prepare("SELECT record FROM documents WHERE request_id = ?", request_id);
  ASSIGN_OR_RETURN(const bool found, select.Step());
  if (!found) return std::nullopt;
  return ReadRecord(select);
}

absl::StatusOr<std::vector<DocumentRecord>> DocumentStore::List(int limit) {
  const auto lock = database_->lock();
  return orchestrator::ReadRows<DocumentRecord>(
      database_->Prepare("SELECT record FROM documents ORDER BY update_time_us DESC, id DESC LIMIT ?", limit),
      ReadRecord);
}

absl::StatusOr<v1::Artifact> DocumentStore::GetLayout(const std::string& document_id, const std::string& artifact_id) {
  const auto lock = database_->lock();
  Statement select = database_->Prepare("SELECT bytes FROM layouts WHERE document_id = ? AND artifact_id = ?",
                                        document_id, artifact_id);
  ASSIGN_OR_RETURN(const bool found, select.Step());
  if (!found) return NotFound("document \"{}\" has no layout {}", document_id, artifact_id);
  return orchestrator::ParseArtifact(select.Text(0), artifact_id, "documents.db");
}

absl::StatusOr<v1::Artifact> DocumentStore::FindLayout(const std::string& artifact_id) {
  const auto lock = database_->lock();
  Statement select = database_->Prepare("SELECT bytes FROM layouts WHERE artifact_id = ? LIMIT 1", artifact_id);
  ASSIGN_OR_RETURN(const bool found, select.Step());
  if (!found) return NotFound("no document has a layout {}", artifact_id);
  return orchestrator::ParseArtifact(select.Text(0), artifact_id, "documents.db");
}

absl::Status DocumentStore::Replace(const DocumentRecord& record) {
  const std::string& id = record.document().id();
  ASSIGN_OR_RETURN(const int64_t revision, database_->FirstInt("SELECT revision FROM documents WHERE id = ?", id));
  if (revision == 0) return NoDocument(id);
  if (revision != record.document().revision() - 1) {
    return absl::AbortedError("the document has been changed by somebody else meanwhile");
  }
  ASSIGN_OR_RETURN(const std::vector<std::string> stored,
                   database_->Texts("SELECT artifact_id FROM layouts WHERE document_id = ?", id));
  const std::set<std::string> named = NamedLayouts(record);
  for (const std::string& artifact_id : stored) {
    if (named.contains(artifact_id)) continue;
    RETURN_IF_ERROR(database_->Run("DELETE FROM layouts WHERE document_id = ? AND artifact_id = ?", id, artifact_id));
  }
  return absl::OkStatus();
}

absl::Status DocumentStore::Save(const DocumentRecord& record, std::span<const SealedArtifact> added) {
  ASSIGN_OR_RETURN(Transaction transaction, Transaction::Begin(*database_));
  const v1::Document& document = record.document();
  if (document.revision() > 1) RETURN_IF_ERROR(Replace(record));
  for (const SealedArtifact& artifact : added) {
    RETURN_IF_ERROR(database_->Run("INSERT OR IGNORE INTO layouts (document_id, artifact_id, bytes) VALUES (?, ?, ?)",
                                   document.id(), artifact.ref.id(), orchestrator::Blob{artifact.bytes}));
  }
  RETURN_IF_ERROR(Put(record));
  return transaction.Commit();
}

absl::Status DocumentStore::Put(const DocumentRecord& record) {
  const v1::Document& document = record.document();
  const std::string bytes = runtime::CanonicalBytes(record);
  const int64_t time_us = google::protobuf::util::TimeUtil::TimestampToMicroseconds(document.update_time());
  return database_->Run(
      "INSERT OR REPLACE INTO documents (id, request_id, revision, update_time_us, record) VALUES (?, ?, ?, ?, ?)",
      document.id(), record.request_id(), document.revision(), time_us, orchestrator::Blob{bytes});
}

absl::Status DocumentStore::SaveCopy(const DocumentRecord& record, const std::string& of_id) {
  ASSIGN_OR_RETURN(Transaction transaction, Transaction::Begin(*database_));
  RETURN_IF_ERROR(
      database_->Run("INSERT INTO layouts (document_id, artifact_id, bytes) SELECT ?, artifact_id, bytes FROM layouts "
                     "WHERE document_id = ?",
                     record.document().id(), of_id));
  RETURN_IF_ERROR(Put(record));
  return transaction.Commit();
}

absl::Status DocumentStore::Delete(const std::string& id) {
  ASSIGN_OR_RETURN(Transaction transaction, Transaction::Begin(*database_));
  RETURN_IF_ERROR(database_->Run("INSERT INTO deleted_documents SELECT * FROM documents WHERE id = ?", id));
  RETURN_IF_ERROR(database_->Run("INSERT INTO deleted_layouts SELECT * FROM layouts WHERE document_id = ?", id));
  ASSIGN_OR_RETURN(const int64_t count, database_->RunAndCount("DELETE FROM documents WHERE id = ?", id));
  if (count == 0) return NoDocument(id);
  RETURN_IF_ERROR(database_->Run("DELETE FROM layouts WHERE document_id = ?", id));
  return transaction.Commit();
}

absl::StatusOr<DocumentRecord> DocumentStore::Restore(const std::string& id) {
  ASSIGN_OR_RETURN(Transaction transaction, Transaction::Begin(*database_));
  RETURN_IF_ERROR(database_->Run("INSERT INTO documents SELECT * FROM deleted_documents WHERE id = ?", id));
  RETURN_IF_ERROR(database_->Run("INSERT INTO layouts SELECT * FROM deleted_layouts WHERE document_id = ?", id));
  RETURN_IF_ERROR(database_->Run("DELETE FROM deleted_documents WHERE id = ?", id));
  RETURN_IF_ERROR(database_->Run("DELETE FROM deleted_layouts WHERE document_id = ?", id));
  RETURN_IF_ERROR(transaction.Commit());
  return Get(id);
}

}  // namespace flair::session
