// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "renderer_worker/scene/room_shape.h"
#include "renderer_worker/scene/scene.h"
#include "renderer_worker/tracing/ray_trees.h"

namespace flair::renderer {

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
