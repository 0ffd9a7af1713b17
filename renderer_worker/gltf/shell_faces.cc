// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/gltf/shell_faces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace flair::renderer::gltf {
namespace {

// Unit, towards the outside of the wall from floor corner `wall` to the next; the floor runs counter-clockwise.
Vec3 OutwardOf(const v1::Room& room, int wall) {
  const auto& corners = room.floor().vertices();
  if (wall < 0 || wall >= corners.size()) return {0, 0, 1};
  const v1::Point2& a = corners[wall];
  const v1::Point2& b = corners[(wall + 1) % corners.size()];
  return Normalized({static_cast<float>(b.y_m() - a.y_m()), static_cast<float>(a.x_m() - b.x_m()), 0});
}

// A wall's faces towards the room, its top and the reveals of its openings; not its outer face, nor the oblique ones at
// its ends, which its neighbours cover.
bool WallFaceIsSeen(Vec3 normal, Vec3 outward) {
  constexpr float kParallel = 0.999F;
  const Vec3 along{-outward.y, outward.x, 0};
  return normal.z > kParallel || normal.z < -kParallel || Dot(normal, outward) < -kParallel ||
         std::abs(Dot(normal, along)) > kParallel;
}

}  // namespace

Mesh SeenFromWithin(const ShellPart& part, const v1::Room& room) {
  const bool ceiling = part.kind == ShellPart::Kind::kCeiling;
  if (!ceiling && part.kind != ShellPart::Kind::kWall) return part.mesh;
  const Vec3 outward = OutwardOf(room, part.wall);
  Mesh kept;
  for (MeshPart faces : part.mesh.parts) {
    std::vector<uint32_t> indices;
    for (size_t i = 0; i + 2 < faces.indices.size(); i += 3) {
      const uint32_t* corner = &faces.indices[i];
      if (std::max({corner[0], corner[1], corner[2]}) >= faces.positions.size()) return part.mesh;  // MeshBook tells
      const Vec3 a = faces.positions[corner[0]];
      const Vec3 normal = Normalized(Cross(faces.positions[corner[1]] - a, faces.positions[corner[2]] - a));
      const bool seen = ceiling ? normal.z < -0.5F : WallFaceIsSeen(normal, outward);
      if (seen) indices.insert(indices.end(), corner, corner + 3);
    }
    faces.indices = std::move(indices);
    if (!faces.indices.empty()) kept.parts.push_back(std::move(faces));
  }
  return kept;
}

}  // namespace flair::renderer::gltf
