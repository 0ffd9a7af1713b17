// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/service/make_renderer_service.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <utility>

#include "flair/v1/renderer_service.grpc.pb.h"
#include "flair/v1/worker_service.pb.h"
#include "renderer_worker/images/image_writer.h"
#include "renderer_worker/service/contact_sheet_taker.h"
#include "renderer_worker/service/export_scene_handler.h"
#include "renderer_worker/service/furnishing_choice.h"
#include "renderer_worker/service/render_handler.h"
#include "renderer_worker/service/render_metrics.h"
#include "worker_runtime/grpc/channel.h"
#include "worker_runtime/grpc/server_call.h"
#include "worker_runtime/logging/log.h"

namespace flair::renderer {
namespace {

class Service final : public v1::RendererService::CallbackService {
 public:
  Service(std::unique_ptr<ImageWriter> writer, std::unique_ptr<FurnishingSource> furnishing, const ViewLimits& limits,
          runtime::WorkerContext& worker)
      : worker_(worker),
        writer_(std::move(writer)),
        furnishing_(std::move(furnishing)),
        render_(*writer_, *furnishing_, limits),
        export_scene_(*furnishing_, worker.build, limits.answer_bytes),
        counted_render_(render_, worker.clock, RenderMetrics(worker.metrics)) {}

  grpc::ServerUnaryReactor* Render(grpc::CallbackServerContext* context, const v1::RenderRequest* request,
                                   v1::RenderResponse* response) override {
    return runtime::ServeUnary(worker_, "Render", context, request, response, counted_render_);
  }

  grpc::ServerUnaryReactor* ExportScene(grpc::CallbackServerContext* context, const v1::ExportSceneRequest* request,
                                        v1::ExportSceneResponse* response) override {
    return runtime::ServeUnary(worker_, "ExportScene", context, request, response, export_scene_);
  }

  grpc::ServerReadReactor<v1::ComposeContactSheetRequest>* ComposeContactSheet(
      grpc::CallbackServerContext* context, v1::ComposeContactSheetResponse* response) override {
    return runtime::ServeClientStream<v1::ComposeContactSheetRequest>(
        worker_, "ComposeContactSheet", context, response, std::make_unique<ContactSheetTaker>(*writer_, open_sheets_));
  }

 private:
  runtime::WorkerContext& worker_;
  const std::unique_ptr<ImageWriter> writer_;
  const std::unique_ptr<FurnishingSource> furnishing_;
  std::atomic<int> open_sheets_ = 0;
  RenderHandler render_;
  ExportSceneHandler export_scene_;
  runtime::ObservedHandler<RenderHandler, RenderMetrics> counted_render_;
};

ViewLimits LimitsOf(const config::v1::RendererWorkerConfig& config) {
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return {.thread_count = std::clamp(
              config.has_tracing_thread_count() ? static_cast<int>(config.tracing_thread_count()) : cores, 1, 256),
          .answer_bytes = runtime::MaxMessageBytes(config.runtime().max_message_mib())};
}

}  // namespace

absl::StatusOr<std::unique_ptr<grpc::Service>> MakeRendererService(const config::v1::RendererWorkerConfig& config,
                                                                   runtime::WorkerContext& worker) {
  absl::StatusOr<FurnishingChoice> furnishing = ChooseFurnishing(config.asset_folder_path());
  if (!furnishing.ok()) return furnishing.status();
  for (const v1::Diagnostic& diagnostic : furnishing->diagnostics)
    worker.logger->warn("assets: {}", diagnostic.message());
  worker.revision = furnishing->revision;
  worker.capabilities = {v1::CAPABILITY_DETERMINISTIC, v1::CAPABILITY_VIEWS, v1::CAPABILITY_EXPORT_SCENE,
                         v1::CAPABILITY_CONTACT_SHEET};
  return std::make_unique<Service>(MakeImageWriter(), std::move(furnishing->source), LimitsOf(config), worker);
}

}  // namespace flair::renderer
