// SPDX-License-Identifier: GPL-3.0-or-later
// The module flair_image_writer: OpenImageIO behind two functions.
#include "renderer_worker/images/image_module.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <memory>
#include <mutex>
#include <new>
#include <string_view>

namespace flair::renderer {
namespace {

// Calls run on threads of their own, so the library needs none. Once for all of them: setting it changes a pool that
// another call may be using, which ends the process.
void SetUpLibrary() {
  static std::once_flag once;
  std::call_once(once, [] {
    OIIO::attribute("threads", 1);
    OIIO::attribute("debug", 0);
  });
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

std::string DecodeOrThrow(const DecoderRequest& request, RowSink& sink) {
  OIIO::Filesystem::IOMemReader memory(const_cast<void*>(request.bytes), request.byte_count);
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(request.file_name, nullptr, &memory);
  if (!input) return OIIO::geterror();
  const OIIO::ImageSpec& spec = input->spec();
  if (std::string why = WhyTooLarge(spec, request); !why.empty()) return why;
  if (spec.tile_width > 0 || spec.deep) return "is stored in tiles or in depth; only rows are read";
  sink.Start(spec.width, spec.height);
  const size_t width = static_cast<size_t>(spec.width), channels = static_cast<size_t>(spec.nchannels);
  std::vector<uint8_t> stored(width * channels), rgb(width * 3);
  for (int y = 0; y < spec.height; ++y) {
    if (!input->read_scanline(spec.y + y, spec.z, OIIO::TypeDesc::UINT8, stored.data()))
      return "row " + std::to_string(y) + " of " + std::to_string(spec.height) + ": " + input->geterror();
    ToRgb(stored, channels, rgb);
    sink.Row(rgb.data());
  }
  return "";
}

// Whether it is a drawing: most pixels are like their left neighbours. PNG's filters, which predict a pixel from its
// neighbours, cost five times as much time there as they save space; on shaded pictures they are worth it.
bool IsFlat(const EncoderRequest& request) {
  const size_t count = static_cast<size_t>(request.width_px) * static_cast<size_t>(request.height_px);
  size_t equal = 0;
  for (size_t i = 1; i < count; ++i) equal += std::memcmp(request.rgb + 3 * i, request.rgb + 3 * i - 3, 3) == 0;
  return equal > count - count / 3;
}

OIIO::TypeDesc TypeOf(ChannelStorage storage) {
  constexpr OIIO::TypeDesc::BASETYPE kTypes[] = {OIIO::TypeDesc::HALF, OIIO::TypeDesc::FLOAT, OIIO::TypeDesc::UINT32};
  return kTypes[static_cast<int>(storage)];
}

OIIO::ImageSpec SpecOf(const EncoderRequest& request, std::string_view format) {
  const bool has_channels = !request.channels.empty();
  const int count = has_channels ? static_cast<int>(request.channels.size()) : 3;
  OIIO::ImageSpec spec(request.width_px, request.height_px, count, OIIO::TypeDesc::UINT8);
  if (has_channels) {
    spec.channelnames.clear();
    for (const EncoderChannel& channel : request.channels) {
      spec.channelnames.push_back(channel.name);
      spec.channelformats.push_back(TypeOf(channel.storage));
    }
    spec.format = OIIO::TypeDesc::FLOAT;
    spec.attribute("oiio:ColorSpace", "Linear");
    spec.attribute("compression", "zip");
  } else if (format != "tiff") {  // its writer takes these for other things and breaks the file
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("png:compressionLevel", 3);
    constexpr int kNoFilter = 8;
    if (format == "png" && IsFlat(request)) spec.attribute("png:filter", kNoFilter);
    spec.attribute("CompressionQuality", 93);
    spec.attribute("jpeg:subsampling", "4:4:4");  // thin coloured lines
  }
  if (request.dots_per_inch > 0) {
    spec.attribute("XResolution", static_cast<float>(request.dots_per_inch));
    spec.attribute("YResolution", static_cast<float>(request.dots_per_inch));
    spec.attribute("ResolutionUnit", "in");
  }
  // EXR and TIFF would add the time of day, and equal pictures would differ. EXR leaves out one of no date's type; TIFF
  // has an empty one.
  if (has_channels) {
    spec.attribute("DateTime", 0);
  } else {
    spec.attribute("DateTime", "");
  }
  for (const auto& [name, value] : request.metadata) spec.attribute(name, value);
  return spec;
}

// Row by row in the types in which they are stored: one copy of a row at a time.
bool WriteChannels(const EncoderRequest& request, const OIIO::ImageSpec& spec, OIIO::ImageOutput& output) {
  const size_t width = static_cast<size_t>(request.width_px);
  const size_t pixel_bytes = spec.pixel_bytes(true);
  std::vector<char> row(width * pixel_bytes);
  for (int y = 0; y < request.height_px; ++y) {
    size_t at = 0;
    for (size_t c = 0; c < request.channels.size(); ++c) {
      const EncoderChannel& channel = request.channels[c];
      const OIIO::TypeDesc type = spec.channelformats[c];
      const OIIO::TypeDesc source =
          channel.storage == ChannelStorage::kUint32 ? OIIO::TypeDesc::UINT32 : OIIO::TypeDesc::FLOAT;
      const char* first = static_cast<const char*>(channel.values) +
                          4 * (static_cast<size_t>(y) * width * channel.stride + channel.offset);
      if (!OIIO::convert_image(1, request.width_px, 1, 1, first, source,
                               static_cast<OIIO::stride_t>(4 * channel.stride), OIIO::AutoStride, OIIO::AutoStride,
                               row.data() + at, type, static_cast<OIIO::stride_t>(pixel_bytes), OIIO::AutoStride,
                               OIIO::AutoStride))
        return false;
      at += type.size();
    }
    if (!output.write_scanline(y, 0, OIIO::TypeDesc::UNKNOWN, row.data())) return false;
  }
  return true;
}

std::string EncodeOrThrow(const EncoderRequest& request, std::string& file) {
  std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(request.file_name);
  if (!output) return "no encoder for " + request.file_name + ": " + OIIO::geterror();
  if (!output->supports("ioproxy")) return std::string(output->format_name()) + " cannot be written to memory";
  const OIIO::ImageSpec spec = SpecOf(request, output->format_name());
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  if (!output->set_ioproxy(&memory) || !output->open(request.file_name, spec)) return output->geterror();
  const bool written = request.channels.empty() ? output->write_image(OIIO::TypeDesc::UINT8, request.rgb)
                                                : WriteChannels(request, spec, *output);
  if (!written || !output->close()) return output->geterror();
  file.assign(bytes.begin(), bytes.end());
  return "";
}

template <typename Work>
std::string WithoutExceptions(const Work& work) {
  try {
    SetUpLibrary();
    return work();
  } catch (const std::bad_alloc&) {
    return kNoMemory;
  } catch (const std::exception& exception) {
    return exception.what();
  } catch (...) {
    return "unknown exception";
  }
}

std::string Encode(const EncoderRequest& request, std::string& file) {
  return WithoutExceptions([&] { return EncodeOrThrow(request, file); });
}

std::string Decode(const DecoderRequest& request, RowSink& sink) {
  return WithoutExceptions([&] { return DecodeOrThrow(request, sink); });
}

}  // namespace
}  // namespace flair::renderer

extern "C" const flair::renderer::ImageModule flair_image_module = {flair::renderer::kImageModuleVersion,
                                                                    flair::renderer::Encode, flair::renderer::Decode};
