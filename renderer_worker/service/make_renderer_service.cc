// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/service/make_renderer_service.h"

#include <utility>

#include "flair/v1/renderer_service.grpc.pb.h"
#include "renderer_worker/images/image_writer.h"
#include "renderer_worker/service/export_scene_handler.h"
#include "renderer_worker/service/render_handler.h"
#include "worker_runtime/grpc/unary_call.h"

namespace flair::renderer {
namespace {

class Service final : public v1::RendererService::CallbackService {
 public:
  Service(std::unique_ptr<ImageWriter> writer, runtime::WorkerContext& worker)
      : worker_(worker), writer_(std::move(writer)), render_(*writer_) {}

  grpc::ServerUnaryReactor* Render(grpc::CallbackServerContext* context, const v1::RenderRequest* request,
                                   v1::RenderResponse* response) override {
    return runtime::ServeUnary(worker_, "Render", context, request, response, render_);
  }

  grpc::ServerUnaryReactor* ExportScene(grpc::CallbackServerContext* context, const v1::ExportSceneRequest* request,
                                        v1::ExportSceneResponse* response) override {
    return runtime::ServeUnary(worker_, "ExportScene", context, request, response, export_scene_);
  }

 private:
  runtime::WorkerContext& worker_;
  const std::unique_ptr<ImageWriter> writer_;
  RenderHandler render_;
  ExportSceneHandler export_scene_;
};

}  // namespace

absl::StatusOr<std::unique_ptr<grpc::Service>> MakeRendererService(const config::v1::RendererWorkerConfig& config,
                                                                   runtime::WorkerContext& worker) {
  return std::make_unique<Service>(MakeImageWriter(), worker);
}

}  // namespace flair::renderer
