// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/gltf/testing/glb_files.h"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iostream>

namespace flair::renderer::gltf {
namespace {

void AppendWord(std::string& bytes, uint32_t word) { bytes.append(reinterpret_cast<const char*>(&word), sizeof word); }

void AppendChunk(std::string& bytes, uint32_t type, std::string content, char filling) {
  content.resize((content.size() + 3) / 4 * 4, filling);
  AppendWord(bytes, static_cast<uint32_t>(content.size()));
  AppendWord(bytes, type);
  bytes += content;
}

}  // namespace

std::string GlbOf(std::string_view json, std::string_view binary) {
  std::string chunks;
  AppendChunk(chunks, 0x4E4F534A, std::string(json), ' ');
  if (!binary.empty()) AppendChunk(chunks, 0x004E4942, std::string(binary), 0);
  std::string glb;
  AppendWord(glb, 0x46546C67);
  AppendWord(glb, 2);
  AppendWord(glb, static_cast<uint32_t>(12 + chunks.size()));
  return glb + chunks;
}

std::string TriangleGlb(const TriangleFile& file) {
  using Json = nlohmann::json;
  std::string binary(reinterpret_cast<const char*>(file.positions.data()), file.positions.size() * sizeof(float));
  Json view = {{"buffer", 0}, {"byteLength", binary.size()}};
  view.update(file.view);
  Json accessor = {{"bufferView", 0}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}};
  accessor.update(file.accessor);
  Json primitive = {{"attributes", {{"POSITION", 0}}}};
  Json json = {{"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", {0}}}}}};
  json["bufferViews"] = Json::array({view});
  if (!file.image.empty()) {
    json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", file.image.size()}});
    json["images"] = {{{"bufferView", 1}, {"mimeType", "image/png"}}};
    json["textures"] = {{{"source", 0}}};
    json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    primitive["material"] = 0;
    binary += file.image;
  }
  primitive.update(file.primitive);
  json["buffers"] = {{{"byteLength", binary.size()}}};
  json["accessors"] = Json::array({accessor});
  json["meshes"] = {{{"primitives", Json::array({primitive})}}};
  Json node = {{"mesh", 0}};
  node.update(file.node);
  json["nodes"] = Json::array({node});
  json.update(file.top);
  return GlbOf(json.dump(), binary);
}

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
