// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/scene/sight.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "renderer_worker/scene/shell.h"

namespace flair::renderer {
namespace {

constexpr size_t kMaxBoxes = 80;

float Volume(const SightBox& box) { return box.half.x * box.half.y * box.half.z; }

// Where the way enters the box, `miss` when it does not up to there.
float Enter(const SightBox& box, Vec3 eye, Vec3 direction, float miss) {
  const Vec3 from = eye - box.centre;
  const float origin[] = {Dot(from, box.right), Dot(from, box.front), from.z};
  const float along[] = {Dot(direction, box.right), Dot(direction, box.front), direction.z};
  const float half[] = {box.half.x, box.half.y, box.half.z};
  float enter = 0, leave = miss;
  for (int k = 0; k < 3; ++k) {
    const float inverse = 1 / (std::abs(along[k]) > 1e-9F ? along[k] : 1e-9F);
    const float a = (-half[k] - origin[k]) * inverse, b = (half[k] - origin[k]) * inverse;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter < leave ? enter : miss;
}

std::vector<SightBox> LeavesOf(const RoomShape& shape) {
  std::vector<SightBox> leaves;
  for (const ShapedWall& wall : shape.walls) {
    for (const ShapedOpening& opening : wall.openings) {
      const std::optional<Axes> axes = OpenLeafAxes(shape, wall, opening);
      if (!axes.has_value()) continue;
      SightBox leaf;
      const float width = opening.u1 - opening.u0;
      leaf.half = {width < 1.3F ? width / 2 : width / 4, 0.03F, (opening.w1 - opening.w0) / 2};  // wide ones have two
      leaf.centre = axes->At(leaf.half.x, 0, leaf.half.z);
      leaf.right = axes->along;
      leaf.front = axes->outward;
      leaves.push_back(leaf);
    }
  }
  return leaves;
}

}  // namespace

Sight::Sight(const RoomShape& shape, const std::vector<SceneObject>& objects)
    : shape_(shape), leaves_(LeavesOf(shape)) {
  for (const SceneObject& o : objects) {
    if (o.object->walk_over()) continue;
    const float theta = static_cast<float>(o.placement.theta_rad());
    SightBox box;
    box.half = Vec3{static_cast<float>(o.object->width_m()), static_cast<float>(o.object->depth_m()),
                    static_cast<float>(o.object->height_m())} *
               0.5F;
    box.centre = {static_cast<float>(o.placement.x_m()), static_cast<float>(o.placement.y_m()),
                  static_cast<float>(o.placement.z_m()) + box.half.z};
    box.right = {std::cos(theta), std::sin(theta), 0};
    box.front = {-std::sin(theta), std::cos(theta), 0};
    box.high = o.object->kind() == v1::OBJECT_KIND_CEILING;
    box.wall = o.wall;
    boxes_.push_back(box);
  }
  if (boxes_.size() > kMaxBoxes) {
    std::stable_sort(boxes_.begin(), boxes_.end(),
                     [](const SightBox& a, const SightBox& b) { return Volume(a) > Volume(b); });
    boxes_.resize(kMaxBoxes);
  }
}

float Sight::FirstBox(Vec3 eye, Vec3 direction, float miss, int but, const CutAway& cut) const {
  float first = miss;
  for (int i = 0; i < static_cast<int>(boxes_.size()); ++i) {
    if (i != but && !boxes_[i].GoneIn(cut)) first = std::min(first, Enter(boxes_[i], eye, direction, first));
  }
  for (const SightBox& leaf : leaves_) first = std::min(first, Enter(leaf, eye, direction, first));
  return first;
}

bool Sight::WallBetween(Vec3 eye, Vec3 point, const CutAway& cut) const {
  for (size_t i = 0; i < shape_.walls.size(); ++i) {
    if (cut.walls[i] != WallCut::kWhole) continue;
    const ShapedWall& wall = shape_.walls[i];
    const float from = Dot(eye - wall.axes.origin, wall.axes.outward);
    const float to = Dot(point - wall.axes.origin, wall.axes.outward);
    // What hangs on a wall may reach into it.
    if (from > 0 ? to > -0.02F : to < 0.05F) continue;
    const Vec3 at = eye + (point - eye) * (from / (from - to));
    const float along = Dot(at - wall.axes.origin, wall.axes.along);
    if (along > 0 && along < wall.length_m && at.z < shape_.height_m) return true;
  }
  return false;
}

}  // namespace flair::renderer
