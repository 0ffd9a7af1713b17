// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "absl/status/statusor.h"
#include "flair/v1/renderer_service.pb.h"
#include "flair/v1/solved_layout.pb.h"
#include "renderer_worker/images/image_files.h"
#include "renderer_worker/scene/scene.h"
#include "worker_runtime/bootstrap/call_context.h"

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

// Ray-traces BIRDSEYE or PERSPECTIVE of a valid request into PNG, JPEG, TIFF or EXR. INVALID_ARGUMENT names size_px
// when the picture cannot fit the answer.
absl::StatusOr<v1::RenderResponse> RenderView(const v1::RenderRequest& request, const FurnishingSource& furnishing,
                                              ImageWriter& writer, const ViewLimits& limits,
                                              runtime::CallContext& call);

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

}  // namespace flair::renderer
