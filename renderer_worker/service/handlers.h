// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/impl/service_type.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/config/v1/renderer_worker_config.pb.h"
#include "flair/v1/renderer_service.pb.h"
#include "flair/v1/solved_layout.pb.h"
#include "renderer_worker/contact_sheet/contact_sheet.h"
#include "renderer_worker/images/image_files.h"
#include "renderer_worker/scene/scene.h"
#include "worker_runtime/bootstrap/call_context.h"
#include "worker_runtime/bootstrap/worker_context.h"

namespace flair::renderer {

// What a file says of where it comes from. Nothing that differs between two runs: no time, no machine.
struct Origin {
  std::string job_id;
  std::string brief_text;
  std::optional<int64_t> brief_seed;
  std::string layout_sha256;  // of the layout's canonical bytes, lower-case hex
};

// Of a RenderRequest or an ExportSceneRequest.
template <typename Request>
Origin OriginOf(const Request& request);

// Title, Software, and what is known of the origin as "flair:job_id", "flair:brief", "flair:seed",
// "flair:layout_sha256".
ImageMetadata MetadataOf(const Origin& origin, const std::string& title, const std::string& software);

// What the room is called, such as "A bedroom for a vampire."; "Room" when it has no name.
std::string TitleOf(const v1::SolvedLayout& layout);

// Answers RendererService.ExportScene: binary glTF, or SceneState JSON.
class ExportSceneHandler {
 public:
  // `furnishing` must outlive the handler. `build` is what the program was built from.
  ExportSceneHandler(const FurnishingSource& furnishing, std::string build, int64_t answer_bytes)
      : furnishing_(furnishing), build_(std::move(build)), answer_bytes_(answer_bytes) {}

  absl::StatusOr<v1::ExportSceneResponse> Handle(const v1::ExportSceneRequest& request,
                                                 runtime::CallContext& call) const;

 private:
  const FurnishingSource& furnishing_;
  const std::string build_;
  const int64_t answer_bytes_;
};

// Raise whenever equal requests would give another picture.
inline constexpr char kViewVersion[] = "4";

inline constexpr int kDefaultViewSizePx = 1024;
inline constexpr int kDefaultSampleCount = 16;

struct ViewLimits {
  int thread_count = 1;
  // Largest answer in bytes: a picture that might not fit is refused before it is traced.
  int64_t answer_bytes = 0;
};

// Answers RendererService.Render: plans are drawn, the other views ray-traced.
class RenderHandler {
 public:
  // `writer` and `furnishing` must outlive the handler.
  RenderHandler(ImageWriter& writer, const FurnishingSource& furnishing, const ViewLimits& limits)
      : writer_(writer), furnishing_(furnishing), limits_(limits) {}

  absl::StatusOr<v1::RenderResponse> Handle(const v1::RenderRequest& request, runtime::CallContext& call) const;

 private:
  ImageWriter& writer_;
  const FurnishingSource& furnishing_;
  const ViewLimits limits_;
};

// Answers RendererService.DrawPlanParts.
class PlanPartsHandler {
 public:
  explicit PlanPartsHandler(int64_t answer_bytes) : answer_bytes_(answer_bytes) {}

  absl::StatusOr<v1::DrawPlanPartsResponse> Handle(const v1::DrawPlanPartsRequest& request,
                                                   runtime::CallContext& call) const;

 private:
  const int64_t answer_bytes_;
};

// Where a renderer takes its furniture from: of its own making, or, with a folder of assets, from there where one fits.
struct FurnishingChoice {
  std::unique_ptr<FurnishingSource> source;
  std::string revision;                     // of the manifest; empty without assets
  std::vector<v1::Diagnostic> diagnostics;  // what of the manifest cannot be used
};

using SceneExporter =
    std::function<absl::StatusOr<v1::ExportSceneResponse>(const v1::ExportSceneRequest&, runtime::CallContext&)>;

// What reads folders of models and writes scenes. A program that does neither goes without it, and need not link it.
struct SceneFiles {
  absl::StatusOr<FurnishingChoice> (*choose_furnishing)(const std::string& asset_folder) = nullptr;
  SceneExporter (*make_exporter)(const FurnishingSource& furnishing, const std::string& build,
                                 int64_t answer_bytes) = nullptr;
};
// Ours, in the library flair_renderer_scene_files.
SceneFiles OurSceneFiles();

// The RendererService, for flair-renderer and for programs that host it themselves. `worker` must outlive it. Loads the
// image library only when the first picture is written. NOT_FOUND and INVALID_ARGUMENT for a folder of assets that
// cannot be used, UNIMPLEMENTED for one without SceneFiles.
absl::StatusOr<std::unique_ptr<grpc::Service>> MakeRendererService(const config::v1::RendererWorkerConfig& config,
                                                                   runtime::WorkerContext& worker,
                                                                   const SceneFiles& files);

// In the library flair_renderer_scene_files. NOT_FOUND and INVALID_ARGUMENT name the folder.
absl::StatusOr<FurnishingChoice> ChooseFurnishing(const std::string& asset_folder);

// Sheets that a renderer draws at the same time: each keeps its pixels while its tiles come, however slowly.
inline constexpr int kMostOpenSheets = 8;

// One call of RendererService.ComposeContactSheet. A tile that cannot be drawn shows why in its place and is told in
// the diagnostics. Errors, which end the call: INVALID_ARGUMENT for messages out of order, too many or too few tiles,
// and tiles that do not fit; RESOURCE_EXHAUSTED when kMostOpenSheets are being drawn.
class ContactSheetTaker {
 public:
  // Both must outlive it; `open_sheets` counts those of all calls.
  ContactSheetTaker(ImageWriter& writer, std::atomic<int>& open_sheets);
  ~ContactSheetTaker();
  ContactSheetTaker(const ContactSheetTaker&) = delete;
  ContactSheetTaker& operator=(const ContactSheetTaker&) = delete;

  absl::Status Take(const v1::ComposeContactSheetRequest& request, runtime::CallContext& call);
  absl::StatusOr<v1::ComposeContactSheetResponse> Finish(runtime::CallContext& call);

 private:
  absl::Status Begin(const v1::ContactSheetOptions& options);
  absl::Status Add(const v1::ContactSheetTile& tile);

  ImageWriter& writer_;
  std::atomic<int>& open_sheets_;
  const int open_count_;
  int message_count_ = 0;
  v1::PreviewFormat format_ = v1::PREVIEW_FORMAT_PNG;
  std::string title_;
  SheetGrid grid_;
  std::unique_ptr<ContactSheet> sheet_;
  std::vector<v1::Diagnostic> diagnostics_;
};

}  // namespace flair::renderer
