// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/session/variants.h"

#include <filesystem>
#include <memory>

#include "cli/output/artifact_text.h"
#include "cli/output/report_text.h"
#include "cli/output/solve_text.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "optimizer_worker/solver/nlopt_solver.h"
#include "optimizer_worker/stages/solve_layout.h"
#include "orchestrator/store/artifact_id.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {

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
