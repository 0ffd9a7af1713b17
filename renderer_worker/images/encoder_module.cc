// SPDX-License-Identifier: GPL-3.0-or-later
// The module flair_image_writer: OpenImageIO behind one function.
#include "renderer_worker/images/encoder_module.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cstring>
#include <exception>
#include <memory>
#include <string>
#include <vector>

namespace flair::renderer {
namespace {

bool Fail(EncoderSink error, void* context, const std::string& message) {
  error(context, message.data(), message.size());
  return false;
}

bool EncodeOrThrow(const EncoderRequest& request, EncoderSink file, EncoderSink error, void* context) {
  OIIO::attribute("threads", 1);
  std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(request.file_name);
  if (!output)
    return Fail(error, context, "no encoder for " + std::string(request.file_name) + ": " + OIIO::geterror());
  if (!output->supports("ioproxy"))
    return Fail(error, context, std::string(output->format_name()) + " cannot be written to memory");
  OIIO::ImageSpec spec(request.width_px, request.height_px, 3, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("png:compressionLevel", 4);
  for (size_t i = 0; i < request.metadata_count; ++i)
    spec.attribute(request.metadata[i].name, request.metadata[i].value);
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  if (!output->set_ioproxy(&memory) || !output->open(request.file_name, spec) ||
      !output->write_image(OIIO::TypeDesc::UINT8, request.rgb) || !output->close()) {
    return Fail(error, context, output->geterror());
  }
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

extern "C" const flair::renderer::EncoderModule flair_image_encoder = {flair::renderer::kEncoderModuleVersion,
                                                                       flair::renderer::Encode};
