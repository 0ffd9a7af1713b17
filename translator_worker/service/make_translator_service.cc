// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/service/make_translator_service.h"

#include <utility>

#include "flair/v1/optimizer_service.grpc.pb.h"
#include "flair/v1/translator_service.grpc.pb.h"
#include "translator_worker/catalog/remote_catalog_source.h"
#include "translator_worker/service/translate_handler.h"
#include "worker_runtime/grpc/channel.h"
#include "worker_runtime/grpc/unary_call.h"

namespace flair::translator {
namespace {

class Service final : public v1::TranslatorService::CallbackService {
 public:
  Service(std::unique_ptr<CatalogSource> source, runtime::WorkerContext& worker)
      : worker_(worker), source_(std::move(source)), translate_(*source_) {}

  grpc::ServerUnaryReactor* Translate(grpc::CallbackServerContext* context, const v1::TranslateRequest* request,
                                      v1::TranslateResponse* response) override {
    return runtime::ServeUnary(worker_, "Translate", context, request, response, translate_);
  }

 private:
  runtime::WorkerContext& worker_;
  const std::unique_ptr<CatalogSource> source_;
  TranslateHandler translate_;
};

}  // namespace

absl::StatusOr<std::unique_ptr<grpc::Service>> MakeTranslatorService(const config::v1::TranslatorWorkerConfig& config,
                                                                     runtime::WorkerContext& worker) {
  if (config.optimizer_address().empty()) return MakeTranslatorService(std::make_unique<NoCatalogSource>(), worker);
  absl::StatusOr<std::shared_ptr<grpc::Channel>> channel = runtime::MakeChannel(
      config.optimizer_address(), v1::OptimizerService::service_full_name(), config.runtime().max_message_mib());
  if (!channel.ok()) return channel.status();
  return MakeTranslatorService(std::make_unique<RemoteCatalogSource>(*std::move(channel)), worker);
}

std::unique_ptr<grpc::Service> MakeTranslatorService(std::unique_ptr<CatalogSource> source,
                                                     runtime::WorkerContext& worker) {
  return std::make_unique<Service>(std::move(source), worker);
}

}  // namespace flair::translator
