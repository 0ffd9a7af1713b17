// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "renderer_worker/scene/furnishing.h"

namespace flair::renderer {

// Where a renderer takes its furniture from: of its own making, or, with a folder of assets, from there where one fits.
struct FurnishingChoice {
  std::unique_ptr<FurnishingSource> source;
  std::string revision;                     // of the manifest; empty without assets
  std::vector<v1::Diagnostic> diagnostics;  // what of the manifest cannot be used
};

// NOT_FOUND and INVALID_ARGUMENT name the folder.
absl::StatusOr<FurnishingChoice> ChooseFurnishing(const std::string& asset_folder);

}  // namespace flair::renderer
