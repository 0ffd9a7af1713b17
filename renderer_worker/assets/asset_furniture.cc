// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fmt/format.h"
#include "renderer_worker/assets/asset_library.h"

namespace flair::renderer {
namespace {

constexpr float kTallest = 1.25F;

struct Bounds {
  Vec3 low{std::numeric_limits<float>::max(), std::numeric_limits<float>::max(), std::numeric_limits<float>::max()};
  Vec3 high{-low.x, -low.y, -low.z};
  bool empty() const { return low.x > high.x; }
};

Bounds BoundsOf(const Mesh& mesh) {
  Bounds bounds;
  for (const MeshPart& part : mesh.parts) {
    for (const uint32_t index : part.indices) {
      const Vec3 p = part.positions[index];
      bounds.low = {std::min(bounds.low.x, p.x), std::min(bounds.low.y, p.y), std::min(bounds.low.z, p.z)};
      bounds.high = {std::max(bounds.high.x, p.x), std::max(bounds.high.y, p.y), std::max(bounds.high.z, p.z)};
    }
  }
  return bounds;
}

// What brings `from` to `to`; 1 for what has no extent.
float Ratio(float to, float from) { return from > 1e-9F ? to / from : 1; }

constexpr size_t kTries = 4;
constexpr size_t kMaxFitted = 4096;

void Tell(v1::Severity severity, const char* code, const v1::Object& object, std::string message,
          std::vector<v1::Diagnostic>& diagnostics) {
  v1::Diagnostic& diagnostic = diagnostics.emplace_back();
  diagnostic.set_severity(severity);
  diagnostic.set_code(code);
  diagnostic.set_message(std::move(message));
  diagnostic.set_subject_id(object.id());
}

}  // namespace

Vec3 ExtentOf(const Mesh& mesh) {
  const Bounds bounds = BoundsOf(mesh);
  return bounds.empty() ? Vec3{} : bounds.high - bounds.low;
}

Mesh Fitted(const Mesh& asset, const v1::Object& object) {
  const Bounds bounds = BoundsOf(asset);
  if (bounds.empty()) return asset;
  const Vec3 extent = bounds.high - bounds.low;
  const auto height = static_cast<float>(object.height_m());
  Vec3 scale{Ratio(static_cast<float>(object.width_m()), extent.x),
             Ratio(static_cast<float>(object.depth_m()), extent.y), 1};
  scale.z = object.kind() == v1::OBJECT_KIND_WALL ? scale.x : std::sqrt(scale.x * scale.y);
  scale.z = std::min(scale.z, Ratio(height * kTallest, extent.z));
  float lift = 0;
  if (object.kind() == v1::OBJECT_KIND_WALL) lift = (height - extent.z * scale.z) / 2;
  if (object.kind() == v1::OBJECT_KIND_CEILING) lift = height - extent.z * scale.z;
  const Vec3 origin{(bounds.low.x + bounds.high.x) / 2, (bounds.low.y + bounds.high.y) / 2, bounds.low.z};
  Mesh fitted = asset;
  for (MeshPart& part : fitted.parts) {
    for (Vec3& p : part.positions) p = (p - origin) * scale + Vec3{0, 0, lift};
    for (Vec3& n : part.normals) n = Normalized({n.x / scale.x, n.y / scale.y, n.z / scale.z});
  }
  return fitted;
}

Furnishing AssetFurniture::FurnishingOf(const v1::Object& object, const v1::ObjectStyle* style,
                                        std::vector<v1::Diagnostic>& diagnostics) const {
  Furnishing furnishing = fallback_.FurnishingOf(object, style, diagnostics);
  const absl::StatusOr<std::vector<AssetMatch>> matches = library_.index().Find(object, style, kTries);
  if (!matches.ok()) {
    Tell(v1::SEVERITY_WARNING, "asset_search_failed", object,
         fmt::format("No asset was looked for: {}.", std::string(matches.status().message())), diagnostics);
    return furnishing;
  }
  for (const AssetMatch& match : *matches) {
    const AssetEntry& entry = library_.manifest().entries[match.entry];
    const absl::StatusOr<std::shared_ptr<const AssetMesh>> asset = library_.MeshOf(match.entry);
    if (!asset.ok()) {
      Tell(v1::SEVERITY_WARNING, "asset_unreadable", object,
           fmt::format("Asset '{}' fits {} but cannot be used: {}.", entry.id, object.name(),
                       std::string(asset.status().message())),
           diagnostics);
      continue;
    }
    if (!entry.size_m.has_value() && WithSize(match.score, ExtentOf((*asset)->mesh), object) < kLeastAssetScore) {
      continue;
    }
    for (const std::string& note : (*asset)->notes) {
      Tell(v1::SEVERITY_NOTE, "asset_partly_read", object, fmt::format("Asset '{}': {}.", entry.id, note), diagnostics);
    }
    furnishing.mesh = FittedMesh(match.entry, **asset, object);
    furnishing.asset_id = entry.id;
    furnishing.asset_licence = entry.licence;
    return furnishing;
  }
  return furnishing;
}

std::shared_ptr<const Mesh> AssetFurniture::FittedMesh(size_t entry, const AssetMesh& asset,
                                                       const v1::Object& object) const {
  const std::string key = fmt::format("{} {} {} {} {}", entry, object.width_m(), object.depth_m(), object.height_m(),
                                      static_cast<int>(object.kind()));
  {
    const std::lock_guard lock(mutex_);
    const auto known = fitted_.find(key);
    if (known != fitted_.end()) {
      if (auto mesh = known->second.lock()) return mesh;
    }
  }
  auto mesh = std::make_shared<const Mesh>(Fitted(asset.mesh, object));
  const std::lock_guard lock(mutex_);
  if (fitted_.size() > kMaxFitted) std::erase_if(fitted_, [](const auto& item) { return item.second.expired(); });
  fitted_[key] = mesh;
  return mesh;
}

}  // namespace flair::renderer
