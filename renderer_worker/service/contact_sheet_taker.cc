// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/service/contact_sheet_taker.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "renderer_worker/drawing/draw_plan.h"
#include "renderer_worker/images/image_files.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {
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
    return absl::ResourceExhaustedError(
        fmt::format("{} contact sheets are being drawn; try again later", kMostOpenSheets));
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
    return absl::InvalidArgumentError(
        fmt::format("tile: one more than the {} of options.tile_count", grid_.tile_count));
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
    return absl::InvalidArgumentError(
        fmt::format("options.tile_count: {} tiles were announced, {} came", grid_.tile_count, sheet_->added_count()));
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
