// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "renderer_worker/furniture/patch.h"

// Boxes, tapers and slabs.
namespace flair::renderer {
namespace {

float& Part(Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

Vec3 Unit(int axis, float sign = 1) {
  Vec3 v;
  Part(v, axis) = sign;
  return v;
}

void Sort(Vec3& low, Vec3& high) {
  for (int axis = 0; axis < 3; ++axis) {
    if (Part(low, axis) > Part(high, axis)) std::swap(Part(low, axis), Part(high, axis));
  }
}

int LongestAxis(Vec3 size) { return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2; }

// The corner of a bevelled box that lies on the face `axis`; `sign` says which corner.
Vec3 CornerOn(Vec3 low, Vec3 high, float bevel, const std::array<bool, 3>& upper, int axis) {
  Vec3 p;
  for (int k = 0; k < 3; ++k) {
    const float inset = k == axis ? 0 : bevel;
    Part(p, k) = upper[static_cast<size_t>(k)] ? Part(high, k) - inset : Part(low, k) + inset;
  }
  return p;
}

// A quad or triangle between faces: each corner is shaded as the face it lies on, so that the edge looks round.
void Cut(Patch& patch, std::span<const Vec3> points, std::span<const Vec3> normals, Vec3 grain) {
  Vec3 middle, outward;
  for (const Vec3& p : points) middle = middle + p;
  for (const Vec3& n : normals) outward = outward + n;
  const Vec3 across = Normalized(Cross(Normalized(outward), grain));
  std::array<uint32_t, 4> index{};
  for (size_t i = 0; i < points.size(); ++i) {
    index[i] = patch.Vertex(points[i], normals[i], {Dot(points[i], grain), Dot(points[i], across)});
  }
  const bool turned = Dot(Cross(points[1] - points[0], points[2] - points[0]), outward) < 0;
  if (points.size() == 3) {
    turned ? patch.Triangle(index[0], index[2], index[1]) : patch.Triangle(index[0], index[1], index[2]);
  } else {
    turned ? patch.Quad(index[0], index[3], index[2], index[1]) : patch.Quad(index[0], index[1], index[2], index[3]);
  }
}

void Faces(Patch& patch, Vec3 low, Vec3 high, float bevel, Vec3 grain) {
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const bool top : {false, true}) {
      std::array<Vec3, 4> corners;
      const std::array<std::array<bool, 2>, 4> around{{{false, false}, {true, false}, {true, true}, {false, true}}};
      for (size_t i = 0; i < 4; ++i) {
        std::array<bool, 3> upper{};
        upper[static_cast<size_t>(axis)] = top;
        upper[static_cast<size_t>(u)] = around[i][top ? 0 : 1];
        upper[static_cast<size_t>(v)] = around[i][top ? 1 : 0];
        corners[i] = CornerOn(low, high, bevel, upper, axis);
      }
      patch.Flat(corners, grain);
    }
  }
}

}  // namespace

void Modeller::Box(const Material& material, Vec3 low, Vec3 high, float bevel) {
  Sort(low, high);
  const Vec3 size = high - low;
  const float thin = std::min({size.x, size.y, size.z});
  if (thin < 1e-5F) return;
  bevel = std::min(bevel, 0.3F * thin);
  const Vec3 grain = Unit(LongestAxis(size));
  Patch patch(*this, material);
  Faces(patch, low, high, bevel, grain);
  if (bevel < 1e-4F) return;
  for (int axis = 0; axis < 3; ++axis) {  // the four edges along this axis
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int k = 0; k < 4; ++k) {
      std::array<bool, 3> from{}, to{};
      from[static_cast<size_t>(u)] = to[static_cast<size_t>(u)] = (k & 1) != 0;
      from[static_cast<size_t>(v)] = to[static_cast<size_t>(v)] = (k & 2) != 0;
      to[static_cast<size_t>(axis)] = true;
      const Vec3 nu = Unit(u, (k & 1) != 0 ? 1.0F : -1.0F), nv = Unit(v, (k & 2) != 0 ? 1.0F : -1.0F);
      Cut(patch,
          std::array{CornerOn(low, high, bevel, from, u), CornerOn(low, high, bevel, to, u),
                     CornerOn(low, high, bevel, to, v), CornerOn(low, high, bevel, from, v)},
          std::array{nu, nu, nv, nv}, Unit(axis));
    }
  }
  for (int k = 0; k < 8; ++k) {
    const std::array<bool, 3> upper{(k & 1) != 0, (k & 2) != 0, (k & 4) != 0};
    std::array<Vec3, 3> points, normals;
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<size_t>(axis);
      points[i] = CornerOn(low, high, bevel, upper, axis);
      normals[i] = Unit(axis, upper[i] ? 1.0F : -1.0F);
    }
    Cut(patch, points, normals, grain);
  }
}

void Modeller::Taper(const Material& material, Vec3 bottom, Vec2 bottom_half, Vec3 top, Vec2 top_half) {
  if (top.z < bottom.z) std::swap(top, bottom), std::swap(top_half, bottom_half);
  if (top.z - bottom.z < 1e-5F || std::min({bottom_half.x, bottom_half.y, top_half.x, top_half.y}) < 1e-6F) return;
  const auto ring = [](Vec3 c, Vec2 h) {
    return std::array{c + Vec3{-h.x, -h.y, 0}, c + Vec3{h.x, -h.y, 0}, c + Vec3{h.x, h.y, 0}, c + Vec3{-h.x, h.y, 0}};
  };
  const auto low = ring(bottom, bottom_half), high = ring(top, top_half);
  Patch patch(*this, material);
  const Vec3 grain = Normalized(top - bottom);
  for (size_t i = 0; i < 4; ++i) {
    const size_t k = (i + 1) % 4;
    patch.Flat(std::array{low[i], low[k], high[k], high[i]}, grain);
  }
  patch.Flat(high, {1, 0, 0});
  patch.Flat(std::array{low[3], low[2], low[1], low[0]}, {1, 0, 0});
}

}  // namespace flair::renderer
