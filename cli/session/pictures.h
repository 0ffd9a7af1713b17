// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures that commands draw of layouts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "cli/output/output_folder.h"
#include "cli/session/stage_calls.h"
#include "flair/v1/artifact.pb.h"
#include "flair/v1/brief.pb.h"
#include "flair/v1/solved_layout.pb.h"

namespace flair::cli {

struct PlanBeside {
  v1::SolvedLayout layout;
  std::string caption;
  std::string remark;
  // What became of the first plan's objects; none for the first itself.
  std::vector<v1::ObjectChange> changes;
};

struct PlansBeside {
  std::string picture;  // its ending says the format
  std::optional<int> size_px;
  RendererChoice renderer;
  std::vector<PlanBeside> plans;  // at least 2, at most 8
};

// Whether the picture can be drawn to that file; for before the work. INVALID_ARGUMENT for an ending that says no
// format of plans, or sizes of a format without pixels.
absl::Status CheckPicture(const PlansBeside& plans);

// Draws and writes it. Errors as RendererClient and WriteOutputFile.
absl::Status DrawPlansBeside(const PlansBeside& plans);

// Ray-traced pictures that a design gets beside its plan.

// INVALID_ARGUMENT for a name that is none of plan, birdseye and perspective.
absl::Status CheckViews(const std::vector<std::string>& names);

// "birdseye.png" and so on: the same bytes as `flair render` makes of the layout with this renderer. The plan is left
// out, which every design has.
absl::StatusOr<std::vector<OutputFile>> DrawViews(const std::vector<std::string>& names, const RendererChoice& choice,
                                                  const v1::Artifact& layout, const v1::Brief& brief, bool quiet);

// Layouts of one room that differ visibly: the best one and its complete runner-ups.

// The layout first, then its complete runner-ups, best first, each with the whole-room terms that runner-ups lack.
std::vector<v1::SolvedLayout> VariantLayouts(const v1::SolvedLayout& layout, const v1::SolveOptions& options);

// Where variant `number` (from 1 on) goes: "layout.pb" is followed by "layout-2.pb", "layout-3.pb".
std::string VariantPath(const std::string& out, int number);

// "3 of 6 layouts: no more were found that differ visibly; ...".
std::string FewerVariants(size_t found, int wanted);

// The files that a design of several variants has beside its others: layout-2.pb and so on, and variants.png, which
// shows them all.
absl::StatusOr<std::vector<OutputFile>> MakeVariantFiles(const v1::Artifact& layout, const v1::SolveOptions& options,
                                                         const RendererChoice& renderer);

}  // namespace flair::cli
