// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/service/make_language_service.h"

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <utility>

#include "flair/v1/language_service.grpc.pb.h"
#include "flair/v1/worker_service.pb.h"
#include "language_worker/handbook/loading/load_handbook.h"
#include "language_worker/model/model_tools.h"
#include "language_worker/service/language_handlers.h"
#include "llm/answers/prompt_library.h"
#include "llm/config/check_llm_config.h"
#include "llm/make_llm_client.h"
#include "worker_runtime/grpc/server_call.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::language {
namespace {

class Service final : public v1::LanguageService::CallbackService {
 public:
  // `arguments` are those of the handlers after the handbook.
  template <typename... Arguments>
  Service(runtime::WorkerContext& worker, std::unique_ptr<const Handbook> handbook, Arguments&&... arguments)
      : worker_(worker), handbook_(std::move(handbook)), handlers_(*handbook_, std::forward<Arguments>(arguments)...) {}

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
  LanguageHandlers handlers_;
};

absl::StatusOr<std::unique_ptr<const Handbook>> ReadHandbook(const config::v1::LanguageWorkerConfig& config) {
  const std::string& path = config.handbook_path();
  return LoadHandbook(path.empty() ? DefaultHandbookFolder() : std::filesystem::path(path),
                      {config.handbook_overlay_paths().begin(), config.handbook_overlay_paths().end()});
}

}  // namespace

absl::StatusOr<std::unique_ptr<grpc::Service>> MakeLanguageService(const config::v1::LanguageWorkerConfig& config,
                                                                   runtime::WorkerContext& worker) {
  if (config.has_llm()) {
    ASSIGN_OR_RETURN(std::unique_ptr<llm::LlmClient> model, llm::MakeLlmClient(config.llm(), worker));
    return MakeLanguageService(config, std::move(model), worker);
  }
  ASSIGN_OR_RETURN(auto handbook, ReadHandbook(config));
  worker.revision = (handbook)->version();
  worker.capabilities = {v1::CAPABILITY_DETERMINISTIC};
  return std::make_unique<Service>(worker, std::move(handbook));
}

absl::StatusOr<std::unique_ptr<grpc::Service>> MakeLanguageService(const config::v1::LanguageWorkerConfig& config,
                                                                   std::unique_ptr<llm::LlmClient> model,
                                                                   runtime::WorkerContext& worker) {
  ASSIGN_OR_RETURN(auto handbook, ReadHandbook(config));
  ASSIGN_OR_RETURN(auto prompts,
                   llm::PromptLibrary::Load(DefaultPromptsFolder(), config.llm().prompts_path(), LanguagePrompts()));
  // A recording answers the same every time.
  if (!config.llm().replay_path().empty()) worker.capabilities = {v1::CAPABILITY_DETERMINISTIC};
  worker.revision = fmt::format("{}, {}, prompts {}", (handbook)->version(), model->identity(), prompts.version());
  return std::make_unique<Service>(worker, std::move(handbook), std::move(model), std::move(prompts));
}

void CheckLanguageConfig(const config::v1::LanguageWorkerConfig& config, runtime::ConfigChecker& checker) {
  if (!config.has_llm()) return;
  llm::CheckLlmConfig(config.llm(), [&checker](std::string_view field, std::string_view problem) {
    checker.Report(fmt::format("llm.{}", field), problem);
  });
}

}  // namespace flair::language
