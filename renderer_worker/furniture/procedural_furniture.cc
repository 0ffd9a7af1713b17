// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/furniture/procedural_furniture.h"

#include "renderer_worker/furniture/classes.h"

namespace flair::renderer {
namespace {

// A face of the box: corner, then two edges that turn counter-clockwise as seen from outside.
void AddFace(MeshPart& part, Vec3 corner, Vec3 u, Vec3 v) {
  const auto first = static_cast<uint32_t>(part.positions.size());
  const Vec3 normal = Normalized(Cross(u, v));
  for (const Vec3 point : {corner, corner + u, corner + u + v, corner + v}) {
    part.positions.push_back(point);
    part.normals.push_back(normal);
    part.uvs.push_back({Dot(point - corner, Normalized(u)), Dot(point - corner, Normalized(v))});
  }
  for (const uint32_t i : {0U, 1U, 2U, 0U, 2U, 3U}) part.indices.push_back(first + i);
}

Mesh BoxMesh(float width, float depth, float height) {
  MeshPart part;
  part.material = {.name = "wood", .colour = {0.42F, 0.3F, 0.19F}, .roughness = 0.6F};
  const Vec3 low{-width / 2, -depth / 2, 0}, high{width / 2, depth / 2, height};
  const Vec3 x{width, 0, 0}, y{0, depth, 0}, z{0, 0, height};
  AddFace(part, low, y, x), AddFace(part, low, x, z), AddFace(part, low, z, y);
  AddFace(part, high, -x, -y), AddFace(part, high, -z, -x), AddFace(part, high, -y, -z);
  return {{part}};
}

}  // namespace

Furnishing ProceduralFurniture::FurnishingOf(const v1::Object& object, const v1::ObjectStyle* /*style*/,
                                             std::vector<v1::Diagnostic>& /*diagnostics*/) const {
  Furnishing furnishing{.class_name = std::string(ClassOf(object))};
  const std::string key = furnishing.class_name + "/" + std::to_string(object.width_m()) + "/" +
                          std::to_string(object.depth_m()) + "/" + std::to_string(object.height_m());
  const std::lock_guard lock(mutex_);
  Made& made = made_[key];
  furnishing.mesh = made.mesh.lock();
  if (furnishing.mesh == nullptr) {
    furnishing.mesh =
        std::make_shared<Mesh>(BoxMesh(static_cast<float>(object.width_m()), static_cast<float>(object.depth_m()),
                                       static_cast<float>(object.height_m())));
    made.mesh = furnishing.mesh;
  }
  furnishing.lights = made.lights;
  return furnishing;
}

}  // namespace flair::renderer
