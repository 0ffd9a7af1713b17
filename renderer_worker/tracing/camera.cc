// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "renderer_worker/tracing/frame.h"

namespace flair::renderer {
namespace {

bool Plausible(Vec3 p) {
  return std::abs(p.x) <= 1e5F && std::abs(p.y) <= 1e5F && std::abs(p.z) <= 1e5F;  // false for NaN
}

}  // namespace

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

}  // namespace flair::renderer
