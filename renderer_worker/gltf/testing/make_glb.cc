// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/gltf/testing/make_glb.h"

#include <cstdint>

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

}  // namespace flair::renderer::gltf
