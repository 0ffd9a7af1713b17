// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/session/plans_beside.h"

#include <cstdio>
#include <memory>

#include "cli/input/render_flags.h"
#include "cli/output/output_folder.h"
#include "cli/progress/slow_note.h"
#include "fmt/format.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

constexpr int kDefaultSizePx = 2400;
constexpr size_t kMostLetters = 190;

bool IsDocument(v1::PreviewFormat format) {
  return format == v1::PREVIEW_FORMAT_SVG || format == v1::PREVIEW_FORMAT_PDF;
}

// What the contract takes for a caption: the end of a long path says more than its beginning.
std::string Shortened(const std::string& text) {
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
  if (absl::Status status = CheckPicture(plans); !status.ok()) return status;
  v1::RenderRequest request;
  request.set_request_id("flair-beside");
  const PlanBeside& first = plans.plans.front();
  *request.mutable_solved_layout() = first.layout;
  request.set_caption(Shortened(first.caption));
  request.set_remark(Shortened(first.remark));
  for (size_t i = 1; i < plans.plans.size(); ++i) {
    const PlanBeside& plan = plans.plans[i];
    v1::ComparedLayout& beside = *request.add_beside();
    *beside.mutable_solved_layout() = plan.layout;
    beside.set_caption(Shortened(plan.caption));
    beside.set_remark(Shortened(plan.remark));
    beside.mutable_changes()->Add(plan.changes.begin(), plan.changes.end());
  }
  request.mutable_options()->set_format(*FormatOfFile(plans.picture));
  if (!IsDocument(request.options().format())) {
    request.mutable_options()->set_size_px(plans.size_px.value_or(kDefaultSizePx));
  }
  absl::StatusOr<std::unique_ptr<RendererClient>> renderer = RendererClient::Open(plans.renderer);
  if (!renderer.ok()) return renderer.status();
  const absl::StatusOr<v1::RenderResponse> response = [&] {
    const SlowNote note("drawing");
    return (*renderer)->Render(request);
  }();
  if (!response.ok()) return response.status();
  if (absl::Status status = WriteOutputFile(plans.picture, response->preview().image()); !status.ok()) return status;
  for (const v1::Diagnostic& diagnostic : response->diagnostics()) fmt::print(stderr, "{}\n", diagnostic.message());
  fmt::print(stderr, "{}: {}\n", plans.picture, Counted(std::ssize(plans.plans), "plan"));
  return absl::OkStatus();
}

}  // namespace flair::cli
