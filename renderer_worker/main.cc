// SPDX-License-Identifier: GPL-3.0-or-later
// flair-renderer: serves flair.v1.RendererService.
#include "flair/config/v1/renderer_worker_config.pb.h"
#include "flair/v1/renderer_service.grpc.pb.h"
#include "renderer_worker/service/handlers.h"
#include "worker_runtime/bootstrap/build_id.h"
#include "worker_runtime/bootstrap/run.h"

int main(int argc, char** argv) {
  using namespace flair;  // Their names in one call.
  const auto make = [](const config::v1::RendererWorkerConfig& config, runtime::WorkerContext& context) {
    return renderer::MakeRendererService(config, context, renderer::OurSceneFiles());
  };
  const auto check = [](const config::v1::RendererWorkerConfig& config, runtime::ConfigChecker& checker) {
    if (config.has_tracing_thread_count()) checker.Range("tracing_thread_count", config.tracing_thread_count(), 1, 256);
  };
  return runtime::RunService<config::v1::RendererWorkerConfig, v1::RendererService>(
      argc, argv,
      {"flair-renderer", "Serves flair.v1.RendererService: draws layouts and writes their scenes.",
       runtime::BuildName()},
      make, check);
}
