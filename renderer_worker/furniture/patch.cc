// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/furniture/patch.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace flair::renderer {

Patch::Patch(Modeller& modeller, const Material& material)
    : modeller_(modeller),
      part_(modeller.PartOf(material)),
      first_vertex_(part_.positions.size()),
      first_index_(part_.indices.size()) {}

uint32_t Patch::Vertex(Vec3 position, Vec3 normal, Vec2 uv) {
  part_.positions.push_back(modeller_.Placed(position));
  part_.normals.push_back(modeller_.Directed(normal));
  part_.uvs.push_back(uv);
  return static_cast<uint32_t>(part_.positions.size() - 1);
}

void Patch::Triangle(uint32_t a, uint32_t b, uint32_t c) {
  if (a == b || b == c || c == a) return;
  part_.indices.insert(part_.indices.end(), {a, b, c});
}

void Patch::Flat(std::span<const Vec3> corners, Vec3 grain) {
  // Newell's normal: also right where the first corners are in line.
  Vec3 normal;
  for (size_t i = 0; i < corners.size(); ++i) normal = normal + Cross(corners[i], corners[(i + 1) % corners.size()]);
  if (!(Length(normal) > 1e-12F)) return;
  normal = Normalized(normal);
  Vec3 along = grain - normal * Dot(grain, normal);
  if (Length(along) < 1e-3F) along = corners[1] - corners[0];
  along = Normalized(along);
  const Vec3 across = Cross(normal, along);
  uint32_t first = 0, last = 0;
  for (size_t i = 0; i < corners.size(); ++i) {
    const uint32_t index = Vertex(corners[i], normal, {Dot(corners[i], along), Dot(corners[i], across)});
    if (i == 0) first = index;
    if (i >= 2) Triangle(first, last, index);
    last = index;
  }
}

void Patch::SmoothNormals() {
  const size_t count = part_.positions.size() - first_vertex_;
  // Vertices by position, so that seams of the texture do not show.
  std::vector<uint32_t> order(count);
  std::iota(order.begin(), order.end(), static_cast<uint32_t>(first_vertex_));
  const auto key = [this](uint32_t i) {
    const Vec3 p = part_.positions[i];
    const auto grid = [](float value) { return std::llround(static_cast<double>(value) * 1e6); };
    return std::tuple(grid(p.x), grid(p.y), grid(p.z));
  };
  std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return key(a) < key(b); });
  std::vector<Vec3> sums(count);
  for (size_t i = first_index_; i + 2 < part_.indices.size(); i += 3) {
    const uint32_t a = part_.indices[i], b = part_.indices[i + 1], c = part_.indices[i + 2];
    const Vec3 area = Cross(part_.positions[b] - part_.positions[a], part_.positions[c] - part_.positions[a]);
    for (const uint32_t k : {a, b, c}) sums[k - first_vertex_] = sums[k - first_vertex_] + area;
  }
  for (size_t i = 0; i < count;) {
    size_t end = i;
    Vec3 sum;
    while (end < count && key(order[end]) == key(order[i])) sum = sum + sums[order[end++] - first_vertex_];
    for (; i < end; ++i) part_.normals[order[i]] = Normalized(sum);
  }
}

}  // namespace flair::renderer
