// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "renderer_worker/gltf/tiny_gltf.h"
#include "renderer_worker/scene/mesh.h"

namespace flair::renderer::gltf {

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
