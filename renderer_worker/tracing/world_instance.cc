// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/tracing/world_instance.h"

#include <cmath>

#include "renderer_worker/furniture/classes.h"

namespace flair::renderer {
namespace {

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

WorldInstance InstanceOf(const SceneObject& object, const CutAway& cut) {
  WorldInstance instance;
  instance.class_id = ClassIdOf(object.furnishing.class_name);
  instance.mesh = object.furnishing.mesh.get();
  const double theta = object.placement.theta_rad();
  instance.cosine = static_cast<float>(std::cos(theta));
  instance.sine = static_cast<float>(std::sin(theta));
  // What hangs from a ceiling or on a wall goes with it: it would float, and hide what it hangs over.
  const bool hangs = object.object->kind() == v1::OBJECT_KIND_CEILING;
  if ((cut.ceiling && hangs) || cut.Takes(object.wall)) instance.seen = instance.shades = false;
  instance.origin = {static_cast<float>(object.placement.x_m()), static_cast<float>(object.placement.y_m()),
                     static_cast<float>(object.placement.z_m())};
  return instance;
}

WorldInstance InstanceOf(const ShellPart& part, const CutAway& cut) {
  WorldInstance instance;
  instance.class_id = ClassOfPart(part.kind);
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

}  // namespace flair::renderer
