// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/gltf/asset_materials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "fmt/format.h"
#include "renderer_worker/gltf/limited_json.h"
#include "renderer_worker/images/file_header.h"

namespace flair::renderer::gltf {

namespace {

using Json = nlohmann::json;

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
