// SPDX-License-Identifier: GPL-3.0-or-later
// One picture of several layouts' plans.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/session/renderer_client.h"

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

}  // namespace flair::cli
