// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/channel.h>

#include <memory>
#include <mutex>
#include <optional>

#include "flair/v1/optimizer_service.grpc.pb.h"
#include "translator_worker/catalog/catalog_source.h"

namespace flair::translator {

// Asks an optimizer by ListConstraintTypes and keeps the first good answer. A failed attempt is not kept.
class RemoteCatalogSource final : public CatalogSource {
 public:
  explicit RemoteCatalogSource(std::shared_ptr<grpc::Channel> channel);

  absl::StatusOr<v1::ConstraintCatalog> Get(runtime::CallContext& call) override;

 private:
  const std::unique_ptr<v1::OptimizerService::StubInterface> stub_;
  std::mutex mutex_;
  std::optional<v1::ConstraintCatalog> catalog_;
};

}  // namespace flair::translator
