// SPDX-License-Identifier: GPL-3.0-or-later
// Files that users bring: models and manifests. Whatever they hold, what is read of them must be sound.
#include <cmath>
#include <set>

#include "renderer_worker/assets/asset_library.h"
#include "renderer_worker/gltf/gltf.h"
#include "tests/fuzz/targets.h"

namespace flair::fuzz {
namespace {

bool Finite(renderer::Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void RequireSound(const renderer::Mesh& mesh) {
  Require(!mesh.parts.empty(), "an asset that was read has triangles");
  for (const renderer::MeshPart& part : mesh.parts) {
    Require(part.positions.size() == part.normals.size() && part.positions.size() == part.uvs.size(),
            "the arrays of a part run parallel");
    for (const renderer::Vec3 p : part.positions) Require(Finite(p), "positions are finite");
    for (const renderer::Vec3 n : part.normals) {
      Require(std::abs(renderer::Length(n) - 1) < 1e-3F, "normals have length 1");
    }
    for (const uint32_t index : part.indices) Require(index < part.positions.size(), "indices name vertices");
    Require(part.material.roughness > 0 && part.material.roughness <= 1 && part.material.opacity > 0 &&
                part.material.opacity <= 1 && Finite(part.material.colour) && Finite(part.material.emission),
            "materials are within their ranges");
  }
}

}  // namespace

void ReadAsset(std::string_view bytes) {
  const absl::StatusOr<renderer::AssetMesh> asset = renderer::ReadAsset(bytes, {});
  if (!asset.ok()) {
    Require(!asset.status().message().empty(), "a refusal says why");
    return;
  }
  RequireSound(asset->mesh);
  v1::Object object;
  object.set_width_m(1.2);
  object.set_depth_m(0.6);
  object.set_height_m(0.9);
  const double fit = renderer::SizeFit(renderer::ExtentOf(asset->mesh), object);
  Require(fit >= 0 && fit <= 1, "the fit of a size is a share");
  const renderer::Mesh fitted = renderer::Fitted(asset->mesh, object);
  RequireSound(fitted);
  const renderer::Vec3 extent = renderer::ExtentOf(fitted);
  Require(extent.x < 1.3F && extent.y < 0.7F && extent.z < 1.2F, "a fitted asset keeps within its object");
  const absl::StatusOr<std::string> glb = renderer::WriteMeshGlb(fitted, "asset");
  Require(glb.ok() || absl::IsInternal(glb.status()), "a sound mesh can be written");
}

void ReadManifest(std::string_view bytes) {
  const absl::StatusOr<renderer::Manifest> manifest = renderer::ReadManifest(bytes);
  if (!manifest.ok()) return;
  std::set<std::string> ids;
  for (const renderer::AssetEntry& entry : manifest->entries) {
    Require(ids.insert(entry.id).second, "ids are unique");
    Require(renderer::StaysInFolder(entry.file), "files stay in their folder");
    Require(renderer::CheckAxes(entry.axes).ok(), "axes are axes");
  }
  const auto index = renderer::AssetIndex::Make(manifest->entries);
  Require(index.ok(), "every manifest that was read can be searched");
  v1::Object object;
  object.set_name(manifest->entries.empty() ? "chair" : manifest->entries.front().name);
  object.set_width_m(1);
  object.set_depth_m(1);
  object.set_height_m(1);
  const auto matches = (*index)->Find(object, nullptr, 5);
  Require(matches.ok(), "every name can be searched for");
  for (const renderer::AssetMatch& match : *matches) {
    Require(match.entry < manifest->entries.size(), "matches are entries");
    Require(match.score >= renderer::kLeastAssetScore && match.score <= 1.0001, "scores are shares");
  }
}

}  // namespace flair::fuzz
