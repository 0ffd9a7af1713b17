// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "renderer_worker/furniture/modeller.h"

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

float Cross2(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
Vec2 Minus(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
float Length2(Vec2 a) { return std::sqrt(a.x * a.x + a.y * a.y); }

// Of the edge from a to b, pointing out of a counter-clockwise outline.
Vec2 EdgeNormal(Vec2 a, Vec2 b) {
  const Vec2 d = Minus(b, a);
  const float length = std::max(Length2(d), 1e-9F);
  return {d.y / length, -d.x / length};
}

bool Inside(Vec2 p, Vec2 a, Vec2 b, Vec2 c) {
  return Cross2(Minus(b, a), Minus(p, a)) > 0 && Cross2(Minus(c, b), Minus(p, b)) > 0 &&
         Cross2(Minus(a, c), Minus(p, c)) > 0;
}

// Triangles of a simple counter-clockwise polygon, by clipping ears.
std::vector<std::array<uint32_t, 3>> Triangulated(std::span<const Vec2> outline) {
  std::vector<uint32_t> left(outline.size());
  for (size_t i = 0; i < left.size(); ++i) left[i] = static_cast<uint32_t>(i);
  std::vector<std::array<uint32_t, 3>> triangles;
  size_t misses = 0, i = 0;
  while (left.size() > 2 && misses <= left.size()) {
    const size_t count = left.size();
    const uint32_t a = left[i % count], b = left[(i + 1) % count], c = left[(i + 2) % count];
    bool ear = Cross2(Minus(outline[b], outline[a]), Minus(outline[c], outline[a])) > 0;
    for (size_t k = 3; ear && k < count; ++k) {
      ear = !Inside(outline[left[(i + k) % count]], outline[a], outline[b], outline[c]);
    }
    if (ear) {
      triangles.push_back({a, b, c});
      left.erase(left.begin() + static_cast<std::ptrdiff_t>((i + 1) % count));
      misses = 0;
    } else {
      ++misses;
    }
    ++i;
  }
  return triangles;
}

// Every corner moved in by `distance`, along the mean of its edges' normals.
std::vector<Vec2> Inset(std::span<const Vec2> outline, float distance) {
  std::vector<Vec2> inset;
  const size_t count = outline.size();
  for (size_t i = 0; i < count; ++i) {
    const Vec2 n = EdgeNormal(outline[(i + count - 1) % count], outline[i]),
               m = EdgeNormal(outline[i], outline[(i + 1) % count]);
    const float share = distance / std::max(1 + n.x * m.x + n.y * m.y, 0.4F);
    inset.push_back({outline[i].x - share * (n.x + m.x), outline[i].y - share * (n.y + m.y)});
  }
  return inset;
}

struct Rims {
  std::span<const Vec2> lower, upper;
  float bottom, top;
};

// A wall between two outlines. Shaded from `down` (z of the lower rim's normal) to `up`.
void Band(Patch& patch, std::span<const Vec2> outline, const Rims& rims, float down, float up) {
  const size_t count = outline.size();
  float along = 0;
  const auto shaded = [](Vec2 n, float z) {
    return Normalized(Vec3{n.x * (1 - std::abs(z)), n.y * (1 - std::abs(z)), z});
  };
  for (size_t i = 0; i < count; ++i) {
    const size_t k = (i + 1) % count;
    const Vec2 n = EdgeNormal(outline[i], outline[k]);
    const auto corner = [&](Vec2 other) {  // smooth with the neighbouring edge when the corner is flat
      if (n.x * other.x + n.y * other.y < 0.766F) return n;
      const float length = std::max(Length2({n.x + other.x, n.y + other.y}), 1e-6F);
      return Vec2{(n.x + other.x) / length, (n.y + other.y) / length};
    };
    const Vec2 ni = corner(EdgeNormal(outline[(i + count - 1) % count], outline[i])),
               nk = corner(EdgeNormal(outline[k], outline[(k + 1) % count]));
    const float length = Length2(Minus(outline[k], outline[i]));
    const uint32_t a =
        patch.Vertex({rims.lower[i].x, rims.lower[i].y, rims.bottom}, shaded(ni, down), {along, rims.bottom});
    const uint32_t b =
        patch.Vertex({rims.lower[k].x, rims.lower[k].y, rims.bottom}, shaded(nk, down), {along + length, rims.bottom});
    const uint32_t c =
        patch.Vertex({rims.upper[k].x, rims.upper[k].y, rims.top}, shaded(nk, up), {along + length, rims.top});
    const uint32_t d = patch.Vertex({rims.upper[i].x, rims.upper[i].y, rims.top}, shaded(ni, up), {along, rims.top});
    patch.Quad(a, b, c, d);
    along += length;
  }
}

void Lid(Patch& patch, std::span<const Vec2> outline, float z, bool upwards, bool grain_along_y) {
  std::vector<uint32_t> index;
  for (const Vec2& p : outline) {
    index.push_back(patch.Vertex({p.x, p.y, z}, {0, 0, upwards ? 1.0F : -1.0F}, grain_along_y ? Vec2{p.y, p.x} : p));
  }
  for (const auto& [a, b, c] : Triangulated(outline)) {
    upwards ? patch.Triangle(index[a], index[b], index[c]) : patch.Triangle(index[a], index[c], index[b]);
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

void Modeller::Slab(const Material& material, std::span<const Vec2> outline, float bottom, float top, float bevel) {
  if (bottom > top) std::swap(bottom, top);
  if (outline.size() < 3 || top - bottom < 1e-5F) return;
  const auto [low, high] = Bounds2(outline);
  bevel = std::min({bevel, 0.3F * (top - bottom), 0.1F * std::min(high.x - low.x, high.y - low.y)});
  const std::vector<Vec2> rim =
      bevel > 1e-4F ? Inset(outline, bevel) : std::vector<Vec2>(outline.begin(), outline.end());
  if (bevel <= 1e-4F) bevel = 0;
  Patch patch(*this, material);
  const bool grain_along_y = high.y - low.y > high.x - low.x;
  Lid(patch, rim, top, true, grain_along_y);
  Lid(patch, rim, bottom, false, grain_along_y);
  if (bevel > 0) {
    Band(patch, outline, {rim, outline, bottom, bottom + bevel}, -1, 0);
    Band(patch, outline, {outline, rim, top - bevel, top}, 0, 1);
  }
  Band(patch, outline, {outline, outline, bottom + bevel, top - bevel}, 0, 0);
}

}  // namespace flair::renderer
