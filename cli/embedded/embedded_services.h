// SPDX-License-Identifier: GPL-3.0-or-later
// All five services in this process, over channels that need no port; of the four stages those that nobody else runs.
#pragma once

#include <grpcpp/channel.h>

#include <memory>
#include <optional>
#include <string>

#include "absl/status/statusor.h"
#include "cli/input/service_flags.h"
#include "flair/config/v1/orchestrator_config.pb.h"
#include "language_worker/service/make_language_service.h"
#include "orchestrator/service/make_orchestrator_service.h"
#include "renderer_worker/service/handlers.h"
#include "translator_worker/service/make_translator_service.h"
#include "worker_runtime/grpc/in_process_server.h"

namespace flair::cli {

// How the language stage and the translator here come to ask a model, and the renderer to 3D models and scenes.
struct ModelStages {
  language::ModelHandlersMaker language;
  translator::ModelTranslatorMaker translator;
  renderer::SceneFiles renderer;
};

// Called at a program's start. Without it they are refused, and the program need not link them: flair-design, which is
// built first, does without.
void UseModels(ModelStages stages);
const ModelStages& UsedModels();
// The same with ours, in the library flair_cli_models.
void UseOurModels();

class EmbeddedServices {
 public:
  // `store_path` is made when missing. FAILED_PRECONDITION when it cannot be used; for a model as llm::MakeLlmClient;
  // for stages elsewhere as ConnectToStage; for handbooks as language::LoadHandbook. The translator here takes its
  // catalogue from the optimizer that is used. What `orchestrator` sets goes before what a command needs otherwise:
  // another store or queue, more jobs at once, none at all.
  static absl::StatusOr<std::unique_ptr<EmbeddedServices>> Start(
      const std::string& store_path, const OptionalLlm& llm = std::nullopt, const StageChoice& stages = {},
      const config::v1::OrchestratorConfig& orchestrator = {});
  // The four stages without an orchestrator and its store; orchestrator() must not be called.
  static absl::StatusOr<std::unique_ptr<EmbeddedServices>> StartStages(const OptionalLlm& llm = std::nullopt,
                                                                       const StageChoice& stages = {});
  // Interrupts running jobs, which go on when the store is opened again.
  ~EmbeddedServices();

  std::shared_ptr<grpc::Channel> orchestrator() { return orchestrator_->channel(); }
  const orchestrator::StageChannels& stages() const { return stages_; }

 private:
  EmbeddedServices() = default;
  // For so many jobs at once.
  absl::Status StartWorkers(const OptionalLlm& llm, const StageChoice& stages, int job_count);
  absl::Status StartOrchestrator(const std::string& default_path, const config::v1::OrchestratorConfig& asked);

  // Made in this order, destroyed in reverse; null for a stage that is elsewhere.
  std::unique_ptr<runtime::InProcessServer> language_;
  std::unique_ptr<runtime::InProcessServer> optimizer_;
  std::unique_ptr<runtime::InProcessServer> translator_;
  std::unique_ptr<runtime::InProcessServer> renderer_;
  orchestrator::StageChannels stages_;
  std::unique_ptr<runtime::InProcessServer> orchestrator_;
  orchestrator::OrchestratorService* service_ = nullptr;
};

// Servers of single stages that the user named, in place of those in this process.

// What a stage is called on the command line and on the wire.
struct StageName {
  const char* flag;     // such as "--optimizer"
  const char* service;  // full name, such as "flair.v1.OptimizerService"
  // Asks nothing of it, which tells whether the service is there: a request without content costs no server anything.
  absl::Status (*ask_nothing)(const std::shared_ptr<grpc::Channel>& channel);
};
extern const StageName kLanguageStage;
extern const StageName kTranslatorStage;
extern const StageName kOptimizerStage;
extern const StageName kRendererStage;

// A channel to the server at `address`, which has answered. INVALID_ARGUMENT when the address has no right form or
// leads to a server of something else or of another version of the protocol, UNAVAILABLE when nobody answers; all name
// flag and address. `max_message_mib` 0: as runtime::MakeChannel.
absl::StatusOr<std::shared_ptr<grpc::Channel>> ConnectToStage(const StageName& stage, const std::string& address,
                                                              int max_message_mib = 0);

// `status` of a later call in words, when it says that the server is not there any more; itself otherwise.
absl::Status InWords(const StageName& stage, const std::string& address, const absl::Status& status);

}  // namespace flair::cli
