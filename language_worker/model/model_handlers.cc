// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/model/model_handlers.h"

#include <fmt/format.h>

#include <utility>

#include "flair/v1/worker_service.pb.h"
#include "llm/answers/conversation.h"
#include "llm/config/check_llm_config.h"
#include "llm/make_llm_client.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::language {
namespace {

// The brief's seed; cleaning knows no brief, and nothing in it is a matter of taste.
template <typename Request>
int64_t SeedOf(const Request& request) {
  if constexpr (requires { request.brief(); }) return request.brief().seed();
  return 0;
}

absl::StatusOr<v1::Room> Ask(const v1::DescribeRoomRequest& request, const ModelTools& tools,
                             llm::Conversation& conversation) {
  return AskRoom(request.brief(), tools, conversation);
}
absl::StatusOr<v1::ZonePlan> Ask(const v1::PlanZonesRequest& request, const ModelTools& tools,
                                 llm::Conversation& conversation) {
  return AskZones(request.brief(), request.room(), tools, conversation);
}
absl::StatusOr<v1::ObjectList> Ask(const v1::ListObjectsRequest& request, const ModelTools& tools,
                                   llm::Conversation& conversation) {
  return AskObjects({request.brief(), request.room(), request.zone_plan()}, tools, conversation);
}
absl::StatusOr<v1::StyleSheet> Ask(const v1::ChooseStyleRequest& request, const ModelTools& tools,
                                   llm::Conversation& conversation) {
  return AskStyle(request.brief(), request.room(), request.object_list(), tools, conversation);
}
absl::StatusOr<v1::ConstraintList> Ask(const v1::ListConstraintsRequest& request, const ModelTools& tools,
                                       llm::Conversation& conversation) {
  return AskConstraints({request.brief(), request.room(), request.zone_plan()}, request.object_list(), tools,
                        conversation);
}
absl::StatusOr<v1::ConstraintList> Ask(const v1::CleanConstraintsRequest& request, const ModelTools& tools,
                                       llm::Conversation& conversation) {
  return AskCleaning(request.room(), request.object_list(), request.constraint_list(), tools, conversation);
}

}  // namespace

ModelHandlers::ModelHandlers(const Handbook& handbook, std::unique_ptr<llm::LlmClient> client,
                             llm::PromptLibrary prompts)
    : LanguageHandlers(handbook),
      client_(std::move(client)),
      prompts_(std::move(prompts)),
      furniture_(handbook),
      tools_{prompts_, handbook, furniture_} {}

template <typename Response, typename Request>
absl::StatusOr<Response> ModelHandlers::AskModel(const Request& request, runtime::CallContext& call) const {
  llm::Conversation conversation(*client_, prompts_, request.model_options(), call, SeedOf(request));
  auto answer = Ask(request, tools_, conversation);
  Response response;
  if (answer.ok()) {
    const bool asked = !conversation.calls().empty();
    response = asked ? AnsweredBy<Response>(conversation.calls().back().model(), prompts_.version())
                     : AnsweredBy<Response>("handbook", handbook().version());
    PartOf(response) = *std::move(answer);
  } else {
    if (!conversation.MayStandIn(answer.status())) return answer.status();
    ASSIGN_OR_RETURN(response, LanguageHandlers::Answer(request, call));
    AddStandIn(answer.status(), PartOf(response));
  }
  for (const v1::ModelCall& made : conversation.calls()) *response.add_model_calls() = made;
  return response;
}

#define FLAIR_ANSWER(Rpc)                                                                                              \
  absl::StatusOr<v1::Rpc##Response> ModelHandlers::Answer(const v1::Rpc##Request& request, runtime::CallContext& call) \
      const {                                                                                                          \
    return AskModel<v1::Rpc##Response>(request, call);                                                                 \
  }
FLAIR_ANSWER(DescribeRoom)
FLAIR_ANSWER(PlanZones)
FLAIR_ANSWER(ListObjects)
FLAIR_ANSWER(ChooseStyle)
FLAIR_ANSWER(ListConstraints)
FLAIR_ANSWER(CleanConstraints)
#undef FLAIR_ANSWER

absl::StatusOr<std::unique_ptr<LanguageHandlers>> MakeModelHandlers(const config::v1::LanguageWorkerConfig& config,
                                                                    const Handbook& handbook,
                                                                    runtime::WorkerContext& worker) {
  ASSIGN_OR_RETURN(std::unique_ptr<llm::LlmClient> model, llm::MakeLlmClient(config.llm(), worker));
  return MakeModelHandlers(std::move(model), config, handbook, worker);
}

absl::StatusOr<std::unique_ptr<LanguageHandlers>> MakeModelHandlers(std::unique_ptr<llm::LlmClient> model,
                                                                    const config::v1::LanguageWorkerConfig& config,
                                                                    const Handbook& handbook,
                                                                    runtime::WorkerContext& worker) {
  ASSIGN_OR_RETURN(auto prompts,
                   llm::PromptLibrary::Load(DefaultPromptsFolder(), config.llm().prompts_path(), LanguagePrompts()));
  // A recording answers the same every time.
  if (!config.llm().replay_path().empty()) worker.capabilities = {v1::CAPABILITY_DETERMINISTIC};
  worker.revision = fmt::format("{}, {}, prompts {}", handbook.version(), model->identity(), prompts.version());
  return std::make_unique<ModelHandlers>(handbook, std::move(model), std::move(prompts));
}

void CheckLanguageConfig(const config::v1::LanguageWorkerConfig& config, runtime::ConfigChecker& checker) {
  if (!config.has_llm()) return;
  llm::CheckLlmConfig(config.llm(), [&checker](std::string_view field, std::string_view problem) {
    checker.Report(fmt::format("llm.{}", field), problem);
  });
}

}  // namespace flair::language
