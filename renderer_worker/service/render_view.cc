// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/service/render_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "renderer_worker/images/prepare_beside.h"
#include "renderer_worker/scene/scene.h"
#include "renderer_worker/service/exr_planes.h"
#include "renderer_worker/service/origin.h"
#include "renderer_worker/tracing/trace_view.h"

namespace flair::renderer {
namespace {

// Annotations, metadata and headers of an answer.
constexpr int64_t kBesidePixels = 1 << 20;

int SizeOf(const v1::RenderOptions& options) { return options.has_size_px() ? options.size_px() : kDefaultViewSizePx; }

// The compressed file is never larger than its pixels.
absl::Status CheckSize(const v1::RenderOptions& options, int64_t answer_bytes) {
  const bool is_exr = options.format() == v1::PREVIEW_FORMAT_EXR;
  const int64_t pixel_bytes = is_exr ? kExrPixelBytes : 3;
  const int64_t most_pixels = std::min(kMaxTracedPixels, (answer_bytes - kBesidePixels) / pixel_bytes);
  const int64_t size = SizeOf(options);
  if (size * size <= most_pixels) return absl::OkStatus();
  const int64_t largest = static_cast<int64_t>(std::sqrt(static_cast<double>(std::max<int64_t>(0, most_pixels))));
  if (most_pixels == kMaxTracedPixels) {
    return absl::InvalidArgumentError(
        fmt::format("options.size_px: {} is too large for a ray-traced view; at most {}", size, largest));
  }
  return absl::InvalidArgumentError(fmt::format(
      "options.size_px: {0} is too large{1}: {0} x {0} px of {2} bytes may take {3} MiB, and this renderer sends "
      "messages of {4} MiB (runtime.max_message_mib); at most {5}",
      size, is_exr ? " for an EXR" : "", pixel_bytes, (size * size * pixel_bytes) >> 20, answer_bytes >> 20, largest));
}

SceneCamera CameraOf(const v1::RenderOptions& options, const Scene& scene) {
  if (!options.has_camera()) return options.view() == v1::PREVIEW_VIEW_BIRDSEYE ? scene.birdseye : scene.perspective;
  const v1::ViewCamera& camera = options.camera();
  const auto vector = [](const auto& v) {
    return Vec3{static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
  };
  return {.name = "camera",
          .eye = vector(camera.eye_m()),
          .target = vector(camera.target_m()),
          .field_of_view_rad = camera.has_field_of_view_rad() ? static_cast<float>(camera.field_of_view_rad()) : 1.0F};
}

absl::StatusOr<std::string> Encode(const v1::RenderOptions& options, const TracedView& view,
                                   const ImageMetadata& metadata, int thread_count, ImageWriter& writer) {
  if (options.format() == v1::PREVIEW_FORMAT_EXR)
    return writer.WriteExr(view.width_px, view.height_px, ExrPlanes(view), metadata);
  const v1::PreviewFormat format =
      options.format() == v1::PREVIEW_FORMAT_UNSPECIFIED ? v1::PREVIEW_FORMAT_PNG : options.format();
  return writer.Write(format, ToneMapped(view, thread_count), metadata);
}

}  // namespace

absl::StatusOr<v1::RenderResponse> RenderView(const v1::RenderRequest& request, const FurnishingSource& furnishing,
                                              ImageWriter& writer, const ViewLimits& limits,
                                              runtime::CallContext& call) {
  const v1::RenderOptions& options = request.options();
  if (absl::Status status = CheckSize(options, limits.answer_bytes); !status.ok()) return status;
  const PrepareBeside prepare(writer);
  const absl::StatusOr<Scene> scene = BuildScene(request.solved_layout(), furnishing);
  if (!scene.ok()) return scene.status();
  const TraceOptions trace{
      .width_px = SizeOf(options),
      .height_px = SizeOf(options),
      .sample_count = options.has_sample_count() ? options.sample_count() : kDefaultSampleCount,
      .seed = options.seed(),
      .colour_only = options.format() != v1::PREVIEW_FORMAT_EXR,
      .thread_count = limits.thread_count,
      .check_alive = [&call] { return call.CheckAlive(); },
  };
  absl::StatusOr<TracedView> view = TraceView(*scene, CameraOf(options, *scene), trace);
  if (!view.ok()) return view.status();
  const bool is_birdseye = options.view() == v1::PREVIEW_VIEW_BIRDSEYE;
  const char* method = is_birdseye ? "birdseye" : "perspective";
  ImageMetadata metadata = MetadataOf(OriginOf(request), TitleOf(request.solved_layout()),
                                      fmt::format("flair-renderer {} {}", method, kViewVersion));
  metadata.emplace_back("flair:samples", fmt::format("{}", trace.sample_count));
  metadata.emplace_back("flair:view_seed", fmt::format("{}", trace.seed));
  absl::StatusOr<std::string> file = Encode(options, *view, metadata, limits.thread_count, writer);
  if (!file.ok()) return file.status();
  v1::RenderResponse response;
  v1::Preview& preview = *response.mutable_preview();
  preview.set_view(options.view());
  preview.set_format(options.format() == v1::PREVIEW_FORMAT_UNSPECIFIED ? v1::PREVIEW_FORMAT_PNG : options.format());
  preview.set_width_px(view->width_px);
  preview.set_height_px(view->height_px);
  preview.set_image(*std::move(file));
  *preview.mutable_annotations() = std::move(view->annotations);
  for (const v1::Diagnostic& diagnostic : scene->diagnostics) *response.add_diagnostics() = diagnostic;
  response.mutable_producer()->set_program("flair-renderer");
  response.mutable_producer()->set_method(method);
  response.mutable_producer()->set_version(kViewVersion);
  return response;
}

}  // namespace flair::renderer
