// SPDX-License-Identifier: GPL-3.0-or-later
// flair-renderer: serves flair.v1.RendererService.
#include "flair/config/v1/renderer_worker_config.pb.h"
#include "flair/v1/renderer_service.grpc.pb.h"
#include "renderer_worker/service/handlers.h"
#include "worker_runtime/bootstrap/build_id.h"
#include "worker_runtime/bootstrap/run.h"
#include "worker_runtime/status/status_macros.h"

namespace flair {
namespace {

absl::Status Assemble(const config::v1::RendererWorkerConfig& config, runtime::Worker& worker) {
  ASSIGN_OR_RETURN(std::unique_ptr<grpc::Service> service,
                   renderer::MakeRendererService(config, worker.context(), renderer::OurSceneFiles()));
  worker.Serve(v1::RendererService::service_full_name(), std::move(service));
  return absl::OkStatus();
}

void Check(const config::v1::RendererWorkerConfig& config, runtime::ConfigChecker& checker) {
  if (config.has_tracing_thread_count()) checker.Range("tracing_thread_count", config.tracing_thread_count(), 1, 256);
}

}  // namespace
}  // namespace flair

int main(int argc, char** argv) {
  return flair::runtime::Run<flair::config::v1::RendererWorkerConfig>(
      argc, argv,
      {"flair-renderer", "Serves flair.v1.RendererService: draws layouts and writes their scenes.",
       flair::runtime::BuildName()},
      flair::Assemble, flair::Check);
}
