// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/v1/orchestrator_service.pb.h"
#include "orchestrator/store/database.h"

namespace flair::orchestrator {

// What the orchestrators of a store say of themselves. Thread-safe.
class StatusTable {
 public:
  explicit StatusTable(Database& database) : database_(database) {}

  // Replaces what the same one said, and forgets who has said nothing since `oldest`.
  absl::Status Set(const v1::OrchestratorStatus& status, absl::Time time, absl::Time oldest);

  // Who has said something since `oldest`.
  absl::StatusOr<std::vector<v1::OrchestratorStatus>> Since(absl::Time oldest);

 private:
  Database& database_;
};

}  // namespace flair::orchestrator
