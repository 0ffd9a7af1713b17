// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "renderer_worker/gltf/tiny_gltf.h"
#include "renderer_worker/gltf/write_glb.h"
#include "renderer_worker/scene/scene.h"

namespace flair::renderer::gltf {

// What nodes say of themselves in `extras`; docs/scene.md lists the fields. Borrows the layout.
class Extras {
 public:
  explicit Extras(const v1::SolvedLayout& layout);

  tinygltf::Value OfObject(const SceneObject& object) const;
  tinygltf::Value OfShellPart(const ShellPart& part) const;
  static tinygltf::Value OfAsset(const Scene& scene, const GlbMetadata& metadata);

 private:
  tinygltf::Value ConstraintOf(int edge) const;

  const v1::SolvedLayout& layout_;
  std::map<std::string, std::vector<int>> edges_of_;    // object id -> edges that name it
  std::map<std::string, std::string> sentences_;        // id -> text
  std::map<std::string, const v1::Opening*> openings_;  // by id
};

}  // namespace flair::renderer::gltf
