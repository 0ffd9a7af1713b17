// SPDX-License-Identifier: GPL-3.0-or-later
// Models of others read, scenes written.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "renderer_worker/assets/asset_library.h"
#include "renderer_worker/furniture/procedural_furniture.h"
#include "renderer_worker/gltf/gltf.h"
#include "renderer_worker/scene/scene.h"
#include "renderer_worker/scene_state/write_scene_state.h"
#include "renderer_worker/service/handlers.h"
#include "room/validation/validate.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {
namespace {

// A library, what stands in for it, and the two together.
class LibraryFurniture final : public FurnishingSource {
 public:
  explicit LibraryFurniture(std::unique_ptr<AssetLibrary> library)
      : library_(std::move(library)), assets_(*library_, procedural_) {}

  Furnishing FurnishingOf(const v1::Object& object, const v1::ObjectStyle* style,
                          std::vector<v1::Diagnostic>& diagnostics) const override {
    return assets_.FurnishingOf(object, style, diagnostics);
  }

 private:
  const std::unique_ptr<AssetLibrary> library_;
  const ProceduralFurniture procedural_;
  const AssetFurniture assets_;
};

// Of the manifest's bytes: another manifest, another picture.
std::string RevisionOf(const std::filesystem::path& folder) {
  for (const char* name : {"manifest.json", "annotations.json"}) {
    std::ifstream file(folder / name, std::ios::binary);
    if (!file) continue;
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    return "assets " + runtime::Sha256Hex(bytes).substr(0, 16);
  }
  return "";
}

// Raise whenever equal requests would give another scene.
constexpr char kGlbVersion[] = "2";
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

absl::StatusOr<FurnishingChoice> ChooseFurnishing(const std::string& asset_folder) {
  if (asset_folder.empty()) return FurnishingChoice{std::make_unique<ProceduralFurniture>(), "", {}};
  absl::StatusOr<std::unique_ptr<AssetLibrary>> library = AssetLibrary::Open(asset_folder);
  if (!library.ok()) {
    return absl::Status(library.status().code(),
                        fmt::format("folder of assets: {}", std::string(library.status().message())));
  }
  std::vector<v1::Diagnostic> diagnostics = (*library)->manifest().diagnostics;
  return FurnishingChoice{std::make_unique<LibraryFurniture>(*std::move(library)), RevisionOf(asset_folder),
                          std::move(diagnostics)};
}

absl::StatusOr<v1::ExportSceneResponse> ExportSceneHandler::Handle(const v1::ExportSceneRequest& request,
                                                                   runtime::CallContext& call) const {
  RETURN_IF_ERROR(Validate(request));
  ASSIGN_OR_RETURN(const Scene scene, BuildScene(request.solved_layout(), furnishing_));
  RETURN_IF_ERROR(call.CheckAlive());
  const bool is_glb = request.format() == v1::SCENE_FORMAT_GLB;
  ASSIGN_OR_RETURN(std::string file, is_glb ? WriteGlb(scene, MetadataOf(request, build_)) : WriteSceneState(scene));
  if (file.size() > static_cast<uint64_t>(answer_bytes_)) {
    return ResourceExhausted(
        "the scene's file takes {} MiB, and this renderer sends messages of {} MiB "
        "(runtime.max_message_mib)",
        file.size() >> 20, answer_bytes_ >> 20);
  }
  v1::ExportSceneResponse response;
  response.set_scene(std::move(file));
  for (const v1::Diagnostic& diagnostic : scene.diagnostics) *response.add_diagnostics() = diagnostic;
  response.mutable_producer()->set_program("flair-renderer");
  response.mutable_producer()->set_method(is_glb ? "glb" : "scene_state");
  response.mutable_producer()->set_version(is_glb ? kGlbVersion : kSceneStateVersion);
  return response;
}

SceneFiles OurSceneFiles() {
  return {.choose_furnishing = ChooseFurnishing,
          .make_exporter = [](const FurnishingSource& furnishing, const std::string& build, int64_t answer_bytes) {
            return SceneExporter([handler = ExportSceneHandler(furnishing, build, answer_bytes)](
                                     const v1::ExportSceneRequest& request, runtime::CallContext& call) {
              return handler.Handle(request, call);
            });
          }};
}

}  // namespace flair::renderer
