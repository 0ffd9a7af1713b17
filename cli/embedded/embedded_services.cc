// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/embedded/embedded_services.h"

#include <algorithm>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/str_split.h"
#include "absl/time/clock.h"
#include "cli/exit_code.h"
#include "flair/v1/language_service.grpc.pb.h"
#include "flair/v1/optimizer_service.grpc.pb.h"
#include "flair/v1/renderer_service.grpc.pb.h"
#include "flair/v1/translator_service.grpc.pb.h"
#include "flair/v1/worker_service.grpc.pb.h"
#include "optimizer_worker/service/make_optimizer_service.h"
#include "worker_runtime/bootstrap/build_id.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/grpc/channel.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

// What a command prints is its own business; the services speak up when something breaks.
config::v1::RuntimeConfig QuietRuntime() {
  config::v1::RuntimeConfig runtime;
  runtime.set_log_level("error");
  return runtime;
}

// Of a worker that asks a model: its threads wait rather than work.
constexpr int kWaitingThreads = 4;

// With or without a model.
template <typename Config>
Config WithLlm(const OptionalLlm& llm, int job_count) {
  Config config;
  if (!llm.has_value()) return config;
  *config.mutable_llm() = *llm;
  config.mutable_runtime()->set_worker_thread_count(std::max(kWaitingThreads, job_count));
  return config;
}

// One stage: where its server goes, the channel to it, and the address of another server that runs it, if any.
struct StagePlace {
  const StageName& name;
  std::unique_ptr<runtime::InProcessServer>& server;
  orchestrator::StageChannel& channel;
  const std::string& address;
};

// Several servers, with commas between, are each asked once; jobs are then spread over them.
absl::Status Connect(const StagePlace& place) {
  ASSIGN_OR_RETURN(const runtime::ChannelOptions options, StageConnection());
  std::shared_ptr<grpc::Channel> first;
  for (const auto address : absl::StrSplit(place.address, ',')) {
    ASSIGN_OR_RETURN(auto channel, ConnectToStage(place.name, std::string(absl::StripAsciiWhitespace(address))));
    if (first == nullptr) first = std::move(channel);
  }
  place.channel = {.channel = first,
                   .address = place.address,
                   .setting = place.name.flag,
                   .connect = orchestrator::ConnectorTo(place.name.service, options)};
  return absl::OkStatus();
}

// Starts one worker in this process, unless it is elsewhere.
template <typename Config, typename Make>
absl::Status StartWorker(const std::string& program, Config config, const Make& make, const StagePlace& place) {
  if (!place.address.empty()) return Connect(place);
  config::v1::RuntimeConfig runtime = QuietRuntime();
  runtime.MergeFrom(config.runtime());
  config.mutable_runtime()->Swap(&runtime);
  const auto build = [&](runtime::WorkerContext& context) {
    context.build = runtime::BuildName();
    return make(config, context);
  };
  ASSIGN_OR_RETURN(place.server, runtime::InProcessServer::Start(program, config.runtime(), place.name.service, build));
  place.channel.channel = place.server->channel();
  return absl::OkStatus();
}

ModelStages& Models() {
  static ModelStages models;
  return models;
}

}  // namespace

void UseModels(ModelStages stages) { Models() = std::move(stages); }
const ModelStages& UsedModels() { return Models(); }

absl::StatusOr<std::unique_ptr<EmbeddedServices>> EmbeddedServices::Start(const std::string& store_path,
                                                                          const OptionalLlm& llm,
                                                                          const StageChoice& stages,
                                                                          const config::v1::OrchestratorConfig& asked) {
  std::unique_ptr<EmbeddedServices> services(new EmbeddedServices());
  RETURN_IF_ERROR(services->StartWorkers(llm, stages, asked.running_job_limit()));
  RETURN_IF_ERROR(services->StartOrchestrator(store_path, asked));
  return services;
}

absl::StatusOr<std::unique_ptr<EmbeddedServices>> EmbeddedServices::StartStages(const OptionalLlm& llm,
                                                                                const StageChoice& stages) {
  std::unique_ptr<EmbeddedServices> services(new EmbeddedServices());
  RETURN_IF_ERROR(services->StartWorkers(llm, stages, 1));
  return services;
}

EmbeddedServices::~EmbeddedServices() {
  if (service_ != nullptr) service_->Stop();
}

absl::Status EmbeddedServices::StartWorkers(const OptionalLlm& llm, const StageChoice& stages, int job_count) {
  const config::v1::StageAddresses& addresses = stages.addresses;
  auto language = WithLlm<config::v1::LanguageWorkerConfig>(llm, job_count);
  language.mutable_handbook_overlay_paths()->Add(stages.handbooks.begin(), stages.handbooks.end());
  const auto make_language = [](const auto& config, runtime::WorkerContext& context) {
    return language::MakeLanguageService(config, context, Models().language);
  };
  RETURN_IF_ERROR(StartWorker("flair-language", language, make_language,
                              {kLanguageStage, language_, stages_.language, addresses.language()}));
  RETURN_IF_ERROR(StartWorker("flair-optimizer", config::v1::OptimizerWorkerConfig(), optimizer::MakeOptimizerService,
                              {kOptimizerStage, optimizer_, stages_.optimizer, addresses.optimizer()}));
  // Jobs bring the catalogue of their optimizer with each request; this, of the first one, is for requests that bring
  // none.
  auto translator = WithLlm<config::v1::TranslatorWorkerConfig>(llm, job_count);
  translator.set_optimizer_address(addresses.optimizer().substr(0, addresses.optimizer().find(',')));
  const auto make_translator = [](const auto& config, runtime::WorkerContext& context) {
    return translator::MakeTranslatorService(config, context, Models().translator);
  };
  RETURN_IF_ERROR(StartWorker("flair-translator", translator, make_translator,
                              {kTranslatorStage, translator_, stages_.translator, addresses.translator()}));
  const auto make_renderer = [](const auto& config, runtime::WorkerContext& context) {
    return renderer::MakeRendererService(config, context, Models().renderer);
  };
  config::v1::RendererWorkerConfig renderer;
  renderer.set_asset_folder_path(stages.asset_folder);
  // What of a user's models cannot be used is told as they are read.
  if (!stages.asset_folder.empty()) renderer.mutable_runtime()->set_log_level("warning");
  return StartWorker("flair-renderer", renderer, make_renderer,
                     {kRendererStage, renderer_, stages_.renderer, addresses.renderer()});
}

absl::Status EmbeddedServices::StartOrchestrator(const std::string& default_path,
                                                 const config::v1::OrchestratorConfig& asked) {
  const std::string& store_path = asked.store_path().empty() ? default_path : asked.store_path();
  if (const std::error_code error = runtime::MakePrivateFolder(store_path)) {
    return FileError("{}: the store cannot be created: {}; set FLAIR_HOME to a writable folder", store_path,
                     error.message());
  }
  config::v1::OrchestratorConfig config;
  *config.mutable_runtime() = QuietRuntime();
  config.set_store_path(store_path);
  config.set_requested_jobs_only(true);
  config.MergeFrom(asked);
  const auto make = [&](runtime::WorkerContext& context) -> absl::StatusOr<std::unique_ptr<grpc::Service>> {
    context.build = runtime::BuildName();
    ASSIGN_OR_RETURN(auto service, orchestrator::MakeOrchestratorService(config, context, stages_));
    service_ = service.get();
    return service;
  };
  ASSIGN_OR_RETURN(orchestrator_, runtime::InProcessServer::Start("flair-orchestrator", config.runtime(),
                                                                  v1::OrchestratorService::service_full_name(), make));
  return absl::OkStatus();
}

namespace {

constexpr absl::Duration kStageAnswersWithin = absl::Seconds(20);

template <typename Service, auto kMethod, typename Request>
absl::Status AskNothing(const std::shared_ptr<grpc::Channel>& channel) {
  const std::unique_ptr<typename Service::Stub> stub = Service::NewStub(channel);
  runtime::CallContext call;
  return runtime::UnaryRequest(*stub, kMethod, Request(), call, absl::Now() + kStageAnswersWithin).status();
}

// As UNAVAILABLE, when nobody answered or not in time; OK otherwise, also for errors.
absl::Status Silence(const absl::Status& status) {
  if (!absl::IsUnavailable(status) && !absl::IsDeadlineExceeded(status)) return absl::OkStatus();
  return absl::UnavailableError(status.message());
}

absl::Status CheckProtocols(const StageName& stage, const std::string& address,
                            const std::shared_ptr<grpc::Channel>& channel) {
  const std::unique_ptr<v1::WorkerService::Stub> stub = v1::WorkerService::NewStub(channel);
  runtime::CallContext call;
  const absl::StatusOr<v1::GetWorkerResponse> worker =
      runtime::UnaryRequest(*stub, &v1::WorkerService::StubInterface::GetWorker, v1::GetWorkerRequest(), call,
                            absl::Now() + kStageAnswersWithin);
  if (absl::Status silence = Silence(worker.status()); !silence.ok()) return InWords(stage, address, silence);
  const std::string fault = worker.ok() ? runtime::ProtocolFault(*worker) : "";
  if (fault.empty()) return absl::OkStatus();
  return InvalidArgument("{} {}: {}; use a version of it that does", stage.flag, address, fault);
}

}  // namespace

const StageName kLanguageStage = {
    "--language", v1::LanguageService::service_full_name(),
    &AskNothing<v1::LanguageService, &v1::LanguageService::StubInterface::DescribeRoom, v1::DescribeRoomRequest>};
const StageName kTranslatorStage = {
    "--translator", v1::TranslatorService::service_full_name(),
    &AskNothing<v1::TranslatorService, &v1::TranslatorService::StubInterface::Translate, v1::TranslateRequest>};
const StageName kOptimizerStage = {
    "--optimizer", v1::OptimizerService::service_full_name(),
    &AskNothing<v1::OptimizerService, &v1::OptimizerService::StubInterface::Solve, v1::SolveRequest>};
const StageName kRendererStage = {
    "--renderer", v1::RendererService::service_full_name(),
    &AskNothing<v1::RendererService, &v1::RendererService::StubInterface::Render, v1::RenderRequest>};

absl::Status InWords(const StageName& stage, const std::string& address, const absl::Status& status) {
  if (!absl::IsUnavailable(status)) return status;
  return Unavailable("{} {}: no {} answers there: {}; is the program running, and is this its port?", stage.flag,
                     address, stage.service, status.message());
}

absl::StatusOr<std::shared_ptr<grpc::Channel>> ConnectToStage(const StageName& stage, const std::string& address,
                                                              int max_message_mib) {
  ASSIGN_OR_RETURN(runtime::ChannelOptions options, StageConnection());
  options.max_message_mib = max_message_mib;
  absl::StatusOr<std::shared_ptr<grpc::Channel>> channel = runtime::MakeChannel(address, stage.service, options);
  if (!channel.ok()) return InvalidArgument("{}: {}", stage.flag, channel.status().message());
  RETURN_IF_ERROR(CheckProtocols(stage, address, *channel));
  const absl::Status answer = stage.ask_nothing(*channel);
  if (absl::IsUnimplemented(answer)) {
    return InvalidArgument("{} {}: the server there is not a {}; is this the port of another stage?", stage.flag,
                           address, stage.service);
  }
  if (absl::Status silence = Silence(answer); !silence.ok()) return InWords(stage, address, silence);
  return channel;
}

}  // namespace flair::cli
