// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/tracing/world.h"

#include <unordered_map>

#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {
namespace {

absl::Status CheckMesh(const Mesh& mesh, int64_t& triangles) {
  for (const MeshPart& part : mesh.parts) {
    if (part.normals.size() != part.positions.size() || part.uvs.size() != part.positions.size() ||
        part.indices.size() % 3 != 0) {
      return InvalidArgument("mesh part \"{}\": its arrays do not run parallel", part.material.name);
    }
    for (uint32_t index : part.indices) {
      if (index >= part.positions.size()) {
        return InvalidArgument("mesh part \"{}\": index {} of {} positions", part.material.name, index,
                               part.positions.size());
      }
    }
  }
  triangles += TriangleCount(mesh);
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<std::unique_ptr<World>> World::Make(const Scene& scene, const CutAway& cut) {
  std::unique_ptr<World> world(new World);
  world->instances_ = InstancesOf(scene, cut);
  RETURN_IF_ERROR(world->MakeMeanColours());
  auto trees = RayTrees::Make(world->instances_, static_cast<int>(world->mean_colours_.size()));
  if (!trees.ok()) return trees.status();
  world->trees_ = *std::move(trees);
  return world;
}

absl::Status World::MakeMeanColours() {
  std::unordered_map<const Mesh*, int> known;
  int64_t triangles = 0;
  for (WorldInstance& instance : instances_) {
    const auto [at, is_new] = known.try_emplace(instance.mesh, static_cast<int>(mean_colours_.size()));
    instance.mesh_index = at->second;
    if (!is_new) continue;
    RETURN_IF_ERROR(CheckMesh(*instance.mesh, triangles));
    if (triangles > kMaxTriangles) {
      return ResourceExhausted("the scene's meshes have more than {} triangles", kMaxTriangles);
    }
    std::vector<Vec3>& colours = mean_colours_.emplace_back();
    for (const MeshPart& part : instance.mesh->parts) colours.push_back(MeanPatternColour(part.material));
  }
  return absl::OkStatus();
}

Vec3 World::MeanColourOf(int class_id) const {
  for (const WorldInstance& instance : instances_) {
    const std::vector<Vec3>& colours = mean_colours_[instance.mesh_index];
    if (instance.class_id == class_id && !colours.empty()) return colours[0];
  }
  return {0.5F, 0.5F, 0.5F};
}

Surface World::SurfaceAt(const Hit& hit, Vec3 from, Vec3 direction) const {
  const WorldInstance& instance = instances_[hit.instance];
  const MeshPart& part = instance.mesh->parts[hit.part];
  const uint32_t* corner = &part.indices[3 * static_cast<size_t>(hit.triangle)];
  const float w = 1 - hit.u - hit.v;
  Surface surface;
  surface.material = &part.material;
  surface.mean_colour = mean_colours_[instance.mesh_index][hit.part];
  surface.geometric = GeometricNormalAt(hit, direction);
  const Vec3 smooth = part.normals[corner[0]] * w + part.normals[corner[1]] * hit.u + part.normals[corner[2]] * hit.v;
  surface.normal = Normalized(instance.TurnToRoom(smooth));
  if (Dot(surface.normal, surface.geometric) < 0) surface.normal = -surface.normal;
  if (!(Dot(surface.normal, direction) < -1e-3F)) surface.normal = surface.geometric;
  const Vec2 a = part.uvs[corner[0]], b = part.uvs[corner[1]], c = part.uvs[corner[2]];
  surface.uv = {a.x * w + b.x * hit.u + c.x * hit.v, a.y * w + b.y * hit.u + c.y * hit.v};
  // Off the surface by more than what single precision loses of a room's coordinates.
  surface.position = from + direction * hit.distance + surface.geometric * (2e-4F + 2e-5F * hit.distance);
  return surface;
}

}  // namespace flair::renderer
