// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/gltf/write_mesh_glb.h"

#include <utility>

#include "fmt/format.h"
#include "renderer_worker/gltf/mesh_book.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {

absl::StatusOr<std::string> WriteMeshGlb(const Mesh& mesh, const std::string& name) {
  tinygltf::Model model;
  gltf::GlbBuffer buffer(model);
  gltf::MaterialBook materials(model, buffer);
  gltf::MeshBook meshes(model, buffer, materials);
  ASSIGN_OR_RETURN(int number, meshes.NumberOf(mesh, gltf::MeshFrame::kObject, name));
  if (number < 0) return absl::InternalError(fmt::format("the mesh of {} has no triangles", name));
  buffer.Finish();
  tinygltf::Node node;
  node.name = name;
  node.mesh = number;
  model.nodes.push_back(std::move(node));
  tinygltf::Scene scene;
  scene.nodes = {0};
  model.scenes.push_back(std::move(scene));
  model.defaultScene = 0;
  model.asset.version = "2.0";
  model.asset.generator = "Flair";
  return gltf::GlbText(model);
}

}  // namespace flair::renderer
