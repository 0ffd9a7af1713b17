// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/furniture/surfaces.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>
#include <utility>

#include "renderer_worker/furniture/classes.h"

namespace flair::renderer {
namespace {

std::string Lower(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

template <typename List>
bool HasAny(const std::string& text, const List& words) {
  return std::any_of(words.begin(), words.end(),
                     [&](const auto& word) { return text.find(word) != std::string::npos; });
}

float Channel(int value) {
  const float v = static_cast<float>(std::clamp(value, 0, 255)) / 255;
  return v <= 0.04045F ? v / 12.92F : std::pow((v + 0.055F) / 1.055F, 2.4F);
}

using Finishes = google::protobuf::RepeatedPtrField<SurfaceFinish>;

void ApplyFinish(const Finishes& finishes, const v1::SurfaceStyle& surface, Material& material) {
  const std::string words = Lower(surface.material() + " " + surface.description());
  if (surface.has_colour()) material.colour = LinearOf(surface.colour());
  material.pattern = Pattern::kPlain;
  material.second_colour = material.colour;
  if (!surface.material().empty()) material.name = surface.material();
  const auto finish = std::find_if(finishes.begin(), finishes.end(),
                                   [&](const SurfaceFinish& each) { return HasAny(words, each.words()); });
  if (finish == finishes.end()) return;
  material.pattern = static_cast<Pattern>(finish->pattern());
  material.roughness = finish->roughness();
  material.pattern_size_m = finish->pattern_size_m();
  material.second_colour = material.colour * finish->second_colour_factor();
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

ShellMaterials ShellMaterialsOf(const v1::LayoutGraph& graph) {
  const v1::StyleSheet& style = graph.style_sheet();
  ShellMaterials m;
  const bool wet = HasAny(Lower(graph.room().room_type()), Furniture().wet_room());
  m.floor = Plain("floor", wet ? Vec3{0.60F, 0.58F, 0.55F} : Vec3{0.48F, 0.31F, 0.17F}, 0.42F);
  v1::SurfaceStyle usual;
  usual.set_material(wet ? "ceramic tiles" : "oak boards");
  ApplyFinish(Furniture().floor(), usual, m.floor);
  m.wall = Plain("white paint", {0.82F, 0.80F, 0.76F}, 0.9F);
  m.ceiling = Plain("ceiling paint", {0.85F, 0.85F, 0.84F}, 0.95F);
  bool own_ceiling = false;
  for (const v1::SurfaceStyle& surface : style.surfaces()) {
    if (surface.surface() == "floor") ApplyFinish(Furniture().floor(), surface, m.floor);
    if (surface.surface() == "walls") ApplyFinish(Furniture().wall(), surface, m.wall);
    if (surface.surface() != "ceiling" || !surface.has_colour()) continue;
    m.ceiling.colour = LinearOf(surface.colour());
    own_ceiling = true;
  }
  m.outside = Plain("outer plaster", {0.78F, 0.77F, 0.75F}, 0.95F);
  m.section = Plain("section", {0.085F, 0.078F, 0.072F}, 0.95F);  // as in plans
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
    if (HasAny(words, std::array{"wood", "oak", "walnut", "pine", "mahogany", "timber", "teak"})) {
      material.pattern = Pattern::kWood;
      material.second_colour = material.colour * 0.65F;
      material.pattern_size_m = 0.1F;
    }
    if (HasAny(words, std::array{"metal", "steel", "iron", "aluminium"}))
      material.metallic = 0.6F, material.roughness = 0.45F;
    return material;
  }
  return fallback;
}

}  // namespace flair::renderer
