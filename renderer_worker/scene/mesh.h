// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "renderer_worker/scene/material.h"
#include "renderer_worker/scene/vector.h"

namespace flair::renderer {

// Triangles of one material. Positions, normals (unit) and texture coordinates (metres along the surface) run parallel;
// three indices a triangle, counter-clockwise as seen from outside.
struct MeshPart {
  Material material;
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;
  std::vector<Vec2> uvs;
  std::vector<uint32_t> indices;
};

// A piece of furniture in object frame O (metres): x to the right of someone who stands behind it and looks the way it
// faces, y to its front, z up; origin in the middle of its underside. It fills
// [-width/2, width/2] x [-depth/2, depth/2] x [0, height].
// Parts of the room's shell are meshes in room frame R instead.
struct Mesh {
  std::vector<MeshPart> parts;  // one per material
};

}  // namespace flair::renderer
