// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/gltf/mesh_book.h"

#include <algorithm>
#include <bit>
#include <exception>
#include <limits>
#include <sstream>
#include <utility>

#include "worker_runtime/status/status_macros.h"

namespace flair::renderer::gltf {
namespace {

// The header counts bytes in 32 bits; this leaves room for the JSON.
constexpr size_t kMaxBinaryBytes = (size_t{1} << 32) - (size_t{256} << 20);

static_assert(std::endian::native == std::endian::little, "glTF is little-endian and so are the machines we build for");

template <typename T>
void Append(std::vector<unsigned char>& bytes, const T& value) {
  const auto* first = reinterpret_cast<const unsigned char*>(&value);
  bytes.insert(bytes.end(), first, first + sizeof(T));
}

void Pad(std::vector<unsigned char>& bytes) { bytes.resize((bytes.size() + 3) / 4 * 4); }

constexpr char kEmissiveStrength[] = "KHR_materials_emissive_strength";

void Use(tinygltf::Model& model, const std::string& extension) {
  auto& used = model.extensionsUsed;
  if (std::ranges::find(used, extension) == used.end()) used.push_back(extension);
}

double Share(float value) { return Rounded(std::clamp(value, 0.0F, 1.0F)); }

absl::Status Check(const MeshPart& part, const std::string& name) {
  const size_t count = part.positions.size();
  if (part.normals.size() != count || (!part.uvs.empty() && part.uvs.size() != count) || part.indices.size() % 3 != 0) {
    return Internal("the mesh of {} has {} positions, {} normals, {} uvs and {} indices", name, count,
                    part.normals.size(), part.uvs.size(), part.indices.size());
  }
  for (size_t i = 0; i < count; ++i) {
    if (!IsFinite(part.positions[i]) || !IsFinite(part.normals[i])) {
      return Internal("vertex {} of the mesh of {} is not finite", i, name);
    }
  }
  for (const uint32_t index : part.indices) {
    if (index >= count) return Internal("the mesh of {} names vertex {} of {}", name, index, count);
  }
  return absl::OkStatus();
}

bool Equal(const Mesh& a, const Mesh& b) {
  return std::equal(a.parts.begin(), a.parts.end(), b.parts.begin(), b.parts.end(),
                    [](const MeshPart& p, const MeshPart& q) {
                      return p.material == q.material && p.positions == q.positions && p.normals == q.normals &&
                             p.uvs == q.uvs && p.indices == q.indices;
                    });
}

// The part in glTF's frame, without triangles that have lost a corner, vertices that no triangle has, and uvs that
// nothing uses.
Vertices Converted(const MeshPart& part, MeshFrame frame) {
  Vertices out;
  const Vec2 scale = MaterialBook::UvScale(part.material);
  constexpr uint32_t kUnseen = ~uint32_t{0};
  std::vector<uint32_t> moved(part.positions.size(), kUnseen);
  const auto convert = [&](Vec3 v) { return frame == MeshFrame::kRoom ? FromRoom(v) : FromObject(v); };
  const auto vertex = [&](uint32_t index) {
    if (moved[index] == kUnseen) {
      moved[index] = static_cast<uint32_t>(out.positions.size());
      out.positions.push_back(convert(part.positions[index]));
      out.normals.push_back(Normalized(convert(part.normals[index])));
      const Vec2 uv = index < part.uvs.size() ? part.uvs[index] : Vec2{};
      if (scale.x > 0) out.uvs.push_back({uv.x * scale.x, uv.y * scale.y});
    }
    return moved[index];
  };
  out.indices.reserve(part.indices.size());
  for (size_t i = 0; i < part.indices.size(); i += 3) {
    const uint32_t a = part.indices[i];
    const uint32_t b = part.indices[i + 1];
    const uint32_t c = part.indices[i + 2];
    if (a != b && b != c && c != a) out.indices.insert(out.indices.end(), {vertex(a), vertex(b), vertex(c)});
  }
  return out;
}

}  // namespace

absl::StatusOr<std::string> GlbText(const tinygltf::Model& model) {
  const size_t size = model.buffers.front().data.size();
  if (size > kMaxBinaryBytes) return ResourceExhausted("the room's meshes take {} bytes, GLB holds 4 GiB", size);
  // tinygltf's JSON throws, at what is no UTF-8 for one.
  try {
    std::ostringstream stream;
    tinygltf::TinyGLTF writer;
    if (!writer.WriteGltfSceneToStream(&model, stream, /*prettyPrint=*/false, /*writeBinary=*/true) || !stream) {
      return absl::InternalError("the GLB could not be written to memory");
    }
    return std::move(stream).str();
  } catch (const std::exception& failure) {
    return Internal("the GLB could not be written: {}", failure.what());
  }
}

int GlbBuffer::AddAccessor(Section& section, size_t offset, int component_type, int type, size_t count) {
  tinygltf::Accessor accessor;
  accessor.byteOffset = offset;
  accessor.componentType = component_type;
  accessor.type = type;
  accessor.count = count;
  section.accessors.push_back(static_cast<int>(model_.accessors.size()));
  model_.accessors.push_back(std::move(accessor));
  return section.accessors.back();
}

tinygltf::Primitive GlbBuffer::Add(const Vertices& vertices) {
  const size_t count = vertices.positions.size();
  const bool textured = !vertices.uvs.empty();
  Section& section = textured ? textured_ : plain_;
  const size_t offset = section.bytes.size();
  Vec3 low{std::numeric_limits<float>::max(), std::numeric_limits<float>::max(), std::numeric_limits<float>::max()};
  Vec3 high = -low;
  section.bytes.reserve(offset + count * (textured ? 32 : 24));
  for (size_t i = 0; i < count; ++i) {
    const Vec3 p = vertices.positions[i];
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    Append(section.bytes, p);
    Append(section.bytes, vertices.normals[i]);
    if (textured) Append(section.bytes, vertices.uvs[i]);
  }
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  const int positions = AddAccessor(section, offset, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, count);
  model_.accessors[positions].minValues = {low.x, low.y, low.z};
  model_.accessors[positions].maxValues = {high.x, high.y, high.z};
  primitive.attributes["POSITION"] = positions;
  primitive.attributes["NORMAL"] =
      AddAccessor(section, offset + 12, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, count);
  if (textured) {
    primitive.attributes["TEXCOORD_0"] =
        AddAccessor(section, offset + 24, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC2, count);
  }

  // 65535 would be the primitive restart value.
  const bool is_short = count < 65535;
  Section& indices = is_short ? short_indices_ : long_indices_;
  Pad(indices.bytes);
  const size_t first = indices.bytes.size();
  for (const uint32_t index : vertices.indices) {
    if (is_short) {
      Append(indices.bytes, static_cast<uint16_t>(index));
    } else {
      Append(indices.bytes, index);
    }
  }
  primitive.indices = AddAccessor(
      indices, first, is_short ? TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT : TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
      TINYGLTF_TYPE_SCALAR, vertices.indices.size());
  return primitive;
}

int GlbBuffer::AddImage(std::string_view mime_type, std::string_view bytes) {
  tinygltf::Image image;
  image.mimeType = mime_type;
  images_.emplace_back(bytes.begin(), bytes.end());
  model_.images.push_back(std::move(image));
  return static_cast<int>(model_.images.size()) - 1;
}

void GlbBuffer::FinishSection(Section& section, int target, size_t stride) {
  if (section.bytes.empty()) return;
  std::vector<unsigned char>& bytes = model_.buffers.front().data;
  Pad(bytes);
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = bytes.size();
  view.byteLength = section.bytes.size();
  view.byteStride = stride;
  view.target = target;
  for (const int accessor : section.accessors) {
    model_.accessors[accessor].bufferView = static_cast<int>(model_.bufferViews.size());
  }
  model_.bufferViews.push_back(std::move(view));
  bytes.insert(bytes.end(), section.bytes.begin(), section.bytes.end());
}

void GlbBuffer::Finish() {
  model_.buffers.emplace_back();
  FinishSection(plain_, TINYGLTF_TARGET_ARRAY_BUFFER, 24);
  FinishSection(textured_, TINYGLTF_TARGET_ARRAY_BUFFER, 32);
  FinishSection(short_indices_, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER, 0);
  FinishSection(long_indices_, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER, 0);
  for (size_t i = 0; i < images_.size(); ++i) {
    Section image{std::move(images_[i]), {}};
    model_.images[i].bufferView = static_cast<int>(model_.bufferViews.size());
    FinishSection(image, 0, 0);
  }
  Pad(model_.buffers.front().data);
}

Vec2 MaterialBook::UvScale(const Material& material) {
  if (material.image != nullptr) return {1, 1};
  const Vec2 period = PeriodOf(FigureOf(material));
  if (period.x <= 0 || !(material.pattern_size_m > 0)) return {0, 0};
  return {1 / (period.x * material.pattern_size_m), 1 / (period.y * material.pattern_size_m)};
}

int MaterialBook::NumberOf(const Material& material) {
  auto& namesakes = written_[material.name];
  for (const auto& [known, number] : namesakes) {
    if (known == material) return number;
  }
  namesakes.emplace_back(material, Write(material));
  return namesakes.back().second;
}

int MaterialBook::Write(const Material& material) {
  tinygltf::Material written;
  written.name = material.name;
  tinygltf::PbrMetallicRoughness& pbr = written.pbrMetallicRoughness;
  pbr.metallicFactor = Share(material.metallic);
  pbr.roughnessFactor = Share(material.roughness);
  pbr.baseColorTexture.index = TextureOf(material);
  // A pattern's texture holds the colour itself, since its second colour may be the brighter one.
  const bool colour_in_texture = pbr.baseColorTexture.index >= 0 && material.image == nullptr;
  const Vec3 colour = colour_in_texture ? Vec3{1, 1, 1} : material.colour;
  pbr.baseColorFactor = {Share(colour.x), Share(colour.y), Share(colour.z), Share(material.opacity)};
  if (material.opacity < 1) written.alphaMode = "BLEND";

  const Vec3 emission = material.emission;
  const float strongest = std::max({emission.x, emission.y, emission.z});
  if (strongest > 0) {
    const float scale = 1 / std::max(1.0F, strongest);
    written.emissiveFactor = {Share(emission.x * scale), Share(emission.y * scale), Share(emission.z * scale)};
  }
  if (strongest > 1) {
    tinygltf::Value::Object extension;
    extension["emissiveStrength"] = tinygltf::Value(Rounded(strongest));
    written.extensions[kEmissiveStrength] = tinygltf::Value(std::move(extension));
    Use(model_, kEmissiveStrength);
  }
  model_.materials.push_back(std::move(written));
  return static_cast<int>(model_.materials.size()) - 1;
}

int MaterialBook::TextureOf(const Material& material) {
  if (UvScale(material).x <= 0) return -1;
  int* known = nullptr;
  std::string png;
  if (material.image != nullptr) {
    known = &images_.try_emplace(material.image.get(), -1).first->second;
  } else {
    png = PatternPng(material);
    known = &patterns_.try_emplace(png, -1).first->second;
  }
  if (*known >= 0) return *known;
  tinygltf::Texture texture;
  texture.sampler = SamplerNumber();
  texture.source = material.image != nullptr ? buffer_.AddImage(material.image->mime_type, material.image->bytes)
                                             : buffer_.AddImage("image/png", png);
  *known = static_cast<int>(model_.textures.size());
  model_.textures.push_back(std::move(texture));
  return *known;
}

int MaterialBook::SamplerNumber() {
  if (model_.samplers.empty()) {
    tinygltf::Sampler sampler;
    sampler.magFilter = TINYGLTF_TEXTURE_FILTER_LINEAR;
    sampler.minFilter = TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
    sampler.wrapS = TINYGLTF_TEXTURE_WRAP_REPEAT;
    sampler.wrapT = TINYGLTF_TEXTURE_WRAP_REPEAT;
    model_.samplers.push_back(sampler);
  }
  return 0;
}

absl::StatusOr<int> MeshBook::NumberOf(const Mesh& mesh, MeshFrame frame, const std::string& name) {
  for (const Written& known : written_) {
    if (known.frame == frame && (known.mesh == &mesh || Equal(*known.mesh, mesh))) return known.number;
  }
  for (const MeshPart& part : mesh.parts) RETURN_IF_ERROR(Check(part, name));
  written_.push_back({&mesh, frame, Write(mesh, frame, name)});
  return written_.back().number;
}

int MeshBook::Write(const Mesh& mesh, MeshFrame frame, const std::string& name) {
  tinygltf::Mesh written;
  written.name = name;
  for (const MeshPart& part : mesh.parts) {
    const Vertices vertices = Converted(part, frame);
    if (vertices.indices.empty()) continue;
    tinygltf::Primitive primitive = buffer_.Add(vertices);
    primitive.material = materials_.NumberOf(part.material);
    written.primitives.push_back(std::move(primitive));
  }
  if (written.primitives.empty()) return -1;
  model_.meshes.push_back(std::move(written));
  return static_cast<int>(model_.meshes.size()) - 1;
}

}  // namespace flair::renderer::gltf
