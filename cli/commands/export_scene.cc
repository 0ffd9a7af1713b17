// SPDX-License-Identifier: GPL-3.0-or-later
// flair export scene and flair export sceneeval: a furnished room in three dimensions.
#include <cstdio>
#include <filesystem>
#include <memory>

#include "absl/strings/ascii.h"
#include "cli/commands/commands.h"
#include "cli/exit_code.h"
#include "cli/input/artifact_file.h"
#include "cli/output/output_folder.h"
#include "cli/progress/progress.h"
#include "cli/session/stage_calls.h"
#include "fmt/format.h"
#include "renderer_worker/scene/scene.h"
#include "renderer_worker/scene_state/write_scene_state.h"
#include "renderer_worker/service/make_renderer_service.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

struct ExportArguments : Options {
  using Options::Options;
  std::string& layout = Required("LAYOUT", "A layout: layout.pb or layout.json of a design");
  std::string& out = Required("-o,--out FILE", "Where the scene goes");
  RendererFlags renderer{command()};
};
struct ExportGlbArguments : ExportArguments {
  using ExportArguments::ExportArguments;
  std::string& format = Text("--format FORMAT", "Format: glb, which is binary glTF 2.0 (glb)");
};
struct ExportSceneStateArguments : ExportArguments {
  using ExportArguments::ExportArguments;
  std::string& meshes =
      Text("--meshes DIR", "Write the models that the JSON names there too, as ID/ID.glb and ID/data.json");
};

absl::Status ExportScene(const ExportArguments& arguments, v1::SceneFormat format) {
  ASSIGN_OR_RETURN(const LayoutFile layout, ReadLayoutFile(arguments.layout));
  RETURN_IF_ERROR(CheckOutputFile(arguments.out));
  v1::ExportSceneRequest request;
  request.set_request_id("flair-export");
  request.set_format(format);
  SetOrigin(layout, request);
  ASSIGN_OR_RETURN(std::unique_ptr<RendererClient> renderer, RendererClient::Open(arguments.renderer));
  ASSIGN_OR_RETURN(const v1::ExportSceneResponse response, [&] {
    const SlowNote note("building the scene");
    return renderer->ExportScene(request);
  }());
  RETURN_IF_ERROR(WriteOutputFile(arguments.out, response.scene()));
  for (const v1::Diagnostic& diagnostic : response.diagnostics()) fmt::print(stderr, "{}\n", diagnostic.message());
  fmt::print(stderr, "{}: {}, {} KiB\n", arguments.out,
             Counted(layout.artifact.solved_layout().placements_size(), "object"),
             (response.scene().size() + 1023) / 1024);
  return absl::OkStatus();
}

// The models that the JSON names, made in this process.
absl::Status WriteMeshes(const ExportSceneStateArguments& arguments) {
  if (arguments.meshes.empty()) return absl::OkStatus();
  ASSIGN_OR_RETURN(const LayoutFile layout, ReadLayoutFile(arguments.layout));
  ASSIGN_OR_RETURN(const renderer::FurnishingChoice furnishing,
                   renderer::ChooseFurnishing(arguments.renderer.asset_folder));
  ASSIGN_OR_RETURN(const renderer::Scene scene,
                   renderer::BuildScene(layout.artifact.solved_layout(), *furnishing.source));
  ASSIGN_OR_RETURN(const std::vector<renderer::SceneStateFile> files, renderer::SceneStateAssets(scene));
  for (const renderer::SceneStateFile& file : files) {
    RETURN_IF_ERROR(WriteOutputFile(std::filesystem::path(arguments.meshes) / file.path, file.bytes));
  }
  fmt::print(stderr, "{}: {}\n", arguments.meshes, Counted(std::ssize(files), "file"));
  return absl::OkStatus();
}

absl::Status ExportSceneState(const ExportSceneStateArguments& arguments) {
  RETURN_IF_ERROR(ExportScene(arguments, v1::SCENE_FORMAT_SCENE_STATE));
  return WriteMeshes(arguments);
}

absl::Status ExportGlb(const ExportGlbArguments& arguments) {
  if (!arguments.format.empty() && arguments.format != "glb") {
    return absl::InvalidArgumentError(fmt::format(
        "--format: {}: is not a scene format; expected glb (for SceneEval: flair export sceneeval)", arguments.format));
  }
  std::string ending = std::filesystem::path(arguments.out).extension().string();
  absl::AsciiStrToLower(&ending);
  if (!ending.empty() && ending != ".glb") {
    return absl::InvalidArgumentError(
        fmt::format("--out: {}: scenes are written as .glb (binary glTF 2.0); Blender turns that into USD, FBX or OBJ",
                    arguments.out));
  }
  return ExportScene(arguments, v1::SCENE_FORMAT_GLB);
}

}  // namespace

void AddExport(const Commands& program) {
  const Commands exports = program.Group("export", "Export layouts as 3D scenes, for other programs.");
  exports.Add("scene", "Export the furnished room as a 3D scene, for Blender, Unity, Unreal and browsers.", ExportGlb);
  exports.Add("sceneeval", "Export SceneState JSON for the benchmark SceneEval.", ExportSceneState);
}

}  // namespace flair::cli
