// SPDX-License-Identifier: GPL-3.0-or-later
// flair contact-sheet: many designs on one picture.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "CLI/CLI.hpp"
#include "cli/commands/commands.h"
#include "cli/exit_code.h"
#include "cli/input/artifact_file.h"
#include "cli/input/design_folders.h"
#include "cli/input/files.h"
#include "cli/input/layout_file.h"
#include "cli/input/render_flags.h"
#include "cli/input/value_checks.h"
#include "cli/output/output_folder.h"
#include "cli/output/printable.h"
#include "cli/progress/slow_note.h"
#include "cli/session/renderer_client.h"
#include "fmt/format.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMostTiles = 10000;
// As much as a renderer takes in one message, with some room for the rest of it.
constexpr uintmax_t kLargestPictureBytes = uintmax_t{31} << 20;
constexpr int kQuickSampleCount = 8;

struct ContactSheetArguments {
  std::string folder;
  std::string out;
  std::string title;
  std::string view = "plan";
  std::string picture;
  std::optional<int> tile_px;
  RendererChoice renderer;
};

// "45 of 50 constraints hold, OOB 0.00 %, OOR 0.00 %, 3 zones".
std::string Metrics(const v1::SolvedLayout& layout) {
  int held = 0;
  for (const v1::EdgeOutcome& outcome : layout.edge_outcomes())
    held += outcome.status() == v1::OUTCOME_STATUS_SATISFIED ? 1 : 0;
  std::string text;
  if (layout.edge_outcomes_size() > 0)
    text =
        fmt::format("{} of {}, ", held, Counted(layout.edge_outcomes_size(), "constraint holds", "constraints hold"));
  return text + fmt::format("OOB {:.2f} %, OOR {:.2f} %, {}", layout.metrics().oob_percent(),
                            layout.metrics().oor_percent(), Counted(layout.graph().zone_plan().zones_size(), "zone"));
}

// Leaves room for the metrics.
std::string RemarkOf(const std::string& title) {
  constexpr size_t kMost = 49;
  std::string remark = Shortened(title, kMost);
  while (remark.ends_with('.')) remark.pop_back();
  return remark;
}

class Sheet {
 public:
  Sheet(const ContactSheetArguments& arguments, RendererClient& renderer, v1::PreviewView view)
      : arguments_(arguments), renderer_(renderer), view_(view) {}

  v1::ContactSheetTile TileOf(const fs::path& folder) const {
    v1::ContactSheetTile tile;
    std::string name = folder.lexically_relative(arguments_.folder).string();
    if (name == ".") name = fs::absolute(folder).lexically_normal().filename().string();
    absl::StatusOr<LayoutFile> layout = ReadLayout(folder / "layout.pb");
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

 private:
  // The layout alone: where its brief lies does not matter here.
  static absl::StatusOr<LayoutFile> ReadLayout(const fs::path& path) {
    absl::StatusOr<v1::Artifact> artifact = ReadArtifact(path);
    if (!artifact.ok()) return artifact.status();
    if (!artifact->has_solved_layout()) return absl::InvalidArgumentError(path.string() + ": not a layout");
    return LayoutFile{.artifact = *std::move(artifact), .brief = {}};
  }

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
    absl::StatusOr<v1::RenderResponse> response = renderer_.Render(request);
    if (!response.ok()) return response.status();
    tile.set_image(std::move(*response->mutable_preview()->mutable_image()));
    return absl::OkStatus();
  }

  static absl::Status FillFromFile(const fs::path& path, v1::ContactSheetTile& tile) {
    std::error_code error;
    const uintmax_t size = fs::file_size(path, error);
    if (!error && size > kLargestPictureBytes) {
      return absl::InvalidArgumentError(
          fmt::format("{} has {} MiB; at most {}", path.filename().string(), size >> 20, kLargestPictureBytes >> 20));
    }
    absl::StatusOr<std::string> bytes = ReadFile(path);
    if (!bytes.ok()) return bytes.status();
    tile.set_image(*std::move(bytes));
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
    return absl::InvalidArgumentError(
        fmt::format("--out: {}: its ending says the format: png, jpg, jpeg, tif, tiff", arguments.out));
  }
  options.set_format(*format);
  return options;
}

absl::Status MakeContactSheet(const ContactSheetArguments& arguments) {
  const absl::StatusOr<v1::PreviewView> view = ViewOfName(arguments.view);
  if (!view.ok()) return view.status();
  if (absl::Status status = MakeOptions(arguments, 1).status(); !status.ok()) return status;
  const absl::StatusOr<std::vector<fs::path>> designs =
      FindFoldersWith(arguments.folder, arguments.picture.empty() ? "layout.pb" : arguments.picture, kMostTiles);
  if (!designs.ok()) return designs.status();
  if (absl::Status status = CheckOutputFile(arguments.out); !status.ok()) return status;
  absl::StatusOr<std::unique_ptr<RendererClient>> renderer = RendererClient::Open(arguments.renderer);
  if (!renderer.ok()) return renderer.status();
  const Sheet sheet(arguments, **renderer, *view);
  absl::StatusOr<v1::ComposeContactSheetResponse> response;
  {
    SlowNote note("drawing");
    const std::unique_ptr<ContactSheetCall> call =
        (*renderer)->ComposeContactSheet(*MakeOptions(arguments, designs->size()));
    for (size_t i = 0; i < designs->size(); ++i) {
      note.Set(fmt::format("tile {} of {}", i + 1, designs->size()));
      if (!call->Add(sheet.TileOf((*designs)[i]))) break;
    }
    response = call->Finish();
  }
  if (!response.ok()) return response.status();
  if (absl::Status status = WriteOutputFile(arguments.out, response->sheet().image()); !status.ok()) return status;
  for (const v1::Diagnostic& diagnostic : response->diagnostics()) fmt::print(stderr, "{}\n", diagnostic.message());
  fmt::print(stderr, "{}: {}, {} x {} px\n", arguments.out, Counted(std::ssize(*designs), "tile"),
             response->sheet().width_px(), response->sheet().height_px());
  return absl::OkStatus();
}

}  // namespace

void AddContactSheet(CLI::App& program, absl::Status& result) {
  auto arguments = std::make_shared<ContactSheetArguments>();
  CLI::App* command = program.add_subcommand("contact-sheet", "Put the designs of a folder on one picture.");
  command->add_option("DIR", arguments->folder, "Folder of designs, at any depth: of folders that hold a layout.pb")
      ->required();
  command->add_option("-o,--out", arguments->out, "Where the sheet goes: png, jpg or tif")
      ->required()
      ->type_name("FILE");
  command->add_option("--title", arguments->title, "Its heading")->type_name("TEXT");
  command->add_option("--tile", arguments->tile_px, "Width of a tile, 64 to 1024 (480, or what fits 8192 px)")
      ->type_name("PX")
      ->check(WholeNumber(64, 1024));
  CLI::Option* picture =
      command
          ->add_option("--picture", arguments->picture,
                       "Show this file (PNG, JPEG, TIFF) of every folder that has one, such as plan.png")
          ->type_name("NAME");
  command->add_option("--view", arguments->view, "Draw layouts as plan, birdseye or perspective (plan)")
      ->type_name("VIEW")
      ->excludes(picture);
  AddRendererFlags(*command, arguments->renderer);
  command->footer(
      "Below each tile: its folder and room, constraints that hold, furniture out of bounds (OOB) and "
      "overlapping (OOR) in percent of the room, zones. What cannot be drawn shows why in its place.");
  command->callback([arguments, &result] { result = MakeContactSheet(*arguments); });
}

}  // namespace flair::cli
