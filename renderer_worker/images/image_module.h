// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

// The border between our programs and the module `flair_image_writer`, which alone links OpenImageIO. Both sides are of
// one build and share the standard library; nothing else crosses, and no exception does.
namespace flair::renderer {

inline constexpr int kImageModuleVersion = 3;
inline constexpr char kImageModuleSymbol[] = "flair_image_module";

// Name and value, in the order they are written. PNG and EXR keep all; JPEG and TIFF keep names that they know, and get
// the rest as lines "name: value" of their ImageDescription.
using ImageMetadata = std::vector<std::pair<std::string, std::string>>;

// How the values of a channel are stored. All come as 32 bits: floating point for the first two, unsigned for the last.
enum class ChannelStorage : int32_t { kHalf = 0, kFloat = 1, kUint32 = 2 };

// One channel of a picture of many: value i of pixel p is values[p * stride + offset], 4 bytes each.
struct EncoderChannel {
  std::string name;
  ChannelStorage storage;
  const void* values;
  size_t stride;
  size_t offset;
};

struct EncoderRequest {
  std::string file_name;  // only its ending counts: it chooses the format
  int width_px = 0;
  int height_px = 0;
  const uint8_t* rgb = nullptr;  // width * height * 3; null when there are channels
  std::vector<EncoderChannel> channels;
  double dots_per_inch = 0;  // 0: not said
  ImageMetadata metadata;
};

struct DecoderRequest {
  std::string file_name;  // only its ending counts: it chooses the format
  const void* bytes;
  size_t byte_count;
  int max_side_px;             // a larger picture is refused before its pixels are read
  uint64_t max_decoded_bytes;  // of all its pixels as stored
};

// Takes a picture as it is decoded.
class RowSink {
 public:
  virtual ~RowSink() = default;
  // Size of the picture, before its first row. May throw std::bad_alloc.
  virtual void Start(int width_px, int height_px) = 0;
  // One row from the top: width * 3 values of 8 bits, what is transparent over white.
  virtual void Row(const uint8_t* rgb) = 0;
};

struct ImageModule {
  int version;
  // Both return what went wrong, empty when nothing did; kNoMemory for memory.
  std::string (*encode)(const EncoderRequest& request, std::string& file);
  std::string (*decode)(const DecoderRequest& request, RowSink& sink);
};

inline constexpr char kNoMemory[] = "no memory";

}  // namespace flair::renderer
