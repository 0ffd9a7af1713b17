// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/service/handlers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "renderer_worker/comparison/draw_comparison.h"
#include "renderer_worker/drawing/draw_plan.h"
#include "renderer_worker/tracing/trace_view.h"
#include "room/validation/validate.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {

template <typename Request>
Origin OriginOf(const Request& request) {
  Origin origin{.job_id = request.job_id(), .brief_text = request.brief_text(), .brief_seed = {}, .layout_sha256 = {}};
  if (request.has_brief_seed()) origin.brief_seed = request.brief_seed();
  origin.layout_sha256 = runtime::Sha256Hex(runtime::CanonicalBytes(request.solved_layout()));
  return origin;
}

template Origin OriginOf(const v1::RenderRequest&);
template Origin OriginOf(const v1::ExportSceneRequest&);

ImageMetadata MetadataOf(const Origin& origin, const std::string& title, const std::string& software) {
  ImageMetadata metadata = {{"Title", title}, {"Software", software}};
  if (!origin.job_id.empty()) metadata.emplace_back("flair:job_id", origin.job_id);
  if (!origin.brief_text.empty()) metadata.emplace_back("flair:brief", origin.brief_text);
  if (origin.brief_seed) metadata.emplace_back("flair:seed", fmt::format("{}", *origin.brief_seed));
  metadata.emplace_back("flair:layout_sha256", origin.layout_sha256);
  return metadata;
}

std::string TitleOf(const v1::SolvedLayout& layout) {
  const v1::Room& room = layout.graph().room();
  if (!room.title().empty()) return room.title();
  return room.room_type().empty() ? "Room" : room.room_type();
}

// Bytes of a pixel in an EXR before compression, which never makes it more.
inline constexpr int kExrPixelBytes = 30;

// Raise whenever equal requests would give another picture.
inline constexpr char kPlanVersion[] = "4";

namespace {

std::span<const float> Floats(const PixelVector<Vec3>& values) {
  static_assert(sizeof(Vec3) == 3 * sizeof(float));
  return {reinterpret_cast<const float*>(values.data()), 3 * values.size()};
}

// Ids are never negative.
std::span<const uint32_t> Numbers(const PixelVector<int32_t>& values) {
  return {reinterpret_cast<const uint32_t*>(values.data()), values.size()};
}

}  // namespace

// The channels of a traced view, see docs/views.md: R, G, B (half), Z (float, metres), N.X, N.Y, N.Z (float, room
// frame), albedo.R, albedo.G, albedo.B (half), instance, class (unsigned). They refer into `view`.
std::vector<ImagePlane> ExrPlanes(const TracedView& view) {
  return {{{"R", "G", "B"}, ChannelStorage::kHalf, Floats(view.colour), {}},
          {{"Z"}, ChannelStorage::kFloat, view.depth_m, {}},
          {{"N.X", "N.Y", "N.Z"}, ChannelStorage::kHalf, Floats(view.normal), {}},
          {{"albedo.R", "albedo.G", "albedo.B"}, ChannelStorage::kHalf, Floats(view.albedo), {}},
          {{"instance"}, ChannelStorage::kUint32, {}, Numbers(view.instance)},
          {{"class"}, ChannelStorage::kUint32, {}, Numbers(view.object_class)}};
}

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
  ASSIGN_OR_RETURN(DrawnPlan plan, request.beside().empty()
                                       ? DrawPlan(request.solved_layout(), request.options(), request.remark())
                                       : DrawComparison(request));
  RETURN_IF_ERROR(call.CheckAlive());
  ImageMetadata metadata = MetadataOf(request, plan.title);
  metadata.emplace_back("flair:scale", fmt::format("1:{} at {}", plan.scale, plan.paper));
  ASSIGN_OR_RETURN(std::string file, writer.Write(preview.format(), plan.pixels, metadata, DotsPerInch(plan)));
  preview.set_width_px(plan.pixels.width_px);
  preview.set_height_px(plan.pixels.height_px);
  preview.set_image(std::move(file));
  return absl::OkStatus();
}

// Pages have no pixels: their width and height stay 0.
absl::Status FillWithDocument(const v1::RenderRequest& request, v1::Preview& preview) {
  const ImageMetadata metadata = MetadataOf(request, TitleOf(request.solved_layout()));
  ASSIGN_OR_RETURN(std::string file,
                   request.beside().empty()
                       ? DrawPlanDocument(request.solved_layout(), request.options(), metadata, request.remark())
                       : DrawComparisonDocument(request, metadata));
  preview.set_image(std::move(file));
  return absl::OkStatus();
}

}  // namespace

// Draws PLAN of a valid request into PNG, JPEG, TIFF, SVG or PDF; the last two without any image library.
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
    return InvalidArgument("options.size_px: {} is too large for a ray-traced view; at most {}", size, largest);
  }
  return InvalidArgument(
      "options.size_px: {0} is too large{1}: {0} x {0} px of {2} bytes may take {3} MiB, and this renderer sends "
      "messages of {4} MiB (runtime.max_message_mib); at most {5}",
      size, is_exr ? " for an EXR" : "", pixel_bytes, (size * size * pixel_bytes) >> 20, answer_bytes >> 20, largest);
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

// Ray-traces BIRDSEYE or PERSPECTIVE of a valid request into PNG, JPEG, TIFF or EXR. INVALID_ARGUMENT names size_px
// when the picture cannot fit the answer.
absl::StatusOr<v1::RenderResponse> RenderView(const v1::RenderRequest& request, const FurnishingSource& furnishing,
                                              ImageWriter& writer, const ViewLimits& limits,
                                              runtime::CallContext& call) {
  const v1::RenderOptions& options = request.options();
  RETURN_IF_ERROR(CheckSize(options, limits.answer_bytes));
  const PrepareBeside prepare(writer);
  ASSIGN_OR_RETURN(const Scene scene, BuildScene(request.solved_layout(), furnishing));
  const TraceOptions trace{
      .width_px = SizeOf(options),
      .height_px = SizeOf(options),
      .sample_count = options.has_sample_count() ? options.sample_count() : kDefaultSampleCount,
      .seed = options.seed(),
      .colour_only = options.format() != v1::PREVIEW_FORMAT_EXR,
      .thread_count = limits.thread_count,
      .check_alive = [&call] { return call.CheckAlive(); },
  };
  ASSIGN_OR_RETURN(TracedView view, TraceView(scene, CameraOf(options, scene), trace));
  const bool is_birdseye = options.view() == v1::PREVIEW_VIEW_BIRDSEYE;
  const char* method = is_birdseye ? "birdseye" : "perspective";
  ImageMetadata metadata = MetadataOf(OriginOf(request), TitleOf(request.solved_layout()),
                                      fmt::format("flair-renderer {} {}", method, kViewVersion));
  metadata.emplace_back("flair:samples", fmt::format("{}", trace.sample_count));
  metadata.emplace_back("flair:view_seed", fmt::format("{}", trace.seed));
  ASSIGN_OR_RETURN(std::string file, Encode(options, view, metadata, limits.thread_count, writer));
  v1::RenderResponse response;
  v1::Preview& preview = *response.mutable_preview();
  preview.set_view(options.view());
  preview.set_format(options.format() == v1::PREVIEW_FORMAT_UNSPECIFIED ? v1::PREVIEW_FORMAT_PNG : options.format());
  preview.set_width_px(view.width_px);
  preview.set_height_px(view.height_px);
  preview.set_image(std::move(file));
  *preview.mutable_annotations() = std::move(view.annotations);
  for (const v1::Diagnostic& diagnostic : scene.diagnostics) *response.add_diagnostics() = diagnostic;
  response.mutable_producer()->set_program("flair-renderer");
  response.mutable_producer()->set_method(method);
  response.mutable_producer()->set_version(kViewVersion);
  return response;
}

// A plan is compressed many times over, so that its size is known when it is there.
absl::Status CheckAnswer(const v1::RenderResponse& response, int64_t answer_bytes) {
  const size_t size = response.ByteSizeLong();
  if (size <= static_cast<uint64_t>(answer_bytes)) return absl::OkStatus();
  return ResourceExhausted(
      "options: the picture's file takes {} MiB, and this renderer sends messages of {} MiB "
      "(runtime.max_message_mib); ask for a smaller size_px or dpi, or PNG or JPEG",
      size >> 20, answer_bytes >> 20);
}

}  // namespace

absl::StatusOr<v1::RenderResponse> RenderHandler::Handle(const v1::RenderRequest& request,
                                                         runtime::CallContext& call) const {
  RETURN_IF_ERROR(Validate(request));
  const v1::PreviewView view = request.options().view();
  const bool is_plan = view == v1::PREVIEW_VIEW_UNSPECIFIED || view == v1::PREVIEW_VIEW_PLAN;
  absl::StatusOr<v1::RenderResponse> response =
      is_plan ? RenderPlan(request, writer_, call) : RenderView(request, furnishing_, writer_, limits_, call);
  if (!response.ok()) return response;
  RETURN_IF_ERROR(CheckAnswer(*response, limits_.answer_bytes));
  return response;
}

absl::StatusOr<v1::DrawPlanPartsResponse> PlanPartsHandler::Handle(const v1::DrawPlanPartsRequest& request,
                                                                   runtime::CallContext&) const {
  RETURN_IF_ERROR(Validate(request));
  v1::DrawPlanPartsResponse response;
  ASSIGN_OR_RETURN(*response.mutable_parts(), DrawPlanParts(request));
  response.mutable_producer()->set_program("flair-renderer");
  response.mutable_producer()->set_method("plan_parts");
  response.mutable_producer()->set_version(kPlanVersion);
  const size_t size = response.ByteSizeLong();
  if (size <= static_cast<uint64_t>(answer_bytes_)) return response;
  return ResourceExhausted(
      "solved_layout: its parts take {} MiB, and this renderer sends messages of {} MiB (runtime.max_message_mib); "
      "ask for fewer object_ids at a time",
      size >> 20, answer_bytes_ >> 20);
}

}  // namespace flair::renderer
