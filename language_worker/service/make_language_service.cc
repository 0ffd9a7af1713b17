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

class Service final : public v1::LanguageService::CallbackService {
 public:
  Service(runtime::WorkerContext& worker, std::unique_ptr<const Handbook> handbook,
          std::unique_ptr<const LanguageHandlers> handlers)
      : worker_(worker), handbook_(std::move(handbook)), handlers_(std::move(handlers)) {}

  grpc::ServerUnaryReactor* DescribeRoom(grpc::CallbackServerContext* context, const v1::DescribeRoomRequest* request,
                                         v1::DescribeRoomResponse* response) override {
    return runtime::ServeUnary(worker_, "DescribeRoom", context, request, response, *handlers_);
  }
  grpc::ServerUnaryReactor* PlanZones(grpc::CallbackServerContext* context, const v1::PlanZonesRequest* request,
                                      v1::PlanZonesResponse* response) override {
    return runtime::ServeUnary(worker_, "PlanZones", context, request, response, *handlers_);
  }
  grpc::ServerUnaryReactor* ListObjects(grpc::CallbackServerContext* context, const v1::ListObjectsRequest* request,
                                        v1::ListObjectsResponse* response) override {
    return runtime::ServeUnary(worker_, "ListObjects", context, request, response, *handlers_);
  }
  grpc::ServerUnaryReactor* ChooseStyle(grpc::CallbackServerContext* context, const v1::ChooseStyleRequest* request,
                                        v1::ChooseStyleResponse* response) override {
    return runtime::ServeUnary(worker_, "ChooseStyle", context, request, response, *handlers_);
  }
  grpc::ServerUnaryReactor* ListConstraints(grpc::CallbackServerContext* context,
                                            const v1::ListConstraintsRequest* request,
                                            v1::ListConstraintsResponse* response) override {
    return runtime::ServeUnary(worker_, "ListConstraints", context, request, response, *handlers_);
  }
  grpc::ServerUnaryReactor* CleanConstraints(grpc::CallbackServerContext* context,
                                             const v1::CleanConstraintsRequest* request,
                                             v1::CleanConstraintsResponse* response) override {
    return runtime::ServeUnary(worker_, "CleanConstraints", context, request, response, *handlers_);
  }
  grpc::ServerUnaryReactor* CompleteConstraints(grpc::CallbackServerContext* context,
                                                const v1::CompleteConstraintsRequest* request,
                                                v1::CompleteConstraintsResponse* response) override {
    return runtime::ServeUnary(worker_, "CompleteConstraints", context, request, response, *handlers_);
  }

 private:
  runtime::WorkerContext& worker_;
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
