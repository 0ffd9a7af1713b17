// SPDX-License-Identifier: GPL-3.0-or-later
// Layouts of one room that differ visibly: the best one and its complete runner-ups.
#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "cli/output/output_folder.h"
#include "cli/session/stage_calls.h"
#include "flair/v1/artifact.pb.h"
#include "flair/v1/solved_layout.pb.h"

namespace flair::cli {

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
