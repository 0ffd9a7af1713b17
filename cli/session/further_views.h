// SPDX-License-Identifier: GPL-3.0-or-later
// Ray-traced pictures that a design gets beside its plan.
#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "cli/output/output_folder.h"
#include "cli/session/renderer_client.h"
#include "flair/v1/artifact.pb.h"
#include "flair/v1/brief.pb.h"

namespace flair::cli {

// INVALID_ARGUMENT for a name that is none of plan, birdseye and perspective.
absl::Status CheckViews(const std::vector<std::string>& names);

// "birdseye.png" and so on: the same bytes as `flair render` makes of the layout with this renderer. The plan is left
// out, which every design has.
absl::StatusOr<std::vector<OutputFile>> DrawViews(const std::vector<std::string>& names, const RendererChoice& choice,
                                                  const v1::Artifact& layout, const v1::Brief& brief, bool quiet);

}  // namespace flair::cli
