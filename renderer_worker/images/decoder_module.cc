// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/images/decoder_module.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "renderer_worker/images/set_up_library.h"

namespace flair::renderer {
namespace {

bool FailReading(EncoderSink error, void* context, const std::string& message) {
  error(context, message.data(), message.size());
  return false;
}

std::string WhyTooLarge(const OIIO::ImageSpec& spec, const DecoderRequest& request) {
  const std::string size = std::to_string(spec.width) + " x " + std::to_string(spec.height) + " px";
  if (spec.width < 1 || spec.height < 1) return "has no pixels (" + size + ")";
  if (spec.width > request.max_side_px || spec.height > request.max_side_px)
    return "is " + size + "; at most " + std::to_string(request.max_side_px) + " px a side";
  if (spec.nchannels < 1 || spec.nchannels > 8) return "has " + std::to_string(spec.nchannels) + " channels; 1 to 8";
  if (spec.image_bytes(true) > request.max_decoded_bytes) {
    return "has " + size + " of " + std::to_string(spec.pixel_bytes(true)) + " bytes, together more than " +
           std::to_string(request.max_decoded_bytes >> 20) + " MiB";
  }
  return "";
}

// One row of 8-bit values in `channels` channels to RGB, over white.
void ToRgb(const std::vector<uint8_t>& from, size_t channels, std::vector<uint8_t>& rgb) {
  const bool is_grey = channels < 3;
  const bool has_alpha = channels == 2 || channels >= 4;
  for (size_t x = 0; x < rgb.size() / 3; ++x) {
    const uint8_t* pixel = from.data() + x * channels;
    const int alpha = has_alpha ? pixel[is_grey ? 1 : 3] : 255;
    // Colours come multiplied by their alpha.
    for (size_t c = 0; c < 3; ++c)
      rgb[3 * x + c] = static_cast<uint8_t>(std::min(255, pixel[is_grey ? 0 : c] + 255 - alpha));
  }
}

bool DecodeOrThrow(const DecoderRequest& request, DecoderStart start, DecoderRow row, EncoderSink error,
                   void* context) {
  SetUpLibrary();
  OIIO::Filesystem::IOMemReader memory(const_cast<void*>(request.bytes), request.byte_count);
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(request.file_name, nullptr, &memory);
  if (!input) return FailReading(error, context, OIIO::geterror());
  const OIIO::ImageSpec& spec = input->spec();
  if (const std::string why = WhyTooLarge(spec, request); !why.empty()) return FailReading(error, context, why);
  if (spec.tile_width > 0 || spec.deep)
    return FailReading(error, context, "is stored in tiles or in depth; only rows are read");
  if (!start(context, spec.width, spec.height)) return false;
  const size_t width = static_cast<size_t>(spec.width), channels = static_cast<size_t>(spec.nchannels);
  std::vector<uint8_t> stored(width * channels), rgb(width * 3);
  for (int y = 0; y < spec.height; ++y) {
    if (!input->read_scanline(spec.y + y, spec.z, OIIO::TypeDesc::UINT8, stored.data()))
      return FailReading(error, context,
                         "row " + std::to_string(y) + " of " + std::to_string(spec.height) + ": " + input->geterror());
    ToRgb(stored, channels, rgb);
    if (!row(context, rgb.data())) return false;
  }
  return true;
}

}  // namespace

bool Decode(const DecoderRequest& request, DecoderStart start, DecoderRow row, EncoderSink error, void* context) {
  try {
    return DecodeOrThrow(request, start, row, error, context);
  } catch (const std::exception& exception) {
    error(context, exception.what(), std::strlen(exception.what()));
  } catch (...) {
    error(context, "unknown exception", 17);
  }
  return false;
}

}  // namespace flair::renderer
