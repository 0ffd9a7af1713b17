// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace flair::renderer {

// The border between our programs and the module `flair_image_writer`, which alone links OpenImageIO. Plain data only:
// nothing with a destructor or an exception crosses it.
inline constexpr int kEncoderModuleVersion = 2;
inline constexpr char kEncoderModuleSymbol[] = "flair_image_encoder";

struct EncoderMetadata {
  const char* name;
  const char* value;  // UTF-8
};

// How the values of a channel are stored. All come as 32 bits: floating point for the first two, unsigned for the last.
enum class ChannelStorage : int32_t { kHalf = 0, kFloat = 1, kUint32 = 2 };

// One channel of a picture of many: value i of pixel p is values[p * stride + offset], 4 bytes each.
struct EncoderChannel {
  const char* name;
  ChannelStorage storage;
  const void* values;
  size_t stride;
  size_t offset;
};

struct EncoderRequest {
  const char* file_name;  // only its ending counts: it chooses the format
  int width_px;
  int height_px;
  const uint8_t* rgb;  // width * height * 3; null when there are channels
  const EncoderChannel* channels;
  size_t channel_count;
  double dots_per_inch;  // 0: not said
  const EncoderMetadata* metadata;
  size_t metadata_count;
};

// Called once or more with parts of the file, or of an error message.
using EncoderSink = void (*)(void* context, const char* bytes, size_t count);

struct DecoderRequest {
  const char* file_name;  // only its ending counts: it chooses the format
  const void* bytes;
  size_t byte_count;
  int max_side_px;             // a larger picture is refused before its pixels are read
  uint64_t max_decoded_bytes;  // of all its pixels as stored
};

// Size of the picture, before its first row. False: do not go on.
using DecoderStart = bool (*)(void* context, int width_px, int height_px);
// One row from the top: width * 3 values of 8 bits, what is transparent over white. False: do not go on.
using DecoderRow = bool (*)(void* context, const uint8_t* rgb);

struct EncoderModule {
  int version;
  // True when the file was encoded; otherwise `error` was told why.
  bool (*encode)(const EncoderRequest& request, EncoderSink file, EncoderSink error, void* context);
  // True when all rows were told; otherwise `error` was told why, unless `start` or `row` wanted no more.
  bool (*decode)(const DecoderRequest& request, DecoderStart start, DecoderRow row, EncoderSink error, void* context);
};

}  // namespace flair::renderer
