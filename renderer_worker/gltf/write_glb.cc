// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "flair/v1/room.pb.h"
#include "fmt/format.h"
#include "renderer_worker/gltf/gltf.h"
#include "renderer_worker/gltf/mesh_book.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {

absl::Status CheckFinite(const v1::Placement& placement) {
  const double x = placement.x_m(), y = placement.y_m(), z = placement.z_m(), theta = placement.theta_rad();
  if (std::isfinite(x) && std::isfinite(y) && std::isfinite(z) && std::isfinite(theta)) return absl::OkStatus();
  return InvalidArgument("placement of '{}' must be finite, is x {} y {} z {} theta {}", placement.object_id(), x, y, z,
                         theta);
}

namespace gltf {
namespace {

// Unit, towards the outside of the wall from floor corner `wall` to the next; the floor runs counter-clockwise.
Vec3 OutwardOf(const v1::Room& room, int wall) {
  const auto& corners = room.floor().vertices();
  if (wall < 0 || wall >= corners.size()) return {0, 0, 1};
  const v1::Point2& a = corners[wall];
  const v1::Point2& b = corners[(wall + 1) % corners.size()];
  return Normalized({static_cast<float>(b.y_m() - a.y_m()), static_cast<float>(a.x_m() - b.x_m()), 0});
}

// A wall's faces towards the room, its top and the reveals of its openings; not its outer face, nor the oblique ones at
// its ends, which its neighbours cover.
bool WallFaceIsSeen(Vec3 normal, Vec3 outward) {
  constexpr float kParallel = 0.999F;
  const Vec3 along{-outward.y, outward.x, 0};
  return normal.z > kParallel || normal.z < -kParallel || Dot(normal, outward) < -kParallel ||
         std::abs(Dot(normal, along)) > kParallel;
}

// The faces of a part of the shell that are seen from within the room: the underside of the ceiling, walls without
// their outer faces. Nearly all viewers leave out the backs of surfaces and so show the room from outside and above
// like a doll's house, and cameras may stand behind a wall. All other parts as they are.
Mesh SeenFromWithin(const ShellPart& part, const v1::Room& room) {
  const bool ceiling = part.kind == ShellPart::Kind::kCeiling;
  if (!ceiling && part.kind != ShellPart::Kind::kWall) return part.mesh;
  const Vec3 outward = OutwardOf(room, part.wall);
  Mesh kept;
  for (MeshPart faces : part.mesh.parts) {
    std::vector<uint32_t> indices;
    for (size_t i = 0; i + 2 < faces.indices.size(); i += 3) {
      const uint32_t* corner = &faces.indices[i];
      if (std::max({corner[0], corner[1], corner[2]}) >= faces.positions.size()) return part.mesh;  // MeshBook tells
      const Vec3 a = faces.positions[corner[0]];
      const Vec3 normal = Normalized(Cross(faces.positions[corner[1]] - a, faces.positions[corner[2]] - a));
      const bool seen = ceiling ? normal.z < -0.5F : WallFaceIsSeen(normal, outward);
      if (seen) indices.insert(indices.end(), corner, corner + 3);
    }
    faces.indices = std::move(indices);
    if (!faces.indices.empty()) kept.parts.push_back(std::move(faces));
  }
  return kept;
}

constexpr char kLights[] = "KHR_lights_punctual";
// A bright, overcast day as it comes through windows: what lights the room evenly, and what comes from one side.
constexpr double kSunIlluminance_lx = 190;
constexpr double kSkyIlluminance_lx = 110;

// Of a node whose local -z looks along `direction` and whose local y points up as far as it can: cameras, directional
// lights. Both in glTF's frame; any length but zero.
Quaternion LookingAlong(Vec3 direction) {
  // Columns of the rotation: right, up, back.
  const Vec3 back = Normalized(-direction);
  const Vec3 sideways = Cross({0, 1, 0}, back);
  const Vec3 right = Length(sideways) > 1e-6F ? Normalized(sideways) : Vec3{1, 0, 0};
  const Vec3 up = Cross(back, right);
  // Shepperd's method: divide by the largest of the four components.
  const double trace = double{right.x} + up.y + back.z;
  Quaternion q{};
  if (trace > 0) {
    const double s = 2 * std::sqrt(trace + 1);
    q = {(up.z - back.y) / s, (back.x - right.z) / s, (right.y - up.x) / s, s / 4};
  } else if (right.x > up.y && right.x > back.z) {
    const double s = 2 * std::sqrt(1.0 + right.x - up.y - back.z);
    q = {s / 4, (up.x + right.y) / s, (back.x + right.z) / s, (up.z - back.y) / s};
  } else if (up.y > back.z) {
    const double s = 2 * std::sqrt(1.0 + up.y - right.x - back.z);
    q = {(up.x + right.y) / s, s / 4, (back.y + up.z) / s, (back.x - right.z) / s};
  } else {
    const double s = 2 * std::sqrt(1.0 + back.z - right.x - up.y);
    q = {(back.x + right.z) / s, (back.y + up.z) / s, s / 4, (right.y - up.x) / s};
  }
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (double& component : q) component /= length;
  return q;
}

std::vector<double> ListOf(Vec3 v) { return {Rounded(v.x), Rounded(v.y), Rounded(v.z)}; }

std::vector<double> ListOf(const Quaternion& q) {
  std::vector<double> list;
  for (const double component : q) list.push_back(std::round(component * 1e9) / 1e9 + 0.0);
  return list;
}

// Where a camera begins to see: behind the wall that it looks through from outside.
double NearDistance(const SceneCamera& camera, const v1::Room& room) {
  constexpr double kNearest_m = 0.05;
  constexpr double kFramesReach_m = 0.2;  // into the room
  const Vec3 direction = Normalized(camera.target - camera.eye);
  if (camera.eye.z > room.height_m()) return kNearest_m;
  const auto& corners = room.floor().vertices();
  // Crossings of the line of sight and of a line from the eye with the walls, in plan: an odd number, and it is inside.
  double first = 1e9;
  int crossings = 0;
  for (int i = 0; i < corners.size(); ++i) {
    const v1::Point2& a = corners[i];
    const v1::Point2& b = corners[(i + 1) % corners.size()];
    const double ax = a.x_m() - camera.eye.x, ay = a.y_m() - camera.eye.y;
    const double wx = b.x_m() - a.x_m(), wy = b.y_m() - a.y_m();
    const double cross = direction.x * wy - direction.y * wx;
    if (cross == 0) continue;
    const double distance = (ax * wy - ay * wx) / cross;                 // along the line of sight
    const double share = (ax * direction.y - ay * direction.x) / cross;  // of the wall
    if (distance <= 0 || share < 0 || share >= 1) continue;
    ++crossings;
    first = std::min(first, distance);
  }
  return crossings > 0 && crossings % 2 == 0 ? Rounded(first + kFramesReach_m) : kNearest_m;
}

// Makes the model of one scene: a root with the groups shell, furniture, lights and cameras.
class SceneWriter {
 public:
  explicit SceneWriter(const Scene& scene) : scene_(scene), extras_(*scene.layout) {}

  // Call once. Errors as WriteGlb.
  absl::StatusOr<tinygltf::Model> Write(const GlbMetadata& metadata) {
    Group shell, furniture, lights, cameras;
    RETURN_IF_ERROR(AddShell(shell));
    for (const SceneObject& object : scene_.objects) RETURN_IF_ERROR(AddObject(object, furniture));
    AddDaylight(lights);
    for (const SceneCamera* camera : {&scene_.birdseye, &scene_.perspective}) {
      RETURN_IF_ERROR(AddCamera(*camera, cameras));
    }
    Group top;
    AddGroup("shell", std::move(shell), top);
    AddGroup("furniture", std::move(furniture), top);
    AddGroup("daylight", std::move(lights), top);
    AddGroup("cameras", std::move(cameras), top);

    const v1::Room& room = scene_.layout->graph().room();
    Group roots;
    AddGroup(room.room_type().empty() ? "room" : room.room_type(), std::move(top), roots);
    tinygltf::Scene scene;
    scene.name = room.title();
    scene.nodes = std::move(roots);
    model_.scenes.push_back(std::move(scene));
    model_.defaultScene = 0;
    buffer_.Finish();

    model_.asset.version = "2.0";
    model_.asset.generator = metadata.build.empty() ? "Flair" : "Flair " + metadata.build;
    model_.asset.copyright = "Meshes made by Flair: no rights reserved.";
    if (has_assets_) model_.asset.copyright += " Assets: see asset_licence in the extras of their nodes.";
    model_.asset.extras = Extras::OfAsset(scene_, metadata);
    return std::move(model_);
  }

 private:
  using Group = std::vector<int>;  // numbers of nodes

  absl::Status AddShell(Group& group) {
    seen_.reserve(scene_.shell.size());  // MeshBook keeps pointers
    for (const ShellPart& part : scene_.shell) {
      const Mesh& mesh = seen_.emplace_back(SeenFromWithin(part, scene_.layout->graph().room()));
      tinygltf::Node node;
      node.name = Unused(part.id, part.kind == ShellPart::Kind::kSkirting ? "skirting" : "part");
      ASSIGN_OR_RETURN(node.mesh, meshes_.NumberOf(mesh, MeshFrame::kRoom, node.name));
      node.extras = extras_.OfShellPart(part);
      group.push_back(AddNode(std::move(node)));
    }
    return absl::OkStatus();
  }
  absl::Status AddObject(const SceneObject& shown, Group& group) {
    const v1::Placement& p = shown.placement;
    RETURN_IF_ERROR(CheckFinite(p));
    tinygltf::Node node;
    node.name = Unused(shown.object->id(), "object");
    node.translation = {Rounded(p.x_m()), Rounded(p.z_m()), Rounded(-p.y_m())};
    node.rotation = ListOf(NodeRotation(p.theta_rad()));
    if (shown.furnishing.mesh != nullptr) {
      ASSIGN_OR_RETURN(node.mesh, meshes_.NumberOf(*shown.furnishing.mesh, MeshFrame::kObject, shown.object->name()));
    }
    has_assets_ = has_assets_ || !shown.furnishing.asset_id.empty();
    node.extras = extras_.OfObject(shown);
    for (const LampLight& lamp : shown.furnishing.lights) AddLamp(lamp, node.name, node);
    group.push_back(AddNode(std::move(node)));
    return absl::OkStatus();
  }
  void AddLamp(const LampLight& lamp, const std::string& name, tinygltf::Node& parent) {
    if (!(lamp.intensity_cd > 0) || !IsFinite(lamp.position) || !std::isfinite(lamp.intensity_cd)) return;
    tinygltf::Light light;
    light.type = "point";
    light.name = "lamp";
    light.color = ListOf(lamp.colour);
    for (double& share : light.color) share = std::clamp(share, 0.0, 1.0);
    light.intensity = Rounded(lamp.intensity_cd * kLightScale);
    tinygltf::Value::Object reference;
    reference["light"] = tinygltf::Value(LightNumber(std::move(light)));
    tinygltf::Node node;
    node.name = Unused(name + " light", "light");
    node.translation = ListOf(FromObject(lamp.position));
    node.extensions[kLights] = tinygltf::Value(std::move(reference));
    parent.children.push_back(AddNode(std::move(node)));
  }
  void AddDaylight(Group& group) {
    Vec3 inward{0, 0, 0};
    for (const DaylightWindow& window : scene_.windows) {
      inward = inward + window.inward * (Length(window.along) * Length(window.up));
    }
    // Windows that face each other, or none: from the south-west.
    inward.z = 0;
    if (!IsFinite(inward) || Length(inward) < 1e-3F) inward = {0.5F, 0.8F, 0};
    inward = Normalized(inward);
    // A little from one side, so that a window's two sides and a corner's two walls differ.
    const Vec3 sideways{-inward.y, inward.x, 0};
    AddDirectional("sun", inward + sideways * 0.35F + Vec3{0, 0, -1.1F}, {1, 0.96F, 0.9F}, kSunIlluminance_lx, group);
    AddDirectional("sky", inward * -0.6F + sideways * -0.3F + Vec3{0, 0, -0.8F}, {0.86F, 0.93F, 1}, kSkyIlluminance_lx,
                   group);
  }
  void AddDirectional(const std::string& name, Vec3 direction, Vec3 colour, double illuminance_lx, Group& group) {
    tinygltf::Light light;
    light.type = "directional";
    light.name = name;
    light.color = ListOf(colour);
    light.intensity = Rounded(illuminance_lx * kLightScale);
    tinygltf::Value::Object reference;
    reference["light"] = tinygltf::Value(LightNumber(std::move(light)));
    tinygltf::Node node;
    node.name = Unused(name, "light");
    node.rotation = ListOf(LookingAlong(FromRoom(direction)));
    node.extensions[kLights] = tinygltf::Value(std::move(reference));
    group.push_back(AddNode(std::move(node)));
  }
  absl::Status AddCamera(const SceneCamera& camera, Group& group) {
    const Vec3 direction = camera.target - camera.eye;
    if (!IsFinite(camera.eye) || !IsFinite(direction) || !(Length(direction) > 0) || !(camera.field_of_view_rad > 0)) {
      return InvalidArgument("camera '{}' must look somewhere, with a field of view", camera.name);
    }
    tinygltf::Camera written;
    written.type = "perspective";
    written.name = camera.name;
    written.perspective.yfov = Rounded(camera.field_of_view_rad);
    written.perspective.znear = NearDistance(camera, scene_.layout->graph().room());
    written.perspective.zfar = 500;
    tinygltf::Node node;
    node.name = Unused(camera.name, "camera");
    node.translation = ListOf(FromRoom(camera.eye));
    node.rotation = ListOf(LookingAlong(FromRoom(direction)));
    node.camera = static_cast<int>(model_.cameras.size());
    model_.cameras.push_back(std::move(written));
    group.push_back(AddNode(std::move(node)));
    return absl::OkStatus();
  }
  void AddGroup(const std::string& name, Group children, Group& parent) {
    if (children.empty()) return;
    tinygltf::Node node;
    node.name = name;
    node.children = std::move(children);
    parent.push_back(AddNode(std::move(node)));
  }
  int AddNode(tinygltf::Node node) {
    model_.nodes.push_back(std::move(node));
    return static_cast<int>(model_.nodes.size()) - 1;
  }
  int LightNumber(tinygltf::Light light) {
    const auto known = std::ranges::find(model_.lights, light);
    if (known != model_.lights.end()) return static_cast<int>(known - model_.lights.begin());
    model_.lights.push_back(std::move(light));
    return static_cast<int>(model_.lights.size()) - 1;
  }
  std::string Unused(const std::string& name, std::string_view kind) {
    std::string unused = name;
    if (names_.contains(unused)) unused = fmt::format("{} {}", name, kind);
    for (int number = 2; names_.contains(unused); ++number) unused = fmt::format("{} {} {}", name, kind, number);
    names_.insert(unused);
    return unused;
  }

  const Scene& scene_;
  Extras extras_;
  tinygltf::Model model_;
  GlbBuffer buffer_{model_};
  MaterialBook materials_{model_, buffer_};
  MeshBook meshes_{model_, buffer_, materials_};
  std::set<std::string> names_;
  std::vector<Mesh> seen_;  // of the shell
  bool has_assets_ = false;
};

}  // namespace

}  // namespace gltf

absl::StatusOr<std::string> WriteGlb(const Scene& scene, const GlbMetadata& metadata) {
  ASSIGN_OR_RETURN(tinygltf::Model model, gltf::SceneWriter(scene).Write(metadata));
  return gltf::GlbText(model);
}

absl::StatusOr<std::string> WriteMeshGlb(const Mesh& mesh, const std::string& name) {
  tinygltf::Model model;
  gltf::GlbBuffer buffer(model);
  gltf::MaterialBook materials(model, buffer);
  gltf::MeshBook meshes(model, buffer, materials);
  ASSIGN_OR_RETURN(int number, meshes.NumberOf(mesh, gltf::MeshFrame::kObject, name));
  if (number < 0) return Internal("the mesh of {} has no triangles", name);
  buffer.Finish();
  tinygltf::Node node;
  node.name = name;
  node.mesh = number;
  model.nodes.push_back(std::move(node));
  tinygltf::Scene scene;
  scene.nodes = {0};
  model.scenes.push_back(std::move(scene));
  model.defaultScene = 0;
  model.asset.version = "2.0";
  model.asset.generator = "Flair";
  return gltf::GlbText(model);
}

}  // namespace flair::renderer
