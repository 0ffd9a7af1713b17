// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/preview.pb.h"
#include "renderer_worker/drawing/draw_plan.h"
#include "renderer_worker/images/image_module.h"

namespace flair::renderer {

// One or more channels of an EXR that lie side by side in memory: value c of pixel p is [p * channels.size() + c], rows
// from the top. `floats` for kHalf and kFloat, `numbers` for kUint32. Halves end at 65504.
struct ImagePlane {
  std::vector<std::string> channels;
  ChannelStorage storage = ChannelStorage::kHalf;
  std::span<const float> floats;
  std::span<const uint32_t> numbers;
};

// Turns pixels into the bytes of an image file: the same bytes for the same pixels and metadata, no time of day.
// UNAVAILABLE when the encoder cannot be loaded, RESOURCE_EXHAUSTED when memory is, INTERNAL when it fails.
// Thread-safe.
class ImageWriter {
 public:
  virtual ~ImageWriter() = default;
  // What the first picture would wait for, such as loading an encoder, so that it can be done beside other work. Need
  // not be called; what goes wrong is said by the first picture.
  virtual void Prepare() {}
  // `format` is PNG, JPEG or TIFF. `dots_per_inch` is written when above 0.
  virtual absl::StatusOr<std::string> Write(v1::PreviewFormat format, const Pixels& pixels,
                                            const ImageMetadata& metadata, double dots_per_inch = 0) = 0;
  // OpenEXR, linear light. INVALID_ARGUMENT for planes that are not width x height.
  virtual absl::StatusOr<std::string> WriteExr(int width_px, int height_px, std::span<const ImagePlane> planes,
                                               const ImageMetadata& metadata) = 0;

  absl::StatusOr<std::string> WritePng(const Pixels& pixels, const ImageMetadata& metadata) {
    return Write(v1::PREVIEW_FORMAT_PNG, pixels, metadata);
  }
};

// Writes through OpenImageIO, which is loaded on first use (LoadImageModule).
std::unique_ptr<ImageWriter> MakeImageWriter();

// Prepares a writer on a thread of its own while something is drawn; its end waits for it. Without a thread to be had
// the first picture does it. Borrows the writer.
class PrepareBeside {
 public:
  explicit PrepareBeside(ImageWriter& writer) {
    try {
      thread_ = std::jthread([&writer] { writer.Prepare(); });
    } catch (const std::system_error&) {
    }
  }

 private:
  std::jthread thread_;
};

// The module, loaded by the first call of the process (0.4 s) and never unloaded: beside the program, in ../lib or
// ../lib/flair of it, in $FLAIR_MODULE_DIR, or where it was built. UNAVAILABLE when it is not there or of another
// version. Thread-safe.
absl::StatusOr<const ImageModule*> LoadImageModule();

// Largest side of a picture that is read.
inline constexpr int kLargestReadSidePx = 8192;

// Reads a PNG, JPEG or TIFF file that anybody may have written, told apart by its first bytes. The picture is shrunk
// (each pixel the mean of those it covers), never enlarged, to fit the box while its rows are read, so that memory
// stays bounded. What is transparent comes over white. INVALID_ARGUMENT says what is wrong with the bytes: no such
// format, too large (before any pixel is decoded), truncated. UNAVAILABLE when the module cannot be loaded.
// Thread-safe.
absl::StatusOr<Pixels> ReadImage(std::string_view bytes, int box_width_px, int box_height_px);

}  // namespace flair::renderer
