// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/service/render_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "renderer_worker/comparison/draw_comparison.h"
#include "renderer_worker/drawing/draw_plan.h"
#include "renderer_worker/images/prepare_beside.h"
#include "renderer_worker/service/origin.h"

namespace flair::renderer {
namespace {

constexpr double kMmPerInch = 25.4;

ImageMetadata MetadataOf(const v1::RenderRequest& request, const std::string& title) {
  return MetadataOf(OriginOf(request), title, fmt::format("flair-renderer plan {}", kPlanVersion));
}

bool IsDocument(v1::PreviewFormat format) {
  return format == v1::PREVIEW_FORMAT_SVG || format == v1::PREVIEW_FORMAT_PDF;
}

// With which the picture printed is as large as its paper.
double DotsPerInch(const DrawnPlan& plan) {
  const double longer_mm = plan.paper == "A4" ? 297 : 420;
  return std::max(plan.pixels.width_px, plan.pixels.height_px) / longer_mm * kMmPerInch;
}

absl::Status FillWithPixels(const v1::RenderRequest& request, ImageWriter& writer, runtime::CallContext& call,
                            v1::Preview& preview) {
  const PrepareBeside prepare(writer);
  absl::StatusOr<DrawnPlan> plan =
      request.beside().empty() ? DrawPlan(request.solved_layout(), request.options()) : DrawComparison(request);
  if (!plan.ok()) return plan.status();
  if (absl::Status status = call.CheckAlive(); !status.ok()) return status;
  ImageMetadata metadata = MetadataOf(request, plan->title);
  metadata.emplace_back("flair:scale", fmt::format("1:{} at {}", plan->scale, plan->paper));
  absl::StatusOr<std::string> file = writer.Write(preview.format(), plan->pixels, metadata, DotsPerInch(*plan));
  if (!file.ok()) return file.status();
  preview.set_width_px(plan->pixels.width_px);
  preview.set_height_px(plan->pixels.height_px);
  preview.set_image(*std::move(file));
  return absl::OkStatus();
}

// Pages have no pixels: their width and height stay 0.
absl::Status FillWithDocument(const v1::RenderRequest& request, v1::Preview& preview) {
  const ImageMetadata metadata = MetadataOf(request, TitleOf(request.solved_layout()));
  absl::StatusOr<std::string> file = request.beside().empty()
                                         ? DrawPlanDocument(request.solved_layout(), request.options(), metadata)
                                         : DrawComparisonDocument(request, metadata);
  if (!file.ok()) return file.status();
  preview.set_image(*std::move(file));
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<v1::RenderResponse> RenderPlan(const v1::RenderRequest& request, ImageWriter& writer,
                                              runtime::CallContext& call) {
  v1::RenderResponse response;
  v1::Preview& preview = *response.mutable_preview();
  preview.set_view(v1::PREVIEW_VIEW_PLAN);
  const v1::PreviewFormat format = request.options().format();
  preview.set_format(format == v1::PREVIEW_FORMAT_UNSPECIFIED ? v1::PREVIEW_FORMAT_PNG : format);
  const absl::Status filled =
      IsDocument(format) ? FillWithDocument(request, preview) : FillWithPixels(request, writer, call, preview);
  if (!filled.ok()) return filled;
  response.mutable_producer()->set_program("flair-renderer");
  response.mutable_producer()->set_method("plan");
  response.mutable_producer()->set_version(kPlanVersion);
  return response;
}

}  // namespace flair::renderer
