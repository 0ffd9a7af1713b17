// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/service/make_language_service.h"

#include <utility>

#include "flair/v1/language_service.grpc.pb.h"
#include "language_worker/handbook/loading/load_handbook.h"
#include "language_worker/service/handbook_handlers.h"
#include "worker_runtime/grpc/unary_call.h"

namespace flair::language {
namespace {

class Service final : public v1::LanguageService::CallbackService {
 public:
  Service(std::unique_ptr<const Handbook> handbook, runtime::WorkerContext& worker)
      : worker_(worker), handbook_(std::move(handbook)), handlers_(*handbook_) {}

  grpc::ServerUnaryReactor* DescribeRoom(grpc::CallbackServerContext* context, const v1::DescribeRoomRequest* request,
                                         v1::DescribeRoomResponse* response) override {
    return runtime::ServeUnary(worker_, "DescribeRoom", context, request, response, handlers_);
  }
  grpc::ServerUnaryReactor* PlanZones(grpc::CallbackServerContext* context, const v1::PlanZonesRequest* request,
                                      v1::PlanZonesResponse* response) override {
    return runtime::ServeUnary(worker_, "PlanZones", context, request, response, handlers_);
  }
  grpc::ServerUnaryReactor* ListObjects(grpc::CallbackServerContext* context, const v1::ListObjectsRequest* request,
                                        v1::ListObjectsResponse* response) override {
    return runtime::ServeUnary(worker_, "ListObjects", context, request, response, handlers_);
  }
  grpc::ServerUnaryReactor* ChooseStyle(grpc::CallbackServerContext* context, const v1::ChooseStyleRequest* request,
                                        v1::ChooseStyleResponse* response) override {
    return runtime::ServeUnary(worker_, "ChooseStyle", context, request, response, handlers_);
  }
  grpc::ServerUnaryReactor* ListConstraints(grpc::CallbackServerContext* context,
                                            const v1::ListConstraintsRequest* request,
                                            v1::ListConstraintsResponse* response) override {
    return runtime::ServeUnary(worker_, "ListConstraints", context, request, response, handlers_);
  }
  grpc::ServerUnaryReactor* CleanConstraints(grpc::CallbackServerContext* context,
                                             const v1::CleanConstraintsRequest* request,
                                             v1::CleanConstraintsResponse* response) override {
    return runtime::ServeUnary(worker_, "CleanConstraints", context, request, response, handlers_);
  }

 private:
  runtime::WorkerContext& worker_;
  const std::unique_ptr<const Handbook> handbook_;
  HandbookHandlers handlers_;
};

}  // namespace

absl::StatusOr<std::unique_ptr<grpc::Service>> MakeLanguageService(const config::v1::LanguageWorkerConfig& config,
                                                                   runtime::WorkerContext& worker) {
  auto handbook = LoadHandbook(config.handbook_path().empty() ? DefaultHandbookFolder()
                                                              : std::filesystem::path(config.handbook_path()));
  if (!handbook.ok()) return handbook.status();
  worker.revision = (*handbook)->version();
  return std::make_unique<Service>(*std::move(handbook), worker);
}

}  // namespace flair::language
