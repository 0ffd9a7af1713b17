// SPDX-License-Identifier: GPL-3.0-or-later
// The module flair_image_writer: OpenImageIO behind two functions. This file writes, decoder_module.cc reads.
#include "renderer_worker/images/encoder_module.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "renderer_worker/images/decoder_module.h"
#include "renderer_worker/images/set_up_library.h"

namespace flair::renderer {
namespace {

bool FailWriting(EncoderSink error, void* context, const std::string& message) {
  error(context, message.data(), message.size());
  return false;
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
  switch (storage) {
    case ChannelStorage::kHalf:
      return OIIO::TypeDesc::HALF;
    case ChannelStorage::kFloat:
      return OIIO::TypeDesc::FLOAT;
    case ChannelStorage::kUint32:
      return OIIO::TypeDesc::UINT32;
  }
  return OIIO::TypeDesc::UNKNOWN;
}

OIIO::ImageSpec SpecOf(const EncoderRequest& request, std::string_view format) {
  const bool has_channels = request.channel_count > 0;
  const int count = has_channels ? static_cast<int>(request.channel_count) : 3;
  OIIO::ImageSpec spec(request.width_px, request.height_px, count, OIIO::TypeDesc::UINT8);
  if (has_channels) {
    spec.channelnames.clear();
    for (size_t c = 0; c < request.channel_count; ++c) {
      spec.channelnames.emplace_back(request.channels[c].name);
      spec.channelformats.push_back(TypeOf(request.channels[c].storage));
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
  for (size_t i = 0; i < request.metadata_count; ++i)
    spec.attribute(request.metadata[i].name, request.metadata[i].value);
  return spec;
}

// Row by row in the types in which they are stored: one copy of a row at a time.
bool WriteChannels(const EncoderRequest& request, const OIIO::ImageSpec& spec, OIIO::ImageOutput& output) {
  const size_t width = static_cast<size_t>(request.width_px);
  const size_t pixel_bytes = spec.pixel_bytes(true);
  std::vector<char> row(width * pixel_bytes);
  for (int y = 0; y < request.height_px; ++y) {
    size_t at = 0;
    for (size_t c = 0; c < request.channel_count; ++c) {
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

bool EncodeOrThrow(const EncoderRequest& request, EncoderSink file, EncoderSink error, void* context) {
  SetUpLibrary();
  std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(request.file_name);
  if (!output)
    return FailWriting(error, context, "no encoder for " + std::string(request.file_name) + ": " + OIIO::geterror());
  if (!output->supports("ioproxy"))
    return FailWriting(error, context, std::string(output->format_name()) + " cannot be written to memory");
  const OIIO::ImageSpec spec = SpecOf(request, output->format_name());
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  if (!output->set_ioproxy(&memory) || !output->open(request.file_name, spec))
    return FailWriting(error, context, output->geterror());
  const bool written = request.channel_count > 0 ? WriteChannels(request, spec, *output)
                                                 : output->write_image(OIIO::TypeDesc::UINT8, request.rgb);
  if (!written || !output->close()) return FailWriting(error, context, output->geterror());
  file(context, reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return true;
}

bool Encode(const EncoderRequest& request, EncoderSink file, EncoderSink error, void* context) {
  try {
    return EncodeOrThrow(request, file, error, context);
  } catch (const std::exception& exception) {
    error(context, exception.what(), std::strlen(exception.what()));
  } catch (...) {
    error(context, "unknown exception", 17);
  }
  return false;
}

}  // namespace
}  // namespace flair::renderer

extern "C" const flair::renderer::EncoderModule flair_image_encoder = {
    flair::renderer::kEncoderModuleVersion, flair::renderer::Encode, flair::renderer::Decode};
