// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "renderer_worker/scene/room_shape.h"
#include "renderer_worker/scene/scene.h"
#include "renderer_worker/tracing/sampling.h"

namespace flair::renderer {

// A mesh where it stands: turned about z, then moved.
struct WorldInstance {
  int instance_id = 0;
  int class_id = 0;
  const Mesh* mesh = nullptr;
  int mesh_index = 0;
  float cosine = 1, sine = 0;
  Vec3 origin;
  bool seen = true;    // by the camera
  bool shades = true;  // holds up light
  Vec3 ToRoom(Vec3 p) const { return TurnToRoom(p) + origin; }
  Vec3 TurnToRoom(Vec3 v) const { return {v.x * cosine - v.y * sine, v.x * sine + v.y * cosine, v.z}; }
};

// The scene's objects, then the parts of its shell. Ids count all of them, seen or not: the same in every view.
std::vector<WorldInstance> InstancesOf(const Scene& scene, const CutAway& cut);

// Whether what is behind lies in shadow: neither glass nor a lamp.
inline bool HoldsUpLight(const Material& material) {
  return material.opacity >= 1 && Luminance(material.emission) <= 0;
}

// Ids of the parts of a room, beside those of furniture classes; in the order of ShellPart::Kind.
inline constexpr int kFloorClass = 1001, kCeilingClass = 1002, kWallClass = 1003, kDoorClass = 1004,
                     kWindowClass = 1005, kSkirtingClass = 1006;

// Where a ray met a surface.
struct Hit {
  float distance = 0;
  int instance = -1;  // index in the instances; -1 when nothing was met
  int part = 0;
  int triangle = 0;
  float u = 0, v = 0;
  Vec3 across;  // right-angled to the triangle in room frame R, any length, either side
};

inline constexpr int kMostRaysTogether = 8;

// Up to so many triangles, counted once for every object that has them, rays search one tree of all of them, which is
// faster; beyond, equal meshes share a tree each.
inline constexpr int64_t kMaxFlatTriangles = 600'000;

int64_t TriangleCount(const Mesh& mesh);

// Embree's side of a World: what rays meet, of what is seen and of what holds up light. Thread-safe once made.
class RayTrees {
 public:
  // The instances, with valid meshes numbered by mesh_index below `mesh_count`, are borrowed. RESOURCE_EXHAUSTED when
  // there is no memory.
  static absl::StatusOr<std::unique_ptr<RayTrees>> Make(std::span<const WorldInstance> instances, int mesh_count);
  ~RayTrees();
  RayTrees(const RayTrees&) = delete;
  RayTrees& operator=(const RayTrees&) = delete;

  // The nearest thing seen, from `least` on.
  Hit NearestSeen(Vec3 from, Vec3 direction, float least) const;
  // The same for up to kMostRaysTogether directions; nothing where `least` is infinite.
  void NearestSeen(Vec3 from, std::span<const Vec3> directions, std::span<const float> least,
                   std::span<Hit> hits) const;
  // The nearest thing that holds up light.
  Hit NearestShading(Vec3 from, Vec3 direction) const;
  // Whether something holds up light within `distance`, in lengths of `direction`.
  bool Shaded(Vec3 from, Vec3 direction, float distance) const;

 private:
  struct Trees;
  explicit RayTrees(std::span<const WorldInstance> instances);
  void AttachAll(int mesh_count);

  std::span<const WorldInstance> instances_;
  std::unique_ptr<Trees> trees_;
};

// The surface at a hit.
struct Surface {
  Vec3 position;
  Vec3 normal;     // shading, unit, towards where the ray came from
  Vec3 geometric;  // of the triangle, the same side
  Vec2 uv;
  const Material* material = nullptr;
  Vec3 mean_colour;  // of the material's pattern
};

// The colour of a material at texture coordinates in metres, as the mean over about `filter_m` (the width of a pixel on
// the surface): what is finer is blurred away instead of flickering. Linear RGB in [0, 1]. Pure; no pattern repeats.
Vec3 PatternColour(const Material& material, Vec2 uv_m, float filter_m);

// Its mean over a large surface.
Vec3 MeanPatternColour(const Material& material);

// Of all meshes together, each counted once.
inline constexpr int64_t kMaxTriangles = 20'000'000;

// Triangles in space for rays. Thread-safe once made.
class World {
 public:
  // Meshes are borrowed from the scene. RESOURCE_EXHAUSTED beyond kMaxTriangles, INVALID_ARGUMENT for broken meshes.
  static absl::StatusOr<std::unique_ptr<World>> Make(const Scene& scene, const CutAway& cut);
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  const std::vector<WorldInstance>& instances() const { return instances_; }
  // The nearest thing that the camera sees.
  Hit Look(Vec3 from, Vec3 direction, float least) const { return trees_->NearestSeen(from, direction, least); }
  // The same for up to kMostRaysTogether neighbouring directions from one point; nothing where `least` is infinite.
  void Look(Vec3 from, std::span<const Vec3> directions, std::span<const float> least, std::span<Hit> hits) const {
    trees_->NearestSeen(from, directions, least, hits);
  }
  // The nearest thing that holds up light: no glass, nothing that shines, but walls that are cut away for the camera
  // only.
  Hit Feel(Vec3 from, Vec3 direction) const { return trees_->NearestShading(from, direction); }
  bool Shaded(Vec3 from, Vec3 direction, float distance) const { return trees_->Shaded(from, direction, distance); }
  Surface SurfaceAt(const Hit& hit, Vec3 from, Vec3 direction) const;
  Vec3 MeanColourAt(const Hit& hit) const { return mean_colours_[instances_[hit.instance].mesh_index][hit.part]; }
  // Of the first part of the first instance of a class; grey when there is none.
  Vec3 MeanColourOf(int class_id) const;
  // The unit normal of the hit triangle, on the side that `direction` comes from.
  Vec3 GeometricNormalAt(const Hit& hit, Vec3 direction) const {
    const Vec3 normal = Normalized(hit.across);
    return Dot(normal, direction) > 0 ? -normal : normal;
  }

 private:
  World() = default;
  absl::Status MakeMeanColours();

  std::vector<WorldInstance> instances_;
  std::vector<std::vector<Vec3>> mean_colours_;  // by mesh and part
  std::unique_ptr<RayTrees> trees_;
};

}  // namespace flair::renderer
