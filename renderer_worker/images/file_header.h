// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "absl/status/statusor.h"

namespace flair::renderer {

// What the first bytes of an image file say, found without any image library.
struct FileHeader {
  const char* file_name = nullptr;  // a name with the ending of the format
  const char* mime_type = nullptr;  // "image/png" or "image/jpeg"; null for TIFF, which glTF does not know
  int width_px = 0;                 // 0 where only a decoder can tell (TIFF)
  int height_px = 0;
};

// INVALID_ARGUMENT when it is no PNG, JPEG or TIFF, or a JPEG of so many scans that decoding it would take hours.
absl::StatusOr<FileHeader> ReadFileHeader(std::string_view bytes);

}  // namespace flair::renderer
