// SPDX-License-Identifier: GPL-3.0-or-later
// How to draw, as a person says it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "CLI/CLI.hpp"
#include "absl/status/statusor.h"
#include "flair/v1/renderer_service.pb.h"

namespace flair::cli {

struct RenderFlags {
  std::string view = "plan";
  std::optional<int> size_px;
  std::optional<int> dpi;
  std::string paper;
  std::string scale;   // "1:50" or "50"
  std::string layers;  // "zones,tertiary" or "all"
  std::optional<int> samples;
  std::optional<int64_t> seed;
  std::string camera;   // "x,y,z"
  std::string look_at;  // the same
  std::optional<double> field_of_view_deg;
};

// Adds the flags to a command; `flags` must outlive it.
void AddRenderFlags(CLI::App& command, RenderFlags& flags);

// The options for a picture that goes to the file `out`, whose ending says the format. INVALID_ARGUMENT names the flag
// or the ending, the value, and what would be right, also for flags that do not go together.
absl::StatusOr<v1::RenderOptions> ReadRenderFlags(const RenderFlags& flags, const std::string& out);

// By the ending of a file name. INVALID_ARGUMENT when it is none of png, jpg, jpeg, tif, tiff, exr, svg, pdf.
absl::StatusOr<v1::PreviewFormat> FormatOfFile(const std::string& path);

// "plan", "birdseye" or "perspective"; INVALID_ARGUMENT otherwise.
absl::StatusOr<v1::PreviewView> ViewOfName(const std::string& name);

}  // namespace flair::cli
