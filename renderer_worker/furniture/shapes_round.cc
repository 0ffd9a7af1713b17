// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "renderer_worker/furniture/patch.h"

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

void Modeller::Cylinder(const Material& material, Vec3 base, float radius, float height, float bevel, int sides) {
  if (radius < 1e-5F || height < 1e-5F) return;
  bevel = std::min({bevel, 0.3F * radius, 0.3F * height});
  Lathe(material, base,
        std::array<Vec2, 4>{{{radius - bevel, 0}, {radius, bevel}, {radius, height - bevel}, {radius - bevel, height}}},
        sides);
}

void Modeller::Ellipsoid(const Material& material, Vec3 centre, Vec3 radii, int sides, int rings) {
  if (std::min({radii.x, radii.y, radii.z}) < 1e-5F) return;
  std::vector<Vec2> profile = ArcPoints({0, 0}, 1, radii.z, -kPiFloat / 2, kPiFloat / 2, rings);
  profile.front().x = profile.back().x = 0;
  Lathe(material, centre, profile, sides, {radii.x, radii.y});
}

void Modeller::Hoop(const Material& material, Vec3 centre, float radius, float thickness, int sides) {
  std::vector<Vec2> profile = EllipseOutline({radius, 0}, thickness / 2, thickness / 2, 6);
  Ring(material, centre, profile, sides);
}

void Modeller::Tube(const Material& material, std::span<const Vec3> path, std::span<const float> radii, int sides) {
  if (path.size() < 2 || radii.empty() || *std::min_element(radii.begin(), radii.end()) < 1e-6F) return;
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

void Modeller::Bar(const Material& material, Vec3 from, Vec3 to, float radius, int sides) {
  Bar(material, from, to, radius, radius, sides);
}

void Modeller::Bar(const Material& material, Vec3 from, Vec3 to, float from_radius, float to_radius, int sides) {
  if (Length(to - from) < 1e-5F) return;
  Tube(material, std::array{from, to}, std::array{from_radius, to_radius}, sides);
}

}  // namespace flair::renderer
