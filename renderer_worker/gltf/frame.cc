// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/gltf/frame.h"

namespace flair::renderer::gltf {

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

}  // namespace flair::renderer::gltf
