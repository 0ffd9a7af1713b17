// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "renderer_worker/furniture/patch.h"

// Slabs of any outline, and outlines.
namespace flair::renderer {
namespace {

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

void Modeller::Slab(const Material& material, std::span<const Vec2> outline, float bottom, float top, float bevel) {
  if (bottom > top) std::swap(bottom, top);
  if (outline.size() < 3 || top - bottom < 1e-5F) return;
  Vec2 low = outline[0], high = outline[0];
  for (const Vec2& p : outline) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
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

std::vector<Vec2> ArcPoints(Vec2 centre, float radius_x, float radius_y, float from_rad, float to_rad, int steps) {
  std::vector<Vec2> points;
  for (int i = 0; i <= steps; ++i) {
    const float angle = from_rad + (to_rad - from_rad) * static_cast<float>(i) / static_cast<float>(steps);
    points.push_back({centre.x + radius_x * std::cos(angle), centre.y + radius_y * std::sin(angle)});
  }
  return points;
}

std::vector<Vec2> EllipseOutline(Vec2 centre, float radius_x, float radius_y, int sides) {
  std::vector<Vec2> points = ArcPoints(centre, radius_x, radius_y, 0, 2 * std::numbers::pi_v<float>, sides);
  points.pop_back();
  return points;
}

std::vector<Vec2> RoundedOutline(Vec2 low, Vec2 high, float radius, int steps) {
  constexpr float kQuarter = std::numbers::pi_v<float> / 2;
  radius = std::min(radius, 0.499F * std::min(high.x - low.x, high.y - low.y));
  std::vector<Vec2> points;
  const std::array<Vec2, 4> centres{{{high.x - radius, low.y + radius},
                                     {high.x - radius, high.y - radius},
                                     {low.x + radius, high.y - radius},
                                     {low.x + radius, low.y + radius}}};
  for (size_t i = 0; i < 4; ++i) {
    const float from = kQuarter * (static_cast<float>(i) - 1);
    for (const Vec2& p : ArcPoints(centres[i], radius, radius, from, from + kQuarter, steps)) points.push_back(p);
  }
  return points;
}

}  // namespace flair::renderer
