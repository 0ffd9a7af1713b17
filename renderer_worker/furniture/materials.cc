// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <utility>

#include "renderer_worker/furniture/classes.h"

namespace flair::renderer {
namespace {

BaseMaterial Read(const FurnitureMaterial& data) {
  Material look;
  look.name = data.name();
  look.colour = LinearHex(data.colour());
  look.roughness = data.roughness();
  look.metallic = data.metallic();
  look.opacity = data.opacity() > 0 ? data.opacity() : data.kind() == FurnitureMaterial::GLASS ? 0.25F : 1;
  if (data.emission_size() == 3) look.emission = {data.emission(0), data.emission(1), data.emission(2)};
  look.pattern = static_cast<Pattern>(data.pattern());
  if (data.pattern_size_m() > 0) look.pattern_size_m = data.pattern_size_m();
  look.second_colour = look.colour * (data.second_colour_factor() > 0 ? data.second_colour_factor() : 1);
  return {data.name(), data.kind(), look};
}

const BaseMaterial* Find(std::string_view name) {
  for (const BaseMaterial& base : BaseMaterials()) {
    if (base.name == name) return &base;
  }
  return nullptr;
}

const BaseMaterial* OfWord(std::string_view word) {
  const auto& materials = Furniture().material();
  for (int i = 0; i < materials.size(); ++i) {
    const auto& words = materials[i].words();
    if (materials[i].name() == word || std::ranges::find(words, word) != words.end()) {
      return &BaseMaterials()[static_cast<size_t>(i)];
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

bool IsHard(const BaseMaterial& m) { return m.kind != FurnitureMaterial::CLOTH; }
bool IsCloth(const BaseMaterial& m) { return m.kind == FurnitureMaterial::CLOTH; }
bool IsMetal(const BaseMaterial& m) { return m.kind == FurnitureMaterial::METAL; }

using Materials = std::vector<const BaseMaterial*>;

const BaseMaterial& MaterialOf(const std::string& name, std::string_view usual) {
  return BaseMaterialOf(name.empty() ? usual : name);
}

template <typename Predicate>
const BaseMaterial* First(const Materials& named, Predicate predicate) {
  const auto at = std::ranges::find_if(named, [&](const BaseMaterial* m) { return predicate(*m); });
  return at != named.end() ? *at : nullptr;
}

// What the style names, most telling first.
struct Choice {
  const BaseMaterial* hard = nullptr;
  const BaseMaterial* soft = nullptr;
  const BaseMaterial* metal = nullptr;
};

Choice Choose(const Materials& named, const ClassMaterials& look) {
  Choice choice{First(named, IsHard), First(named, IsCloth), First(named, IsMetal)};
  // "walnut and brass": the metal is for the fittings when there is something else for the body, and where the body
  // is not of metal by nature.
  if (choice.hard != nullptr && IsMetal(*choice.hard) && !IsMetal(MaterialOf(look.hard(), "oak"))) {
    const BaseMaterial* body = First(named, [](const BaseMaterial& m) { return IsHard(m) && !IsMetal(m); });
    if (body != nullptr) choice.hard = body;
  }
  return choice;
}

// Colours say which part they are of: "dark walnut" is a wood's, "antique brass" a metal's.
enum class Part { kHard, kSoft, kMetal };

Part PartColoured(const ClassMaterials& look, const Choice& choice, const Materials& named, const v1::Colour& colour) {
  const Materials said = MaterialsInWords(colour.name());
  if (!said.empty() && IsCloth(*said.front())) return Part::kSoft;
  const bool hard_is_metal = IsMetal(choice.hard != nullptr ? *choice.hard : MaterialOf(look.hard(), "oak"));
  if (!said.empty() && IsMetal(*said.front())) return hard_is_metal ? Part::kHard : Part::kMetal;
  if (!said.empty()) return Part::kHard;
  if (look.styled() == ClassMaterials::HARD) {
    return choice.soft != nullptr && choice.hard == nullptr ? Part::kSoft : Part::kHard;
  }
  // Upholstery of which only wood or metal is named, in a brown that suits the wood: the wood's.
  if (!named.empty() && choice.soft == nullptr && choice.hard != nullptr &&
      choice.hard->kind == FurnitureMaterial::WOOD) {
    const Vec3 difference = LinearOf(colour) - choice.hard->look.colour;
    if (Length(difference) < 0.12F) return Part::kHard;
  }
  return Part::kSoft;
}

std::string Lower(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

template <typename List>
bool HasAny(const std::string& text, const List& words) {
  return std::ranges::any_of(words, [&](const auto& word) { return text.find(word) != std::string::npos; });
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
  const auto finish =
      std::ranges::find_if(finishes, [&](const SurfaceFinish& each) { return HasAny(words, each.words()); });
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

Vec3 LinearHex(unsigned srgb) {
  v1::Colour colour;
  colour.set_red(static_cast<int>((srgb >> 16) & 255));
  colour.set_green(static_cast<int>((srgb >> 8) & 255));
  colour.set_blue(static_cast<int>(srgb & 255));
  return LinearOf(colour);
}

Vec3 Blend(Vec3 from, Vec3 to, float share) { return from * (1 - share) + to * share; }

std::span<const BaseMaterial> BaseMaterials() {
  static const std::vector<BaseMaterial> kMaterials = [] {
    std::vector<BaseMaterial> materials;
    for (const FurnitureMaterial& data : Furniture().material()) materials.push_back(Read(data));
    return materials;
  }();
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
    if (!word.empty() && base != nullptr && std::ranges::find(found, base) == found.end()) found.push_back(base);
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
    return base->kind == FurnitureMaterial::WOOD && base->look.pattern == Pattern::kWood && base->name != "wood";
  };
  if (std::ranges::any_of(found, tree)) {
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

const Material* FixedMaterial(std::string_view name) {
  static const auto& fixtures = *[] {
    auto* read = new std::map<std::string_view, Material>();
    for (const FurnitureMaterial& data : Furniture().fixture()) read->emplace(data.name(), Read(data).look);
    return read;
  }();
  if (const auto at = fixtures.find(name); at != fixtures.end()) return &at->second;
  const BaseMaterial* base = Find(name);
  return base != nullptr ? &base->look : nullptr;
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

Palette PaletteOf(const ClassMaterials& look, const v1::Object& object, const v1::ObjectStyle* style) {
  Materials named = style != nullptr ? MaterialsInWords(style->material()) : Materials();
  const Materials by_name = MaterialsInWords(object.name());
  named.insert(named.end(), by_name.begin(), by_name.end());
  const Choice choice = Choose(named, look);
  const BaseMaterial& hard = choice.hard != nullptr ? *choice.hard : MaterialOf(look.hard(), "oak");
  const BaseMaterial& soft = choice.soft != nullptr ? *choice.soft : MaterialOf(look.soft(), "linen");
  const BaseMaterial& metal = choice.metal != nullptr ? *choice.metal : MaterialOf(look.metal(), "steel");
  Palette palette;
  palette.hard = hard.look, palette.soft = soft.look, palette.metal = metal.look;
  if (look.hard_colour() != 0 && choice.hard == nullptr) palette.hard = Coloured(hard, LinearHex(look.hard_colour()));
  if (look.soft_colour() != 0 && choice.soft == nullptr) palette.soft = Coloured(soft, LinearHex(look.soft_colour()));
  if (style != nullptr && style->has_colour()) {
    palette.styled = true;
    const Vec3 colour = LinearOf(style->colour());
    switch (PartColoured(look, choice, named, style->colour())) {
      case Part::kHard:
        palette.hard = Coloured(hard, colour);
        break;
      case Part::kSoft:
        palette.soft = Coloured(soft, colour);
        break;
      case Part::kMetal:
        palette.metal = Coloured(metal, colour);
        break;
    }
  }
  // Glass as the body of a piece that is not of glass by nature is thick enough to be seen.
  if (palette.hard.opacity < 1 && &hard != &MaterialOf(look.hard(), "oak")) palette.hard.opacity = 0.35F;
  palette.hard.name += ", body";
  palette.soft.name += ", soft";
  palette.metal.name += ", fittings";
  palette.colour = look.styled() == ClassMaterials::HARD ? palette.hard.colour : palette.soft.colour;
  palette.pale = palette.soft;
  palette.pale.name = "pale " + palette.soft.name;
  palette.pale.colour = Blend(palette.soft.colour, {0.80F, 0.78F, 0.73F}, 0.82F);
  palette.pale.second_colour = palette.pale.colour * 0.9F;
  palette.accent = Shaded(palette.soft, 0.55F, "deep");
  return palette;
}

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
