// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <thread>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/strip.h"
#include "absl/time/time.h"
#include "flair/v1/renderer_service.grpc.pb.h"
#include "flair/v1/worker_service.pb.h"
#include "renderer_worker/drawing/draw_plan.h"
#include "renderer_worker/furniture/procedural_furniture.h"
#include "renderer_worker/service/handlers.h"
#include "room/validation/validate.h"
#include "worker_runtime/grpc/channel.h"
#include "worker_runtime/grpc/server_call.h"
#include "worker_runtime/logging/log.h"
#include "worker_runtime/metrics/metrics.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {
namespace {

constexpr runtime::MetricFamily kDuration =
    runtime::HistogramFamily("flair_render_duration_seconds", "Time to draw or trace a picture and to encode it.",
                             runtime::kSecondsBuckets, {"view"});

// "plan", "bird_eye" ...; a plan when nothing is asked for.
std::string ViewName(v1::PreviewView view) {
  if (view == v1::PREVIEW_VIEW_UNSPECIFIED) view = v1::PREVIEW_VIEW_PLAN;
  return absl::AsciiStrToLower(absl::StripPrefix(v1::PreviewView_Name(view), "PREVIEW_VIEW_"));
}

// Counts what pictures take, by view. Thread-safe. `metrics` outlives it.
class RenderMetrics {
 public:
  explicit RenderMetrics(runtime::Metrics& metrics) : metrics_(metrics) { metrics.Declare(kDuration); }

  // To be told of answers (runtime::ObservedHandler).
  void operator()(const v1::RenderRequest& request, const v1::RenderResponse&, absl::Duration duration) const {
    metrics_.Get(kDuration, {ViewName(request.options().view())}).Add(absl::ToDoubleSeconds(duration));
  }

 private:
  runtime::Metrics& metrics_;
};

absl::StatusOr<v1::ExportSceneResponse> RefuseExport(const v1::ExportSceneRequest&, runtime::CallContext&) {
  return absl::UnimplementedError("this program writes no scenes");
}

class Service final : public runtime::Service {
 public:
  Service(std::unique_ptr<ImageWriter> writer, std::unique_ptr<FurnishingSource> furnishing, const ViewLimits& limits,
          const SceneFiles& files, runtime::WorkerContext& worker)
      : runtime::Service(worker, v1::RendererService::service_full_name()),
        writer_(std::move(writer)),
        furnishing_(std::move(furnishing)),
        render_(*writer_, *furnishing_, limits),
        parts_(limits.answer_bytes),
        counted_render_(render_, worker.clock, RenderMetrics(worker.metrics)) {
    Unary<v1::RenderRequest>("Render", counted_render_);
    Unary<v1::ExportSceneRequest>("ExportScene",
                                  files.make_exporter == nullptr
                                      ? RefuseExport
                                      : files.make_exporter(*furnishing_, worker.build, limits.answer_bytes));
    Unary<v1::DrawPlanPartsRequest>("DrawPlanParts", parts_);
    ClientStream<v1::ComposeContactSheetRequest>(
        "ComposeContactSheet", [this] { return std::make_unique<ContactSheetTaker>(*writer_, open_sheets_); });
  }

 private:
  const std::unique_ptr<ImageWriter> writer_;
  const std::unique_ptr<FurnishingSource> furnishing_;
  std::atomic<int> open_sheets_ = 0;
  RenderHandler render_;
  PlanPartsHandler parts_;
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

namespace {

// Raise whenever equal requests would give another sheet.
constexpr char kContactSheetVersion[] = "1";

absl::StatusOr<Pixels> DrawTile(const v1::ContactSheetTile& tile, int tile_px) {
  if (tile.has_image()) {
    absl::StatusOr<Pixels> pixels = ReadImage(tile.image(), tile_px, tile_px);
    if (pixels.ok() || !absl::IsInvalidArgument(pixels.status())) return pixels;
    return absl::InvalidArgumentError("the image " + std::string(pixels.status().message()));
  }
  if (!tile.has_solved_layout()) return absl::InvalidArgumentError(tile.remark());
  RETURN_IF_ERROR(Validate(tile.solved_layout()));
  return DrawPlanTile(tile.solved_layout(), tile_px, tile_px);
}

// The tile is at fault, not the renderer.
bool IsOfTile(const absl::Status& status) {
  return absl::IsInvalidArgument(status) || absl::IsResourceExhausted(status);
}

}  // namespace

ContactSheetTaker::ContactSheetTaker(ImageWriter& writer, std::atomic<int>& open_sheets)
    : writer_(writer), open_sheets_(open_sheets), open_count_(++open_sheets) {}

ContactSheetTaker::~ContactSheetTaker() { --open_sheets_; }

absl::Status ContactSheetTaker::Take(const v1::ComposeContactSheetRequest& request, runtime::CallContext& call) {
  if (open_count_ > kMostOpenSheets) {
    return ResourceExhausted("{} contact sheets are being drawn; try again later", kMostOpenSheets);
  }
  RETURN_IF_ERROR(Validate(request, message_count_));
  return message_count_++ == 0 ? Begin(request.options()) : Add(request.tile());
}

absl::Status ContactSheetTaker::Begin(const v1::ContactSheetOptions& options) {
  std::optional<int> tile_px;
  if (options.has_tile_px()) tile_px = options.tile_px();
  ASSIGN_OR_RETURN(grid_, ArrangeSheet(options.tile_count(), tile_px, !options.title().empty()));
  title_ = options.title();
  if (options.format() != v1::PREVIEW_FORMAT_UNSPECIFIED) format_ = options.format();
  ASSIGN_OR_RETURN(sheet_, ContactSheet::Make(grid_, title_));
  return absl::OkStatus();
}

absl::Status ContactSheetTaker::Add(const v1::ContactSheetTile& tile) {
  if (sheet_->added_count() == grid_.tile_count) {
    return InvalidArgument("tile: one more than the {} of options.tile_count", grid_.tile_count);
  }
  const TileText text{tile.caption(), tile.remark()};
  const absl::StatusOr<Pixels> pixels = DrawTile(tile, grid_.tile_px);
  if (pixels.ok()) return sheet_->Add(*pixels, text);
  if (!IsOfTile(pixels.status())) return pixels.status();
  const std::string reason(pixels.status().message());
  v1::Diagnostic& diagnostic = diagnostics_.emplace_back();
  diagnostic.set_severity(v1::SEVERITY_ERROR);
  diagnostic.set_code("tile_not_drawn");
  diagnostic.set_message(fmt::format("tile {}, \"{}\": {}", message_count_ - 1, tile.caption(), reason));
  return sheet_->AddBroken(reason, {tile.caption(), reason == tile.remark() ? "" : tile.remark()});
}

absl::StatusOr<v1::ComposeContactSheetResponse> ContactSheetTaker::Finish(runtime::CallContext& call) {
  if (sheet_ == nullptr) return absl::InvalidArgumentError("options: is not set; the first message holds it");
  if (sheet_->added_count() != grid_.tile_count) {
    return InvalidArgument("options.tile_count: {} tiles were announced, {} came", grid_.tile_count,
                           sheet_->added_count());
  }
  ASSIGN_OR_RETURN(const Pixels pixels, sheet_->Finish());
  ImageMetadata metadata;
  if (!title_.empty()) metadata.emplace_back("Title", title_);
  metadata.emplace_back("Software", fmt::format("flair-renderer contact_sheet {}", kContactSheetVersion));
  ASSIGN_OR_RETURN(std::string file, writer_.Write(format_, pixels, metadata));
  v1::ComposeContactSheetResponse response;
  v1::Preview& preview = *response.mutable_sheet();
  preview.set_format(format_);
  preview.set_width_px(pixels.width_px);
  preview.set_height_px(pixels.height_px);
  preview.set_image(std::move(file));
  for (v1::Diagnostic& diagnostic : diagnostics_) *response.add_diagnostics() = std::move(diagnostic);
  response.mutable_producer()->set_program("flair-renderer");
  response.mutable_producer()->set_method("contact_sheet");
  response.mutable_producer()->set_version(kContactSheetVersion);
  return response;
}

}  // namespace flair::renderer
