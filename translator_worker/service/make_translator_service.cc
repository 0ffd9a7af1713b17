// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/service/make_translator_service.h"

#include <utility>

#include "english/language.h"
#include "flair/v1/optimizer_service.grpc.pb.h"
#include "flair/v1/translator_service.grpc.pb.h"
#include "flair/v1/worker_service.pb.h"
#include "fmt/format.h"
#include "room/validation/validate.h"
#include "translator_worker/grammar/translate.h"
#include "worker_runtime/grpc/channel.h"
#include "worker_runtime/grpc/server_call.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::translator {
namespace {

// What decides the grammar's answers beyond the build: raised whenever equal sentences would give other calls.
inline constexpr char kGrammarVersion[] = "4";

// Answers TranslatorService.Translate with a model, or with the grammar when there is none.
class TranslateHandler {
 public:
  // `source` gives the catalogue to requests without one; `model` may be null. Both must outlive the handler.
  TranslateHandler(CatalogSource& source, const Translator* model) : source_(source), model_(model) {}

  absl::StatusOr<v1::TranslateResponse> Handle(const v1::TranslateRequest& request, runtime::CallContext& call) const {
    RETURN_IF_ERROR(Validate(request));
    if (request.has_catalog()) return Answer(request, call);
    v1::TranslateRequest complete = request;
    ASSIGN_OR_RETURN(*complete.mutable_catalog(), source_.Get(call));
    return Answer(complete, call);
  }

 private:
  absl::StatusOr<v1::TranslateResponse> Answer(const v1::TranslateRequest& complete, runtime::CallContext& call) const {
    v1::TranslateResponse response;
    if (model_ != nullptr) {
      ASSIGN_OR_RETURN(response, model_->Translate(complete, call));
      // As the server names it; a request that needed no call names what was configured.
      response.mutable_producer()->set_method(response.model_calls().empty() ? model_->model()
                                                                             : response.model_calls(0).model());
      response.mutable_producer()->set_version(model_->version());
    } else {
      *response.mutable_layout_graph() = Translate(complete);
      response.mutable_producer()->set_method("grammar");
      response.mutable_producer()->set_version(kGrammarVersion);
    }
    RETURN_IF_ERROR(call.CheckAlive());
    response.mutable_producer()->set_program("flair-translator");
    return response;
  }

  CatalogSource& source_;
  const Translator* const model_;
};

class Service final : public runtime::Service {
 public:
  Service(std::unique_ptr<CatalogSource> source, std::unique_ptr<const Translator> model,
          runtime::WorkerContext& worker)
      : runtime::Service(worker, v1::TranslatorService::service_full_name()),
        source_(std::move(source)),
        model_(std::move(model)),
        translate_(*source_, model_.get()) {
    Unary<v1::TranslateRequest>("Translate", translate_);
  }

 private:
  const std::unique_ptr<CatalogSource> source_;
  const std::unique_ptr<const Translator> model_;
  TranslateHandler translate_;
};

absl::StatusOr<std::unique_ptr<CatalogSource>> MakeSource(const config::v1::TranslatorWorkerConfig& config) {
  if (config.optimizer_address().empty()) return std::make_unique<NoCatalogSource>();
  absl::StatusOr<std::shared_ptr<grpc::Channel>> channel =
      runtime::MakeChannel(config.optimizer_address(), v1::OptimizerService::service_full_name(),
                           runtime::ChannelOptionsOf(config.runtime()));
  if (!channel.ok()) {
    return InvalidArgument("optimizer_address: {}", channel.status().message());
  }
  return MakeRemoteCatalogSource(*channel);
}

}  // namespace

absl::StatusOr<std::unique_ptr<grpc::Service>> MakeTranslatorService(const config::v1::TranslatorWorkerConfig& config,
                                                                     runtime::WorkerContext& worker,
                                                                     const ModelTranslatorMaker& with_model) {
  RETURN_IF_ERROR(english::Language::CheckInstalled());
  ASSIGN_OR_RETURN(std::unique_ptr<CatalogSource> source, MakeSource(config));
  std::unique_ptr<const Translator> model;
  if (config.has_llm()) {
    if (with_model == nullptr) {
      return absl::InvalidArgumentError("llm: this program asks no language model; flair and flair-translator do");
    }
    ASSIGN_OR_RETURN(model, with_model(config, worker));
  }
  return MakeTranslatorService(std::move(source), std::move(model), worker);
}

std::unique_ptr<grpc::Service> MakeTranslatorService(std::unique_ptr<CatalogSource> source,
                                                     std::unique_ptr<const Translator> model,
                                                     runtime::WorkerContext& worker) {
  worker.revision = fmt::format("grammar {}", kGrammarVersion);
  if (model == nullptr) worker.capabilities = {v1::CAPABILITY_DETERMINISTIC};
  if (model != nullptr) worker.revision = fmt::format("{}, {} {}", worker.revision, model->model(), model->version());
  return std::make_unique<Service>(std::move(source), std::move(model), worker);
}

}  // namespace flair::translator
