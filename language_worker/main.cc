// SPDX-License-Identifier: GPL-3.0-or-later
// flair-language: serves flair.v1.LanguageService.
#include "flair/config/v1/language_worker_config.pb.h"
#include "flair/v1/language_service.grpc.pb.h"
#include "language_worker/model/model_handlers.h"
#include "language_worker/service/make_language_service.h"
#include "worker_runtime/bootstrap/build_id.h"
#include "worker_runtime/bootstrap/run.h"

int main(int argc, char** argv) {
  using namespace flair;  // Their names in one call.
  const auto make = [](const config::v1::LanguageWorkerConfig& config, runtime::WorkerContext& context) {
    return language::MakeLanguageService(config, context, [](const auto& own, const auto& handbook, auto& worker) {
      return language::MakeModelHandlers(own, handbook, worker);
    });
  };
  return runtime::RunService<config::v1::LanguageWorkerConfig, v1::LanguageService>(
      argc, argv,
      {"flair-language", "Serves flair.v1.LanguageService: describes rooms in words and lists.", runtime::BuildName()},
      make, language::CheckLanguageConfig);
}
