// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/catalog/remote_catalog_source.h"

#include "fmt/format.h"
#include "worker_runtime/grpc/client_call.h"

namespace flair::translator {

RemoteCatalogSource::RemoteCatalogSource(std::shared_ptr<grpc::Channel> channel)
    : stub_(v1::OptimizerService::NewStub(channel)) {}

absl::StatusOr<v1::ConstraintCatalog> RemoteCatalogSource::Get(runtime::CallContext& call) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (catalog_) return *catalog_;
  }
  absl::StatusOr<v1::ListConstraintTypesResponse> answer =
      runtime::UnaryRequest<v1::OptimizerService::StubInterface, v1::OptimizerService::StubInterface,
                            v1::ListConstraintTypesRequest, v1::ListConstraintTypesResponse>(
          *stub_, &v1::OptimizerService::StubInterface::ListConstraintTypes, v1::ListConstraintTypesRequest(), call);
  if (!answer.ok()) {
    return absl::Status(answer.status().code(), fmt::format("asking the optimizer for its catalogue: {}",
                                                            std::string(answer.status().message())));
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  catalog_ = answer->catalog();
  return *catalog_;
}

}  // namespace flair::translator
