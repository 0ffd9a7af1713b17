// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/pipeline/catalog_cache.h"

#include <optional>
#include <utility>

#include "worker_runtime/files/files.h"

namespace flair::orchestrator {
namespace {

// Optimizers of more revisions than this are not at work at once.
constexpr size_t kCatalogsKept = 4;

}  // namespace

absl::StatusOr<std::shared_ptr<const SharedCatalog>> CatalogCache::Get(StageClients& clients, StageCall& call) {
  const absl::StatusOr<std::optional<std::string>> revision = clients.Revision(v1::ARTIFACT_KIND_SOLVED_LAYOUT, call);
  if (!revision.ok()) return revision.status();
  if (revision->has_value()) {
    std::lock_guard lock(mutex_);
    if (const auto known = catalogs_.find(**revision); known != catalogs_.end()) return known->second;
  }
  auto response = clients.ListConstraintTypes({}, call);
  if (!response.ok()) return response.status();
  const auto asked = std::make_shared<SharedCatalog>();
  asked->catalog = std::move(*response->mutable_catalog());
  asked->digest = runtime::Sha256Hex(runtime::CanonicalBytes(asked->catalog));
  // Another one than was thought of may have answered, or one that does not say which it is.
  if (call.answerer().has_value() && call.answerer()->revision.has_value()) {
    std::lock_guard lock(mutex_);
    if (catalogs_.size() >= kCatalogsKept) catalogs_.clear();
    catalogs_[*call.answerer()->revision] = asked;
  }
  return asked;
}

}  // namespace flair::orchestrator
