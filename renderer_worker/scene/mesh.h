// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <vector>

namespace flair::renderer {

// Half a turn.
inline constexpr float kPiFloat = std::numbers::pi_v<float>;

// A point or direction in the plane, single precision: what graphics libraries take.
struct Vec2 {
  float x = 0;
  float y = 0;
  friend bool operator==(const Vec2&, const Vec2&) = default;
};

// The least box round points, at least one.
struct Bounds2 {
  explicit Bounds2(std::span<const Vec2> points) : low(points.front()), high(low) {
    for (const Vec2& p : points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  Vec2 low, high;
};

// A point, direction or linear RGB colour.
struct Vec3 {
  float x = 0;
  float y = 0;
  float z = 0;
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

inline bool IsFinite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
constexpr Vec3 operator*(Vec3 a, float s) { return {a.x * s, a.y * s, a.z * s}; }
constexpr Vec3 operator*(float s, Vec3 a) { return a * s; }
// Component by component: how colours filter each other.
constexpr Vec3 operator*(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
constexpr float Dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 Cross(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline float Length(Vec3 a) { return std::sqrt(Dot(a, a)); }
// Unit vector along `a`; +z for a vector too short to have a direction.
inline Vec3 Normalized(Vec3 a) {
  const float length = Length(a);
  return length > 1e-12F ? a * (1 / length) : Vec3{0, 0, 1};
}

// A procedural variation of a material's colour over its surface, by texture coordinates in metres.
enum class Pattern { kPlain, kWood, kPlanks, kHerringbone, kTiles, kBricks, kStone, kCarpet, kFabric, kWallpaper };

// A picture on a surface as its asset brought it: never decoded by us, only handed on.
struct SurfaceImage {
  std::string mime_type;  // "image/png" or "image/jpeg"
  std::string bytes;      // of the file
};

// How a surface reflects light: the metallic-roughness model of glTF 2.0, plus a pattern. Colours are linear RGB.
struct Material {
  std::string name;  // such as "oak", unique within a mesh
  Vec3 colour{0.8F, 0.8F, 0.8F};
  float roughness = 0.7F;  // (0, 1]
  float metallic = 0;      // [0, 1]
  float opacity = 1;       // (0, 1]; below 1: glass
  Vec3 emission;           // radiance, for lamp shades and flames; 1 is as bright as a white wall in daylight
  Pattern pattern = Pattern::kPlain;
  Vec3 second_colour;  // of joints, figures or threads
  float pattern_size_m = 0.2F;
  // Multiplies `colour`; null nearly always. Texture coordinates are then in parts of it, v downwards.
  std::shared_ptr<const SurfaceImage> image;
  friend bool operator==(const Material&, const Material&) = default;
};

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
