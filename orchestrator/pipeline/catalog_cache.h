// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "absl/status/statusor.h"
#include "flair/v1/constraint_catalog.pb.h"
#include "orchestrator/pipeline/stage_clients.h"

namespace flair::orchestrator {

// What an optimizer understands, the same for all jobs.
struct SharedCatalog {
  v1::ConstraintCatalog catalog;
  // SHA-256 of its canonical bytes, in hex.
  std::string digest;
};

// The catalogue of each optimizer that was asked: every job wants it, and an optimizer of one revision has one.
// Thread-safe.
class CatalogCache {
 public:
  // Asks the optimizer unless one of its revision was asked before. Errors as StageClients.
  absl::StatusOr<std::shared_ptr<const SharedCatalog>> Get(StageClients& clients, StageCall& call);

 private:
  std::mutex mutex_;
  // By revision.
  std::map<std::string, std::shared_ptr<const SharedCatalog>> catalogs_;
};

}  // namespace flair::orchestrator
