// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "renderer_worker/gltf/gltf.h"
#include "renderer_worker/scene/mesh.h"

namespace flair::renderer::gltf {

// A GLB that a stranger made, opened: its JSON and its binary chunk. Nothing in the JSON is trusted: every number is
// checked where it is used. Borrows the file's bytes.
class AssetFile {
 public:
  // INVALID_ARGUMENT says what of the container is wrong; UNIMPLEMENTED names what it requires and we cannot read.
  static absl::StatusOr<AssetFile> Open(std::string_view bytes);

  const nlohmann::json& json() const { return json_; }

  // Element `index` of a top-level array, null when there is none.
  const nlohmann::json* Item(const char* array, size_t index) const;

  // The bytes of a buffer view. INVALID_ARGUMENT when they are not in the file.
  absl::StatusOr<std::string_view> View(size_t index) const;

  // An accessor's elements as numbers, `components` each, integers as glTF's normalisation has it; what `type` the
  // accessor must have: "VEC3" and the like. At most `max_count` elements: more is RESOURCE_EXHAUSTED.
  absl::StatusOr<std::vector<float>> Numbers(size_t accessor, std::string_view type, size_t components,
                                             size_t max_count) const;

  // An accessor of unsigned integers, each below `bound`.
  absl::StatusOr<std::vector<uint32_t>> Indices(size_t accessor, size_t bound, size_t max_count) const;

 private:
  struct Elements {
    std::string_view bytes;  // from the first element on
    size_t stride = 0;
    size_t count = 0;
    int component_type = 0;
    bool normalized = false;
  };
  absl::StatusOr<Elements> ElementsOf(size_t accessor, std::string_view type, size_t components,
                                      size_t max_count) const;

  nlohmann::json json_;
  std::string_view binary_;
};

// How a picture's coordinates come from a vertex's (KHR_texture_transform): scaled, turned, moved.
struct UvUse {
  int set = 0;  // of TEXCOORD_
  Vec2 offset;
  Vec2 scale{1, 1};
  float rotation_rad = 0;
  Vec2 Of(Vec2 uv) const;
};

struct AssetMaterial {
  Material material;
  UvUse uv;
};

// The materials of a file, read when first asked for. Never fails: what is wrong becomes the default, what is left out
// is added to the notes.
class AssetMaterials {
 public:
  // Both must outlive this.
  AssetMaterials(const AssetFile& file, std::vector<std::string>& notes) : file_(file), notes_(notes) {}

  // `index` as a primitive names it, or any number for none.
  const AssetMaterial& At(size_t index);

 private:
  AssetMaterial Read(const nlohmann::json& json);
  void ReadTexture(const nlohmann::json& info, AssetMaterial& material);
  std::shared_ptr<const SurfaceImage> ImageAt(size_t texture);

  const AssetFile& file_;
  std::vector<std::string>& notes_;
  std::map<size_t, AssetMaterial> read_;
  std::map<size_t, std::shared_ptr<const SurfaceImage>> images_;
  std::map<std::string, int> names_;
};

// An affine map: p' = columns[0] x + columns[1] y + columns[2] z + columns[3].
struct Affine {
  std::array<Vec3, 4> columns = {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{}};

  Vec3 Direction(Vec3 v) const { return columns[0] * v.x + columns[1] * v.y + columns[2] * v.z; }
  Vec3 Point(Vec3 p) const { return Direction(p) + columns[3]; }
  // Normals go by the cofactors, which are right for uneven scales and for maps that flatten; not of unit length.
  Vec3 Normal(Vec3 n) const {
    return Cross(columns[1], columns[2]) * n.x + Cross(columns[2], columns[0]) * n.y +
           Cross(columns[0], columns[1]) * n.z;
  }
  // Of volumes; negative for a mirror.
  float Determinant() const { return Dot(columns[0], Cross(columns[1], columns[2])); }
};

// First `inner`, then `outer`.
Affine operator*(const Affine& outer, const Affine& inner);

// A node's own transform: its matrix, or translation, rotation and scale. What is no number counts as left out.
Affine TransformOf(const nlohmann::json& node);

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
