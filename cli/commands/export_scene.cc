// SPDX-License-Identifier: GPL-3.0-or-later
// flair export scene and flair export sceneeval: a furnished room in three dimensions.
#include <cstdio>
#include <filesystem>
#include <memory>

#include "CLI/CLI.hpp"
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
#include "renderer_worker/service/furnishing_choice.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

struct ExportSceneArguments {
  std::string layout;
  std::string out;
  std::string format = "glb";
  std::string meshes;
  RendererChoice renderer;
};

absl::Status ExportScene(const ExportSceneArguments& arguments, v1::SceneFormat format) {
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
absl::Status WriteMeshes(const ExportSceneArguments& arguments) {
  if (arguments.meshes.empty()) return absl::OkStatus();
  ASSIGN_OR_RETURN(const LayoutFile layout, ReadLayoutFile(arguments.layout));
  const absl::StatusOr<renderer::FurnishingChoice> furnishing =
      renderer::ChooseFurnishing(arguments.renderer.asset_folder);
  if (!furnishing.ok()) return furnishing.status();
  const absl::StatusOr<renderer::Scene> scene =
      renderer::BuildScene(layout.artifact.solved_layout(), *furnishing->source);
  if (!scene.ok()) return scene.status();
  ASSIGN_OR_RETURN(const std::vector<renderer::SceneStateFile> files, renderer::SceneStateAssets(*scene));
  for (const renderer::SceneStateFile& file : files) {
    RETURN_IF_ERROR(WriteOutputFile(std::filesystem::path(arguments.meshes) / file.path, file.bytes));
  }
  fmt::print(stderr, "{}: {}\n", arguments.meshes, Counted(std::ssize(files), "file"));
  return absl::OkStatus();
}

absl::Status ExportSceneState(const ExportSceneArguments& arguments) {
  RETURN_IF_ERROR(ExportScene(arguments, v1::SCENE_FORMAT_SCENE_STATE));
  return WriteMeshes(arguments);
}

absl::Status ExportGlb(const ExportSceneArguments& arguments) {
  if (arguments.format != "glb") {
    return absl::InvalidArgumentError(fmt::format(
        "--format: {}: is no format of scenes; glb (for SceneEval: flair export sceneeval)", arguments.format));
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

void AddExport(CLI::App& program, absl::Status& result) {
  CLI::App* const exports = program.add_subcommand("export", "Layouts as 3D scenes, for other programs.");
  exports->require_subcommand(1);
  auto scene = std::make_shared<ExportSceneArguments>();
  CLI::App* command = exports->add_subcommand(
      "scene", "The furnished room in three dimensions, for Blender, Unity, Unreal and browsers.");
  command->add_option("LAYOUT", scene->layout, "A layout: layout.pb or layout.json of a design")->required();
  command->add_option("-o,--out", scene->out, "Where the scene goes")->required()->type_name("FILE");
  command->add_option("--format", scene->format, "How: glb, which is binary glTF 2.0 (glb)")->type_name("FORMAT");
  AddRendererFlags(*command, scene->renderer);
  command->callback([scene, &result] { result = ExportGlb(*scene); });

  auto state = std::make_shared<ExportSceneArguments>();
  command = exports->add_subcommand("sceneeval", "SceneState JSON, as the benchmark SceneEval reads it.");
  command->add_option("LAYOUT", state->layout, "A layout: layout.pb or layout.json of a design")->required();
  command->add_option("-o,--out", state->out, "Where the .json goes")->required()->type_name("FILE");
  command
      ->add_option("--meshes", state->meshes,
                   "Write the models that the JSON names there too, as ID/ID.glb and ID/data.json")
      ->type_name("DIR");
  AddRendererFlags(*command, state->renderer);
  command->callback([state, &result] { result = ExportSceneState(*state); });
}

}  // namespace flair::cli
