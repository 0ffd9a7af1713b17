// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "flair/v1/object_list.pb.h"
#include "renderer_worker/assets/asset_library.h"
#include "renderer_worker/scene/mesh.h"
#include "renderer_worker/scene/scene.h"

namespace flair::renderer {

// Width, depth and height of the box round a mesh's triangles; 0 for a mesh without.
Vec3 ExtentOf(const Mesh& mesh);

// An asset (x right, y front, z up, any unit and origin) as a piece of furniture in frame O: scaled to the object's
// width and depth, its height in proportion (by the mean of both scales, on walls by that of the width) but at most a
// quarter higher than the object's; what stands has its underside at 0, what hangs on a wall is centred in the object's
// height, what hangs from the ceiling reaches up to it. An extent of nothing stays nothing.
Mesh Fitted(const Mesh& asset, const v1::Object& object);

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
