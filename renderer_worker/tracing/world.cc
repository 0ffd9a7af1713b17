// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/tracing/world.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "renderer_worker/tracing/frame.h"
#include "renderer_worker/tracing/lighting.h"
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

bool Plausible(Vec3 p) {
  return std::abs(p.x) <= 1e5F && std::abs(p.y) <= 1e5F && std::abs(p.z) <= 1e5F;  // false for NaN
}

constexpr int kMostLayers = 8;  // panes and mirrors one behind the other

Vec3 Schlick(Vec3 straight, float cosine) {
  const float grazing = FifthPower(std::clamp(1 - cosine, 0.0F, 1.0F));
  return straight * (1 - grazing) + Vec3{1, 1, 1} * grazing;
}

// A bright day far out of focus, as it shall appear in a window.
Vec3 DayOutside(Vec3 direction) {
  const float up = std::clamp(direction.z, -1.0F, 1.0F);
  const Vec3 horizon{1.12F, 1.12F, 1.08F}, zenith{0.66F, 0.83F, 1.08F}, garden{0.60F, 0.68F, 0.52F};
  const float ground = std::clamp(0.5F - up / 0.16F, 0.0F, 1.0F);
  const Vec3 sky = horizon + (zenith - horizon) * std::sqrt(std::max(0.0F, up));
  const float share = ground * ground * (3 - 2 * ground) * 0.8F;
  return sky * (1 - share) + garden * share;
}

// Nothing more is met on the way.
void SeeBeyond(const Lights& lights, const Surroundings& around, Vec3 from, Vec3 direction, Seen& seen) {
  seen.lit_instance = -1;
  if (around.open && direction.z < -1e-4F && from.z > around.ground_z) {
    seen.position = from + direction * ((around.ground_z - from.z) / direction.z);
    seen.normal = {0, 0, 1};
    seen.albedo = around.backdrop;
    seen.lit_instance = -2;
    return;
  }
  const Vec3 beyond =
      !around.open && lights.WindowThrough(from, direction) >= 0 ? DayOutside(direction) : around.backdrop;
  seen.added = seen.added + seen.filter * beyond;
}

constexpr float kNearest_m = 0.01F;

// On from the first thing that was met.
Seen LookOn(const World& world, const Lights& lights, const Surroundings& around, Vec3 eye, Vec3 direction,
            float pixel_rad, Hit hit) {
  Seen seen;
  Vec3 from = eye, since = eye;  // `since`: where the way was last bent
  float travelled = 0;
  for (int layer = 0; layer < kMostLayers; ++layer) {
    if (layer > 0) hit = world.Look(from, direction, 1e-4F);
    seen.direction = direction;
    if (hit.instance < 0) {
      SeeBeyond(lights, around, since, direction, seen);
      return seen;
    }
    const Surface surface = world.SurfaceAt(hit, from, direction);
    const Material& material = *surface.material;
    travelled += hit.distance;
    const float cosine = std::max(0.05F, -Dot(surface.geometric, direction));
    const Vec3 colour = PatternColour(material, surface.uv, travelled * pixel_rad / std::sqrt(cosine));
    if (layer == 0) {
      seen.instance = hit.instance;
      seen.distance = hit.distance;
      seen.first_normal = surface.normal;
      seen.first_albedo = colour;
    }
    if (material.opacity < 1 && layer + 1 < kMostLayers) {
      // A pane: a little of its own colour, the more the flatter it is looked through.
      const float kept = 1 - std::clamp(material.opacity, 0.0F, 1.0F);
      const float mirrored = Schlick({0.04F, 0.04F, 0.04F}, -Dot(surface.normal, direction)).x;
      seen.added = seen.added + seen.filter * colour * ((1 - kept) * 0.6F + 0.25F * mirrored);
      seen.filter = seen.filter * (kept * (1 - mirrored));
      from = from + direction * hit.distance;
      continue;
    }
    if (IsMirror(material) && layer + 1 < kMostLayers) {
      seen.filter = seen.filter * Schlick(colour, -Dot(surface.normal, direction));
      from = since = surface.position;
      direction = direction - surface.normal * (2 * Dot(surface.normal, direction));
      continue;
    }
    seen.lit_instance = hit.instance;
    seen.position = surface.position;
    seen.normal = surface.normal;
    seen.added = seen.added + seen.filter * material.emission;
    seen.albedo = colour * (1 - material.metallic);
    seen.specular = Vec3{0.04F, 0.04F, 0.04F} * (1 - material.metallic) + colour * material.metallic;
    seen.roughness = std::clamp(material.roughness, 0.05F, 1.0F);
    return seen;
  }
  return seen;
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

absl::StatusOr<PinholeCamera> PinholeCamera::Make(const SceneCamera& camera, int width_px, int height_px) {
  if (!Plausible(camera.eye) || !Plausible(camera.target)) {
    return absl::InvalidArgumentError("camera: eye and target must be finite, at most 100 km away");
  }
  const Vec3 way = camera.target - camera.eye;
  if (!(std::hypot(way.x, way.y) > 1e-4F * std::abs(way.z)) || !(Length(way) > 1e-6F)) {
    return absl::InvalidArgumentError("camera: its target must not be at, right above or right below its eye");
  }
  if (!(camera.field_of_view_rad >= 0.01F && camera.field_of_view_rad <= 3.1F)) {
    return absl::InvalidArgumentError("camera: field_of_view_rad must be in [0.01, 3.1]");
  }
  PinholeCamera made;
  made.width_px = width_px;
  made.height_px = height_px;
  made.focal_px = 0.5F * static_cast<float>(height_px) / std::tan(camera.field_of_view_rad / 2);
  made.eye = camera.eye;
  made.forward = Normalized(way);
  made.right = Normalized(Cross(made.forward, {0, 0, 1}));
  made.down = Cross(made.forward, made.right);
  return made;
}

v1::CameraParameters PinholeCamera::Parameters() const {
  v1::CameraParameters camera;
  camera.set_width_px(width_px);
  camera.set_height_px(height_px);
  camera.set_focal_x_px(focal_px);
  camera.set_focal_y_px(focal_px);
  camera.set_center_x_px(0.5 * width_px);
  camera.set_center_y_px(0.5 * height_px);
  for (const Vec3& axis : {right, down, forward}) {
    camera.add_camera_from_room(axis.x);
    camera.add_camera_from_room(axis.y);
    camera.add_camera_from_room(axis.z);
    camera.add_camera_from_room(-Dot(axis, eye));
  }
  for (const double last : {0.0, 0.0, 0.0, 1.0}) camera.add_camera_from_room(last);
  return camera;
}

Seen LookFrom(const World& world, const Lights& lights, const Surroundings& around, Vec3 eye, Vec3 direction,
              float pixel_rad) {
  Seen seen;
  LookFrom(world, lights, around, eye, {&direction, 1}, pixel_rad, {&seen, 1});
  return seen;
}

void LookFrom(const World& world, const Lights& lights, const Surroundings& around, Vec3 eye,
              std::span<const Vec3> directions, float pixel_rad, std::span<Seen> seen) {
  std::array<Hit, kMostRaysTogether> hits;
  std::array<float, kMostRaysTogether> nearest;
  for (size_t i = 0; i < directions.size(); ++i) {
    nearest[i] = around.room == nullptr ? kNearest_m : std::max(kNearest_m, WayIn(*around.room, eye, directions[i]));
  }
  world.Look(eye, directions, nearest, hits);
  for (size_t i = 0; i < directions.size(); ++i) {
    seen[i] = LookOn(world, lights, around, eye, directions[i], pixel_rad, hits[i]);
  }
}

}  // namespace flair::renderer
