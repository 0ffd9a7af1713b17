// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/service/render_handler.h"

#include <fmt/format.h>

#include <utility>

#include "renderer_worker/drawing/draw_plan.h"
#include "room/validation/validate.h"

namespace flair::renderer {
namespace {

// Raise whenever equal layouts would give another picture.
constexpr char kPlanVersion[] = "1";

// Nothing that differs between two runs: no time, no machine.
ImageMetadata MetadataOf(const v1::RenderRequest& request, const DrawnPlan& plan) {
  ImageMetadata metadata = {{"Title", plan.title}, {"Software", fmt::format("flair-renderer plan {}", kPlanVersion)}};
  metadata.emplace_back("flair:scale", fmt::format("1:{} at A3", plan.scale));
  if (!request.job_id().empty()) metadata.emplace_back("flair:job_id", request.job_id());
  return metadata;
}

}  // namespace

absl::StatusOr<v1::RenderResponse> RenderHandler::Handle(const v1::RenderRequest& request,
                                                         runtime::CallContext& call) const {
  if (absl::Status status = Validate(request); !status.ok()) return status;
  absl::StatusOr<DrawnPlan> plan = DrawPlan(request.solved_layout(), request.options());
  if (!plan.ok()) return plan.status();
  if (absl::Status status = call.CheckAlive(); !status.ok()) return status;
  absl::StatusOr<std::string> file = writer_.WritePng(plan->pixels, MetadataOf(request, *plan));
  if (!file.ok()) return file.status();
  v1::RenderResponse response;
  v1::Preview& preview = *response.mutable_preview();
  preview.set_view(v1::PREVIEW_VIEW_PLAN);
  preview.set_format(v1::PREVIEW_FORMAT_PNG);
  preview.set_width_px(plan->pixels.width_px);
  preview.set_height_px(plan->pixels.height_px);
  preview.set_image(*std::move(file));
  response.mutable_producer()->set_program("flair-renderer");
  response.mutable_producer()->set_method("plan");
  response.mutable_producer()->set_version(kPlanVersion);
  return response;
}

}  // namespace flair::renderer
