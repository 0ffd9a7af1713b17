// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace flair::renderer {

// The border between our programs and the module `flair_image_writer`, which alone links OpenImageIO. Plain data only:
// nothing with a destructor or an exception crosses it.
inline constexpr int kEncoderModuleVersion = 1;
inline constexpr char kEncoderModuleSymbol[] = "flair_image_encoder";

struct EncoderMetadata {
  const char* name;
  const char* value;  // UTF-8
};

struct EncoderRequest {
  const char* file_name;  // only its ending counts: it chooses the format
  int width_px;
  int height_px;
  const uint8_t* rgb;  // width * height * 3
  const EncoderMetadata* metadata;
  size_t metadata_count;
};

// Called once or more with parts of the file, or of an error message.
using EncoderSink = void (*)(void* context, const char* bytes, size_t count);

struct EncoderModule {
  int version;
  // True when the file was encoded; otherwise `error` was told why.
  bool (*encode)(const EncoderRequest& request, EncoderSink file, EncoderSink error, void* context);
};

}  // namespace flair::renderer
