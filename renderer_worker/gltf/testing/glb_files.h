// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "renderer_worker/gltf/tiny_gltf.h"
#include "renderer_worker/scene/mesh.h"

namespace flair::renderer::gltf {

// A triangle as GLB, good unless members are replaced: each JSON is merged into the part it is named after.
struct TriangleFile {
  std::vector<float> positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  nlohmann::json node = nlohmann::json::object();
  nlohmann::json primitive = nlohmann::json::object();
  nlohmann::json accessor = nlohmann::json::object();  // of the positions
  nlohmann::json view = nlohmann::json::object();      // of the positions
  nlohmann::json top = nlohmann::json::object();
  std::string image = {};  // base colour picture, when not empty
};
std::string TriangleGlb(const TriangleFile& file);

// A GLB of any JSON text and binary chunk.
std::string GlbOf(std::string_view json, std::string_view binary);

// A GLB as tinygltf reads it, images left as bytes; stops the test program when it cannot.
tinygltf::Model ReadModel(const std::string& glb);

// The node of that name, null when there is none.
const tinygltf::Node* NodeNamed(const tinygltf::Model& model, const std::string& name);

// Floats of an accessor, component after component.
std::vector<float> Floats(const tinygltf::Model& model, int accessor);

// Every vertex of the node's mesh in glTF's world. The node has no parent that moves it.
std::vector<Vec3> WorldPositions(const tinygltf::Model& model, const tinygltf::Node& node);

// `v` turned by a unit quaternion x, y, z, w.
Vec3 Turned(const std::vector<double>& quaternion, Vec3 v);

}  // namespace flair::renderer::gltf
