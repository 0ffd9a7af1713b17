// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/gltf/image_header.h"

#include <cstdint>

namespace flair::renderer::gltf {
namespace {

uint32_t BigEndian(std::string_view bytes, size_t offset, size_t count) {
  uint32_t value = 0;
  for (size_t i = 0; i < count; ++i) value = value << 8 | static_cast<uint8_t>(bytes[offset + i]);
  return value;
}

// Segments of a JPEG up to the frame that tells its size.
std::optional<ImageHeader> ReadJpeg(std::string_view bytes) {
  size_t at = 2;
  while (at + 9 <= bytes.size() && static_cast<uint8_t>(bytes[at]) == 0xFF) {
    const uint32_t marker = static_cast<uint8_t>(bytes[at + 1]);
    const bool frame = marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
    if (frame) {
      return ImageHeader{"image/jpeg", static_cast<int>(BigEndian(bytes, at + 7, 2)),
                         static_cast<int>(BigEndian(bytes, at + 5, 2))};
    }
    at += 2 + BigEndian(bytes, at + 2, 2);
  }
  return std::nullopt;
}

}  // namespace

std::optional<ImageHeader> ReadImageHeader(std::string_view bytes) {
  if (bytes.size() >= 33 && bytes.starts_with("\x89PNG\r\n\x1A\n") && bytes.substr(12, 4) == "IHDR") {
    const uint32_t width = BigEndian(bytes, 16, 4);
    const uint32_t height = BigEndian(bytes, 20, 4);
    if (width > INT32_MAX || height > INT32_MAX) return std::nullopt;
    return ImageHeader{"image/png", static_cast<int>(width), static_cast<int>(height)};
  }
  if (bytes.starts_with("\xFF\xD8\xFF")) return ReadJpeg(bytes);
  return std::nullopt;
}

}  // namespace flair::renderer::gltf
