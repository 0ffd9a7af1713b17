// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "renderer_worker/gltf/glb_buffer.h"
#include "renderer_worker/scene/material.h"

namespace flair::renderer::gltf {

// The materials of a file, each once. Patterns become textures that tile; emission above 1 uses
// KHR_materials_emissive_strength.
class MaterialBook {
 public:
  // Both must outlive this.
  MaterialBook(tinygltf::Model& model, GlbBuffer& buffer) : model_(model), buffer_(buffer) {}

  // Number of the material in the file.
  int NumberOf(const Material& material);

  // What texture coordinates of the scene are multiplied with in the file; (0, 0) where the material has no texture.
  static Vec2 UvScale(const Material& material);

 private:
  int Write(const Material& material);
  int TextureOf(const Material& material);
  int SamplerNumber();

  tinygltf::Model& model_;
  GlbBuffer& buffer_;
  std::map<std::string, std::vector<std::pair<Material, int>>> written_;  // by name
  std::map<const SurfaceImage*, int> images_;                             // texture of each
  std::map<std::string, int> patterns_;                                   // texture of each, by its PNG
};

}  // namespace flair::renderer::gltf
