// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "renderer_worker/gltf/glb_buffer.h"
#include "renderer_worker/gltf/material_book.h"
#include "renderer_worker/scene/mesh.h"

namespace flair::renderer::gltf {

// Which frame a mesh is in: R for the shell, O for furniture.
enum class MeshFrame { kRoom, kObject };

// The meshes of a file; those with equal content and frame are one.
class MeshBook {
 public:
  // All must outlive this.
  MeshBook(tinygltf::Model& model, GlbBuffer& buffer, MaterialBook& materials)
      : model_(model), buffer_(buffer), materials_(materials) {}

  // Number of the mesh in the file, -1 for one without triangles. `mesh` must outlive this; the first of equal meshes
  // gives the name. INTERNAL for a mesh that is not sound: arrays of different lengths, numbers that are not finite,
  // indices of no vertex.
  absl::StatusOr<int> NumberOf(const Mesh& mesh, MeshFrame frame, const std::string& name);

 private:
  struct Written {
    const Mesh* mesh;
    MeshFrame frame;
    int number;
  };
  int Write(const Mesh& mesh, MeshFrame frame, const std::string& name);

  tinygltf::Model& model_;
  GlbBuffer& buffer_;
  MaterialBook& materials_;
  std::map<uint64_t, std::vector<Written>> written_;  // by digest of the content
};

}  // namespace flair::renderer::gltf
