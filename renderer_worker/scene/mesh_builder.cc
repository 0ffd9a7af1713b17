// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/scene/mesh_builder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flair::renderer {
namespace {

// Newell's normal: twice the area long, whatever corners fall together.
Vec3 AreaNormal(std::span<const Vec3> corners) {
  Vec3 sum;
  for (size_t i = 0; i < corners.size(); ++i) sum = sum + Cross(corners[i], corners[(i + 1) % corners.size()]);
  return sum;
}

}  // namespace

MeshPart& MeshBuilder::PartOf(const Material& material) {
  for (MeshPart& part : mesh_.parts) {
    if (part.material == material) return part;
  }
  mesh_.parts.emplace_back().material = material;
  return mesh_.parts.back();
}

void MeshBuilder::Polygon(const Material& material, std::span<const Vec3> corners, Vec3 u_axis) {
  const Vec3 area = AreaNormal(corners);
  if (corners.size() < 3 || !(Length(area) > 1e-9F)) return;
  const Vec3 normal = Normalized(area), v_axis = Cross(normal, u_axis);
  MeshPart& part = PartOf(material);
  const uint32_t first = static_cast<uint32_t>(part.positions.size());
  for (const Vec3& corner : corners) {
    part.positions.push_back(corner);
    part.normals.push_back(normal);
    part.uvs.push_back({Dot(corner, u_axis), Dot(corner, v_axis)});
  }
  for (uint32_t i = 2; i < corners.size(); ++i)
    part.indices.insert(part.indices.end(), {first, first + i - 1, first + i});
}

void MeshBuilder::Quad(const Material& material, Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const Vec3 corners[] = {a, b, c, d};
  const Vec3 first = b - a, second = d - a;
  if (!(Length(first) > 1e-6F) || !(Length(second) > 1e-6F)) return;
  Polygon(material, corners, Normalized(first));
}

void MeshBuilder::Box(const Material& material, const Axes& axes, Vec3 low, Vec3 high) {
  const auto at = [&](int u, int v, int w) {
    return axes.At(u == 0 ? low.x : high.x, v == 0 ? low.y : high.y, w == 0 ? low.z : high.z);
  };
  // Seen from outside each face runs counter-clockwise when (along, outward, up) is right-handed, clockwise otherwise.
  const bool right_handed = Dot(Cross(axes.along, axes.outward), axes.up) > 0;
  const int faces[6][4][3] = {
      {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}, {{1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {1, 1, 1}},
      {{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}, {{0, 1, 0}, {0, 0, 0}, {0, 0, 1}, {0, 1, 1}},
      {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}, {{0, 1, 0}, {1, 1, 0}, {1, 0, 0}, {0, 0, 0}}};
  for (const auto& face : faces) {
    Vec3 p[4];
    for (int i = 0; i < 4; ++i) p[i] = at(face[i][0], face[i][1], face[i][2]);
    if (right_handed) {
      Quad(material, p[0], p[1], p[2], p[3]);
    } else {
      Quad(material, p[3], p[2], p[1], p[0]);
    }
  }
}

void MeshBuilder::Bar(const Material& material, Vec3 a, Vec3 b, float radius, int sides) {
  const Vec3 axis = Normalized(b - a);
  const Vec3 side = Normalized(Cross(axis, std::abs(axis.z) < 0.9F ? Vec3{0, 0, 1} : Vec3{1, 0, 0}));
  const Vec3 other = Cross(axis, side);
  std::vector<Vec3> low, high;
  for (int i = 0; i < sides; ++i) {
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(sides);
    const Vec3 out = (side * std::cos(angle) + other * std::sin(angle)) * radius;
    low.push_back(a + out);
    high.push_back(b + out);
  }
  for (int i = 0; i < sides; ++i) {
    const int k = (i + 1) % sides;
    Quad(material, low[i], low[k], high[k], high[i]);
  }
  Polygon(material, high, side);
  std::reverse(low.begin(), low.end());
  Polygon(material, low, side);
}

void MeshBuilder::Append(const Mesh& mesh) {
  for (const MeshPart& from : mesh.parts) {
    MeshPart& to = PartOf(from.material);
    const uint32_t first = static_cast<uint32_t>(to.positions.size());
    to.positions.insert(to.positions.end(), from.positions.begin(), from.positions.end());
    to.normals.insert(to.normals.end(), from.normals.begin(), from.normals.end());
    to.uvs.insert(to.uvs.end(), from.uvs.begin(), from.uvs.end());
    for (uint32_t index : from.indices) to.indices.push_back(first + index);
  }
}

}  // namespace flair::renderer
