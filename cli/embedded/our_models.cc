// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/embedded/embedded_services.h"
#include "language_worker/model/model_handlers.h"
#include "translator_worker/model/model_translator.h"

namespace flair::cli {

void UseOurModels() {
  UseModels({[](const auto& config, const language::Handbook& handbook, runtime::WorkerContext& worker) {
               return language::MakeModelHandlers(config, handbook, worker);
             },
             translator::MakeModelTranslator, renderer::OurSceneFiles()});
}

}  // namespace flair::cli
