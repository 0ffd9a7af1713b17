// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/session/pictures.h"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "cli/input/artifact_file.h"
#include "cli/input/job_options.h"
#include "cli/output/artifact_text.h"
#include "cli/output/output_folder.h"
#include "cli/output/report_text.h"
#include "cli/output/solve_text.h"
#include "cli/output/text.h"
#include "cli/progress/progress.h"
#include "fmt/format.h"
#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/solve_layout.h"
#include "orchestrator/store/artifact_id.h"
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

std::vector<v1::SolvedLayout> VariantLayouts(const v1::SolvedLayout& layout, const v1::SolveOptions& options) {
  std::vector<v1::SolvedLayout> layouts = {layout};
  const optimizer::NloptSolver solver;
  for (int i = 0; i < layout.runner_ups_size(); ++i) {
    if (!IsComplete(layout.runner_ups(i))) continue;
    v1::SolvedLayout& variant = layouts.emplace_back(VariantOf(layout, i));
    v1::EvaluateRequest evaluate;
    *evaluate.mutable_layout_graph() = variant.graph();
    *evaluate.mutable_placements() = variant.placements();
    *evaluate.mutable_options() = options;
    const absl::StatusOr<v1::EvaluateResponse> terms = optimizer::EvaluateLayout(evaluate, solver);
    // Another optimizer's library may be unknown here.
    if (!terms.ok()) continue;
    *variant.mutable_term_outcomes() = terms->term_outcomes();
    double total = 0;
    for (const v1::EdgeOutcome& edge : variant.edge_outcomes()) total += edge.weighted_cost();
    for (const v1::TermOutcome& term : variant.term_outcomes()) total += term.cost() * term.factor();
    variant.set_total_cost(total);
  }
  return layouts;
}

std::string VariantPath(const std::string& out, int number) {
  if (number == 1) return out;
  const std::filesystem::path path(out);
  return (path.parent_path() / fmt::format("{}-{}{}", path.stem().string(), number, path.extension().string()))
      .string();
}

std::string FewerVariants(size_t found, int wanted) {
  return fmt::format("{} of {} layouts: no more were found that differ visibly; more --restarts may find some", found,
                     wanted);
}

absl::StatusOr<std::vector<OutputFile>> MakeVariantFiles(const v1::Artifact& layout, const v1::SolveOptions& options,
                                                         const RendererChoice& renderer) {
  const std::vector<v1::SolvedLayout> layouts = VariantLayouts(layout.solved_layout(), options);
  v1::ContactSheetOptions sheet;
  sheet.set_request_id("flair-variants");
  sheet.set_title(Shortened(layout.solved_layout().graph().room().title(), 200));
  sheet.set_tile_count(static_cast<int>(layouts.size()));
  sheet.set_format(v1::PREVIEW_FORMAT_PNG);
  ASSIGN_OR_RETURN(const std::unique_ptr<RendererClient> client, RendererClient::Open(renderer));
  const std::unique_ptr<ContactSheetCall> call = client->ComposeContactSheet(sheet);
  std::vector<OutputFile> files;
  for (size_t i = 0; i < layouts.size(); ++i) {
    const std::string name = VariantPath("layout.pb", static_cast<int>(i) + 1);
    v1::ContactSheetTile tile;
    tile.set_caption(name);
    tile.set_remark(LayoutLine(layouts[i]));
    *tile.mutable_solved_layout() = layouts[i];
    call->Add(std::move(tile));
    if (i == 0) continue;
    v1::Artifact artifact = layout;
    *artifact.mutable_solved_layout() = layouts[i];
    artifact.set_id(orchestrator::ComputeArtifactId(artifact));
    files.push_back({name, ArtifactBytes(artifact)});
  }
  ASSIGN_OR_RETURN(v1::ComposeContactSheetResponse response, call->Finish());
  files.push_back({kVariantsPicture, std::move(*response.mutable_sheet()->mutable_image())});
  return files;
}

}  // namespace flair::cli
