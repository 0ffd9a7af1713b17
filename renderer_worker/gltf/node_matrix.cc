// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/gltf/node_matrix.h"

#include <cmath>
#include <optional>

#include "renderer_worker/gltf/limited_json.h"

namespace flair::renderer::gltf {
namespace {

// All of an array's numbers, or nothing.
template <size_t kCount>
std::optional<std::array<float, kCount>> Numbers(const nlohmann::json& json, const char* name) {
  const nlohmann::json& items = ArrayOf(json, name);
  if (items.size() != kCount) return std::nullopt;
  std::array<float, kCount> numbers{};
  for (size_t i = 0; i < kCount; ++i) {
    if (!items[i].is_number()) return std::nullopt;
    numbers[i] = static_cast<float>(items[i].get<double>());
    if (!std::isfinite(numbers[i])) return std::nullopt;
  }
  return numbers;
}

// Rows of a unit quaternion's rotation are columns here.
std::array<Vec3, 3> Rotation(std::array<float, 4> q) {
  const float length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (!(length > 1e-6F) || !std::isfinite(length)) return {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  const float x = q[0] / length, y = q[1] / length, z = q[2] / length, w = q[3] / length;
  return {Vec3{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
          Vec3{2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
          Vec3{2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)}};
}

}  // namespace

Affine operator*(const Affine& outer, const Affine& inner) {
  Affine both;
  for (size_t i = 0; i < 3; ++i) both.columns[i] = outer.Direction(inner.columns[i]);
  both.columns[3] = outer.Point(inner.columns[3]);
  return both;
}

Affine TransformOf(const nlohmann::json& node) {
  Affine transform;
  if (const auto m = Numbers<16>(node, "matrix")) {
    for (size_t i = 0; i < 4; ++i) transform.columns[i] = {(*m)[4 * i], (*m)[4 * i + 1], (*m)[4 * i + 2]};
    return transform;
  }
  const std::array<Vec3, 3> turned = Rotation(Numbers<4>(node, "rotation").value_or(std::array<float, 4>{0, 0, 0, 1}));
  const auto scale = Numbers<3>(node, "scale").value_or(std::array<float, 3>{1, 1, 1});
  for (size_t i = 0; i < 3; ++i) transform.columns[i] = turned[i] * scale[i];
  const auto moved = Numbers<3>(node, "translation").value_or(std::array<float, 3>{});
  transform.columns[3] = {moved[0], moved[1], moved[2]};
  return transform;
}

}  // namespace flair::renderer::gltf
