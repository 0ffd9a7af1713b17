// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/gltf/glb_buffer.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>

namespace flair::renderer::gltf {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF is little-endian and so are the machines we build for");

template <typename T>
void Append(std::vector<unsigned char>& bytes, const T& value) {
  const auto* first = reinterpret_cast<const unsigned char*>(&value);
  bytes.insert(bytes.end(), first, first + sizeof(T));
}

void Pad(std::vector<unsigned char>& bytes) { bytes.resize((bytes.size() + 3) / 4 * 4); }

}  // namespace

int GlbBuffer::AddAccessor(Section& section, size_t offset, int component_type, int type, size_t count) {
  tinygltf::Accessor accessor;
  accessor.byteOffset = offset;
  accessor.componentType = component_type;
  accessor.type = type;
  accessor.count = count;
  section.accessors.push_back(static_cast<int>(model_.accessors.size()));
  model_.accessors.push_back(std::move(accessor));
  return section.accessors.back();
}

tinygltf::Primitive GlbBuffer::Add(const Vertices& vertices) {
  const size_t count = vertices.positions.size();
  const bool textured = !vertices.uvs.empty();
  Section& section = textured ? textured_ : plain_;
  const size_t offset = section.bytes.size();
  Vec3 low{std::numeric_limits<float>::max(), std::numeric_limits<float>::max(), std::numeric_limits<float>::max()};
  Vec3 high = -low;
  section.bytes.reserve(offset + count * (textured ? 32 : 24));
  for (size_t i = 0; i < count; ++i) {
    const Vec3 p = vertices.positions[i];
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    Append(section.bytes, p);
    Append(section.bytes, vertices.normals[i]);
    if (textured) Append(section.bytes, vertices.uvs[i]);
  }
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  const int positions = AddAccessor(section, offset, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, count);
  model_.accessors[positions].minValues = {low.x, low.y, low.z};
  model_.accessors[positions].maxValues = {high.x, high.y, high.z};
  primitive.attributes["POSITION"] = positions;
  primitive.attributes["NORMAL"] =
      AddAccessor(section, offset + 12, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, count);
  if (textured) {
    primitive.attributes["TEXCOORD_0"] =
        AddAccessor(section, offset + 24, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC2, count);
  }

  // 65535 would be the primitive restart value.
  const bool is_short = count < 65535;
  Section& indices = is_short ? short_indices_ : long_indices_;
  Pad(indices.bytes);
  const size_t first = indices.bytes.size();
  for (const uint32_t index : vertices.indices) {
    if (is_short) {
      Append(indices.bytes, static_cast<uint16_t>(index));
    } else {
      Append(indices.bytes, index);
    }
  }
  primitive.indices = AddAccessor(
      indices, first, is_short ? TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT : TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
      TINYGLTF_TYPE_SCALAR, vertices.indices.size());
  return primitive;
}

int GlbBuffer::AddImage(std::string_view mime_type, std::string_view bytes) {
  tinygltf::Image image;
  image.mimeType = mime_type;
  images_.emplace_back(bytes.begin(), bytes.end());
  model_.images.push_back(std::move(image));
  return static_cast<int>(model_.images.size()) - 1;
}

void GlbBuffer::FinishSection(Section& section, int target, size_t stride) {
  if (section.bytes.empty()) return;
  std::vector<unsigned char>& bytes = model_.buffers.front().data;
  Pad(bytes);
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = bytes.size();
  view.byteLength = section.bytes.size();
  view.byteStride = stride;
  view.target = target;
  for (const int accessor : section.accessors) {
    model_.accessors[accessor].bufferView = static_cast<int>(model_.bufferViews.size());
  }
  model_.bufferViews.push_back(std::move(view));
  bytes.insert(bytes.end(), section.bytes.begin(), section.bytes.end());
}

void GlbBuffer::Finish() {
  model_.buffers.emplace_back();
  FinishSection(plain_, TINYGLTF_TARGET_ARRAY_BUFFER, 24);
  FinishSection(textured_, TINYGLTF_TARGET_ARRAY_BUFFER, 32);
  FinishSection(short_indices_, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER, 0);
  FinishSection(long_indices_, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER, 0);
  for (size_t i = 0; i < images_.size(); ++i) {
    Section image{std::move(images_[i]), {}};
    model_.images[i].bufferView = static_cast<int>(model_.bufferViews.size());
    FinishSection(image, 0, 0);
  }
  Pad(model_.buffers.front().data);
}

}  // namespace flair::renderer::gltf
