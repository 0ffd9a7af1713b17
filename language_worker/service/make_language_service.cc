// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/service/make_language_service.h"

#include <filesystem>
#include <string>
#include <utility>

#include "flair/v1/language_service.grpc.pb.h"
#include "flair/v1/worker_service.pb.h"
#include "language_worker/handbook/loading/load_handbook.h"
#include "worker_runtime/grpc/server_call.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::language {
namespace {

class Service final : public runtime::Service {
 public:
  Service(runtime::WorkerContext& worker, std::unique_ptr<const Handbook> handbook,
          std::unique_ptr<const LanguageHandlers> handlers)
      : runtime::Service(worker, v1::LanguageService::service_full_name()),
        handbook_(std::move(handbook)),
        handlers_(std::move(handlers)) {
    Unary<v1::DescribeRoomRequest>("DescribeRoom", *handlers_);
    Unary<v1::PlanZonesRequest>("PlanZones", *handlers_);
    Unary<v1::ListObjectsRequest>("ListObjects", *handlers_);
    Unary<v1::ChooseStyleRequest>("ChooseStyle", *handlers_);
    Unary<v1::ListConstraintsRequest>("ListConstraints", *handlers_);
    Unary<v1::CleanConstraintsRequest>("CleanConstraints", *handlers_);
    Unary<v1::CompleteConstraintsRequest>("CompleteConstraints", *handlers_);
  }

 private:
  const std::unique_ptr<const Handbook> handbook_;
  const std::unique_ptr<const LanguageHandlers> handlers_;
};

absl::StatusOr<std::unique_ptr<const Handbook>> ReadHandbook(const config::v1::LanguageWorkerConfig& config) {
  const std::string& path = config.handbook_path();
  return LoadHandbook(path.empty() ? DefaultHandbookFolder() : std::filesystem::path(path),
                      {config.handbook_overlay_paths().begin(), config.handbook_overlay_paths().end()});
}

}  // namespace

absl::StatusOr<std::unique_ptr<grpc::Service>> MakeLanguageService(const config::v1::LanguageWorkerConfig& config,
                                                                   runtime::WorkerContext& worker,
                                                                   const ModelHandlersMaker& with_model) {
  ASSIGN_OR_RETURN(std::unique_ptr<const Handbook> handbook, ReadHandbook(config));
  worker.revision = handbook->version();
  std::unique_ptr<const LanguageHandlers> handlers;
  if (!config.has_llm()) {
    worker.capabilities = {v1::CAPABILITY_DETERMINISTIC};
    handlers = std::make_unique<LanguageHandlers>(*handbook);
  } else if (with_model == nullptr) {
    return absl::InvalidArgumentError("llm: this program asks no language model; flair and flair-language do");
  } else {
    ASSIGN_OR_RETURN(handlers, with_model(config, *handbook, worker));
  }
  return std::make_unique<Service>(worker, std::move(handbook), std::move(handlers));
}

}  // namespace flair::language
