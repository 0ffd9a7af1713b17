// SPDX-License-Identifier: GPL-3.0-or-later
// flair contact-sheet: many designs on one picture.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

#include "absl/strings/ascii.h"
#include "cli/commands/commands.h"
#include "cli/input/artifact_file.h"
#include "cli/input/job_options.h"
#include "cli/output/output_folder.h"
#include "cli/output/report_text.h"
#include "cli/output/text.h"
#include "cli/progress/progress.h"
#include "cli/session/stage_calls.h"
#include "fmt/format.h"
#include "renderer_worker/scene/scene.h"
#include "renderer_worker/scene_state/write_scene_state.h"
#include "renderer_worker/service/handlers.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMostTiles = 10000;
// As much as a renderer takes in one message, with some room for the rest of it.
constexpr uintmax_t kLargestPictureBytes = uintmax_t{31} << 20;
constexpr int kQuickSampleCount = 8;

struct ContactSheetArguments : Options {
  using Options::Options;
  std::string& folder = Required("DIR", "Folder of designs, at any depth: of folders that hold a layout.pb");
  std::string& out = Required("-o,--out FILE", "Where the sheet goes: png, jpg or tif");
  std::string& title = Text("--title TEXT", "Its heading");
  std::optional<int>& tile_px = Whole("--tile PX", 64, 1024, "Width of a tile, 64 to 1024 (480, or what fits 8192 px)");
  std::string& picture =
      Text("--picture NAME", "Show this file (PNG, JPEG, TIFF) of every folder that has one, such as plan.png");
  std::string& view = Text("--view VIEW", "Draw layouts as plan, birdseye or perspective (plan)", {"--picture"});
  bool& variants = Flag("--variants", "Also show the variants of each layout, best first", {"--picture"});
  RendererFlags renderer{command()};
};

// "45 of 50 constraints hold, OOB 0.00 %, OOR 0.00 %, 3 zones".
std::string Metrics(const v1::SolvedLayout& layout) {
  return fmt::format("{}, {}", LayoutLine(layout), Counted(layout.graph().zone_plan().zones_size(), "zone"));
}

// Leaves room for the metrics.
std::string RemarkOf(const std::string& title) {
  constexpr size_t kMost = 49;
  std::string remark = Shortened(title, kMost);
  while (remark.ends_with('.')) remark.pop_back();
  return remark;
}

// What one tile shows: the layout of a folder, or one of its runner-ups.
struct TileSource {
  fs::path folder;
  int runner_up = -1;
};

class Sheet {
 public:
  Sheet(const ContactSheetArguments& arguments, RendererClient& renderer, v1::PreviewView view)
      : arguments_(arguments), renderer_(renderer), view_(view) {}

  v1::ContactSheetTile TileOf(const TileSource& source) const {
    const fs::path& folder = source.folder;
    v1::ContactSheetTile tile;
    std::string name = folder.lexically_relative(arguments_.folder).string();
    if (name == ".") name = fs::absolute(folder).lexically_normal().filename().string();
    absl::StatusOr<LayoutFile> layout = ReadLayout(folder / "layout.pb");
    if (layout.ok() && source.runner_up >= 0) {
      v1::SolvedLayout& best = *layout->artifact.mutable_solved_layout();
      v1::SolvedLayout variant = VariantOf(best, source.runner_up);
      best = std::move(variant);
      name += fmt::format(", variant {}", source.runner_up + 2);
    }
    if (layout.ok()) {
      const v1::SolvedLayout& solved = layout->artifact.solved_layout();
      const std::string& title = solved.graph().room().title();
      tile.set_remark(title.empty() ? Metrics(solved) : RemarkOf(title) + ". " + Metrics(solved));
    }
    tile.set_caption(Shortened(name, 200));
    const absl::Status filled = Fill(folder, layout, tile);
    if (!filled.ok()) {
      tile.clear_picture();
      tile.set_remark(Shortened(std::string(filled.message()), 400));
    }
    return tile;
  }

  // The layout alone: where its brief lies does not matter here.
  static absl::StatusOr<LayoutFile> ReadLayout(const fs::path& path) {
    ASSIGN_OR_RETURN(v1::Artifact artifact, ReadArtifact(path));
    if (!artifact.has_solved_layout()) return absl::InvalidArgumentError(path.string() + ": not a layout");
    return LayoutFile{.artifact = std::move(artifact), .brief = {}};
  }

 private:
  absl::Status Fill(const fs::path& folder, absl::StatusOr<LayoutFile>& layout, v1::ContactSheetTile& tile) const {
    if (!arguments_.picture.empty()) return FillFromFile(folder / arguments_.picture, tile);
    if (!layout.ok()) return layout.status();
    if (view_ == v1::PREVIEW_VIEW_PLAN) {
      *tile.mutable_solved_layout() = std::move(*layout->artifact.mutable_solved_layout());
      return absl::OkStatus();
    }
    v1::RenderRequest request;
    SetOrigin(*layout, request);
    v1::RenderOptions& options = *request.mutable_options();
    options.set_view(view_);
    options.set_size_px(std::clamp(arguments_.tile_px.value_or(480), 256, 1024));
    options.set_sample_count(kQuickSampleCount);
    ASSIGN_OR_RETURN(v1::RenderResponse response, renderer_.Render(request));
    tile.set_image(std::move(*response.mutable_preview()->mutable_image()));
    return absl::OkStatus();
  }

  static absl::Status FillFromFile(const fs::path& path, v1::ContactSheetTile& tile) {
    std::error_code error;
    const uintmax_t size = fs::file_size(path, error);
    if (!error && size > kLargestPictureBytes) {
      return InvalidArgument("{} has {} MiB; at most {}", path.filename().string(), size >> 20,
                             kLargestPictureBytes >> 20);
    }
    ASSIGN_OR_RETURN(std::string bytes, ReadFile(path));
    tile.set_image(std::move(bytes));
    return absl::OkStatus();
  }

  const ContactSheetArguments& arguments_;
  RendererClient& renderer_;
  const v1::PreviewView view_;
};

absl::StatusOr<v1::ContactSheetOptions> MakeOptions(const ContactSheetArguments& arguments, size_t count) {
  v1::ContactSheetOptions options;
  options.set_request_id("flair-contact-sheet");
  options.set_title(Shortened(arguments.title, 200));
  options.set_tile_count(static_cast<int>(count));
  if (arguments.tile_px) options.set_tile_px(*arguments.tile_px);
  const absl::StatusOr<v1::PreviewFormat> format = FormatOfFile(arguments.out);
  if (!format.ok() || *format == v1::PREVIEW_FORMAT_EXR || *format == v1::PREVIEW_FORMAT_SVG ||
      *format == v1::PREVIEW_FORMAT_PDF) {
    return InvalidArgument("--out: {}: its extension chooses the format: png, jpg, jpeg, tif, tiff", arguments.out);
  }
  options.set_format(*format);
  return options;
}

// With `variants`, the complete runner-ups of each layout behind it, as many as a picture holds beside the layouts.
std::vector<TileSource> SourcesOf(const std::vector<fs::path>& folders, bool variants) {
  std::vector<TileSource> sources;
  size_t room = kMostTiles - std::min(kMostTiles, folders.size());
  for (const fs::path& folder : folders) {
    sources.push_back({folder});
    const absl::StatusOr<LayoutFile> layout =
        variants ? Sheet::ReadLayout(folder / "layout.pb") : absl::NotFoundError("");
    if (!layout.ok()) continue;
    const v1::SolvedLayout& solved = layout->artifact.solved_layout();
    for (int i = 0; i < solved.runner_ups_size() && room > 0; ++i) {
      if (!IsComplete(solved.runner_ups(i))) continue;
      sources.push_back({folder, i});
      --room;
    }
  }
  return sources;
}

absl::Status MakeContactSheet(const ContactSheetArguments& arguments) {
  ASSIGN_OR_RETURN(const v1::PreviewView view, ViewOfName(arguments.view.empty() ? "plan" : arguments.view));
  RETURN_IF_ERROR(MakeOptions(arguments, 1).status());
  ASSIGN_OR_RETURN(
      const std::vector<fs::path> designs,
      FindFoldersWith(arguments.folder, arguments.picture.empty() ? "layout.pb" : arguments.picture, kMostTiles));
  RETURN_IF_ERROR(CheckOutputFile(arguments.out));
  ASSIGN_OR_RETURN(std::unique_ptr<RendererClient> renderer, RendererClient::Open(arguments.renderer));
  const Sheet sheet(arguments, *renderer, view);
  const std::vector<TileSource> sources = SourcesOf(designs, arguments.variants);
  ASSIGN_OR_RETURN(const v1::ContactSheetOptions options, MakeOptions(arguments, sources.size()));
  ASSIGN_OR_RETURN(const v1::ComposeContactSheetResponse response, [&] {
    SlowNote note("drawing");
    return renderer->ComposeContactSheet(options, [&](int i) {
      note.Set(fmt::format("tile {} of {}", i + 1, sources.size()));
      return sheet.TileOf(sources[static_cast<size_t>(i)]);
    });
  }());
  RETURN_IF_ERROR(WriteOutputFile(arguments.out, response.sheet().image()));
  for (const v1::Diagnostic& diagnostic : response.diagnostics()) fmt::print(stderr, "{}\n", diagnostic.message());
  fmt::print(stderr, "{}: {}, {} x {} px\n", arguments.out, Counted(std::ssize(sources), "tile"),
             response.sheet().width_px(), response.sheet().height_px());
  return absl::OkStatus();
}

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
    return InvalidArgument("--format: {}: is not a scene format; expected glb (for SceneEval: flair export sceneeval)",
                           arguments.format);
  }
  std::string ending = std::filesystem::path(arguments.out).extension().string();
  absl::AsciiStrToLower(&ending);
  if (!ending.empty() && ending != ".glb") {
    return InvalidArgument(
        "--out: {}: scenes are written as .glb (binary glTF 2.0); Blender turns that into USD, FBX or OBJ",
        arguments.out);
  }
  return ExportScene(arguments, v1::SCENE_FORMAT_GLB);
}

}  // namespace

void AddContactSheet(const Commands& program) {
  program.Add("contact-sheet", "Show all designs of a folder in one picture.", MakeContactSheet,
              "Below each tile: its folder and room, constraints that hold, furniture out of bounds (OOB) and "
              "overlapping (OOR) in percent of the room, zones. What cannot be drawn shows the reason instead.");
}

// flair export scene and flair export sceneeval: a furnished room in three dimensions.

void AddExport(const Commands& program) {
  const Commands exports = program.Group("export", "Export layouts as 3D scenes, for other programs.");
  exports.Add("scene", "Export the furnished room as a 3D scene, for Blender, Unity, Unreal and browsers.", ExportGlb);
  exports.Add("sceneeval", "Export SceneState JSON for the benchmark SceneEval.", ExportSceneState);
}

}  // namespace flair::cli
