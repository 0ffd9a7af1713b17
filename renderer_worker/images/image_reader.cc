// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/images/image_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>

#include "renderer_worker/images/file_header.h"
#include "renderer_worker/images/load_module.h"

namespace flair::renderer {
namespace {

constexpr uint64_t kMostDecodedBytes = uint64_t{256} << 20;

// Shrinks rows as they come: every pixel of the result is the mean of the source pixels whose middle it covers.
class Shrinker {
 public:
  Shrinker(int box_width, int box_height) : box_width_(box_width), box_height_(box_height) {}

  bool Start(int width, int height) {
    width_ = width;
    height_ = height;
    const double scale =
        std::min({1.0, static_cast<double>(box_width_) / width, static_cast<double>(box_height_) / height});
    pixels_.width_px = std::max(1, static_cast<int>(width * scale));
    pixels_.height_px = std::max(1, static_cast<int>(height * scale));
    pixels_.rgb.reserve(static_cast<size_t>(pixels_.width_px) * static_cast<size_t>(pixels_.height_px) * 3);
    sums_.assign(static_cast<size_t>(pixels_.width_px) * 3, 0);
    counts_.assign(static_cast<size_t>(pixels_.width_px), 0);
    return true;
  }

  bool Row(const uint8_t* rgb) {
    for (int64_t x = 0; x < width_; ++x) {
      const size_t to = static_cast<size_t>(x * pixels_.width_px / width_);
      for (size_t c = 0; c < 3; ++c) sums_[3 * to + c] += rgb[3 * x + static_cast<int64_t>(c)];
      ++counts_[to];
    }
    const auto row_of = [this](int64_t y) { return y * pixels_.height_px / height_; };
    ++y_;
    if (y_ == height_ || row_of(y_) != row_of(y_ - 1)) EndRow();
    return true;
  }

  Pixels Take() { return std::move(pixels_); }

 private:
  void EndRow() {
    for (size_t i = 0; i < sums_.size(); ++i) {
      const uint64_t count = counts_[i / 3];
      pixels_.rgb.push_back(static_cast<uint8_t>((sums_[i] + count / 2) / count));
      sums_[i] = 0;
    }
    std::fill(counts_.begin(), counts_.end(), 0);
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

struct Reading {
  Shrinker shrinker;
  std::string error;
  bool no_memory = false;

  template <typename Step>
  bool Guard(const Step& step) {
    try {
      return step();
    } catch (const std::bad_alloc&) {
      no_memory = true;
      return false;
    }
  }
};

}  // namespace

absl::StatusOr<Pixels> ReadImage(std::string_view bytes, int box_width_px, int box_height_px) {
  const absl::StatusOr<FileHeader> header = ReadFileHeader(bytes);
  if (!header.ok()) return header.status();
  if (std::max(header->width_px, header->height_px) > kLargestReadSidePx) {
    return absl::InvalidArgumentError(fmt::format("is said to be {} x {} px; at most {} px a side", header->width_px,
                                                  header->height_px, kLargestReadSidePx));
  }
  const absl::StatusOr<const EncoderModule*> module = LoadImageModule();
  if (!module.ok()) return module.status();
  Reading reading{Shrinker(box_width_px, box_height_px), "", false};
  const DecoderRequest request{header->file_name, bytes.data(), bytes.size(), kLargestReadSidePx, kMostDecodedBytes};
  const DecoderStart start = [](void* context, int width_px, int height_px) {
    auto* to = static_cast<Reading*>(context);
    return to->Guard([&] { return to->shrinker.Start(width_px, height_px); });
  };
  const DecoderRow row = [](void* context, const uint8_t* rgb) {
    return static_cast<Reading*>(context)->shrinker.Row(rgb);
  };
  const EncoderSink error = [](void* context, const char* text, size_t count) {
    static_cast<Reading*>(context)->error.append(text, count);
  };
  const bool read = (*module)->decode(request, start, row, error, &reading);
  if (reading.no_memory) return absl::ResourceExhaustedError("no memory for the picture");
  if (!read) return absl::InvalidArgumentError("cannot be read: " + reading.error);
  return reading.shrinker.Take();
}

}  // namespace flair::renderer
