// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "renderer_worker/furniture/modeller.h"

// What is turned about an axis, and bars.
namespace flair::renderer {
namespace {

struct RingPoint {
  Vec2 at;
  Vec2 normal_before, normal_after;  // of the profile, on either side of the point
  float along = 0;                   // from the profile's start
};

// Profile with normals, smooth where it turns by less than 50 degrees.
std::vector<RingPoint> WithNormals(std::span<const Vec2> profile, bool closed) {
  const size_t count = profile.size(), edges = closed ? count : count - 1;
  std::vector<Vec2> normals;
  std::vector<RingPoint> points;
  for (size_t i = 0; i < edges; ++i) {
    const Vec2 a = profile[i], b = profile[(i + 1) % count];
    const Vec2 d{b.x - a.x, b.y - a.y};
    const float length = std::max(std::sqrt(d.x * d.x + d.y * d.y), 1e-9F);
    normals.push_back({d.y / length, -d.x / length});
  }
  float along = 0;
  for (size_t i = 0; i < count; ++i) {
    Vec2 before = normals[i > 0 ? i - 1 : closed ? edges - 1 : 0], after = normals[i < edges ? i : edges - 1];
    if (before.x * after.x + before.y * after.y > 0.643F) {
      const float x = before.x + after.x, y = before.y + after.y, length = std::sqrt(x * x + y * y);
      before = after = {x / length, y / length};
    }
    if (i > 0) along += std::hypot(profile[i].x - profile[i - 1].x, profile[i].y - profile[i - 1].y);
    points.push_back({profile[i], before, after, along});
  }
  return points;
}

// Takes the mean of `stretch` into the profile, so that its slopes are true.
const std::vector<Vec2>& ToMetres(std::vector<Vec2>& profile, Vec2& stretch) {
  const float mean = std::sqrt(std::max(stretch.x * stretch.y, 1e-12F));
  for (Vec2& point : profile) point.x *= mean;
  stretch = {stretch.x / mean, stretch.y / mean};
  return profile;
}

// The surface that an edge of the profile sweeps.
void Sweep(Patch& patch, Vec3 base, const RingPoint& from, const RingPoint& to, float length, int sides, Vec2 stretch) {
  if (from.at.x < 1e-6F && to.at.x < 1e-6F) return;
  const float widest = std::max(from.at.x, to.at.x);
  const auto vertex = [&](const RingPoint& p, Vec2 normal, float along, float angle) {
    const float c = std::cos(angle), s = std::sin(angle);
    const Vec3 outward{normal.x * c * stretch.y, normal.x * s * stretch.x, normal.y * stretch.x * stretch.y};
    return patch.Vertex(base + Vec3{p.at.x * c * stretch.x, p.at.x * s * stretch.y, p.at.y}, Normalized(outward),
                        {along, angle * widest});
  };
  std::array<uint32_t, 2> last{};
  for (int i = 0; i <= sides; ++i) {
    const float angle = i == sides ? 2 * kPiFloat : 2 * kPiFloat * static_cast<float>(i) / static_cast<float>(sides);
    const std::array<uint32_t, 2> now{vertex(from, from.normal_after, from.along, angle),
                                      vertex(to, to.normal_before, from.along + length, angle)};
    if (i > 0) {
      if (from.at.x >= 1e-6F) patch.Triangle(last[0], now[0], now[1]);
      if (to.at.x >= 1e-6F) patch.Triangle(last[0], now[1], last[1]);
    }
    last = now;
  }
}

// Places between the faces' middle planes where a cushion's surface is sampled: the rounded ends and the flat middle.
std::vector<float> Stations(float half, float radius, bool crowned) {
  const float flat = half - radius;
  std::vector<float> stations{-half, -flat - 0.414F * radius, -flat};
  if (crowned) stations.push_back(0);
  stations.insert(stations.end(), {flat, flat + 0.414F * radius, half});
  return stations;
}

struct CushionShape {
  Vec3 half;
  float radius, crown;
  // From a point on the box around the cushion to the cushion's surface.
  Vec3 At(Vec3 p) const {
    const auto inner = [this](float value, float extent) {
      return std::clamp(value, radius - extent, extent - radius);
    };
    const Vec3 q{inner(p.x, half.x), inner(p.y, half.y), inner(p.z, half.z)};
    const Vec3 surface = q + Normalized(p - q) * radius;
    // Thin in the corners, full in the middle, so that nothing leaves the box.
    const auto hollow = [](float value, float extent) { return std::pow(std::abs(value) / extent, 2.5F); };
    const float x = hollow(surface.x, half.x), y = hollow(surface.y, half.y), z = hollow(surface.z, half.z);
    return {surface.x * (1 - crown / half.x * std::max(y, z)), surface.y * (1 - crown / half.y * std::max(x, z)),
            surface.z * (1 - crown / half.z * std::max(x, y))};
  }
};

}  // namespace

void Modeller::Lathe(const Material& material, Vec3 base, std::span<const Vec2> profile, int sides, Vec2 stretch) {
  if (profile.size() < 2) return;
  std::vector<Vec2> closed(profile.begin(), profile.end());
  for (Vec2& point : closed) point.x = std::max(point.x, 0.0F);
  if (closed.front().x > 1e-6F) closed.insert(closed.begin(), {0, closed.front().y});
  if (closed.back().x > 1e-6F) closed.push_back({0, closed.back().y});
  const std::vector<RingPoint> points = WithNormals(ToMetres(closed, stretch), false);
  Patch patch(*this, material);
  for (size_t i = 0; i + 1 < points.size(); ++i) {
    Sweep(patch, base, points[i], points[i + 1], points[i + 1].along - points[i].along, sides, stretch);
  }
}

void Modeller::Ring(const Material& material, Vec3 base, std::span<const Vec2> profile, int sides, Vec2 stretch) {
  if (profile.size() < 3) return;
  std::vector<Vec2> loop(profile.begin(), profile.end());
  const std::vector<RingPoint> points = WithNormals(ToMetres(loop, stretch), true);
  Patch patch(*this, material);
  for (size_t i = 0; i < points.size(); ++i) {
    const RingPoint& to = points[(i + 1) % points.size()];
    Sweep(patch, base, points[i], to, std::hypot(to.at.x - points[i].at.x, to.at.y - points[i].at.y), sides, stretch);
  }
}

void Modeller::Tube(const Material& material, std::span<const Vec3> path, std::span<const float> radii, int sides) {
  if (path.size() < 2 || radii.empty() || *std::ranges::min_element(radii) < 1e-6F) return;
  Patch patch(*this, material);
  const size_t count = path.size();
  Vec3 tangent = Normalized(path[1] - path[0]);
  Vec3 side = Normalized(Cross(tangent, std::abs(tangent.z) < 0.9F ? Vec3{0, 0, 1} : Vec3{1, 0, 0}));
  float along = 0;
  std::vector<uint32_t> last;
  const auto cap = [&](size_t i, Vec3 normal, const std::vector<Vec3>& ring) {
    std::vector<uint32_t> index;
    for (const Vec3& p : ring) index.push_back(patch.Vertex(p, normal, {Dot(p, side), Dot(p, Cross(normal, side))}));
    for (size_t k = 2; k < index.size(); ++k) {
      i == 0 ? patch.Triangle(index[0], index[k], index[k - 1]) : patch.Triangle(index[0], index[k - 1], index[k]);
    }
  };
  for (size_t i = 0; i < count; ++i) {
    const Vec3 before = i > 0 ? Normalized(path[i] - path[i - 1]) : tangent;
    const Vec3 after = i + 1 < count ? Normalized(path[i + 1] - path[i]) : before;
    tangent = Normalized(before + after);
    side = Normalized(side - tangent * Dot(side, tangent));
    const Vec3 up = Cross(side, tangent);
    if (i > 0) along += Length(path[i] - path[i - 1]);
    const float radius = radii[std::min(i, radii.size() - 1)];
    std::vector<uint32_t> now;
    std::vector<Vec3> ring;
    for (int k = 0; k <= sides; ++k) {
      const float angle = -2 * kPiFloat * static_cast<float>(k) / static_cast<float>(sides);
      const Vec3 outward = side * std::cos(angle) + up * std::sin(angle);
      now.push_back(patch.Vertex(path[i] + outward * radius, outward, {along, -angle * radius}));
      if (k < sides) ring.push_back(path[i] + outward * radius);
    }
    for (size_t k = 0; i > 0 && k + 1 < now.size(); ++k) patch.Quad(last[k], last[k + 1], now[k + 1], now[k]);
    if (i == 0) cap(0, -tangent, ring);
    if (i + 1 == count) cap(i, tangent, ring);
    last = now;
  }
}

void Modeller::Cushion(const Material& material, Vec3 low, Vec3 high, float radius, float crown) {
  const Vec3 centre = 0.5F * (low + high), size = high - low;
  const CushionShape shape{{std::abs(size.x) / 2, std::abs(size.y) / 2, std::abs(size.z) / 2},
                           std::min(radius, 0.49F * std::min({std::abs(size.x), std::abs(size.y), std::abs(size.z)})),
                           std::min(crown, 0.4F * std::min({std::abs(size.x), std::abs(size.y), std::abs(size.z)}))};
  if (shape.radius < 1e-5F) return;
  Patch patch(*this, material);
  for (int axis = 0; axis < 3; ++axis) {
    const auto turn = [axis](float a, float u, float v) {
      return axis == 0 ? Vec3{a, u, v} : axis == 1 ? Vec3{v, a, u} : Vec3{u, v, a};
    };
    const Vec3 h = axis == 0   ? shape.half
                   : axis == 1 ? Vec3{shape.half.y, shape.half.z, shape.half.x}
                               : Vec3{shape.half.z, shape.half.x, shape.half.y};
    const std::vector<float> us = Stations(h.y, shape.radius, crown > 0), vs = Stations(h.z, shape.radius, crown > 0);
    for (const float side : {-h.x, h.x}) {
      std::vector<uint32_t> index;
      for (const float v : vs) {
        for (const float u : us) index.push_back(patch.Vertex(centre + shape.At(turn(side, u, v)), {0, 0, 1}, {u, v}));
      }
      for (size_t j = 0; j + 1 < vs.size(); ++j) {
        for (size_t i = 0; i + 1 < us.size(); ++i) {
          const size_t a = j * us.size() + i, c = a + us.size();
          side > 0 ? patch.Quad(index[a], index[a + 1], index[c + 1], index[c])
                   : patch.Quad(index[a], index[c], index[c + 1], index[a + 1]);
        }
      }
    }
  }
  patch.SmoothNormals();
}

void Modeller::Pillow(const Material& material, Vec3 low, Vec3 high) {
  const Vec3 centre = 0.5F * (low + high);
  const Vec3 half{std::abs(high.x - low.x) / 2, std::abs(high.y - low.y) / 2, std::abs(high.z - low.z) / 2};
  const int thin = half.z <= half.x && half.z <= half.y ? 2 : half.y <= half.x ? 1 : 0;
  const auto turn = [thin](float u, float v, float t) {
    return thin == 2 ? Vec3{u, v, t} : thin == 1 ? Vec3{v, t, u} : Vec3{t, u, v};
  };
  const float hu = thin == 2   ? half.x
                   : thin == 1 ? half.z
                               : half.y,
              hv = thin == 2   ? half.y
                   : thin == 1 ? half.x
                               : half.z;
  const float ht = thin == 2 ? half.z : thin == 1 ? half.y : half.x;
  if (ht < 1e-5F) return;
  constexpr std::array kStations{-1.0F, -0.95F, -0.82F, -0.58F, -0.2F, 0.2F, 0.58F, 0.82F, 0.95F, 1.0F};
  Patch patch(*this, material);
  for (const float side : {-1.0F, 1.0F}) {
    std::vector<uint32_t> index;
    for (const float v : kStations) {
      for (const float u : kStations) {
        // Full in the middle, sewn at the edges, its sides pulled in a little between the corners.
        const float full = std::sqrt(std::max(0.0F, (1 - u * u * u * u) * (1 - v * v * v * v)));
        const float x = hu * u * (1 - 0.07F * (1 - v * v)), y = hv * v * (1 - 0.07F * (1 - u * u));
        index.push_back(patch.Vertex(centre + turn(x, y, side * ht * full), {0, 0, 1}, {hu * u, hv * v}));
      }
    }
    constexpr size_t kCount = kStations.size(), kLast = kCount - 2;
    for (size_t j = 0; j <= kLast; ++j) {
      for (size_t i = 0; i <= kLast; ++i) {
        const size_t a = j * kCount + i, c = a + kCount;
        // Corners are cut from the corner inwards: a triangle within the seam would have no outside.
        const bool other = (i == 0 && j == kLast) || (i == kLast && j == 0);
        const std::array<size_t, 4> q = other ? std::array{a + 1, c + 1, c, a} : std::array{a, a + 1, c + 1, c};
        side > 0 ? patch.Quad(index[q[0]], index[q[1]], index[q[2]], index[q[3]])
                 : patch.Quad(index[q[0]], index[q[3]], index[q[2]], index[q[1]]);
      }
    }
  }
  patch.SmoothNormals();
}

void Modeller::Sheet(const Material& material, int columns, int rows, const std::function<Vec3(float u, float v)>& at,
                     float thickness) {
  const auto width = static_cast<size_t>(columns) + 1, height = static_cast<size_t>(rows) + 1;
  std::vector<Vec3> points;
  for (size_t j = 0; j < height; ++j) {
    for (size_t i = 0; i < width; ++i) {
      points.push_back(
          at(static_cast<float>(i) / static_cast<float>(columns), static_cast<float>(j) / static_cast<float>(rows)));
    }
  }
  const auto normal = [&](size_t i, size_t j) {
    const Vec3 u = points[j * width + std::min(i + 1, width - 1)] - points[j * width + (i > 0 ? i - 1 : 0)];
    const Vec3 v = points[std::min(j + 1, height - 1) * width + i] - points[(j > 0 ? j - 1 : 0) * width + i];
    return Normalized(Cross(u, v));
  };
  Patch patch(*this, material);
  std::vector<uint32_t> front, back;
  float v_along = 0;
  for (size_t j = 0; j < height; ++j) {
    if (j > 0) v_along += Length(points[j * width] - points[(j - 1) * width]);
    float u_along = 0;
    for (size_t i = 0; i < width; ++i) {
      const Vec3 p = points[j * width + i], n = normal(i, j);
      if (i > 0) u_along += Length(p - points[j * width + i - 1]);
      front.push_back(patch.Vertex(p + n * (thickness / 2), n, {u_along, v_along}));
      back.push_back(patch.Vertex(p - n * (thickness / 2), -n, {u_along, v_along}));
    }
  }
  for (size_t j = 0; j + 1 < height; ++j) {
    for (size_t i = 0; i + 1 < width; ++i) {
      const size_t a = j * width + i, c = a + width;
      patch.Quad(front[a], front[a + 1], front[c + 1], front[c]);
      patch.Quad(back[a], back[c], back[c + 1], back[a + 1]);
    }
  }
  // The hem: shares no vertices, as it is shaded outwards.
  const auto hem = [&](size_t a, size_t b) {
    const Vec3 na = normal(a % width, a / width) * (thickness / 2), nb = normal(b % width, b / width) * (thickness / 2);
    const std::array corners{points[a] - na, points[b] - nb, points[b] + nb, points[a] + na};
    patch.Flat(corners, points[b] - points[a]);
  };
  for (size_t i = 0; i + 1 < width; ++i) hem(i, i + 1), hem((height - 1) * width + i + 1, (height - 1) * width + i);
  for (size_t j = 0; j + 1 < height; ++j)
    hem(j * width + width - 1, (j + 2) * width - 1), hem((j + 1) * width, j * width);
}

}  // namespace flair::renderer
