// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "renderer_worker/drawing/draw_plan.h"

namespace flair::renderer {

// Name and value, in the order they are written.
using ImageMetadata = std::vector<std::pair<std::string, std::string>>;

// Turns pixels into the bytes of an image file. Thread-safe.
class ImageWriter {
 public:
  virtual ~ImageWriter() = default;
  // The same bytes for the same pixels and metadata. UNAVAILABLE when the encoder cannot be loaded, INTERNAL when it
  // fails.
  virtual absl::StatusOr<std::string> WritePng(const Pixels& pixels, const ImageMetadata& metadata) = 0;
};

// Writes through OpenImageIO, which is loaded as a module on first use: beside the program, in ../lib or ../lib/flair
// of it, in $FLAIR_MODULE_DIR, or where it was built.
std::unique_ptr<ImageWriter> MakeImageWriter();

}  // namespace flair::renderer
