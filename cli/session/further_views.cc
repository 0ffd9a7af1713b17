// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/session/further_views.h"

#include <memory>
#include <optional>
#include <utility>

#include "cli/input/layout_file.h"
#include "cli/input/render_flags.h"
#include "cli/progress/slow_note.h"

namespace flair::cli {

absl::Status CheckViews(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (absl::Status status = ViewOfName(name).status(); !status.ok()) return status;
  }
  return absl::OkStatus();
}

absl::StatusOr<std::vector<OutputFile>> DrawViews(const std::vector<std::string>& names, const RendererChoice& choice,
                                                  const v1::Artifact& layout, const v1::Brief& brief, bool quiet) {
  std::vector<OutputFile> files;
  const LayoutFile from{.artifact = layout, .brief = brief};
  std::unique_ptr<RendererClient> renderer;
  for (const std::string& name : names) {
    const absl::StatusOr<v1::PreviewView> view = ViewOfName(name);
    if (!view.ok()) return view.status();
    if (*view == v1::PREVIEW_VIEW_PLAN) continue;
    if (renderer == nullptr) {
      absl::StatusOr<std::unique_ptr<RendererClient>> opened = RendererClient::Open(choice);
      if (!opened.ok()) return opened.status();
      renderer = *std::move(opened);
    }
    v1::RenderRequest request;
    SetOrigin(from, request);
    request.mutable_options()->set_view(*view);
    request.mutable_options()->set_format(v1::PREVIEW_FORMAT_PNG);
    std::optional<SlowNote> note;
    if (!quiet) note.emplace("drawing " + name);
    absl::StatusOr<v1::RenderResponse> response = renderer->Render(request);
    if (!response.ok()) return response.status();
    files.push_back({name + ".png", std::move(*response->mutable_preview()->mutable_image())});
  }
  return files;
}

}  // namespace flair::cli
