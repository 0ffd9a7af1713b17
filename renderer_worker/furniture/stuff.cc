// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "renderer_worker/furniture/piece.h"

namespace flair::renderer::stuff {
namespace {

Material See(std::string_view name, unsigned srgb, float opacity) {
  Material material = PlainMaterial(name, srgb, 0.04F);
  material.opacity = opacity;
  return material;
}

Material Shining(std::string_view name, unsigned srgb, Vec3 emission) {
  Material material = PlainMaterial(name, srgb, 0.8F);
  material.emission = emission;
  return material;
}

}  // namespace

#define STUFF(function, ...)                       \
  const Material& function() {                     \
    static const Material kMaterial = __VA_ARGS__; \
    return kMaterial;                              \
  }
STUFF(White, PlainMaterial("white glaze", 0xF1F1EE, 0.18F))
STUFF(Black, PlainMaterial("black plastic", 0x232427, 0.4F))
STUFF(Rubber, PlainMaterial("rubber", 0x2A2A2C, 0.85F))
STUFF(Steel, PlainMaterial("brushed steel", 0xB6B9BB, 0.32F, 1))
STUFF(Mirror, PlainMaterial("mirror", 0xE6EBEC, 0.03F, 1))
STUFF(Glass, See("clear glass", 0xDCEBE9, 0.22F))
STUFF(Screen, PlainMaterial("dark screen", 0x14161A, 0.08F))
STUFF(Lit, Shining("lit screen", 0x8FB7D6, {0.32F, 0.46F, 0.58F}))
STUFF(Shade, Shining("lamp shade", 0xF0E4CC, {0.95F, 0.72F, 0.44F}))
STUFF(Bulb, Shining("bulb", 0xFFF4DC, {2.6F, 2.0F, 1.3F}))
STUFF(FlameStuff, Shining("flame", 0xFFB04A, {3.2F, 1.5F, 0.4F}))
STUFF(Embers, Shining("embers", 0xC8642A, {0.9F, 0.3F, 0.05F}))
STUFF(Water, See("water", 0x7FB6C4, 0.75F))
STUFF(Soil, PlainMaterial("soil", 0x3E2E22, 0.98F))
STUFF(Paper, PlainMaterial("paper", 0xEFE8D6, 0.9F))
STUFF(Ivory, PlainMaterial("ivory", 0xF3EDDC, 0.25F))
STUFF(Cork, PlainMaterial("cork", 0xB98A5A, 0.95F))
#undef STUFF

const Material& Leaf(int tint) {
  static const std::array<Material, 3> kLeaves{PlainMaterial("leaf", 0x4F7D3C, 0.55F),
                                               PlainMaterial("light leaf", 0x76A350, 0.55F),
                                               PlainMaterial("dark leaf", 0x2F5A35, 0.55F)};
  return kLeaves[static_cast<size_t>(tint % 3)];
}

const Material& Book(int tint) {
  static const std::array<Material, 7> kBooks{
      PlainMaterial("book, red", 0x7F4038, 0.7F),   PlainMaterial("book, blue", 0x465A70, 0.7F),
      PlainMaterial("book, green", 0x5A6A53, 0.7F), PlainMaterial("book, ochre", 0xB08F5A, 0.7F),
      PlainMaterial("book, cream", 0xD8CFBC, 0.7F), PlainMaterial("book, brown", 0x5F4A3A, 0.7F),
      PlainMaterial("book, slate", 0x4A4F57, 0.7F)};
  return kBooks[static_cast<size_t>(tint % 7)];
}

}  // namespace flair::renderer::stuff
