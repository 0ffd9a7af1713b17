// SPDX-License-Identifier: GPL-3.0-or-later
// flair-translator: serves flair.v1.TranslatorService.
#include "flair/config/v1/translator_worker_config.pb.h"
#include "flair/v1/translator_service.grpc.pb.h"
#include "translator_worker/model/model_translator.h"
#include "translator_worker/service/make_translator_service.h"
#include "worker_runtime/bootstrap/build_id.h"
#include "worker_runtime/bootstrap/run.h"

int main(int argc, char** argv) {
  using namespace flair;  // Their names in one call.
  const auto make = [](const config::v1::TranslatorWorkerConfig& config, runtime::WorkerContext& context) {
    return translator::MakeTranslatorService(config, context, translator::MakeModelTranslator);
  };
  return runtime::RunService<config::v1::TranslatorWorkerConfig, v1::TranslatorService>(
      argc, argv,
      {"flair-translator", "Serves flair.v1.TranslatorService: turns sentences into constraint calls.",
       runtime::BuildName()},
      make, translator::CheckTranslatorConfig);
}
