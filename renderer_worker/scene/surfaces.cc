// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/scene/surfaces.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

namespace flair::renderer {
namespace {

std::string Lower(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

bool HasAny(const std::string& text, std::initializer_list<std::string_view> words) {
  return std::any_of(words.begin(), words.end(), [&](std::string_view w) { return text.find(w) != std::string::npos; });
}

float Channel(int value) {
  const float v = static_cast<float>(std::clamp(value, 0, 255)) / 255;
  return v <= 0.04045F ? v / 12.92F : std::pow((v + 0.055F) / 1.055F, 2.4F);
}

struct Finish {
  std::array<std::string_view, 7> words;
  Pattern pattern;
  float roughness;
  float size_m;
  float second;  // the second colour as a factor of the first
};

// First match decides. Sizes are those of the trade: boards 14 cm, herringbone staves 9 cm, tiles 30 cm.
constexpr Finish kFloors[] = {
    {{"herringbone", "parquet", "chevron"}, Pattern::kHerringbone, 0.38F, 0.09F, 0.55F},
    {{"carpet", "rug", "sisal", "wool", "seagrass"}, Pattern::kCarpet, 0.97F, 0.01F, 0.72F},
    {{"cobble", "slab", "flag", "rough stone", "slate", "earth"}, Pattern::kStone, 0.8F, 0.55F, 0.55F},
    {{"tile", "terracotta", "mosaic", "checker", "ceramic", "porcelain"}, Pattern::kTiles, 0.3F, 0.3F, 0.7F},
    {{"marble", "granite", "travertine", "terrazzo"}, Pattern::kTiles, 0.22F, 0.6F, 0.8F},
    {{"brick"}, Pattern::kBricks, 0.85F, 0.22F, 0.75F},
    {{"concrete", "screed", "microcement", "stone", "rubber", "vinyl"}, Pattern::kStone, 0.6F, 3.0F, 0.88F},
    {{"oak", "wood", "board", "plank", "laminate", "bamboo", "pine"}, Pattern::kPlanks, 0.42F, 0.14F, 0.5F},
    {{"walnut", "ash", "maple", "timber", "birch", "teak", "parquetry"}, Pattern::kPlanks, 0.42F, 0.14F, 0.5F},
};
constexpr Finish kWalls[] = {
    {{"damask", "wallpaper", "paper", "floral", "stripe"}, Pattern::kWallpaper, 0.8F, 0.32F, 0.72F},
    {{"brick"}, Pattern::kBricks, 0.88F, 0.22F, 1.35F},
    {{"tile", "ceramic", "subway"}, Pattern::kTiles, 0.25F, 0.15F, 0.8F},
    {{"panel", "wainscot", "wood", "log", "timber", "plank"}, Pattern::kPlanks, 0.5F, 0.12F, 0.6F},
    {{"stone", "rock", "rubble", "slate", "cave"}, Pattern::kStone, 0.9F, 0.45F, 0.6F},
    {{"fabric", "silk", "velvet", "linen", "grasscloth"}, Pattern::kFabric, 0.9F, 0.006F, 0.8F},
    {{"concrete", "limewash", "plaster", "stucco", "clay"}, Pattern::kStone, 0.9F, 4.0F, 0.93F},
};

template <size_t kCount>
void ApplyFinish(const Finish (&finishes)[kCount], const v1::SurfaceStyle& surface, Material& material) {
  const std::string words = Lower(surface.material() + " " + surface.description());
  if (surface.has_colour()) material.colour = LinearOf(surface.colour());
  material.pattern = Pattern::kPlain;
  material.second_colour = material.colour;
  if (!surface.material().empty()) material.name = surface.material();
  for (const Finish& finish : finishes) {
    for (std::string_view word : finish.words) {
      if (word.empty() || words.find(word) == std::string::npos) continue;
      material.pattern = finish.pattern;
      material.roughness = finish.roughness;
      material.pattern_size_m = finish.size_m;
      material.second_colour = material.colour * finish.second;
      return;
    }
  }
}

constexpr float kDarkWall = 0.36F;  // below, the wall's lightest channel calls for darker ceilings and joinery

// Nothing reflects more than white paint or less than soot: light must get about.
Vec3 Reflectable(Vec3 colour) {
  const auto limit = [](float value) { return std::clamp(value, 0.012F, 0.86F); };
  return {limit(colour.x), limit(colour.y), limit(colour.z)};
}

Material Plain(std::string name, Vec3 colour, float roughness) {
  Material material;
  material.name = std::move(name);
  material.colour = colour;
  material.roughness = roughness;
  return material;
}

}  // namespace

Vec3 LinearOf(const v1::Colour& colour) {
  return Reflectable({Channel(colour.red()), Channel(colour.green()), Channel(colour.blue())});
}

ShellMaterials ShellMaterialsOf(const v1::StyleSheet& style) {
  ShellMaterials m;
  m.floor = Plain("oak boards", {0.48F, 0.31F, 0.17F}, 0.42F);
  m.floor.pattern = Pattern::kPlanks;
  m.floor.second_colour = m.floor.colour * 0.5F;
  m.floor.pattern_size_m = 0.14F;
  m.wall = Plain("white paint", {0.82F, 0.80F, 0.76F}, 0.9F);
  m.ceiling = Plain("ceiling paint", {0.85F, 0.85F, 0.84F}, 0.95F);
  bool own_ceiling = false;
  for (const v1::SurfaceStyle& surface : style.surfaces()) {
    if (surface.surface() == "floor") ApplyFinish(kFloors, surface, m.floor);
    if (surface.surface() == "walls") ApplyFinish(kWalls, surface, m.wall);
    if (surface.surface() != "ceiling" || !surface.has_colour()) continue;
    m.ceiling.colour = LinearOf(surface.colour());
    own_ceiling = true;
  }
  m.outside = Plain("outer plaster", {0.78F, 0.77F, 0.75F}, 0.95F);
  m.section = Plain("section", {0.80F, 0.79F, 0.77F}, 0.95F);
  // A ceiling without a style is white, and takes some of the colour of dark walls: white above them would glare.
  const float light = std::max({m.wall.colour.x, m.wall.colour.y, m.wall.colour.z});
  const float dark = 0.8F * std::clamp(1 - light / kDarkWall, 0.0F, 1.0F);
  if (!own_ceiling) m.ceiling.colour = m.ceiling.colour * (1 - dark) + m.wall.colour * dark;
  // White joinery; in rooms with dark walls it is stained to go with them.
  m.trim = Plain("joinery", {0.80F, 0.79F, 0.77F}, 0.5F);
  if (light < kDarkWall / 2) m.trim.colour = m.wall.colour * 0.5F + Vec3{0.045F, 0.035F, 0.028F};
  m.glass = Plain("glass", {0.9F, 0.95F, 0.95F}, 0.05F);
  m.glass.opacity = 0.1F;
  m.metal = Plain("brushed metal", {0.62F, 0.60F, 0.57F}, 0.35F);
  m.metal.metallic = 1;
  return m;
}

Material OpeningMaterialOf(const v1::StyleSheet& style, const std::string& id, const Material& fallback) {
  for (const v1::ObjectStyle& object : style.objects()) {
    if (object.subject_id() != id) continue;
    Material material = fallback;
    material.name = object.material().empty() ? id : object.material();
    if (object.has_colour()) material.colour = LinearOf(object.colour());
    const std::string words = Lower(object.material());
    if (HasAny(words, {"wood", "oak", "walnut", "pine", "mahogany", "timber", "teak"})) {
      material.pattern = Pattern::kWood;
      material.second_colour = material.colour * 0.65F;
      material.pattern_size_m = 0.1F;
    }
    if (HasAny(words, {"metal", "steel", "iron", "aluminium"})) material.metallic = 0.6F, material.roughness = 0.45F;
    return material;
  }
  return fallback;
}

}  // namespace flair::renderer
