// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/gltf/gltf.h"

#include <optional>
#include <set>

#include "renderer_worker/gltf/asset_primitive.h"
#include "renderer_worker/gltf/limited_json.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {
namespace {

using gltf::Affine;
using Json = nlohmann::json;

constexpr size_t kMaxNodes = 100000;
constexpr int kMaxNodeDepth = 200;
constexpr size_t kMaxNotes = 20;

std::optional<Vec3> AxisOf(std::string_view name) {
  if (name.size() != 2 || (name[0] != '+' && name[0] != '-')) return std::nullopt;
  const float sign = name[0] == '+' ? 1.0F : -1.0F;
  if (name[1] == 'x') return Vec3{sign, 0, 0};
  if (name[1] == 'y') return Vec3{0, sign, 0};
  if (name[1] == 'z') return Vec3{0, 0, sign};
  return std::nullopt;
}

// From the file's axes to an object's. Valid axes only.
Affine TurnOf(const AssetAxes& axes) {
  const Vec3 front = *AxisOf(axes.front);
  const Vec3 up = *AxisOf(axes.up);
  const Vec3 right = Cross(front, up);
  Affine turn;
  turn.columns = {Vec3{right.x, front.x, up.x}, Vec3{right.y, front.y, up.y}, Vec3{right.z, front.z, up.z}, Vec3{}};
  return turn;
}

// Walks the nodes of the default scene and collects their meshes.
class Walk {
 public:
  Walk(const gltf::AssetFile& file, AssetMesh& asset) : file_(file), primitives_(file, asset) {}

  absl::Status Visit(size_t index, const Affine& outer, int depth) {
    const Json* node = file_.Item("nodes", index);
    if (node == nullptr) return InvalidArgument("there is no node {}", index);
    if (depth > kMaxNodeDepth || ++visited_ > kMaxNodes) {
      return ResourceExhausted("its nodes go round or are more than {} or {} deep", kMaxNodes, kMaxNodeDepth);
    }
    const Affine transform = outer * gltf::TransformOf(*node);
    if (const std::optional<size_t> mesh = CountOf(*node, "mesh")) {
      RETURN_IF_ERROR(primitives_.AddMesh(*mesh, transform));
    }
    for (const Json& child : ArrayOf(*node, "children")) {
      if (!child.is_number_unsigned()) return InvalidArgument("node {} has a child of no number", index);
      RETURN_IF_ERROR(Visit(child.get<size_t>(), transform, depth + 1));
    }
    return absl::OkStatus();
  }

  absl::Status VisitAll(const Affine& turn) {
    const std::vector<size_t> roots = Roots();
    for (const size_t root : roots) RETURN_IF_ERROR(Visit(root, turn, 0));
    return absl::OkStatus();
  }

 private:
  // Of the default scene; without scenes, all nodes that are nobody's child.
  std::vector<size_t> Roots() const {
    std::vector<size_t> roots;
    const Json* scene = file_.Item("scenes", CountOf(file_.json(), "scene").value_or(0));
    if (scene != nullptr) {
      for (const Json& node : ArrayOf(*scene, "nodes")) {
        if (node.is_number_unsigned()) roots.push_back(node.get<size_t>());
      }
      return roots;
    }
    std::set<size_t> children;
    const Json& nodes = ArrayOf(file_.json(), "nodes");
    for (const Json& node : nodes) {
      for (const Json& child : ArrayOf(node, "children")) {
        if (child.is_number_unsigned()) children.insert(child.get<size_t>());
      }
    }
    for (size_t i = 0; i < nodes.size(); ++i) {
      if (!children.contains(i)) roots.push_back(i);
    }
    return roots;
  }

  const gltf::AssetFile& file_;
  gltf::PrimitiveReader primitives_;
  size_t visited_ = 0;
};

}  // namespace

absl::Status CheckAxes(const AssetAxes& axes) {
  const std::optional<Vec3> front = AxisOf(axes.front);
  const std::optional<Vec3> up = AxisOf(axes.up);
  if (!front.has_value() || !up.has_value() || Dot(*front, *up) != 0) {
    return InvalidArgument("front '{}' and up '{}' must be two different axes of +x, -x, +y, -y, +z, -z",
                           axes.front.substr(0, 20), axes.up.substr(0, 20));
  }
  return absl::OkStatus();
}

absl::StatusOr<AssetMesh> ReadAsset(std::string_view bytes, const AssetAxes& axes) {
  RETURN_IF_ERROR(CheckAxes(axes));
  if (bytes.size() > kMaxAssetBytes) {
    return ResourceExhausted("it has {} bytes, {} at most are read", bytes.size(), kMaxAssetBytes);
  }
  ASSIGN_OR_RETURN(gltf::AssetFile file, gltf::AssetFile::Open(bytes));
  AssetMesh asset;
  RETURN_IF_ERROR(Walk(file, asset).VisitAll(TurnOf(axes)));
  if (asset.mesh.parts.empty()) return absl::NotFoundError("it has no triangles");
  if (asset.notes.size() > kMaxNotes) asset.notes.resize(kMaxNotes);
  return asset;
}

}  // namespace flair::renderer
