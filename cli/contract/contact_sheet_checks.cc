// SPDX-License-Identifier: GPL-3.0-or-later
// Renderer: many pictures on one sheet, of those who claim it.
#include <grpcpp/client_context.h>

#include "absl/time/clock.h"
#include "cli/contract/ask.h"
#include "cli/contract/bedroom.h"
#include "flair/v1/renderer_service.grpc.pb.h"
#include "worker_runtime/grpc/client_call.h"

namespace flair::contract {
namespace {

v1::ContactSheetTile LayoutTile() {
  v1::ContactSheetTile tile;
  tile.set_caption("bedroom");
  *tile.mutable_solved_layout() = BedroomLayout();
  return tile;
}

v1::ContactSheetTile ImageTile(const std::string& bytes) {
  v1::ContactSheetTile tile;
  tile.set_caption("image");
  tile.set_image(bytes);
  return tile;
}

// Sends the options and the tiles, and waits for the answer.
absl::StatusOr<v1::ComposeContactSheetResponse> Compose(const Target& target, int tile_count,
                                                        const std::vector<v1::ContactSheetTile>& tiles) {
  const auto stub = v1::RendererService::NewStub(target.channel());
  grpc::ClientContext context;
  context.set_deadline(absl::ToChronoTime(absl::Now() + target.options().patience));
  v1::ComposeContactSheetResponse response;
  const auto writer = stub->ComposeContactSheet(&context, &response);
  v1::ComposeContactSheetRequest request;
  request.mutable_options()->set_tile_count(tile_count);
  request.mutable_options()->set_tile_px(96);
  bool open = writer->Write(request);
  for (const v1::ContactSheetTile& tile : tiles) {
    *request.mutable_tile() = tile;
    if (open) open = writer->Write(request);
  }
  writer->WritesDone();
  const grpc::Status status = writer->Finish();
  if (!status.ok()) return runtime::FromGrpcStatus(status);
  return response;
}

Finding ComposesTiles(Target& target) {
  const std::string sent = "ComposeContactSheet of a layout and a PNG";
  v1::RenderRequest request;
  *request.mutable_solved_layout() = BedroomLayout();
  return Given<v1::RenderResponse>(target, "Render of a plan", request, [&](const v1::RenderResponse& picture) {
    const auto answer = Compose(target, 2, {LayoutTile(), ImageTile(picture.preview().image())});
    if (!answer.ok()) return Broken(sent, StatusText(answer.status()), "one PNG");
    if (answer->sheet().image().starts_with("\x89PNG") && answer->diagnostics().empty()) return Kept();
    return Broken(sent,
                  fmt::format("an image of {} bytes and {} diagnostics", answer->sheet().image().size(),
                              answer->diagnostics_size()),
                  "one PNG and no diagnostics");
  });
}

Finding BrokenTilesAreTold(Target& target) {
  const std::string sent = "ComposeContactSheet of a layout and of an image that is none";
  const auto answer = Compose(target, 2, {ImageTile("no picture"), LayoutTile()});
  const std::string right = "the sheet, with one diagnostic that names the caption \"image\"";
  if (!answer.ok()) return Broken(sent, StatusText(answer.status()), right);
  if (answer->diagnostics_size() == 1 && answer->diagnostics(0).message().find("image") != std::string::npos) {
    return Kept();
  }
  return Broken(sent, fmt::format("{} diagnostics", answer->diagnostics_size()), right);
}

Finding WrongCountsAreRefused(Target& target) {
  struct Row {
    int promised;
    std::vector<v1::ContactSheetTile> tiles;
  };
  for (const Row& row : {Row{1, {LayoutTile(), LayoutTile()}}, Row{2, {LayoutTile()}}, Row{0, {}}}) {
    const absl::Status status = Compose(target, row.promised, row.tiles).status();
    if (absl::IsInvalidArgument(status)) continue;
    return Broken(fmt::format("ComposeContactSheet with tile_count {} and {} tiles", row.promised, row.tiles.size()),
                  status.ok() ? "OK, with a sheet" : StatusText(status), "INVALID_ARGUMENT");
  }
  return Kept();
}

}  // namespace

void AddContactSheetChecks(Checks& checks) {
  checks.push_back(
      {"Layouts and pictures become one sheet", Promise::kMessages, ComposesTiles, v1::CAPABILITY_CONTACT_SHEET});
  checks.push_back({"A tile that cannot be drawn is told of, and the sheet comes", Promise::kMessages,
                    BrokenTilesAreTold, v1::CAPABILITY_CONTACT_SHEET});
  checks.push_back({"Too many, too few and no tiles are refused", Promise::kErrors, WrongCountsAreRefused,
                    v1::CAPABILITY_CONTACT_SHEET});
}

}  // namespace flair::contract
