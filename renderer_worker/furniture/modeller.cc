// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/furniture/modeller.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace flair::renderer {
namespace {

// Scale and shift that take [low, high] to [to_low, to_high]; what has no extent is put in the middle.
struct Fit {
  float low, high, to_low, to_high;
  float scale() const { return high - low > 1e-6F ? (to_high - to_low) / (high - low) : 0; }
  float Of(float value) const {
    if (scale() == 0) return (to_low + to_high) / 2;
    return std::clamp(to_low + (value - low) * scale(), to_low, to_high);
  }
};

// Triangles that have an area; vertices that they use, in order.
MeshPart Cleaned(const MeshPart& part) {
  MeshPart clean;
  clean.material = part.material;
  std::vector<uint32_t> taken(part.positions.size(), UINT32_MAX);
  for (size_t i = 0; i + 2 < part.indices.size(); i += 3) {
    const Vec3 a = part.positions[part.indices[i]], b = part.positions[part.indices[i + 1]],
               c = part.positions[part.indices[i + 2]];
    const float longest = std::max({Length(b - a), Length(c - b), Length(a - c)});
    if (!(Length(Cross(b - a, c - a)) > 1e-6F * longest * longest)) continue;
    for (size_t k = i; k < i + 3; ++k) {
      uint32_t& index = taken[part.indices[k]];
      if (index == UINT32_MAX) {
        index = static_cast<uint32_t>(clean.positions.size());
        clean.positions.push_back(part.positions[part.indices[k]]);
        clean.normals.push_back(part.normals[part.indices[k]]);
        clean.uvs.push_back(part.uvs[part.indices[k]]);
      }
      clean.indices.push_back(index);
    }
  }
  return clean;
}

}  // namespace

void Modeller::In(const Frame& frame, const std::function<void()>& body) {
  const Frame outer = frame_;
  frame_ = {Placed(frame.origin), Directed(frame.x), Directed(frame.y), Directed(frame.z)};
  body();
  frame_ = outer;
}

size_t Modeller::vertex_count() const {
  return std::accumulate(parts_.begin(), parts_.end(), size_t{0},
                         [](size_t sum, const MeshPart& part) { return sum + part.positions.size(); });
}

Vec3 Modeller::Directed(Vec3 direction) const {
  return frame_.x * direction.x + frame_.y * direction.y + frame_.z * direction.z;
}

Vec3 Modeller::Placed(Vec3 point) const { return frame_.origin + Directed(point); }

MeshPart& Modeller::PartOf(const Material& material) {
  const auto at = std::ranges::find_if(parts_, [&](const MeshPart& p) { return p.material == material; });
  if (at != parts_.end()) return *at;
  parts_.emplace_back().material = material;
  return parts_.back();
}

Mesh Modeller::Filling(float width, float depth, float height, std::span<Vec3> inside) {
  constexpr float kHuge = std::numeric_limits<float>::max();
  Vec3 low{kHuge, kHuge, kHuge}, high{-kHuge, -kHuge, -kHuge};
  for (const MeshPart& part : parts_) {
    for (const Vec3& p : part.positions) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  }
  const Fit x{low.x, high.x, -width / 2, width / 2}, y{low.y, high.y, -depth / 2, depth / 2},
      z{low.z, high.z, 0, height};
  const auto fitted = [&](Vec3 p) { return Vec3{x.Of(p.x), y.Of(p.y), z.Of(p.z)}; };
  for (Vec3& point : inside) point = fitted(point);
  Mesh mesh;
  for (MeshPart& part : parts_) {
    for (Vec3& p : part.positions) p = fitted(p);
    // Normals turn against the stretching.
    for (Vec3& n : part.normals) {
      n = Normalized({n.x * y.scale() * z.scale(), n.y * x.scale() * z.scale(), n.z * x.scale() * y.scale()});
    }
    MeshPart clean = Cleaned(part);
    if (!clean.indices.empty()) mesh.parts.push_back(std::move(clean));
  }
  return mesh;
}

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
  std::ranges::stable_sort(order, [&](uint32_t a, uint32_t b) { return key(a) < key(b); });
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
