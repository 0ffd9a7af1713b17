// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace flair::renderer::gltf {

struct ImageHeader {
  std::string_view mime_type;  // "image/png" or "image/jpeg"
  int width_px = 0;
  int height_px = 0;
};

// What the first bytes of a PNG or JPEG file say; nothing for other files. Decodes no pixel.
std::optional<ImageHeader> ReadImageHeader(std::string_view bytes);

}  // namespace flair::renderer::gltf
