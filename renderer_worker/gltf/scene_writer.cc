// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/gltf/scene_writer.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "fmt/format.h"
#include "renderer_worker/gltf/numbers.h"
#include "renderer_worker/gltf/shell_faces.h"

namespace flair::renderer::gltf {
namespace {

constexpr char kLights[] = "KHR_lights_punctual";
// A bright, overcast day as it comes through windows: what lights the room evenly, and what comes from one side.
constexpr double kSunIlluminance_lx = 190;
constexpr double kSkyIlluminance_lx = 110;

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

}  // namespace

int SceneWriter::AddNode(tinygltf::Node node) {
  model_.nodes.push_back(std::move(node));
  return static_cast<int>(model_.nodes.size()) - 1;
}

void SceneWriter::AddGroup(const std::string& name, Group children, Group& parent) {
  if (children.empty()) return;
  tinygltf::Node node;
  node.name = name;
  node.children = std::move(children);
  parent.push_back(AddNode(std::move(node)));
}

std::string SceneWriter::Unused(const std::string& name, std::string_view kind) {
  std::string unused = name;
  if (names_.contains(unused)) unused = fmt::format("{} {}", name, kind);
  for (int number = 2; names_.contains(unused); ++number) unused = fmt::format("{} {} {}", name, kind, number);
  names_.insert(unused);
  return unused;
}

absl::Status SceneWriter::AddShell(Group& group) {
  seen_.reserve(scene_.shell.size());  // MeshBook keeps pointers
  for (const ShellPart& part : scene_.shell) {
    const Mesh& mesh = seen_.emplace_back(SeenFromWithin(part, scene_.layout->graph().room()));
    tinygltf::Node node;
    node.name = Unused(part.id, part.kind == ShellPart::Kind::kSkirting ? "skirting" : "part");
    absl::StatusOr<int> number = meshes_.NumberOf(mesh, MeshFrame::kRoom, node.name);
    if (!number.ok()) return number.status();
    node.mesh = *number;
    node.extras = extras_.OfShellPart(part);
    group.push_back(AddNode(std::move(node)));
  }
  return absl::OkStatus();
}

absl::Status SceneWriter::AddObject(const SceneObject& shown, Group& group) {
  const v1::Placement& p = shown.placement;
  for (const double value : {p.x_m(), p.y_m(), p.z_m(), p.theta_rad()}) {
    if (!std::isfinite(value)) {
      return absl::InvalidArgumentError(fmt::format("placement of '{}' must be finite, is x {} y {} z {} theta {}",
                                                    p.object_id(), p.x_m(), p.y_m(), p.z_m(), p.theta_rad()));
    }
  }
  tinygltf::Node node;
  node.name = Unused(shown.object->id(), "object");
  node.translation = {Rounded(p.x_m()), Rounded(p.z_m()), Rounded(-p.y_m())};
  node.rotation = ListOf(NodeRotation(p.theta_rad()));
  if (shown.furnishing.mesh != nullptr) {
    absl::StatusOr<int> number = meshes_.NumberOf(*shown.furnishing.mesh, MeshFrame::kObject, shown.object->name());
    if (!number.ok()) return number.status();
    node.mesh = *number;
  }
  has_assets_ = has_assets_ || !shown.furnishing.asset_id.empty();
  node.extras = extras_.OfObject(shown);
  for (const LampLight& lamp : shown.furnishing.lights) AddLamp(lamp, node.name, node);
  group.push_back(AddNode(std::move(node)));
  return absl::OkStatus();
}

int SceneWriter::LightNumber(tinygltf::Light light) {
  const auto known = std::find(model_.lights.begin(), model_.lights.end(), light);
  if (known != model_.lights.end()) return static_cast<int>(known - model_.lights.begin());
  model_.lights.push_back(std::move(light));
  return static_cast<int>(model_.lights.size()) - 1;
}

void SceneWriter::AddLamp(const LampLight& lamp, const std::string& name, tinygltf::Node& parent) {
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

void SceneWriter::AddDirectional(const std::string& name, Vec3 direction, Vec3 colour, double illuminance_lx,
                                 Group& group) {
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

void SceneWriter::AddDaylight(Group& group) {
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

absl::Status SceneWriter::AddCamera(const SceneCamera& camera, Group& group) {
  const Vec3 direction = camera.target - camera.eye;
  if (!IsFinite(camera.eye) || !IsFinite(direction) || !(Length(direction) > 0) || !(camera.field_of_view_rad > 0)) {
    return absl::InvalidArgumentError(
        fmt::format("camera '{}' must look somewhere, with a field of view", camera.name));
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

absl::StatusOr<tinygltf::Model> SceneWriter::Write(const GlbMetadata& metadata) {
  Group shell, furniture, lights, cameras;
  if (absl::Status status = AddShell(shell); !status.ok()) return status;
  for (const SceneObject& object : scene_.objects) {
    if (absl::Status status = AddObject(object, furniture); !status.ok()) return status;
  }
  AddDaylight(lights);
  for (const SceneCamera* camera : {&scene_.birdseye, &scene_.perspective}) {
    if (absl::Status status = AddCamera(*camera, cameras); !status.ok()) return status;
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

}  // namespace flair::renderer::gltf
