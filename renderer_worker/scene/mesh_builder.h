// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "renderer_worker/scene/mesh.h"

namespace flair::renderer {

// Axes in which the parts of a wall or opening are easily described: a point (u, v, w) is
// origin + u along + v outward + w up. Right-handed when seen with `along` to the right, `outward` away, `up` upwards.
struct Axes {
  Vec3 origin;
  Vec3 along{1, 0, 0};
  Vec3 outward{0, 1, 0};
  Vec3 up{0, 0, 1};
  Vec3 At(float u, float v, float w) const { return origin + along * u + outward * v + up * w; }
};

// Collects flat-shaded polygons into a mesh with one part per material. Polygons without an area are left out.
class MeshBuilder {
 public:
  // A planar polygon, counter-clockwise as seen from outside; the texture runs along `u_axis` (unit, in the plane), its
  // origin at the room's origin. Convex, at least three corners.
  void Polygon(const Material& material, std::span<const Vec3> corners, Vec3 u_axis);
  void Quad(const Material& material, Vec3 a, Vec3 b, Vec3 c, Vec3 d);
  // [low.x, high.x] along, [low.y, high.y] outward, [low.z, high.z] up in `axes`.
  void Box(const Material& material, const Axes& axes, Vec3 low, Vec3 high);
  // A round bar from a to b.
  void Bar(const Material& material, Vec3 a, Vec3 b, float radius, int sides);
  void Append(const Mesh& mesh);

  bool empty() const { return mesh_.parts.empty(); }
  Mesh Take() { return std::move(mesh_); }

 private:
  MeshPart& PartOf(const Material& material);
  Mesh mesh_;
};

}  // namespace flair::renderer
