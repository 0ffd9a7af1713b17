// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "renderer_worker/gltf/tiny_gltf.h"
#include "renderer_worker/scene/vector.h"

namespace flair::renderer::gltf {

// Vertices and indices of one primitive, in glTF's frame. `uvs` may be empty.
struct Vertices {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;
  std::vector<Vec2> uvs;
  std::vector<uint32_t> indices;
};

// Collects what goes into the binary chunk and describes it in the model: vertices interleaved in one view per stride,
// indices in one view per width, images in views of their own. Every offset is a multiple of 4.
class GlbBuffer {
 public:
  // `model` must outlive this.
  explicit GlbBuffer(tinygltf::Model& model) : model_(model) {}

  // A primitive without material. Positions must not be empty and every index must be one of them.
  tinygltf::Primitive Add(const Vertices& vertices);

  // Number of the image.
  int AddImage(std::string_view mime_type, std::string_view bytes);

  // Puts all together; call once, at the end.
  void Finish();

 private:
  struct Section {
    std::vector<unsigned char> bytes;
    std::vector<int> accessors;
  };
  int AddAccessor(Section& section, size_t offset, int component_type, int type, size_t count);
  void FinishSection(Section& section, int target, size_t stride);

  tinygltf::Model& model_;
  Section plain_;     // position, normal: 24 bytes
  Section textured_;  // position, normal, uv: 32 bytes
  Section short_indices_;
  Section long_indices_;
  std::vector<std::vector<unsigned char>> images_;
};

}  // namespace flair::renderer::gltf
