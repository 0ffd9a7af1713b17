// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "renderer_worker/assets/asset_library.h"
#include "renderer_worker/scene/furnishing.h"

namespace flair::renderer {

// Furniture from a user's own models: the asset whose words and size fit an object best, scaled to its width and depth;
// where none fits well enough, or it is missing or broken, what `fallback` makes. Assets keep their own proportions of
// height: unlike procedural meshes they need not fill the object's box. Lamps shine where those of `fallback` do.
//
// Diagnostics: "asset_unreadable" (warning, with the object as its subject) for a model that was chosen and could not
// be read, "asset_partly_read" (note) for pictures that were left out.
class AssetFurniture final : public FurnishingSource {
 public:
  // Both must outlive this.
  AssetFurniture(const AssetLibrary& library, const FurnishingSource& fallback)
      : library_(library), fallback_(fallback) {}

  Furnishing FurnishingOf(const v1::Object& object, const v1::ObjectStyle* style,
                          std::vector<v1::Diagnostic>& diagnostics) const override;

 private:
  std::shared_ptr<const Mesh> FittedMesh(size_t entry, const AssetMesh& asset, const v1::Object& object) const;

  const AssetLibrary& library_;
  const FurnishingSource& fallback_;
  mutable std::mutex mutex_;
  mutable std::map<std::string, std::weak_ptr<const Mesh>> fitted_;  // by entry, size and kind
};

}  // namespace flair::renderer
