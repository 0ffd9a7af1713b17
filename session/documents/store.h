// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/store/v1/document_record.pb.h"
#include "flair/v1/artifact.pb.h"
#include "orchestrator/store/artifact_id.h"
#include "orchestrator/store/database.h"

namespace flair::session {

// Documents and their layouts in one file, FOLDER/documents.db. What Save has returned from is there after the process
// has been killed. Several processes may have the same folder open. Errors also as orchestrator::Database.
// Thread-safe.
class DocumentStore {
 public:
  // Makes the folder when it is missing.
  static absl::StatusOr<std::unique_ptr<DocumentStore>> Open(const std::string& folder);

  // NOT_FOUND when there is no such document.
  absl::StatusOr<store::v1::DocumentRecord> Get(const std::string& id);
  absl::StatusOr<std::optional<store::v1::DocumentRecord>> FindByRequest(const std::string& request_id);
  // Latest change first.
  absl::StatusOr<std::vector<store::v1::DocumentRecord>> List(int limit);
  // NOT_FOUND when the document has no such layout, DATA_LOSS when it is damaged.
  absl::StatusOr<v1::Artifact> GetLayout(const std::string& document_id, const std::string& artifact_id);

  // Of whichever document; NOT_FOUND when none has it.
  absl::StatusOr<v1::Artifact> FindLayout(const std::string& artifact_id);

  // Stores a record whose revision has been counted up, with its new layouts, and forgets those that it does not name
  // any more; all or nothing. ABORTED when the stored one is not the revision before, NOT_FOUND when it is gone. A
  // record of revision 1 is a new document.
  absl::Status Save(const store::v1::DocumentRecord& record, std::span<const orchestrator::SealedArtifact> added);

  // A new document with the layouts of another one; all or nothing.
  absl::Status SaveCopy(const store::v1::DocumentRecord& record, const std::string& of_id);

  // What is deleted can be put back as it was until this store is closed; NOT_FOUND when nothing is called so.
  absl::Status Delete(const std::string& id);
  absl::StatusOr<store::v1::DocumentRecord> Restore(const std::string& id);

 private:
  explicit DocumentStore(std::unique_ptr<orchestrator::Database> database) : database_(std::move(database)) {}
  absl::Status Replace(const store::v1::DocumentRecord& record);
  absl::Status Put(const store::v1::DocumentRecord& record);

  const std::unique_ptr<orchestrator::Database> database_;
};

}  // namespace flair::session
