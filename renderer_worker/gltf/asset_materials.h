// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "renderer_worker/gltf/asset_file.h"
#include "renderer_worker/scene/mesh.h"

namespace flair::renderer::gltf {

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

}  // namespace flair::renderer::gltf
