// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/gltf/material_book.h"

#include <algorithm>

#include "renderer_worker/gltf/numbers.h"
#include "renderer_worker/gltf/pattern_image.h"
#include "renderer_worker/gltf/pattern_tone.h"

namespace flair::renderer::gltf {
namespace {

constexpr char kEmissiveStrength[] = "KHR_materials_emissive_strength";

void Use(tinygltf::Model& model, const std::string& extension) {
  auto& used = model.extensionsUsed;
  if (std::find(used.begin(), used.end(), extension) == used.end()) used.push_back(extension);
}

double Share(float value) { return Rounded(std::clamp(value, 0.0F, 1.0F)); }

}  // namespace

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

}  // namespace flair::renderer::gltf
