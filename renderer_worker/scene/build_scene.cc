// SPDX-License-Identifier: GPL-3.0-or-later

#include <cmath>
#include <unordered_map>

#include "renderer_worker/furniture/classes.h"
#include "renderer_worker/scene/room_shape.h"
#include "renderer_worker/scene/scene.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {
namespace {

absl::Status CheckObject(const v1::Object& object, const v1::Placement& pose, int index) {
  for (double value : {pose.x_m(), pose.y_m(), pose.z_m(), pose.theta_rad()}) {
    if (!std::isfinite(value) || std::abs(value) > 1e4) {
      return InvalidArgument("placements of \"{}\": {} is not a coordinate in a room; must be finite", object.id(),
                             value);
    }
  }
  for (double value : {object.width_m(), object.depth_m(), object.height_m()}) {
    if (!std::isfinite(value) || value <= 0 || value > 1e3) {
      return InvalidArgument(
          "graph.object_list.objects[{}] \"{}\": a size of {} m cannot be shown; must be in (0, 1000]", index,
          object.id(), value);
    }
  }
  return absl::OkStatus();
}

absl::Status PlaceObjects(const v1::SolvedLayout& layout, const FurnishingSource& source, Scene& scene) {
  std::unordered_map<std::string, const v1::Placement*> placements;
  for (const v1::Placement& placement : layout.placements()) placements[placement.object_id()] = &placement;
  std::unordered_map<std::string, const v1::ObjectStyle*> styles;
  for (const v1::ObjectStyle& style : layout.graph().style_sheet().objects()) styles[style.subject_id()] = &style;
  const auto& objects = layout.graph().object_list().objects();
  for (int i = 0; i < objects.size(); ++i) {
    const auto at = placements.find(objects[i].id());
    if (at == placements.end()) continue;
    RETURN_IF_ERROR(CheckObject(objects[i], *at->second, i));
    const auto style = styles.find(objects[i].id());
    SceneObject placed;
    placed.object = &objects[i];
    placed.style = style == styles.end() ? nullptr : style->second;
    placed.placement = *at->second;
    placed.furnishing = source.FurnishingOf(objects[i], placed.style, scene.diagnostics);
    if (placed.furnishing.mesh == nullptr) {
      return Internal("object \"{}\": its furnishing has no mesh", objects[i].id());
    }
    scene.objects.push_back(std::move(placed));
  }
  return absl::OkStatus();
}

// Things lie on the seat of a sofa or the mattress of a bed, not as high as the box that holds its back.
void SettleOnHosts(Scene& scene) {
  std::unordered_map<std::string, const SceneObject*> hosts;
  for (const SceneObject& object : scene.objects) hosts[object.object->id()] = &object;
  for (SceneObject& object : scene.objects) {
    const auto at = hosts.find(object.object->host_id());
    if (object.object->kind() != v1::OBJECT_KIND_SURFACE || at == hosts.end()) continue;
    const SceneObject& host = *at->second;
    if (!host.furnishing.asset_id.empty()) continue;
    const double top = host.placement.z_m() + host.object->height_m();
    const double drop =
        host.object->height_m() - RestHeightOf(host.furnishing.class_name, static_cast<float>(host.object->height_m()));
    if (drop > 1e-3 && object.placement.z_m() > top - 0.05) object.placement.set_z_m(object.placement.z_m() - drop);
  }
}

// The wall that the back of an object touches; -1 for none.
int WallBehind(const RoomShape& shape, const SceneObject& object) {
  constexpr float kTouches_m = 0.15F;
  const double theta = object.placement.theta_rad();
  const Vec3 front{static_cast<float>(-std::sin(theta)), static_cast<float>(std::cos(theta)), 0};
  const Vec3 middle{static_cast<float>(object.placement.x_m()), static_cast<float>(object.placement.y_m()), 0};
  const Vec3 back = middle - front * static_cast<float>(object.object->depth_m() / 2);
  for (size_t i = 0; i < shape.walls.size(); ++i) {
    const ShapedWall& wall = shape.walls[i];
    const Vec3 from = back - wall.axes.origin;
    const float along = Dot(from, wall.axes.along);
    if (along < 0 || along > wall.length_m || Dot(front, wall.axes.outward) > -0.7F) continue;
    if (std::abs(Dot(from, wall.axes.outward)) < kTouches_m) return static_cast<int>(i);
  }
  return -1;
}

void HangOnWalls(const RoomShape& shape, Scene& scene) {
  std::unordered_map<std::string, int> walls;
  for (SceneObject& object : scene.objects) {
    if (object.object->kind() != v1::OBJECT_KIND_WALL) continue;
    walls[object.object->id()] = object.wall = WallBehind(shape, object);
  }
  for (SceneObject& object : scene.objects) {
    const auto host = walls.find(object.object->host_id());
    if (object.object->kind() == v1::OBJECT_KIND_SURFACE && host != walls.end()) object.wall = host->second;
  }
}

std::vector<DaylightWindow> WindowsOf(const RoomShape& shape) {
  std::vector<DaylightWindow> windows;
  for (const ShapedWall& wall : shape.walls) {
    for (const ShapedOpening& opening : wall.openings) {
      if (opening.door()) continue;
      windows.push_back({wall.axes.At(opening.u0, 0, opening.w0), wall.axes.along * (opening.u1 - opening.u0),
                         wall.axes.up * (opening.w1 - opening.w0), -wall.axes.outward});
    }
  }
  return windows;
}

}  // namespace

absl::StatusOr<Scene> BuildScene(const v1::SolvedLayout& layout, const FurnishingSource& source) {
  ASSIGN_OR_RETURN(RoomShape shape, ShapeOf(layout.graph().room()));
  Scene scene;
  scene.layout = &layout;
  scene.shell = BuildShell(shape, layout.graph());
  scene.windows = WindowsOf(shape);
  RETURN_IF_ERROR(PlaceObjects(layout, source, scene));
  SettleOnHosts(scene);
  HangOnWalls(shape, scene);
  const Sight sight(shape, scene.objects);
  scene.birdseye = BirdseyeCamera(shape, sight);
  scene.perspective = PerspectiveCamera(shape, sight);
  return scene;
}

}  // namespace flair::renderer
