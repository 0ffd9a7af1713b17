// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/service/export_scene_handler.h"

#include <fmt/format.h>

#include "renderer_worker/gltf/write_glb.h"
#include "renderer_worker/scene/scene.h"
#include "renderer_worker/scene_state/write_scene_state.h"
#include "renderer_worker/service/origin.h"
#include "room/validation/validate.h"

namespace flair::renderer {
namespace {

// Raise whenever equal requests would give another scene.
constexpr char kGlbVersion[] = "1";
constexpr char kSceneStateVersion[] = "1";

GlbMetadata MetadataOf(const v1::ExportSceneRequest& request, const std::string& build) {
  Origin origin = OriginOf(request);
  return {.job_id = std::move(origin.job_id),
          .brief_text = std::move(origin.brief_text),
          .brief_seed = origin.brief_seed,
          .layout_digest = std::move(origin.layout_sha256),
          .build = build};
}

}  // namespace

absl::StatusOr<v1::ExportSceneResponse> ExportSceneHandler::Handle(const v1::ExportSceneRequest& request,
                                                                   runtime::CallContext& call) const {
  if (absl::Status status = Validate(request); !status.ok()) return status;
  const absl::StatusOr<Scene> scene = BuildScene(request.solved_layout(), furnishing_);
  if (!scene.ok()) return scene.status();
  if (absl::Status status = call.CheckAlive(); !status.ok()) return status;
  const bool is_glb = request.format() == v1::SCENE_FORMAT_GLB;
  absl::StatusOr<std::string> file = is_glb ? WriteGlb(*scene, MetadataOf(request, build_)) : WriteSceneState(*scene);
  if (!file.ok()) return file.status();
  if (file->size() > static_cast<uint64_t>(answer_bytes_)) {
    return absl::ResourceExhaustedError(
        fmt::format("the scene's file takes {} MiB, and this renderer sends messages of {} MiB "
                    "(runtime.max_message_mib)",
                    file->size() >> 20, answer_bytes_ >> 20));
  }
  v1::ExportSceneResponse response;
  response.set_scene(*std::move(file));
  for (const v1::Diagnostic& diagnostic : scene->diagnostics) *response.add_diagnostics() = diagnostic;
  response.mutable_producer()->set_program("flair-renderer");
  response.mutable_producer()->set_method(is_glb ? "glb" : "scene_state");
  response.mutable_producer()->set_version(is_glb ? kGlbVersion : kSceneStateVersion);
  return response;
}

}  // namespace flair::renderer
