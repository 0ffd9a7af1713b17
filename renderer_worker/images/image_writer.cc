// SPDX-License-Identifier: GPL-3.0-or-later
#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "renderer_worker/images/image_files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {
namespace {

constexpr char kFileName[] = "libflair_image_writer.so";

std::vector<std::filesystem::path> Places() {
  std::vector<std::filesystem::path> places;
  if (const char* folder = std::getenv("FLAIR_MODULE_DIR"); folder != nullptr) places.emplace_back(folder);
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  if (!error) {
    places.push_back(program);
    places.push_back(program.parent_path() / "lib");
    places.push_back(program.parent_path() / "lib" / "flair");
  }
  places.emplace_back(FLAIR_MODULE_BUILD_DIR);
  return places;
}

absl::StatusOr<const ImageModule*> LoadModule() {
  std::string tried;
  for (const std::filesystem::path& place : Places()) {
    const std::filesystem::path file = place / kFileName;
    std::error_code error;
    if (!std::filesystem::exists(file, error)) {
      tried += (tried.empty() ? "" : ", ") + place.string();
      continue;
    }
    void* module = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (module == nullptr) return absl::UnavailableError(fmt::format("cannot load the image writer: {}", dlerror()));
    const auto* encoder = static_cast<const ImageModule*>(dlsym(module, kImageModuleSymbol));
    if (encoder == nullptr || encoder->version != kImageModuleVersion) {
      return absl::UnavailableError(fmt::format("{} belongs to another version of this program", file.string()));
    }
    return encoder;
  }
  return absl::UnavailableError(
      fmt::format("cannot find {}; looked in {}; FLAIR_MODULE_DIR may name its folder", kFileName, tried));
}

}  // namespace

absl::StatusOr<const ImageModule*> LoadImageModule() {
  static std::once_flag once;
  static absl::StatusOr<const ImageModule*> module = absl::UnavailableError("not loaded");
  std::call_once(once, [] { module = LoadModule(); });
  return module;
}

namespace {

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

absl::StatusOr<std::string> Encode(const EncoderRequest& request) {
  ASSIGN_OR_RETURN(const ImageModule* module, LoadImageModule());
  std::string file;
  const std::string error = module->encode(request, file);
  if (error == kNoMemory) {
    return absl::ResourceExhaustedError("no memory for the picture's file; ask for a smaller one");
  }
  if (!error.empty()) return absl::InternalError("cannot encode the picture: " + error);
  return file;
}

class ModuleImageWriter final : public ImageWriter {
 public:
  void Prepare() override { LoadImageModule().IgnoreError(); }

  absl::StatusOr<std::string> Write(v1::PreviewFormat format, const Pixels& pixels, const ImageMetadata& metadata,
                                    double dots_per_inch) override {
    const char* name = FileNameOf(format);
    if (name == nullptr) return absl::InvalidArgumentError("format: 8-bit pixels are stored as PNG, JPEG or TIFF");
    return Encode({.file_name = name,
                   .width_px = pixels.width_px,
                   .height_px = pixels.height_px,
                   .rgb = pixels.rgb.data(),
                   .channels = {},
                   .dots_per_inch = dots_per_inch,
                   .metadata = format == v1::PREVIEW_FORMAT_PNG ? metadata : WithDescription(metadata)});
  }

  absl::StatusOr<std::string> WriteExr(int width_px, int height_px, std::span<const ImagePlane> planes,
                                       const ImageMetadata& metadata) override {
    const size_t pixel_count = static_cast<size_t>(width_px) * static_cast<size_t>(height_px);
    EncoderRequest request{.file_name = "picture.exr", .width_px = width_px, .height_px = height_px};
    request.metadata = metadata;
    for (const ImagePlane& plane : planes) {
      const bool is_number = plane.storage == ChannelStorage::kUint32;
      const size_t stride = plane.channels.size();
      if ((is_number ? plane.numbers.size() : plane.floats.size()) != pixel_count * stride) {
        return absl::InvalidArgumentError(fmt::format("channels {}: not of {} x {} px",
                                                      stride == 0 ? "" : plane.channels.front(), width_px, height_px));
      }
      const void* values = is_number ? static_cast<const void*>(plane.numbers.data()) : plane.floats.data();
      for (size_t c = 0; c < stride; ++c)
        request.channels.push_back({plane.channels[c], plane.storage, values, stride, c});
    }
    if (request.channels.empty()) return absl::InvalidArgumentError("a picture needs a channel");
    return Encode(request);
  }
};

}  // namespace

std::unique_ptr<ImageWriter> MakeImageWriter() { return std::make_unique<ModuleImageWriter>(); }

}  // namespace flair::renderer
