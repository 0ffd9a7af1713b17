// SPDX-License-Identifier: GPL-3.0-or-later
// All five services in this process, over channels that need no port; of the four stages those that nobody else runs.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "cli/input/llm_flags.h"
#include "cli/input/service_flags.h"
#include "flair/config/v1/orchestrator_config.pb.h"
#include "language_worker/service/make_language_service.h"
#include "orchestrator/service/make_orchestrator_service.h"
#include "translator_worker/service/make_translator_service.h"
#include "worker_runtime/grpc/in_process_server.h"

namespace flair::cli {

// How the language stage and the translator here come to ask a model.
struct ModelStages {
  language::ModelHandlersMaker language;
  translator::ModelTranslatorMaker translator;
};

// Called at a program's start. Without it a model is refused, and the program need not link what asks one:
// flair-design, which is built first, does without.
void UseModels(ModelStages stages);
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

// $FLAIR_HOME, else $XDG_DATA_HOME/flair, else ~/.local/share/flair.
std::string DefaultStorePath();

}  // namespace flair::cli
