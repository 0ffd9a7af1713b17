// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "renderer_worker/gltf/extras.h"
#include "renderer_worker/gltf/frame.h"
#include "renderer_worker/gltf/glb_buffer.h"
#include "renderer_worker/gltf/material_book.h"
#include "renderer_worker/gltf/mesh_book.h"
#include "renderer_worker/gltf/write_glb.h"

namespace flair::renderer::gltf {

// Makes the model of one scene: a root with the groups shell, furniture, lights and cameras.
class SceneWriter {
 public:
  explicit SceneWriter(const Scene& scene) : scene_(scene), extras_(*scene.layout) {}

  // Call once. Errors as WriteGlb.
  absl::StatusOr<tinygltf::Model> Write(const GlbMetadata& metadata);

 private:
  using Group = std::vector<int>;  // numbers of nodes

  absl::Status AddShell(Group& group);
  absl::Status AddObject(const SceneObject& object, Group& group);
  void AddLamp(const LampLight& lamp, const std::string& name, tinygltf::Node& parent);
  void AddDaylight(Group& group);
  void AddDirectional(const std::string& name, Vec3 direction, Vec3 colour, double illuminance_lx, Group& group);
  absl::Status AddCamera(const SceneCamera& camera, Group& group);
  void AddGroup(const std::string& name, Group children, Group& parent);
  int AddNode(tinygltf::Node node);
  int LightNumber(tinygltf::Light light);
  std::string Unused(const std::string& name, std::string_view kind);

  const Scene& scene_;
  Extras extras_;
  tinygltf::Model model_;
  GlbBuffer buffer_{model_};
  MaterialBook materials_{model_, buffer_};
  MeshBook meshes_{model_, buffer_, materials_};
  std::set<std::string> names_;
  std::vector<Mesh> seen_;  // of the shell
  bool has_assets_ = false;
};

}  // namespace flair::renderer::gltf
