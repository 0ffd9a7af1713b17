// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <list>
#include <map>
#include <memory>
#include <mutex>

#include "absl/status/statusor.h"
#include "renderer_worker/assets/asset_index.h"
#include "renderer_worker/assets/manifest.h"
#include "renderer_worker/gltf/read_asset.h"

namespace flair::renderer {

// A folder of 3D models with its manifest. Models are read when first used and kept while there is room. Thread-safe.
class AssetLibrary {
 public:
  // Reads `folder`/manifest.json, or else `folder`/annotations.json. NOT_FOUND: no such folder or neither file; errors
  // of ReadManifest with the file's name.
  static absl::StatusOr<std::unique_ptr<AssetLibrary>> Open(const std::filesystem::path& folder);

  const Manifest& manifest() const { return manifest_; }
  AssetIndex& index() const { return *index_; }

  // The model of an entry. NOT_FOUND: no such file; errors of ReadAsset. An error is remembered as long as the model
  // would be.
  absl::StatusOr<std::shared_ptr<const AssetMesh>> MeshOf(size_t entry) const;

 private:
  using Loaded = absl::StatusOr<std::shared_ptr<const AssetMesh>>;
  struct Kept {
    Loaded mesh;
    size_t vertex_count;
    std::list<size_t>::iterator used;
  };

  Loaded Load(const AssetEntry& entry) const;

  std::filesystem::path folder_;
  Manifest manifest_;
  std::unique_ptr<AssetIndex> index_;
  mutable std::mutex mutex_;
  mutable std::map<size_t, Kept> kept_;  // by entry
  mutable std::list<size_t> used_;       // entries, last used first
  mutable size_t kept_vertex_count_ = 0;
};

}  // namespace flair::renderer
