// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "renderer_worker/furniture/modeller.h"

namespace flair::renderer {

// Adds one shape's vertices and triangles to the part of its material, within the modeller's frame. For shapes only.
class Patch {
 public:
  Patch(Modeller& modeller, const Material& material);

  // Index of the new vertex, for Triangle and Quad.
  uint32_t Vertex(Vec3 position, Vec3 normal, Vec2 uv);
  void Triangle(uint32_t a, uint32_t b, uint32_t c);
  void Quad(uint32_t a, uint32_t b, uint32_t c, uint32_t d) { Triangle(a, b, c), Triangle(a, c, d); }
  // A flat convex polygon with its own vertices and normal; the texture runs along `grain`.
  void Flat(std::span<const Vec3> corners, Vec3 grain);
  // Gives every vertex of this patch the mean normal of the triangles that meet at its position.
  void SmoothNormals();

 private:
  const Modeller& modeller_;
  MeshPart& part_;
  size_t first_vertex_;
  size_t first_index_;
};

}  // namespace flair::renderer
