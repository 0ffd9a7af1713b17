// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/session/pictures.h"

#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

#include "cli/input/artifact_file.h"
#include "cli/input/render_flags.h"
#include "cli/output/output_folder.h"
#include "cli/progress/progress.h"
#include "fmt/format.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {

namespace {

constexpr int kDefaultSizePx = 2400;
constexpr size_t kMostLetters = 190;

bool IsDocument(v1::PreviewFormat format) {
  return format == v1::PREVIEW_FORMAT_SVG || format == v1::PREVIEW_FORMAT_PDF;
}

// What the contract takes for a caption: the end of a long path says more than its beginning.
std::string EndOf(const std::string& text) {
  if (text.size() <= kMostLetters) return text;
  size_t from = text.size() - kMostLetters;
  while (from < text.size() && (static_cast<unsigned char>(text[from]) & 0xC0) == 0x80) ++from;
  return "..." + text.substr(from);
}

}  // namespace

absl::Status CheckPicture(const PlansBeside& plans) {
  const absl::StatusOr<v1::PreviewFormat> format = FormatOfFile(plans.picture);
  if (!format.ok() || *format == v1::PREVIEW_FORMAT_EXR) {
    return absl::InvalidArgumentError(
        fmt::format("--picture: {}: its ending says the format: png, jpg, jpeg, tif, tiff, svg, pdf", plans.picture));
  }
  if (IsDocument(*format) && plans.size_px.has_value()) {
    return absl::InvalidArgumentError(
        fmt::format("--size: {}: not with --picture {}, which has no pixels", *plans.size_px, plans.picture));
  }
  return CheckOutputFile(plans.picture);
}

absl::Status DrawPlansBeside(const PlansBeside& plans) {
  RETURN_IF_ERROR(CheckPicture(plans));
  v1::RenderRequest request;
  request.set_request_id("flair-beside");
  const PlanBeside& first = plans.plans.front();
  *request.mutable_solved_layout() = first.layout;
  request.set_caption(EndOf(first.caption));
  request.set_remark(EndOf(first.remark));
  for (size_t i = 1; i < plans.plans.size(); ++i) {
    const PlanBeside& plan = plans.plans[i];
    v1::ComparedLayout& beside = *request.add_beside();
    *beside.mutable_solved_layout() = plan.layout;
    beside.set_caption(EndOf(plan.caption));
    beside.set_remark(EndOf(plan.remark));
    beside.mutable_changes()->Add(plan.changes.begin(), plan.changes.end());
  }
  request.mutable_options()->set_format(*FormatOfFile(plans.picture));
  if (!IsDocument(request.options().format())) {
    request.mutable_options()->set_size_px(plans.size_px.value_or(kDefaultSizePx));
  }
  ASSIGN_OR_RETURN(std::unique_ptr<RendererClient> renderer, RendererClient::Open(plans.renderer));
  ASSIGN_OR_RETURN(const v1::RenderResponse response, [&] {
    const SlowNote note("drawing");
    return renderer->Render(request);
  }());
  RETURN_IF_ERROR(WriteOutputFile(plans.picture, response.preview().image()));
  for (const v1::Diagnostic& diagnostic : response.diagnostics()) fmt::print(stderr, "{}\n", diagnostic.message());
  fmt::print(stderr, "{}: {}\n", plans.picture, Counted(std::ssize(plans.plans), "plan"));
  return absl::OkStatus();
}

absl::Status CheckViews(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    RETURN_IF_ERROR(ViewOfName(name).status());
  }
  return absl::OkStatus();
}

absl::StatusOr<std::vector<OutputFile>> DrawViews(const std::vector<std::string>& names, const RendererChoice& choice,
                                                  const v1::Artifact& layout, const v1::Brief& brief, bool quiet) {
  std::vector<OutputFile> files;
  const LayoutFile from{.artifact = layout, .brief = brief};
  std::unique_ptr<RendererClient> renderer;
  for (const std::string& name : names) {
    ASSIGN_OR_RETURN(const v1::PreviewView view, ViewOfName(name));
    if (view == v1::PREVIEW_VIEW_PLAN) continue;
    if (renderer == nullptr) {
      ASSIGN_OR_RETURN(renderer, RendererClient::Open(choice));
    }
    v1::RenderRequest request;
    SetOrigin(from, request);
    request.mutable_options()->set_view(view);
    request.mutable_options()->set_format(v1::PREVIEW_FORMAT_PNG);
    std::optional<SlowNote> note;
    if (!quiet) note.emplace("drawing " + name);
    ASSIGN_OR_RETURN(v1::RenderResponse response, renderer->Render(request));
    files.push_back({name + ".png", std::move(*response.mutable_preview()->mutable_image())});
  }
  return files;
}

}  // namespace flair::cli
