// SPDX-License-Identifier: GPL-3.0-or-later
#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "renderer_worker/furniture/classes.h"
#include "renderer_worker/tracing/sampling.h"
#include "renderer_worker/tracing/world.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {
namespace {

constexpr double kHangs_m = 0.2;  // below the ceiling

RTCRay RayFrom(Vec3 from, Vec3 direction, float least, float most) {
  return {.org_x = from.x,
          .org_y = from.y,
          .org_z = from.z,
          .tnear = least,
          .dir_x = direction.x,
          .dir_y = direction.y,
          .dir_z = direction.z,
          .time = 0,
          .tfar = most,
          .mask = ~0U,
          .id = 0,
          .flags = 0};
}

WorldInstance InstanceOf(const SceneObject& object, const CutAway& cut) {
  WorldInstance instance;
  instance.class_id = ClassIdOf(object.furnishing.class_name);
  instance.mesh = object.furnishing.mesh.get();
  const double theta = object.placement.theta_rad();
  instance.cosine = static_cast<float>(std::cos(theta));
  instance.sine = static_cast<float>(std::sin(theta));
  // What is on a wall or flat below a ceiling goes with it: it would float. Lamps hang lower.
  const bool flat = object.object->kind() == v1::OBJECT_KIND_CEILING && object.object->height_m() < kHangs_m;
  if ((cut.ceiling && flat) || cut.Takes(object.wall)) instance.seen = instance.shades = false;
  instance.origin = {static_cast<float>(object.placement.x_m()), static_cast<float>(object.placement.y_m()),
                     static_cast<float>(object.placement.z_m())};
  return instance;
}

WorldInstance InstanceOf(const ShellPart& part, const CutAway& cut) {
  WorldInstance instance;
  instance.class_id = kFloorClass + static_cast<int>(part.kind);
  instance.mesh = &part.mesh;
  if (part.kind == ShellPart::Kind::kCeiling && cut.ceiling) instance.seen = instance.shades = false;
  const WallCut wall = part.wall >= 0 ? cut.walls[part.wall] : WallCut::kWhole;
  if (wall == WallCut::kWhole) return instance;
  const bool stub = part.kind == ShellPart::Kind::kWall && wall == WallCut::kStub;
  if (stub) instance.mesh = &part.stub;
  instance.seen = instance.shades = stub;
  return instance;
}

}  // namespace

std::vector<WorldInstance> InstancesOf(const Scene& scene, const CutAway& cut) {
  std::vector<WorldInstance> instances;
  for (const SceneObject& object : scene.objects) instances.push_back(InstanceOf(object, cut));
  for (const ShellPart& part : scene.shell) instances.push_back(InstanceOf(part, cut));
  for (size_t i = 0; i < instances.size(); ++i) instances[i].instance_id = static_cast<int>(i) + 1;
  return instances;
}

int64_t TriangleCount(const Mesh& mesh) {
  int64_t count = 0;
  for (const MeshPart& part : mesh.parts) count += static_cast<int64_t>(part.indices.size() / 3);
  return count;
}

// Two scenes, of what is seen and of what shades.
struct RayTrees::Trees {
  RTCDevice device = nullptr;
  std::vector<RTCScene> meshes;  // of instances
  RTCScene seen = nullptr;
  RTCScene shading = nullptr;
  bool flat = false;
  std::vector<std::pair<int, int>> parts;  // flat: instance and part by geometry

  ~Trees() {
    for (RTCScene scene : meshes) rtcReleaseScene(scene);
    if (seen != nullptr) rtcReleaseScene(seen);
    if (shading != nullptr) rtcReleaseScene(shading);
    if (device != nullptr) rtcReleaseDevice(device);
  }

  RTCGeometry MakePart(const MeshPart& part, const WorldInstance* placed);
  RTCScene MakeMesh(const Mesh& mesh, bool only_shading);
  void AttachFlat(const WorldInstance& instance, int index);
  void AttachInstance(RTCScene scene, RTCScene mesh, const WorldInstance& instance, unsigned id);
  Hit HitOf(std::span<const WorldInstance> instances, unsigned geometry, unsigned instance, unsigned triangle) const;
  Hit Nearest(RTCScene scene, std::span<const WorldInstance> instances, Vec3 from, Vec3 direction, float least,
              RTCIntersectContextFlags flags) const;
};

// Null when there is no memory. In room frame R when `placed`.
RTCGeometry RayTrees::Trees::MakePart(const MeshPart& part, const WorldInstance* placed) {
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

RTCScene RayTrees::Trees::MakeMesh(const Mesh& mesh, bool only_shading) {
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

void RayTrees::Trees::AttachFlat(const WorldInstance& instance, int index) {
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

void RayTrees::Trees::AttachInstance(RTCScene scene, RTCScene mesh, const WorldInstance& instance, unsigned id) {
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

Hit RayTrees::Trees::HitOf(std::span<const WorldInstance> instances, unsigned geometry, unsigned instance,
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

Hit RayTrees::Trees::Nearest(RTCScene scene, std::span<const WorldInstance> instances, Vec3 from, Vec3 direction,
                             float least, RTCIntersectContextFlags flags) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = flags;
  RTCRayHit query;
  query.ray = RayFrom(from, direction, least, std::numeric_limits<float>::infinity());
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

RayTrees::RayTrees(std::span<const WorldInstance> instances)
    : instances_(instances), trees_(std::make_unique<Trees>()) {}
RayTrees::~RayTrees() = default;

absl::StatusOr<std::unique_ptr<RayTrees>> RayTrees::Make(std::span<const WorldInstance> instances, int mesh_count) {
  std::unique_ptr<RayTrees> made(new RayTrees(instances));
  Trees& trees = *made->trees_;
  // One thread builds, so that the trees and with them ties between surfaces are always the same.
  trees.device = rtcNewDevice("threads=1,set_affinity=0");
  if (trees.device == nullptr) return absl::InternalError("embree: no device");
  trees.seen = rtcNewScene(trees.device);
  trees.shading = rtcNewScene(trees.device);
  made->AttachAll(mesh_count);
  rtcCommitScene(trees.seen);
  rtcCommitScene(trees.shading);
  if (const RTCError error = rtcGetDeviceError(trees.device); error != RTC_ERROR_NONE) {
    if (error == RTC_ERROR_OUT_OF_MEMORY) return absl::ResourceExhaustedError("embree: out of memory");
    return Internal("embree: error {}", static_cast<int>(error));
  }
  return made;
}

void RayTrees::AttachAll(int mesh_count) {
  struct Built {
    RTCScene seen = nullptr, shading = nullptr;
  };
  std::vector<Built> built(static_cast<size_t>(mesh_count));
  int64_t triangles = 0;
  for (const WorldInstance& instance : instances_) triangles += TriangleCount(*instance.mesh);
  trees_->flat = triangles <= kMaxFlatTriangles;
  for (size_t i = 0; i < instances_.size(); ++i) {
    const WorldInstance& instance = instances_[i];
    if (trees_->flat) {
      trees_->AttachFlat(instance, static_cast<int>(i));
      continue;
    }
    Built& mesh = built[instance.mesh_index];
    if (mesh.seen == nullptr) {
      const auto& parts = instance.mesh->parts;
      mesh.seen = trees_->MakeMesh(*instance.mesh, false);
      mesh.shading = std::ranges::all_of(parts, [](const MeshPart& p) { return HoldsUpLight(p.material); })
                         ? mesh.seen
                         : trees_->MakeMesh(*instance.mesh, true);
    }
    if (instance.seen) trees_->AttachInstance(trees_->seen, mesh.seen, instance, static_cast<unsigned>(i));
    if (instance.shades) trees_->AttachInstance(trees_->shading, mesh.shading, instance, static_cast<unsigned>(i));
  }
}

Hit RayTrees::NearestSeen(Vec3 from, Vec3 direction, float least) const {
  return trees_->Nearest(trees_->seen, instances_, from, direction, least, RTC_INTERSECT_CONTEXT_FLAG_COHERENT);
}

Hit RayTrees::NearestShading(Vec3 from, Vec3 direction) const {
  return trees_->Nearest(trees_->shading, instances_, from, direction, 0, RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT);
}

void RayTrees::NearestSeen(Vec3 from, std::span<const Vec3> directions, std::span<const float> least,
                           std::span<Hit> hits) const {
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
  rtcIntersect8(valid.data(), trees_->seen, &context, &query);
  for (size_t i = 0; i <= last; ++i) {
    hits[i] = {};
    if (query.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
    Hit& hit = hits[i] = trees_->HitOf(instances_, query.hit.geomID[i], query.hit.instID[0][i], query.hit.primID[i]);
    hit.distance = query.ray.tfar[i];
    hit.u = query.hit.u[i];
    hit.v = query.hit.v[i];
    hit.across = {query.hit.Ng_x[i], query.hit.Ng_y[i], query.hit.Ng_z[i]};
    if (!trees_->flat) hit.across = instances_[hit.instance].TurnToRoom(hit.across);
  }
}

bool RayTrees::Shaded(Vec3 from, Vec3 direction, float distance) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray = RayFrom(from, direction, 0, distance);
  rtcOccluded1(trees_->shading, &context, &ray);
  return ray.tfar < 0;
}

}  // namespace flair::renderer
