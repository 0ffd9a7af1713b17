// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/images/image_files.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <mutex>

#include "renderer_worker/images/file_header.h"
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
    if (module == nullptr) return Unavailable("cannot load the image writer: {}", dlerror());
    const auto* encoder = static_cast<const ImageModule*>(dlsym(module, kImageModuleSymbol));
    if (encoder == nullptr || encoder->version != kImageModuleVersion) {
      return Unavailable("{} belongs to another version of this program", file.string());
    }
    return encoder;
  }
  return Unavailable("cannot find {}; looked in {}; FLAIR_MODULE_DIR may name its folder", kFileName, tried);
}

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
        return InvalidArgument("channels {}: not of {} x {} px", stride == 0 ? "" : plane.channels.front(), width_px,
                               height_px);
      }
      const void* values = is_number ? static_cast<const void*>(plane.numbers.data()) : plane.floats.data();
      for (size_t c = 0; c < stride; ++c)
        request.channels.push_back({plane.channels[c], plane.storage, values, stride, c});
    }
    if (request.channels.empty()) return absl::InvalidArgumentError("a picture needs a channel");
    return Encode(request);
  }
};

constexpr uint64_t kMostDecodedBytes = uint64_t{256} << 20;

// Shrinks rows as they come: every pixel of the result is the mean of the source pixels whose middle it covers.
class Shrinker final : public RowSink {
 public:
  Shrinker(int box_width, int box_height) : box_width_(box_width), box_height_(box_height) {}

  void Start(int width, int height) override {
    width_ = width;
    height_ = height;
    const double scale =
        std::min({1.0, static_cast<double>(box_width_) / width, static_cast<double>(box_height_) / height});
    pixels_.width_px = std::max(1, static_cast<int>(width * scale));
    pixels_.height_px = std::max(1, static_cast<int>(height * scale));
    pixels_.rgb.reserve(static_cast<size_t>(pixels_.width_px) * static_cast<size_t>(pixels_.height_px) * 3);
    sums_.assign(static_cast<size_t>(pixels_.width_px) * 3, 0);
    counts_.assign(static_cast<size_t>(pixels_.width_px), 0);
  }

  void Row(const uint8_t* rgb) override {
    for (int64_t x = 0; x < width_; ++x) {
      const size_t to = static_cast<size_t>(x * pixels_.width_px / width_);
      for (size_t c = 0; c < 3; ++c) sums_[3 * to + c] += rgb[3 * x + static_cast<int64_t>(c)];
      ++counts_[to];
    }
    const auto row_of = [this](int64_t y) { return y * pixels_.height_px / height_; };
    ++y_;
    if (y_ == height_ || row_of(y_) != row_of(y_ - 1)) EndRow();
  }

  Pixels Take() { return std::move(pixels_); }

 private:
  void EndRow() {
    for (size_t i = 0; i < sums_.size(); ++i) {
      const uint64_t count = counts_[i / 3];
      pixels_.rgb.push_back(static_cast<uint8_t>((sums_[i] + count / 2) / count));
      sums_[i] = 0;
    }
    std::ranges::fill(counts_, 0);
  }

  const int box_width_;
  const int box_height_;
  int width_ = 0;
  int height_ = 0;
  int64_t y_ = 0;
  Pixels pixels_;
  std::vector<uint64_t> sums_;
  std::vector<uint64_t> counts_;
};

}  // namespace

absl::StatusOr<const ImageModule*> LoadImageModule() {
  static std::once_flag once;
  static absl::StatusOr<const ImageModule*> module = absl::UnavailableError("not loaded");
  std::call_once(once, [] { module = LoadModule(); });
  return module;
}

std::unique_ptr<ImageWriter> MakeImageWriter() { return std::make_unique<ModuleImageWriter>(); }

absl::StatusOr<Pixels> ReadImage(std::string_view bytes, int box_width_px, int box_height_px) {
  ASSIGN_OR_RETURN(const FileHeader header, ReadFileHeader(bytes));
  if (std::max(header.width_px, header.height_px) > kLargestReadSidePx) {
    return InvalidArgument("is said to be {} x {} px; at most {} px a side", header.width_px, header.height_px,
                           kLargestReadSidePx);
  }
  ASSIGN_OR_RETURN(const ImageModule* module, LoadImageModule());
  Shrinker shrinker(box_width_px, box_height_px);
  const std::string error =
      module->decode({header.file_name, bytes.data(), bytes.size(), kLargestReadSidePx, kMostDecodedBytes}, shrinker);
  if (error == kNoMemory) return absl::ResourceExhaustedError("no memory for the picture");
  if (!error.empty()) return absl::InvalidArgumentError("cannot be read: " + error);
  return shrinker.Take();
}

}  // namespace flair::renderer
