// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/service/make_renderer_service.h"

#include <algorithm>
#include <atomic>
#include <string>
#include <thread>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/strip.h"
#include "absl/time/time.h"
#include "flair/v1/renderer_service.grpc.pb.h"
#include "flair/v1/renderer_service.pb.h"
#include "flair/v1/worker_service.pb.h"
#include "renderer_worker/furniture/procedural_furniture.h"
#include "renderer_worker/images/image_files.h"
#include "renderer_worker/service/contact_sheet_taker.h"
#include "renderer_worker/service/handlers.h"
#include "worker_runtime/grpc/channel.h"
#include "worker_runtime/grpc/server_call.h"
#include "worker_runtime/logging/log.h"
#include "worker_runtime/metrics/metrics.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {

// Counts what pictures take, by view. Thread-safe. `metrics` outlives it.
class RenderMetrics {
 public:
  explicit RenderMetrics(runtime::Metrics& metrics);

  // To be told of answers (runtime::ObservedHandler).
  void operator()(const v1::RenderRequest& request, const v1::RenderResponse& response, absl::Duration duration) const;

 private:
  runtime::Metrics& metrics_;
};

namespace {

constexpr runtime::MetricFamily kDuration{.kind = runtime::MetricKind::kHistogram,
                                          .name = "flair_render_duration_seconds",
                                          .help = "Time to draw or trace a picture and to encode it.",
                                          .labels = {"view"},
                                          .buckets = runtime::kSecondsBuckets};

// "plan", "bird_eye" ...; a plan when nothing is asked for.
std::string ViewName(v1::PreviewView view) {
  if (view == v1::PREVIEW_VIEW_UNSPECIFIED) view = v1::PREVIEW_VIEW_PLAN;
  return absl::AsciiStrToLower(absl::StripPrefix(v1::PreviewView_Name(view), "PREVIEW_VIEW_"));
}

}  // namespace

RenderMetrics::RenderMetrics(runtime::Metrics& metrics) : metrics_(metrics) { metrics.Declare(kDuration); }

void RenderMetrics::operator()(const v1::RenderRequest& request, const v1::RenderResponse&,
                               absl::Duration duration) const {
  metrics_.GetHistogram(kDuration, {ViewName(request.options().view())}).Observe(absl::ToDoubleSeconds(duration));
}

namespace {

absl::StatusOr<v1::ExportSceneResponse> RefuseExport(const v1::ExportSceneRequest&, runtime::CallContext&) {
  return absl::UnimplementedError("this program writes no scenes");
}

class Service final : public v1::RendererService::CallbackService {
 public:
  Service(std::unique_ptr<ImageWriter> writer, std::unique_ptr<FurnishingSource> furnishing, const ViewLimits& limits,
          const SceneFiles& files, runtime::WorkerContext& worker)
      : worker_(worker),
        writer_(std::move(writer)),
        furnishing_(std::move(furnishing)),
        render_(*writer_, *furnishing_, limits),
        export_scene_(files.make_exporter == nullptr
                          ? RefuseExport
                          : files.make_exporter(*furnishing_, worker.build, limits.answer_bytes)),
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
  const SceneExporter export_scene_;
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
                                                                   runtime::WorkerContext& worker,
                                                                   const SceneFiles& files) {
  FurnishingChoice furnishing{std::make_unique<ProceduralFurniture>(), "", {}};
  if (files.choose_furnishing != nullptr) {
    ASSIGN_OR_RETURN(furnishing, files.choose_furnishing(config.asset_folder_path()));
  } else if (!config.asset_folder_path().empty()) {
    return absl::UnimplementedError(config.asset_folder_path() + ": this program reads no folders of models");
  }
  for (const v1::Diagnostic& diagnostic : furnishing.diagnostics)
    worker.logger->warn("assets: {}", diagnostic.message());
  worker.revision = furnishing.revision;
  worker.capabilities = {v1::CAPABILITY_DETERMINISTIC, v1::CAPABILITY_VIEWS};
  if (files.make_exporter != nullptr) worker.capabilities.push_back(v1::CAPABILITY_EXPORT_SCENE);
  worker.capabilities.push_back(v1::CAPABILITY_CONTACT_SHEET);
  return std::make_unique<Service>(MakeImageWriter(), std::move(furnishing.source), LimitsOf(config), files, worker);
}

}  // namespace flair::renderer
