// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/gltf/testing/read_model.h"

#include <cstdlib>
#include <cstring>
#include <iostream>

namespace flair::renderer::gltf {
namespace {

bool LeaveUnread(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
  return true;
}

Vec3 Vec(const std::vector<double>& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

}  // namespace

tinygltf::Model ReadModel(const std::string& glb) {
  tinygltf::TinyGLTF reader;
  reader.SetImageLoader(LeaveUnread, nullptr);
  tinygltf::Model model;
  std::string error;
  std::string warning;
  if (!reader.LoadBinaryFromMemory(&model, &error, &warning, reinterpret_cast<const unsigned char*>(glb.data()),
                                   static_cast<unsigned>(glb.size())) ||
      !warning.empty()) {
    std::cerr << "tinygltf: " << error << warning << "\n";
    std::abort();
  }
  return model;
}

const tinygltf::Node* NodeNamed(const tinygltf::Model& model, const std::string& name) {
  for (const tinygltf::Node& node : model.nodes) {
    if (node.name == name) return &node;
  }
  return nullptr;
}

std::vector<float> Floats(const tinygltf::Model& model, int accessor) {
  const tinygltf::Accessor& a = model.accessors.at(static_cast<size_t>(accessor));
  const tinygltf::BufferView& view = model.bufferViews.at(static_cast<size_t>(a.bufferView));
  const size_t components = static_cast<size_t>(tinygltf::GetNumComponentsInType(static_cast<uint32_t>(a.type)));
  const size_t stride = static_cast<size_t>(a.ByteStride(view));
  std::vector<float> floats(a.count * components);
  for (size_t i = 0; i < a.count; ++i) {
    std::memcpy(&floats[i * components], &model.buffers[0].data.at(view.byteOffset + a.byteOffset + i * stride),
                components * sizeof(float));
  }
  return floats;
}

std::vector<Vec3> WorldPositions(const tinygltf::Model& model, const tinygltf::Node& node) {
  std::vector<Vec3> positions;
  for (const tinygltf::Primitive& primitive : model.meshes.at(static_cast<size_t>(node.mesh)).primitives) {
    const std::vector<float> floats = Floats(model, primitive.attributes.at("POSITION"));
    for (size_t i = 0; i + 2 < floats.size(); i += 3) {
      Vec3 p{floats[i], floats[i + 1], floats[i + 2]};
      if (!node.rotation.empty()) p = Turned(node.rotation, p);
      if (!node.translation.empty()) p = p + Vec(node.translation);
      positions.push_back(p);
    }
  }
  return positions;
}

Vec3 Turned(const std::vector<double>& q, Vec3 v) {
  const Vec3 axis = Vec(q);
  const Vec3 twice = Cross(axis, v) * 2;
  return v + twice * static_cast<float>(q[3]) + Cross(axis, twice);
}

}  // namespace flair::renderer::gltf
