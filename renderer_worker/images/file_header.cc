// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/images/file_header.h"

#include <cstdint>

#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {
namespace {

using std::string_view_literals::operator""sv;

// Progressive files of cameras and programs have about ten.
constexpr int kMostJpegScans = 100;

int64_t BigEndian(std::string_view bytes, size_t at, size_t count) {
  int64_t value = 0;
  for (size_t i = 0; i < count; ++i) value = value << 8 | static_cast<uint8_t>(bytes[at + i]);
  return value;
}

absl::StatusOr<FileHeader> Sized(const char* name, const char* mime_type, int64_t width, int64_t height) {
  if (width < 1 || height < 1 || width > INT32_MAX || height > INT32_MAX)
    return InvalidArgument("is said to be {} x {} px", width, height);
  return FileHeader{name, mime_type, static_cast<int>(width), static_cast<int>(height)};
}

absl::StatusOr<FileHeader> ReadPng(std::string_view bytes) {
  if (bytes.size() < 33 || bytes.substr(12, 4) != "IHDR")
    return absl::InvalidArgumentError("is a PNG that ends in its header");
  return Sized("picture.png", "image/png", BigEndian(bytes, 16, 4), BigEndian(bytes, 20, 4));
}

absl::StatusOr<FileHeader> ReadJpeg(std::string_view bytes) {
  int scans = 0;
  for (size_t at = bytes.find("\xFF\xDA"sv); at != std::string_view::npos; at = bytes.find("\xFF\xDA"sv, at + 2))
    ++scans;
  if (scans > kMostJpegScans) return InvalidArgument("is a JPEG of {} scans; at most {}", scans, kMostJpegScans);
  // Segments from the start: marker, length, content; the frame header (SOF) says the size.
  for (size_t at = 2; at + 9 < bytes.size();) {
    if (bytes[at] != '\xFF') break;
    const int marker = static_cast<uint8_t>(bytes[at + 1]);
    if (marker == 0xFF) {
      ++at;
      continue;
    }
    const bool is_frame = marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
    if (is_frame) return Sized("picture.jpg", "image/jpeg", BigEndian(bytes, at + 7, 2), BigEndian(bytes, at + 5, 2));
    at += 2 + static_cast<size_t>(BigEndian(bytes, at + 2, 2));
  }
  return absl::InvalidArgumentError("is a JPEG that ends in its header");
}

}  // namespace

absl::StatusOr<FileHeader> ReadFileHeader(std::string_view bytes) {
  if (bytes.empty()) return absl::InvalidArgumentError("is empty");
  if (bytes.starts_with("\x89PNG\r\n\x1A\n"sv)) return ReadPng(bytes);
  if (bytes.starts_with("\xFF\xD8\xFF"sv)) return ReadJpeg(bytes);
  if (bytes.starts_with("II*\0"sv) || bytes.starts_with("MM\0*"sv)) return FileHeader{"picture.tif", nullptr, 0, 0};
  return absl::InvalidArgumentError("is none of PNG, JPEG and TIFF");
}

}  // namespace flair::renderer
