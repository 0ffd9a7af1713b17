// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/tracing/world.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "renderer_worker/furniture/classes.h"
#include "renderer_worker/tracing/patterns/pattern.h"
#include "renderer_worker/tracing/sampling.h"

namespace flair::renderer {
namespace {

bool HoldsUpLight(const Material& material) { return material.opacity >= 1 && Luminance(material.emission) <= 0; }

int64_t TriangleCount(const Mesh& mesh) {
  int64_t count = 0;
  for (const MeshPart& part : mesh.parts) count += static_cast<int64_t>(part.indices.size() / 3);
  return count;
}

absl::Status CheckMesh(const Mesh& mesh, int64_t& triangles) {
  for (const MeshPart& part : mesh.parts) {
    if (part.normals.size() != part.positions.size() || part.uvs.size() != part.positions.size() ||
        part.indices.size() % 3 != 0) {
      return absl::InvalidArgumentError(
          fmt::format("mesh part \"{}\": its arrays do not run parallel", part.material.name));
    }
    for (uint32_t index : part.indices) {
      if (index >= part.positions.size()) {
        return absl::InvalidArgumentError(fmt::format("mesh part \"{}\": index {} of {} positions", part.material.name,
                                                      index, part.positions.size()));
      }
    }
  }
  triangles += TriangleCount(mesh);
  return absl::OkStatus();
}

int ClassOfPart(ShellPart::Kind kind) {
  switch (kind) {
    case ShellPart::Kind::kFloor:
      return kFloorClass;
    case ShellPart::Kind::kCeiling:
      return kCeilingClass;
    case ShellPart::Kind::kWall:
      return kWallClass;
    case ShellPart::Kind::kDoor:
      return kDoorClass;
    case ShellPart::Kind::kWindow:
      return kWindowClass;
    case ShellPart::Kind::kSkirting:
      return kSkirtingClass;
  }
  return 0;
}

// Ids count objects in the list's order, then all parts of the shell, seen or not: the same in every view.
std::vector<WorldInstance> InstancesOf(const Scene& scene, const CutAway& cut) {
  std::vector<WorldInstance> instances;
  int id = 0;
  for (const SceneObject& object : scene.objects) {
    WorldInstance instance;
    instance.instance_id = ++id;
    instance.class_id = ClassIdOf(object.furnishing.class_name);
    instance.mesh = object.furnishing.mesh.get();
    const double theta = object.placement.theta_rad();
    instance.cosine = static_cast<float>(std::cos(theta));
    instance.sine = static_cast<float>(std::sin(theta));
    // What hangs from a ceiling goes with it: it would float, and hide what it hangs over.
    const bool hangs = object.object->kind() == v1::OBJECT_KIND_CEILING;
    if (cut.ceiling && hangs) instance.seen = instance.shades = false;
    instance.origin = {static_cast<float>(object.placement.x_m()), static_cast<float>(object.placement.y_m()),
                       static_cast<float>(object.placement.z_m())};
    instances.push_back(instance);
  }
  for (const ShellPart& part : scene.shell) {
    WorldInstance instance;
    instance.instance_id = ++id;
    instance.class_id = ClassOfPart(part.kind);
    instance.mesh = &part.mesh;
    const WallCut wall = part.wall >= 0 ? cut.walls[part.wall] : WallCut::kWhole;
    if (part.kind == ShellPart::Kind::kCeiling && cut.ceiling) instance.seen = instance.shades = false;
    if (wall != WallCut::kWhole) {
      instance.seen = false;
      instance.shades = false;
      if (part.kind == ShellPart::Kind::kWall && wall == WallCut::kStub) {
        instance.mesh = &part.stub;
        instance.seen = instance.shades = true;
      }
    }
    instances.push_back(instance);
  }
  return instances;
}

}  // namespace

// Embree's side: two scenes, of what is seen and of what shades.
struct World::Rays {
  RTCDevice device = nullptr;
  std::vector<RTCScene> meshes;  // of instances
  RTCScene seen = nullptr;
  RTCScene shading = nullptr;
  bool flat = false;
  std::vector<std::pair<int, int>> parts;  // flat: instance and part by geometry

  ~Rays() {
    for (RTCScene scene : meshes) rtcReleaseScene(scene);
    if (seen != nullptr) rtcReleaseScene(seen);
    if (shading != nullptr) rtcReleaseScene(shading);
    if (device != nullptr) rtcReleaseDevice(device);
  }

  RTCGeometry MakePart(const MeshPart& part, const WorldInstance* placed);
  RTCScene MakeMesh(const Mesh& mesh, bool only_shading);
  void AttachFlat(const WorldInstance& instance, int index);
  void AttachInstance(RTCScene scene, RTCScene mesh, const WorldInstance& instance, unsigned id);
  Hit HitOf(const std::vector<WorldInstance>& instances, unsigned geometry, unsigned instance, unsigned triangle) const;
  Hit Nearest(RTCScene scene, const std::vector<WorldInstance>& instances, Vec3 from, Vec3 direction, float least,
              RTCIntersectContextFlags flags) const;
};

// Null when there is no memory. In room frame R when `placed`.
RTCGeometry World::Rays::MakePart(const MeshPart& part, const WorldInstance* placed) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  Vec3* vertices = static_cast<Vec3*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                              sizeof(Vec3), part.positions.size()));
  void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(uint32_t),
                                          part.indices.size() / 3);
  if (vertices == nullptr || indices == nullptr) {
    rtcReleaseGeometry(geometry);
    return nullptr;
  }
  for (size_t i = 0; i < part.positions.size(); ++i) {
    vertices[i] = placed != nullptr ? placed->ToRoom(part.positions[i]) : part.positions[i];
  }
  std::memcpy(indices, part.indices.data(), part.indices.size() * sizeof(uint32_t));
  rtcCommitGeometry(geometry);
  return geometry;
}

RTCScene World::Rays::MakeMesh(const Mesh& mesh, bool only_shading) {
  RTCScene scene = rtcNewScene(device);
  for (unsigned i = 0; i < mesh.parts.size(); ++i) {
    const MeshPart& part = mesh.parts[i];
    if (part.indices.empty() || (only_shading && !HoldsUpLight(part.material))) continue;
    if (RTCGeometry geometry = MakePart(part, nullptr); geometry != nullptr) {
      rtcAttachGeometryByID(scene, geometry, i);
      rtcReleaseGeometry(geometry);
    }
  }
  rtcCommitScene(scene);
  meshes.push_back(scene);
  return scene;
}

void World::Rays::AttachFlat(const WorldInstance& instance, int index) {
  for (size_t i = 0; i < instance.mesh->parts.size(); ++i) {
    const MeshPart& part = instance.mesh->parts[i];
    if (part.indices.empty() || !(instance.seen || instance.shades)) continue;
    RTCGeometry geometry = MakePart(part, &instance);
    if (geometry == nullptr) continue;
    const unsigned id = static_cast<unsigned>(parts.size());
    parts.emplace_back(index, static_cast<int>(i));
    if (instance.seen) rtcAttachGeometryByID(seen, geometry, id);
    if (instance.shades && HoldsUpLight(part.material)) rtcAttachGeometryByID(shading, geometry, id);
    rtcReleaseGeometry(geometry);
  }
}

void World::Rays::AttachInstance(RTCScene scene, RTCScene mesh, const WorldInstance& instance, unsigned id) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
  if (geometry == nullptr) return;
  rtcSetGeometryInstancedScene(geometry, mesh);
  rtcSetGeometryTimeStepCount(geometry, 1);
  const float to_room[12] = {
      instance.cosine,   instance.sine,    0, -instance.sine, instance.cosine, 0, 0, 0, 1, instance.origin.x,
      instance.origin.y, instance.origin.z};
  rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, to_room);
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, id);
  rtcReleaseGeometry(geometry);
}

World::World() = default;
World::~World() = default;

absl::Status World::MakeMeanColours() {
  std::unordered_map<const Mesh*, int> known;
  int64_t triangles = 0;
  for (WorldInstance& instance : instances_) {
    const auto [at, is_new] = known.try_emplace(instance.mesh, static_cast<int>(mean_colours_.size()));
    instance.mesh_index = at->second;
    if (!is_new) continue;
    if (absl::Status status = CheckMesh(*instance.mesh, triangles); !status.ok()) return status;
    if (triangles > kMaxTriangles) {
      return absl::ResourceExhaustedError(fmt::format("the scene's meshes have more than {} triangles", kMaxTriangles));
    }
    std::vector<Vec3>& colours = mean_colours_.emplace_back();
    for (const MeshPart& part : instance.mesh->parts) colours.push_back(MeanPatternColour(part.material));
  }
  return absl::OkStatus();
}

void World::AttachAll() {
  struct Built {
    RTCScene seen = nullptr, shading = nullptr;
  };
  std::vector<Built> built(mean_colours_.size());
  int64_t triangles = 0;
  for (const WorldInstance& instance : instances_) triangles += TriangleCount(*instance.mesh);
  rays_->flat = triangles <= kMaxFlatTriangles;
  for (size_t i = 0; i < instances_.size(); ++i) {
    const WorldInstance& instance = instances_[i];
    if (rays_->flat) {
      rays_->AttachFlat(instance, static_cast<int>(i));
      continue;
    }
    Built& mesh = built[instance.mesh_index];
    if (mesh.seen == nullptr) {
      const auto& parts = instance.mesh->parts;
      mesh.seen = rays_->MakeMesh(*instance.mesh, false);
      mesh.shading = std::all_of(parts.begin(), parts.end(), [](const MeshPart& p) { return HoldsUpLight(p.material); })
                         ? mesh.seen
                         : rays_->MakeMesh(*instance.mesh, true);
    }
    if (instance.seen) rays_->AttachInstance(rays_->seen, mesh.seen, instance, static_cast<unsigned>(i));
    if (instance.shades) rays_->AttachInstance(rays_->shading, mesh.shading, instance, static_cast<unsigned>(i));
  }
}

absl::StatusOr<std::unique_ptr<World>> World::Make(const Scene& scene, const CutAway& cut) {
  std::unique_ptr<World> world(new World);
  world->instances_ = InstancesOf(scene, cut);
  if (absl::Status status = world->MakeMeanColours(); !status.ok()) return status;
  world->rays_ = std::make_unique<Rays>();
  Rays& rays = *world->rays_;
  // One thread builds, so that the trees and with them ties between surfaces are always the same.
  rays.device = rtcNewDevice("threads=1,set_affinity=0");
  if (rays.device == nullptr) return absl::InternalError("embree: no device");
  rays.seen = rtcNewScene(rays.device);
  rays.shading = rtcNewScene(rays.device);
  world->AttachAll();

  rtcCommitScene(rays.seen);
  rtcCommitScene(rays.shading);
  if (const RTCError error = rtcGetDeviceError(rays.device); error != RTC_ERROR_NONE) {
    if (error == RTC_ERROR_OUT_OF_MEMORY) return absl::ResourceExhaustedError("embree: out of memory");
    return absl::InternalError(fmt::format("embree: error {}", static_cast<int>(error)));
  }
  return world;
}

Hit World::Rays::HitOf(const std::vector<WorldInstance>& instances, unsigned geometry, unsigned instance,
                       unsigned triangle) const {
  Hit hit;
  hit.triangle = static_cast<int>(triangle);
  if (flat) {
    std::tie(hit.instance, hit.part) = parts[geometry];
  } else {
    hit.instance = static_cast<int>(instance);
    hit.part = static_cast<int>(geometry);
  }
  return hit;
}

Hit World::Rays::Nearest(RTCScene scene, const std::vector<WorldInstance>& instances, Vec3 from, Vec3 direction,
                         float least, RTCIntersectContextFlags flags) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = flags;
  RTCRayHit query;
  query.ray.org_x = from.x, query.ray.org_y = from.y, query.ray.org_z = from.z;
  query.ray.dir_x = direction.x, query.ray.dir_y = direction.y, query.ray.dir_z = direction.z;
  query.ray.tnear = least;
  query.ray.tfar = std::numeric_limits<float>::infinity();
  query.ray.time = 0;
  query.ray.mask = ~0U;
  query.ray.id = 0;
  query.ray.flags = 0;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  Hit hit = HitOf(instances, query.hit.geomID, query.hit.instID[0], query.hit.primID);
  hit.distance = query.ray.tfar;
  hit.u = query.hit.u;
  hit.v = query.hit.v;
  hit.across = {query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z};
  if (!flat) hit.across = instances[hit.instance].TurnToRoom(hit.across);
  return hit;
}

Hit World::Look(Vec3 from, Vec3 direction, float least) const {
  return rays_->Nearest(rays_->seen, instances_, from, direction, least, RTC_INTERSECT_CONTEXT_FLAG_COHERENT);
}

Hit World::Feel(Vec3 from, Vec3 direction) const {
  return rays_->Nearest(rays_->shading, instances_, from, direction, 0, RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT);
}

void World::Look(Vec3 from, std::span<const Vec3> directions, std::span<const float> least, std::span<Hit> hits) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  alignas(32) std::array<int, kMostRaysTogether> valid{};
  RTCRayHit8 query;
  const size_t last = directions.size() - 1;
  for (size_t i = 0; i < kMostRaysTogether; ++i) {
    const Vec3 direction = directions[std::min(i, last)];
    valid[i] = i <= last && std::isfinite(least[i]) ? -1 : 0;
    query.ray.org_x[i] = from.x, query.ray.org_y[i] = from.y, query.ray.org_z[i] = from.z;
    query.ray.dir_x[i] = direction.x, query.ray.dir_y[i] = direction.y, query.ray.dir_z[i] = direction.z;
    query.ray.tnear[i] = valid[i] != 0 ? least[i] : 0;
    query.ray.tfar[i] = std::numeric_limits<float>::infinity();
    query.ray.time[i] = 0;
    query.ray.mask[i] = ~0U;
    query.ray.id[i] = query.ray.flags[i] = 0;
    query.hit.geomID[i] = query.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  rtcIntersect8(valid.data(), rays_->seen, &context, &query);
  for (size_t i = 0; i <= last; ++i) {
    hits[i] = {};
    if (query.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
    Hit& hit = hits[i] = rays_->HitOf(instances_, query.hit.geomID[i], query.hit.instID[0][i], query.hit.primID[i]);
    hit.distance = query.ray.tfar[i];
    hit.u = query.hit.u[i];
    hit.v = query.hit.v[i];
    hit.across = {query.hit.Ng_x[i], query.hit.Ng_y[i], query.hit.Ng_z[i]};
    if (!rays_->flat) hit.across = instances_[hit.instance].TurnToRoom(hit.across);
  }
}

bool World::Shaded(Vec3 from, Vec3 direction, float distance) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray;
  ray.org_x = from.x, ray.org_y = from.y, ray.org_z = from.z;
  ray.dir_x = direction.x, ray.dir_y = direction.y, ray.dir_z = direction.z;
  ray.tnear = 0;
  ray.tfar = distance;
  ray.time = 0;
  ray.mask = ~0U;
  ray.id = 0;
  ray.flags = 0;
  rtcOccluded1(rays_->shading, &context, &ray);
  return ray.tfar < 0;
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
