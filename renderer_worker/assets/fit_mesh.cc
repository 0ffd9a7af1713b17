// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/assets/fit_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

}  // namespace flair::renderer
