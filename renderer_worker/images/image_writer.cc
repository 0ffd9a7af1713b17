// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/images/image_writer.h"

#include <fmt/format.h>

#include <new>

#include "renderer_worker/images/load_module.h"

namespace flair::renderer {
namespace {

struct Answer {
  std::string file;
  std::string error;
};

const char* FileNameOf(v1::PreviewFormat format) {
  switch (format) {
    case v1::PREVIEW_FORMAT_PNG:
      return "picture.png";
    case v1::PREVIEW_FORMAT_JPEG:
      return "picture.jpg";
    case v1::PREVIEW_FORMAT_TIFF:
      return "picture.tif";
    default:
      return nullptr;
  }
}

// What formats that only know a few names lose otherwise.
ImageMetadata WithDescription(ImageMetadata metadata) {
  std::string description;
  for (const auto& [name, value] : metadata) {
    if (name == "ImageDescription") return metadata;
    description += fmt::format("{}{}: {}", description.empty() ? "" : "\n", name, value);
  }
  if (!description.empty()) metadata.emplace_back("ImageDescription", std::move(description));
  return metadata;
}

absl::StatusOr<std::string> Encode(EncoderRequest request, const ImageMetadata& metadata) {
  const absl::StatusOr<const EncoderModule*> module = LoadImageModule();
  if (!module.ok()) return module.status();
  std::vector<EncoderMetadata> entries;
  for (const auto& [name, value] : metadata) entries.push_back({name.c_str(), value.c_str()});
  request.metadata = entries.data();
  request.metadata_count = entries.size();
  Answer answer;
  const EncoderSink file = [](void* context, const char* bytes, size_t count) {
    static_cast<Answer*>(context)->file.append(bytes, count);
  };
  const EncoderSink error = [](void* context, const char* bytes, size_t count) {
    static_cast<Answer*>(context)->error.append(bytes, count);
  };
  try {
    if (!(*module)->encode(request, file, error, &answer))
      return absl::InternalError("cannot encode the picture: " + answer.error);
  } catch (const std::bad_alloc&) {  // of the sinks
    return absl::ResourceExhaustedError("no memory for the picture's file; ask for a smaller one");
  }
  return std::move(answer.file);
}

class ModuleImageWriter final : public ImageWriter {
 public:
  void Prepare() override { LoadImageModule().IgnoreError(); }

  absl::StatusOr<std::string> Write(v1::PreviewFormat format, const Pixels& pixels, const ImageMetadata& metadata,
                                    double dots_per_inch) override {
    const char* name = FileNameOf(format);
    if (name == nullptr) return absl::InvalidArgumentError("format: 8-bit pixels are stored as PNG, JPEG or TIFF");
    EncoderRequest request = {};
    request.file_name = name;
    request.width_px = pixels.width_px;
    request.height_px = pixels.height_px;
    request.rgb = pixels.rgb.data();
    request.dots_per_inch = dots_per_inch;
    return Encode(request, format == v1::PREVIEW_FORMAT_PNG ? metadata : WithDescription(metadata));
  }

  absl::StatusOr<std::string> WriteExr(int width_px, int height_px, std::span<const ImagePlane> planes,
                                       const ImageMetadata& metadata) override {
    const size_t pixel_count = static_cast<size_t>(width_px) * static_cast<size_t>(height_px);
    std::vector<EncoderChannel> channels;
    for (const ImagePlane& plane : planes) {
      const bool is_number = plane.storage == ChannelStorage::kUint32;
      const size_t stride = plane.channels.size();
      if ((is_number ? plane.numbers.size() : plane.floats.size()) != pixel_count * stride) {
        return absl::InvalidArgumentError(fmt::format("channels {}: not of {} x {} px",
                                                      stride == 0 ? "" : plane.channels.front(), width_px, height_px));
      }
      const void* values = is_number ? static_cast<const void*>(plane.numbers.data()) : plane.floats.data();
      for (size_t c = 0; c < stride; ++c)
        channels.push_back({plane.channels[c].c_str(), plane.storage, values, stride, c});
    }
    if (channels.empty()) return absl::InvalidArgumentError("a picture needs a channel");
    EncoderRequest request = {};
    request.file_name = "picture.exr";
    request.width_px = width_px;
    request.height_px = height_px;
    request.channels = channels.data();
    request.channel_count = channels.size();
    return Encode(request, metadata);
  }
};

}  // namespace

std::unique_ptr<ImageWriter> MakeImageWriter() { return std::make_unique<ModuleImageWriter>(); }

}  // namespace flair::renderer
