// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <nlohmann/json.hpp>

#include "renderer_worker/scene/vector.h"

namespace flair::renderer::gltf {

// An affine map: p' = columns[0] x + columns[1] y + columns[2] z + columns[3].
struct Affine {
  std::array<Vec3, 4> columns = {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{}};

  Vec3 Direction(Vec3 v) const { return columns[0] * v.x + columns[1] * v.y + columns[2] * v.z; }
  Vec3 Point(Vec3 p) const { return Direction(p) + columns[3]; }
  // Normals go by the cofactors, which are right for uneven scales and for maps that flatten; not of unit length.
  Vec3 Normal(Vec3 n) const {
    return Cross(columns[1], columns[2]) * n.x + Cross(columns[2], columns[0]) * n.y +
           Cross(columns[0], columns[1]) * n.z;
  }
  // Of volumes; negative for a mirror.
  float Determinant() const { return Dot(columns[0], Cross(columns[1], columns[2])); }
};

// First `inner`, then `outer`.
Affine operator*(const Affine& outer, const Affine& inner);

// A node's own transform: its matrix, or translation, rotation and scale. What is no number counts as left out.
Affine TransformOf(const nlohmann::json& node);

}  // namespace flair::renderer::gltf
