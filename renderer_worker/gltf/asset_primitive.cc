// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/gltf/asset_primitive.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "fmt/format.h"
#include "renderer_worker/gltf/limited_json.h"
#include "renderer_worker/images/file_header.h"
#include "worker_runtime/status/status_macros.h"

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

using Json = nlohmann::json;

// Farther than this from the origin nothing of an asset lies, in any unit: squares must stay finite.
constexpr float kFarthest = 1e8F;

bool Near(Vec3 p) { return std::abs(p.x) < kFarthest && std::abs(p.y) < kFarthest && std::abs(p.z) < kFarthest; }

std::vector<Vec3> Triples(const std::vector<float>& numbers) {
  std::vector<Vec3> triples(numbers.size() / 3);
  for (size_t i = 0; i < triples.size(); ++i) triples[i] = {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
  return triples;
}

// Mean of COLOR_0, three or four components a vertex.
std::optional<Vec3> MeanColour(const AssetFile& file, size_t accessor, size_t vertex_count) {
  for (const auto& [type, components] : {std::pair<const char*, size_t>{"VEC3", 3}, {"VEC4", 4}}) {
    const auto numbers = file.Numbers(accessor, type, components, vertex_count);
    if (!numbers.ok()) continue;
    Vec3 sum;
    for (size_t i = 0; i + components <= numbers->size(); i += components) {
      sum = sum + Vec3{(*numbers)[i], (*numbers)[i + 1], (*numbers)[i + 2]};
    }
    const Vec3 mean = sum * (static_cast<float>(components) / static_cast<float>(numbers->size()));
    if (!std::isfinite(mean.x + mean.y + mean.z)) return std::nullopt;
    return Vec3{std::clamp(mean.x, 0.0F, 1.0F), std::clamp(mean.y, 0.0F, 1.0F), std::clamp(mean.z, 0.0F, 1.0F)};
  }
  return std::nullopt;
}

constexpr int kMaxImageSide_px = 4096;
constexpr size_t kMaxImageBytes = size_t{32} << 20;
constexpr size_t kMaxNameBytes = 80;

float Limited(std::optional<double> value, float low, float high, float otherwise) {
  return value.has_value() ? std::clamp(static_cast<float>(*value), low, high) : otherwise;
}

// The first `kCount` numbers of an array, `otherwise` where there are none.
template <size_t kCount>
std::array<float, kCount> NumbersOf(const Json& json, const char* name, std::array<float, kCount> otherwise, float low,
                                    float high) {
  const Json& items = ArrayOf(json, name);
  for (size_t i = 0; i < kCount && i < items.size(); ++i) {
    if (!items[i].is_number()) continue;
    const auto value = static_cast<float>(items[i].get<double>());
    if (std::isfinite(value)) otherwise[i] = std::clamp(value, low, high);
  }
  return otherwise;
}

const Json& MemberOf(const Json& json, const char* name) {
  static const Json& nothing = *new Json(Json::object());
  const Json* found = Find(json, name);
  return found != nullptr && found->is_object() ? *found : nothing;
}

// No surface is a perfect mirror or swallows all light.
constexpr float kLeastRoughness = 0.04F;

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

absl::Status PrimitiveReader::AddMesh(size_t index, const Affine& transform) {
  const Json* mesh = file_.Item("meshes", index);
  if (mesh == nullptr) return InvalidArgument("there is no mesh {}", index);
  for (const Json& primitive : ArrayOf(*mesh, "primitives")) RETURN_IF_ERROR(AddPrimitive(primitive, transform));
  return absl::OkStatus();
}

absl::StatusOr<std::vector<uint32_t>> PrimitiveReader::Triangles(const Json& json, size_t vertex_count) const {
  std::vector<uint32_t> corners;
  if (const std::optional<size_t> accessor = CountOf(json, "indices")) {
    ASSIGN_OR_RETURN(corners, file_.Indices(*accessor, vertex_count, 3 * kMaxAssetTriangles));
  } else {
    corners.resize(vertex_count);
    for (size_t i = 0; i < vertex_count; ++i) corners[i] = static_cast<uint32_t>(i);
  }
  const size_t mode = CountOf(json, "mode").value_or(4);
  std::vector<uint32_t> triangles;
  if (mode == 4) {
    corners.resize(corners.size() / 3 * 3);
    triangles = std::move(corners);
  } else {  // 5: strip, 6: fan
    for (size_t i = 2; i < corners.size(); ++i) {
      const uint32_t first = mode == 6 ? corners[0] : corners[i - 2 + i % 2];
      const uint32_t second = mode == 6 ? corners[i - 1] : corners[i - 1 - i % 2];
      triangles.insert(triangles.end(), {first, second, corners[i]});
    }
  }
  return triangles;
}

absl::StatusOr<PrimitiveReader::Primitive> PrimitiveReader::Read(const Json& json,
                                                                 const AssetMaterial& material) const {
  const Json* attributes = Find(json, "attributes");
  const std::optional<size_t> positions = attributes == nullptr ? std::nullopt : CountOf(*attributes, "POSITION");
  if (!positions.has_value()) return absl::InvalidArgumentError("a primitive has no positions");
  ASSIGN_OR_RETURN(auto numbers, file_.Numbers(*positions, "VEC3", 3, kMaxAssetVertices - vertex_count_));
  Primitive read;
  read.positions = Triples(numbers);
  const size_t count = read.positions.size();
  if (const std::optional<size_t> normals = CountOf(*attributes, "NORMAL")) {
    ASSIGN_OR_RETURN(auto values, file_.Numbers(*normals, "VEC3", 3, count));
    if (values.size() == 3 * count) read.normals = Triples(values);
  }
  if (material.material.image != nullptr) {
    const std::string name = fmt::format("TEXCOORD_{}", material.uv.set);
    if (const std::optional<size_t> uvs = CountOf(*attributes, name.c_str())) {
      ASSIGN_OR_RETURN(auto values, file_.Numbers(*uvs, "VEC2", 2, count));
      for (size_t i = 0; i + 1 < values.size(); i += 2) {
        const Vec2 uv = material.uv.Of({(values)[i], (values)[i + 1]});
        read.uvs.push_back(std::isfinite(uv.x) && std::isfinite(uv.y) ? uv : Vec2{});
      }
      read.uvs.resize(count);
    }
  }
  if (const std::optional<size_t> colours = CountOf(*attributes, "COLOR_0")) {
    read.tint = MeanColour(file_, *colours, count).value_or(read.tint);
  }
  ASSIGN_OR_RETURN(read.indices, Triangles(json, count));
  return read;
}

MeshPart& PrimitiveReader::PartOf(size_t material_index, const AssetMaterial& material, Vec3 tint) {
  const auto [known, fresh] = parts_.try_emplace(material_index, asset_.mesh.parts.size());
  if (fresh) {
    asset_.mesh.parts.emplace_back().material = material.material;
    Vec3& colour = asset_.mesh.parts.back().material.colour;
    colour = colour * tint;
  }
  return asset_.mesh.parts[known->second];
}

absl::Status PrimitiveReader::AddPrimitive(const Json& json, const Affine& transform) {
  const size_t mode = CountOf(json, "mode").value_or(4);
  if (mode < 4 || mode > 6) return absl::OkStatus();  // points and lines
  const size_t material_index = CountOf(json, "material").value_or(SIZE_MAX);
  const AssetMaterial& material = materials_.At(material_index);
  ASSIGN_OR_RETURN(Primitive read, Read(json, material));
  // A mesh of few triangles may have many vertices and be in many nodes.
  read_vertex_count_ += read.positions.size();
  if (read_vertex_count_ > 4 * kMaxAssetVertices) {
    return ResourceExhausted("its meshes repeat more than {} vertices", 4 * kMaxAssetVertices);
  }
  if (read.indices.empty()) return absl::OkStatus();
  triangle_count_ += read.indices.size() / 3;
  if (triangle_count_ > kMaxAssetTriangles) {
    return ResourceExhausted("it has more than {} triangles", kMaxAssetTriangles);
  }
  for (Vec3& p : read.positions) {
    p = transform.Point(p);
    if (!Near(p)) return absl::InvalidArgumentError("a vertex is not finite or farther than 1e8 from the origin");
  }
  MeshPart& part = PartOf(material_index, material, read.tint);
  const bool mirrored = transform.Determinant() < 0;
  // Without normals every triangle is flat: each corner its own vertex.
  const bool flat = read.normals.empty();
  const auto add = [&](uint32_t corner, Vec3 normal) {
    part.positions.push_back(read.positions[corner]);
    part.normals.push_back(Near(normal) ? Normalized(normal) : Vec3{0, 0, 1});
    part.uvs.push_back(read.uvs.empty() ? Vec2{} : read.uvs[corner]);
  };
  const auto base = static_cast<uint32_t>(part.positions.size());
  if (!flat) {
    for (uint32_t i = 0; i < read.positions.size(); ++i) {
      Vec3 normal = transform.Normal(read.normals[i]);
      if (mirrored) normal = -normal;
      add(i, normal * (1 / std::max(1e-30F, std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)}))));
    }
  }
  for (size_t i = 0; i < read.indices.size(); i += 3) {
    uint32_t a = read.indices[i], b = read.indices[i + 1], c = read.indices[i + 2];
    if (mirrored) std::swap(b, c);
    if (flat) {
      const Vec3 ab = read.positions[b] - read.positions[a];
      const Vec3 ac = read.positions[c] - read.positions[a];
      const Vec3 normal = Cross(Normalized(ab), Normalized(ac));
      const auto next = static_cast<uint32_t>(part.positions.size());
      for (const uint32_t corner : {a, b, c}) add(corner, normal);
      part.indices.insert(part.indices.end(), {next, next + 1, next + 2});
    } else {
      part.indices.insert(part.indices.end(), {base + a, base + b, base + c});
    }
  }
  vertex_count_ += flat ? read.indices.size() : read.positions.size();
  if (vertex_count_ > kMaxAssetVertices) return ResourceExhausted("it has more than {} vertices", kMaxAssetVertices);
  return absl::OkStatus();
}

Vec2 UvUse::Of(Vec2 uv) const {
  const float s = std::sin(rotation_rad);
  const float c = std::cos(rotation_rad);
  const Vec2 scaled{uv.x * scale.x, uv.y * scale.y};
  return {c * scaled.x + s * scaled.y + offset.x, -s * scaled.x + c * scaled.y + offset.y};
}

const AssetMaterial& AssetMaterials::At(size_t index) {
  const Json* json = file_.Item("materials", index);
  if (json == nullptr) index = SIZE_MAX;
  const auto known = read_.find(index);
  if (known != read_.end()) return known->second;
  AssetMaterial material = json == nullptr ? AssetMaterial{} : Read(*json);
  std::string& name = material.material.name;
  name = name.empty() ? "asset" : name.substr(0, kMaxNameBytes);
  if (const int number = ++names_[name]; number > 1) name = fmt::format("{} {}", name, number);
  return read_.emplace(index, std::move(material)).first->second;
}

AssetMaterial AssetMaterials::Read(const Json& json) {
  AssetMaterial read;
  Material& material = read.material;
  material.name = std::string(TextOf(json, "name"));
  const Json& pbr = MemberOf(json, "pbrMetallicRoughness");
  const Json& extensions = MemberOf(json, "extensions");
  auto colour = NumbersOf<4>(pbr, "baseColorFactor", {1, 1, 1, 1}, 0, 1);
  material.metallic = Limited(NumberOf(pbr, "metallicFactor"), 0, 1, 1);
  material.roughness = Limited(NumberOf(pbr, "roughnessFactor"), kLeastRoughness, 1, 1);
  // Both factors multiply a picture that is left out; what is metal in it is not known.
  if (Find(pbr, "metallicRoughnessTexture") != nullptr) material.metallic = 0, material.roughness *= 0.7F;
  const Json* texture = Find(pbr, "baseColorTexture");
  const Json& glossy = MemberOf(extensions, "KHR_materials_pbrSpecularGlossiness");
  if (!glossy.empty()) {
    colour = NumbersOf<4>(glossy, "diffuseFactor", {1, 1, 1, 1}, 0, 1);
    material.metallic = 0;
    material.roughness = std::max(kLeastRoughness, 1 - Limited(NumberOf(glossy, "glossinessFactor"), 0, 1, 1) * 0.8F);
    texture = Find(glossy, "diffuseTexture");
  }
  material.colour = {colour[0], colour[1], colour[2]};
  if (TextOf(json, "alphaMode") == "BLEND") material.opacity = std::max(0.02F, colour[3]);
  const auto emission = NumbersOf<3>(json, "emissiveFactor", {0, 0, 0}, 0, 1);
  const float strength =
      Limited(NumberOf(MemberOf(extensions, "KHR_materials_emissive_strength"), "emissiveStrength"), 0, 100, 1);
  // An emissive picture that is left out would make the whole surface shine.
  if (Find(json, "emissiveTexture") == nullptr) {
    material.emission = Vec3{emission[0], emission[1], emission[2]} * strength;
  }
  if (texture != nullptr) ReadTexture(*texture, read);
  return read;
}

void AssetMaterials::ReadTexture(const Json& info, AssetMaterial& read) {
  const std::optional<size_t> index = CountOf(info, "index");
  if (!index.has_value()) return;
  auto [known, fresh] = images_.try_emplace(*index);
  if (fresh) known->second = ImageAt(*index);
  read.material.image = known->second;
  const Json& transform = MemberOf(MemberOf(info, "extensions"), "KHR_texture_transform");
  size_t set = CountOf(info, "texCoord").value_or(0);
  set = CountOf(transform, "texCoord").value_or(set);
  const auto offset = NumbersOf<2>(transform, "offset", {0, 0}, -1e4F, 1e4F);
  const auto scale = NumbersOf<2>(transform, "scale", {1, 1}, -1e4F, 1e4F);
  read.uv = {static_cast<int>(std::min<size_t>(set, 15)),
             {offset[0], offset[1]},
             {scale[0], scale[1]},
             Limited(NumberOf(transform, "rotation"), -100, 100, 0)};
}

std::shared_ptr<const SurfaceImage> AssetMaterials::ImageAt(size_t texture) {
  const auto left_out = [&](std::string why) -> std::shared_ptr<const SurfaceImage> {
    notes_.push_back(fmt::format("texture {} is left out: {}", texture, why));
    return nullptr;
  };
  const Json* json = file_.Item("textures", texture);
  const std::optional<size_t> source = json == nullptr ? std::nullopt : CountOf(*json, "source");
  const Json* image = source.has_value() ? file_.Item("images", *source) : nullptr;
  const std::optional<size_t> view_index = image == nullptr ? std::nullopt : CountOf(*image, "bufferView");
  if (!view_index.has_value()) return left_out("it has no picture in the file");
  const absl::StatusOr<std::string_view> view = file_.View(*view_index);
  if (!view.ok()) return left_out(std::string(view.status().message()));
  const absl::StatusOr<FileHeader> header = ReadFileHeader(*view);
  if (!header.ok() || header->mime_type == nullptr) return left_out("it is neither PNG nor JPEG");
  if (header->width_px < 1 || header->height_px < 1 || header->width_px > kMaxImageSide_px ||
      header->height_px > kMaxImageSide_px || view->size() > kMaxImageBytes) {
    return left_out(fmt::format("it has {} x {} px in {} bytes, at most {} px a side and {} bytes are handed on",
                                header->width_px, header->height_px, view->size(), kMaxImageSide_px, kMaxImageBytes));
  }
  return std::make_shared<SurfaceImage>(SurfaceImage{header->mime_type, std::string(*view)});
}

}  // namespace flair::renderer::gltf
