// SPDX-License-Identifier: GPL-3.0-or-later
// flair-translator: serves flair.v1.TranslatorService.
#include "flair/config/v1/translator_worker_config.pb.h"
#include "flair/v1/translator_service.grpc.pb.h"
#include "translator_worker/model/model_translator.h"
#include "translator_worker/service/make_translator_service.h"
#include "worker_runtime/bootstrap/build_id.h"
#include "worker_runtime/bootstrap/run.h"

namespace flair {
namespace {

absl::Status Assemble(const config::v1::TranslatorWorkerConfig& config, runtime::Worker& worker) {
  auto service = translator::MakeTranslatorService(config, worker.context(), translator::MakeModelTranslator);
  if (!service.ok()) return service.status();
  worker.Serve(v1::TranslatorService::service_full_name(), *std::move(service));
  return absl::OkStatus();
}

}  // namespace
}  // namespace flair

int main(int argc, char** argv) {
  return flair::runtime::Run<flair::config::v1::TranslatorWorkerConfig>(
      argc, argv,
      {"flair-translator", "Serves flair.v1.TranslatorService: turns sentences into constraint calls.",
       flair::runtime::BuildName()},
      flair::Assemble, flair::translator::CheckTranslatorConfig);
}
