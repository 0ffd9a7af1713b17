// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#include "renderer_worker/gltf/asset_primitive.h"
#include "renderer_worker/gltf/limited_json.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::renderer::gltf {
namespace {

constexpr uint32_t kMagic = 0x46546C67;
constexpr uint32_t kJsonChunk = 0x4E4F534A;
constexpr uint32_t kBinaryChunk = 0x004E4942;

// A parsed number takes several times the room of its text.
constexpr size_t kMaxJsonBytes = size_t{32} << 20;

// Extensions that a file may require without our reading it wrong.
constexpr std::array<std::string_view, 4> kReadable = {"KHR_lights_punctual", "KHR_mesh_quantization",
                                                       "KHR_texture_transform", "KHR_xmp_json_ld"};

uint32_t WordAt(std::string_view bytes, size_t offset) {
  uint32_t word = 0;
  std::memcpy(&word, bytes.data() + offset, sizeof word);
  return word;
}

size_t SizeOf(int component_type) {
  constexpr size_t kSizes[] = {1, 1, 2, 2, 0, 4, 4};  // from 5120 on: int8, uint8, int16, uint16, none, uint32, float
  return component_type < 5120 || component_type > 5126 ? 0 : kSizes[component_type - 5120];
}

template <typename T>
T ValueAt(std::string_view bytes, size_t offset) {
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

// Normalised or plain, as glTF 2.0, 3.6.2.2 and 3.11 have it.
float ComponentAt(std::string_view bytes, size_t offset, int component_type, bool normalized) {
  const auto signed_value = [&](float value, float most) { return normalized ? std::max(value / most, -1.0F) : value; };
  switch (component_type) {
    case 5120:
      return signed_value(ValueAt<int8_t>(bytes, offset), 127);
    case 5121:
      return signed_value(ValueAt<uint8_t>(bytes, offset), 255);
    case 5122:
      return signed_value(ValueAt<int16_t>(bytes, offset), 32767);
    case 5123:
      return signed_value(ValueAt<uint16_t>(bytes, offset), 65535);
    case 5125:
      return static_cast<float>(ValueAt<uint32_t>(bytes, offset));
    default:
      return ValueAt<float>(bytes, offset);
  }
}

absl::Status CheckRequired(const nlohmann::json& json) {
  for (const nlohmann::json& name : ArrayOf(json, "extensionsRequired")) {
    if (!name.is_string()) continue;
    const std::string& extension = name.get_ref<const std::string&>();
    if (extension.starts_with("KHR_materials_")) continue;
    if (std::ranges::find(kReadable, extension) == kReadable.end()) {
      return Unimplemented("it requires {}, which is not read", extension.substr(0, 80));
    }
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<AssetFile> AssetFile::Open(std::string_view bytes) {
  if (bytes.size() < 20 || WordAt(bytes, 0) != kMagic) return InvalidArgument("it is no GLB file");
  if (WordAt(bytes, 4) != 2) return InvalidArgument("it is glTF {}, must be 2", WordAt(bytes, 4));
  const size_t length = WordAt(bytes, 8);
  if (length > bytes.size()) return InvalidArgument("it says it has {} bytes, there are {}", length, bytes.size());
  bytes = bytes.substr(0, std::max<size_t>(length, 20));
  const size_t json_size = WordAt(bytes, 12);
  if (WordAt(bytes, 16) != kJsonChunk || json_size > bytes.size() - 20) {
    return InvalidArgument("its JSON of {} bytes is not in the file", json_size);
  }
  if (json_size > kMaxJsonBytes) {
    return ResourceExhausted("its JSON has {} bytes, {} at most are read", json_size, kMaxJsonBytes);
  }
  AssetFile file;
  ASSIGN_OR_RETURN(file.json_, ParseLimitedJson(bytes.substr(20, json_size)));
  RETURN_IF_ERROR(CheckRequired(file.json_));
  const size_t binary = 20 + (json_size + 3) / 4 * 4;
  if (bytes.size() >= binary + 8 && WordAt(bytes, binary + 4) == kBinaryChunk) {
    const size_t size = WordAt(bytes, binary);
    if (size > bytes.size() - binary - 8) return InvalidArgument("its {} binary bytes are not in the file", size);
    file.binary_ = bytes.substr(binary + 8, size);
  }
  return file;
}

const nlohmann::json* AssetFile::Item(const char* array, size_t index) const {
  const nlohmann::json& items = ArrayOf(json_, array);
  return index < items.size() && items[index].is_object() ? &items[index] : nullptr;
}

absl::StatusOr<std::string_view> AssetFile::View(size_t index) const {
  const nlohmann::json* view = Item("bufferViews", index);
  if (view == nullptr) return InvalidArgument("there is no buffer view {}", index);
  if (CountOf(*view, "buffer") != 0) return InvalidArgument("buffer view {} is of another file", index);
  const nlohmann::json* buffer = Item("buffers", 0);
  if (buffer == nullptr || Find(*buffer, "uri") != nullptr) return InvalidArgument("its buffer is in another file");
  const size_t offset = CountOf(*view, "byteOffset").value_or(0);
  const std::optional<size_t> length = CountOf(*view, "byteLength");
  if (!length.has_value() || offset > binary_.size() || *length > binary_.size() - offset) {
    return InvalidArgument("buffer view {} leaves the {} bytes of the file", index, binary_.size());
  }
  return binary_.substr(offset, *length);
}

absl::StatusOr<AssetFile::Elements> AssetFile::ElementsOf(size_t accessor, std::string_view type, size_t components,
                                                          size_t max_count) const {
  const nlohmann::json* json = Item("accessors", accessor);
  if (json == nullptr) return InvalidArgument("there is no accessor {}", accessor);
  if (TextOf(*json, "type") != type) return InvalidArgument("accessor {} must be {}", accessor, type);
  if (Find(*json, "sparse") != nullptr) return absl::UnimplementedError("sparse accessors are not read");
  Elements elements;
  elements.component_type = static_cast<int>(std::min<size_t>(CountOf(*json, "componentType").value_or(0), 9999));
  const size_t size = SizeOf(elements.component_type) * components;
  if (size == 0) return InvalidArgument("accessor {} has components of no known type", accessor);
  const nlohmann::json* normalized = Find(*json, "normalized");
  elements.normalized = normalized != nullptr && normalized->is_boolean() && normalized->get<bool>();
  const std::optional<size_t> count = CountOf(*json, "count");
  if (!count.has_value() || *count == 0) return InvalidArgument("accessor {} has no count", accessor);
  if (*count > max_count) {
    return ResourceExhausted("accessor {} has {} elements, {} at most are read here", accessor, *count, max_count);
  }
  elements.count = *count;
  const std::optional<size_t> view_index = CountOf(*json, "bufferView");
  if (!view_index.has_value()) return InvalidArgument("accessor {} has no buffer view", accessor);
  ASSIGN_OR_RETURN(std::string_view view, View(*view_index));
  elements.stride = CountOf(*Item("bufferViews", *view_index), "byteStride").value_or(size);
  const size_t offset = CountOf(*json, "byteOffset").value_or(0);
  // `count` is bounded and so is a stride that fits the view: no product overflows.
  if (elements.stride < size || elements.stride > 252 + size || offset > view.size() ||
      (elements.count - 1) * elements.stride + size > view.size() - offset) {
    return InvalidArgument("accessor {} leaves its buffer view", accessor);
  }
  elements.bytes = view.substr(offset);
  return elements;
}

absl::StatusOr<std::vector<float>> AssetFile::Numbers(size_t accessor, std::string_view type, size_t components,
                                                      size_t max_count) const {
  ASSIGN_OR_RETURN(Elements elements, ElementsOf(accessor, type, components, max_count));
  std::vector<float> numbers;
  numbers.reserve(elements.count * components);
  const size_t size = SizeOf(elements.component_type);
  for (size_t i = 0; i < elements.count; ++i) {
    for (size_t c = 0; c < components; ++c) {
      numbers.push_back(
          ComponentAt(elements.bytes, i * elements.stride + c * size, elements.component_type, elements.normalized));
    }
  }
  return numbers;
}

absl::StatusOr<std::vector<uint32_t>> AssetFile::Indices(size_t accessor, size_t bound, size_t max_count) const {
  ASSIGN_OR_RETURN(Elements elements, ElementsOf(accessor, "SCALAR", 1, max_count));
  const int type = elements.component_type;
  if (type != 5121 && type != 5123 && type != 5125) return InvalidArgument("accessor {} holds no indices", accessor);
  std::vector<uint32_t> indices;
  indices.reserve(elements.count);
  for (size_t i = 0; i < elements.count; ++i) {
    const size_t at = i * elements.stride;
    const uint32_t index = type == 5121   ? ValueAt<uint8_t>(elements.bytes, at)
                           : type == 5123 ? ValueAt<uint16_t>(elements.bytes, at)
                                          : ValueAt<uint32_t>(elements.bytes, at);
    if (index >= bound)
      return InvalidArgument("index {} of accessor {} is not a vertex, there are {}", index, accessor, bound);
    indices.push_back(index);
  }
  return indices;
}

}  // namespace flair::renderer::gltf
