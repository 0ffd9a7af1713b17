// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "renderer_worker/gltf/asset_file.h"
#include "renderer_worker/gltf/asset_materials.h"
#include "renderer_worker/gltf/node_matrix.h"
#include "renderer_worker/gltf/read_asset.h"

namespace flair::renderer::gltf {

// Adds the triangles of a file's meshes to an asset, one part per material.
class PrimitiveReader {
 public:
  // Both must outlive this.
  PrimitiveReader(const AssetFile& file, AssetMesh& asset)
      : file_(file), asset_(asset), materials_(file, asset.notes) {}

  // All triangles of mesh `index`, moved by `transform`. Errors as ReadAsset.
  absl::Status AddMesh(size_t index, const Affine& transform);

 private:
  struct Primitive {
    std::vector<Vec3> positions;
    std::vector<Vec3> normals;  // empty when the file has none
    std::vector<Vec2> uvs;      // the same
    std::vector<uint32_t> indices;
    Vec3 tint{1, 1, 1};  // mean of the vertices' colours
  };
  absl::Status AddPrimitive(const nlohmann::json& json, const Affine& transform);
  absl::StatusOr<Primitive> Read(const nlohmann::json& json, const AssetMaterial& material) const;
  absl::StatusOr<std::vector<uint32_t>> Triangles(const nlohmann::json& json, size_t vertex_count) const;
  MeshPart& PartOf(size_t material_index, const AssetMaterial& material, Vec3 tint);

  const AssetFile& file_;
  AssetMesh& asset_;
  AssetMaterials materials_;
  std::map<size_t, size_t> parts_;  // material -> part
  size_t read_vertex_count_ = 0;
  size_t vertex_count_ = 0;
  size_t triangle_count_ = 0;
};

}  // namespace flair::renderer::gltf
