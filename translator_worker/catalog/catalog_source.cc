// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/catalog/catalog_source.h"

#include <mutex>
#include <optional>

#include "flair/v1/optimizer_service.grpc.pb.h"
#include "fmt/format.h"
#include "worker_runtime/grpc/client_call.h"

namespace flair::translator {
namespace {

class RemoteCatalogSource final : public CatalogSource {
 public:
  explicit RemoteCatalogSource(const std::shared_ptr<grpc::Channel>& channel)
      : stub_(v1::OptimizerService::NewStub(channel)) {}

  absl::StatusOr<v1::ConstraintCatalog> Get(runtime::CallContext& call) override {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (catalog_) return *catalog_;
    }
    using Stub = v1::OptimizerService::StubInterface;
    absl::StatusOr<v1::ListConstraintTypesResponse> answer =
        runtime::UnaryRequest<Stub, Stub, v1::ListConstraintTypesRequest, v1::ListConstraintTypesResponse>(
            *stub_, &Stub::ListConstraintTypes, v1::ListConstraintTypesRequest(), call);
    if (!answer.ok()) {
      return absl::Status(answer.status().code(), fmt::format("asking the optimizer for its catalogue: {}",
                                                              std::string(answer.status().message())));
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    catalog_ = answer->catalog();
    return *catalog_;
  }

 private:
  const std::unique_ptr<v1::OptimizerService::StubInterface> stub_;
  std::mutex mutex_;
  std::optional<v1::ConstraintCatalog> catalog_;
};

}  // namespace

std::unique_ptr<CatalogSource> MakeRemoteCatalogSource(const std::shared_ptr<grpc::Channel>& channel) {
  return std::make_unique<RemoteCatalogSource>(channel);
}

}  // namespace flair::translator
