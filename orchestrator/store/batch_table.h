// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "flair/v1/orchestrator_service.pb.h"
#include "orchestrator/store/database.h"

namespace flair::orchestrator {

// Jobs that were asked for together. Thread-safe.
class BatchTable {
 public:
  explicit BatchTable(Database& database) : database_(database) {}

  // ALREADY_EXISTS when the id or the request id is taken.
  absl::Status Insert(const std::string& id, const std::string& request_id, const std::string& specs_digest);

  struct Row {
    std::string id;
    std::string specs_digest;
  };
  // The batch that a request made; nothing when none.
  absl::StatusOr<std::optional<Row>> FindByRequest(const std::string& request_id);

  // With the counts of its jobs. NOT_FOUND when unknown.
  absl::StatusOr<v1::Batch> Get(const std::string& id);

 private:
  Database& database_;
};

}  // namespace flair::orchestrator
