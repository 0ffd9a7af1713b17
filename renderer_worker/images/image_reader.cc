// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "renderer_worker/images/file_header.h"
#include "renderer_worker/images/image_files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {
namespace {

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

}  // namespace

absl::StatusOr<Pixels> ReadImage(std::string_view bytes, int box_width_px, int box_height_px) {
  ASSIGN_OR_RETURN(const FileHeader header, ReadFileHeader(bytes));
  if (std::max(header.width_px, header.height_px) > kLargestReadSidePx) {
    return absl::InvalidArgumentError(fmt::format("is said to be {} x {} px; at most {} px a side", header.width_px,
                                                  header.height_px, kLargestReadSidePx));
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
