// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/furniture/materials.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>

#include "renderer_worker/scene/surfaces.h"

namespace flair::renderer {
namespace {

struct Meaning {
  std::string_view material;
  std::string_view words;  // parted by blanks
};

#define MEANS(material, words) {#material, words},
constexpr Meaning kMeanings[] = {
#include "renderer_worker/furniture/material_words.inc"
};
#undef MEANS

BaseMaterial Base(std::string_view name, MaterialKind kind, unsigned srgb, float roughness, float metallic,
                  Pattern pattern, float size_m, float second) {
  Material look;
  look.name = name;
  look.colour = LinearHex(srgb);
  look.roughness = roughness;
  look.metallic = metallic;
  look.opacity = kind == MaterialKind::kGlass ? 0.25F : 1;
  look.pattern = pattern;
  look.pattern_size_m = size_m;
  look.second_colour = look.colour * second;
  return {name, kind, look};
}

const BaseMaterial* Find(std::string_view name) {
  for (const BaseMaterial& base : BaseMaterials()) {
    if (base.name == name) return &base;
  }
  return nullptr;
}

const BaseMaterial* OfWord(std::string_view word) {
  if (const BaseMaterial* base = Find(word); base != nullptr) return base;
  for (const Meaning& meaning : kMeanings) {
    for (size_t at = meaning.words.find(word); at != std::string_view::npos; at = meaning.words.find(word, at + 1)) {
      const size_t end = at + word.size();
      if ((at == 0 || meaning.words[at - 1] == ' ') && (end == meaning.words.size() || meaning.words[end] == ' ')) {
        return Find(meaning.material);
      }
    }
  }
  return nullptr;
}

// Browns, from pale birch to ebony: what wood may be without paint.
bool IsWoodColour(Vec3 c) {
  if (c.x < 0.06F) return c.x >= c.z;                                 // near black: stained
  if (!(c.x >= c.y && c.y >= c.z * 0.98F)) return false;              // orange hues only
  return c.z < 0.72F * c.x && c.y > 0.22F * c.x && c.y < 0.9F * c.x;  // neither grey nor red nor yellow
}

}  // namespace

Vec3 LinearHex(unsigned srgb) {
  v1::Colour colour;
  colour.set_red(static_cast<int>((srgb >> 16) & 255));
  colour.set_green(static_cast<int>((srgb >> 8) & 255));
  colour.set_blue(static_cast<int>(srgb & 255));
  return LinearOf(colour);
}

Vec3 Blend(Vec3 from, Vec3 to, float share) { return from * (1 - share) + to * share; }

std::span<const BaseMaterial> BaseMaterials() {
#define MATERIAL(name, kind, srgb, roughness, metallic, pattern, size_m, second) \
  Base(#name, MaterialKind::kind, srgb, roughness, metallic, Pattern::pattern, size_m, second),
  static const std::vector<BaseMaterial> kMaterials{
#include "renderer_worker/furniture/material_list.inc"
  };
#undef MATERIAL
  return kMaterials;
}

const BaseMaterial& BaseMaterialOf(std::string_view name) {
  const BaseMaterial* found = Find(name);
  return found != nullptr ? *found : *Find("wood");
}

std::vector<const BaseMaterial*> MaterialsInWords(std::string_view text) {
  std::vector<const BaseMaterial*> found;
  std::string word;
  const auto take = [&] {
    const BaseMaterial* base = OfWord(word);
    if (base == nullptr && word.ends_with('s')) base = OfWord(word.substr(0, word.size() - 1));
    if (!word.empty() && base != nullptr && std::find(found.begin(), found.end(), base) == found.end())
      found.push_back(base);
    word.clear();
  };
  for (const char c : text.substr(0, 400)) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalpha(byte) != 0) {
      word += static_cast<char>(std::tolower(byte));
    } else {
      take();
    }
  }
  take();
  // "walnut wooden shelves": wood says nothing beside the name of a tree.
  const auto tree = [](const BaseMaterial* base) {
    return base->kind == MaterialKind::kWood && base->look.pattern == Pattern::kWood && base->name != "wood";
  };
  if (std::any_of(found.begin(), found.end(), tree)) {
    std::erase_if(found, [](const BaseMaterial* base) { return base->name == "wood"; });
  }
  return found;
}

Material Coloured(const BaseMaterial& material, Vec3 colour) {
  Material look = material.look;
  const float second = look.second_colour.x / std::max(look.colour.x, 1e-4F);
  look.colour = colour;
  look.second_colour = colour * second;
  if (look.pattern == Pattern::kWood && !IsWoodColour(colour)) {
    look.name = "painted " + look.name;
    look.pattern = Pattern::kPlain;
    look.roughness = 0.4F;
  }
  return look;
}

Material PlainMaterial(std::string_view name, unsigned srgb, float roughness, float metallic) {
  Material look;
  look.name = name;
  look.colour = LinearHex(srgb);
  look.roughness = roughness;
  look.metallic = metallic;
  look.second_colour = look.colour;
  return look;
}

Material Shaded(const Material& material, float factor, std::string_view suffix) {
  Material shaded = material;
  shaded.name += " " + std::string(suffix);
  const auto shade = [factor](Vec3 c) {
    return factor <= 1 ? c * factor : Blend(c, {0.84F, 0.84F, 0.84F}, factor - 1);
  };
  shaded.colour = shade(material.colour);
  shaded.second_colour = shade(material.second_colour);
  return shaded;
}

}  // namespace flair::renderer
