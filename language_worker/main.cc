// SPDX-License-Identifier: GPL-3.0-or-later
// flair-language: serves flair.v1.LanguageService.
#include "flair/config/v1/language_worker_config.pb.h"
#include "flair/v1/language_service.grpc.pb.h"
#include "language_worker/model/model_handlers.h"
#include "language_worker/service/make_language_service.h"
#include "worker_runtime/bootstrap/build_id.h"
#include "worker_runtime/bootstrap/run.h"

namespace flair {
namespace {

absl::Status Assemble(const config::v1::LanguageWorkerConfig& config, runtime::Worker& worker) {
  const auto with_model = [](const auto& config, const language::Handbook& handbook, runtime::WorkerContext& context) {
    return language::MakeModelHandlers(config, handbook, context);
  };
  auto service = language::MakeLanguageService(config, worker.context(), with_model);
  if (!service.ok()) return service.status();
  worker.Serve(v1::LanguageService::service_full_name(), *std::move(service));
  return absl::OkStatus();
}

}  // namespace
}  // namespace flair

int main(int argc, char** argv) {
  return flair::runtime::Run<flair::config::v1::LanguageWorkerConfig>(
      argc, argv,
      {"flair-language", "Serves flair.v1.LanguageService: describes rooms in words and lists.",
       flair::runtime::BuildName()},
      flair::Assemble, flair::language::CheckLanguageConfig);
}
