// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "flair/v1/style_sheet.pb.h"
#include "renderer_worker/scene/material.h"

// What furniture is made of. Thread-safe; nothing here fails.
namespace flair::renderer {

enum class MaterialKind { kWood, kPaint, kMetal, kCloth, kStone, kGlass };

// A material that words name.
struct BaseMaterial {
  std::string_view name;
  MaterialKind kind;
  Material look;
};

// Every base material, in the order of material_list.inc.
std::span<const BaseMaterial> BaseMaterials();
// By its own name; "wood" for a name that is none.
const BaseMaterial& BaseMaterialOf(std::string_view name);
// Those that free text names, in the text's order and without repeats: "walnut and brass" -> walnut, brass.
std::vector<const BaseMaterial*> MaterialsInWords(std::string_view text);

// `material` in another colour (linear RGB), the contrast of its pattern kept. Wood in a colour that no wood has
// becomes painted wood.
Material Coloured(const BaseMaterial& material, Vec3 colour);

// A plain material that no style changes.
Material PlainMaterial(std::string_view name, unsigned srgb, float roughness, float metallic = 0);
// Linear RGB of 0xRRGGBB.
Vec3 LinearHex(unsigned srgb);
// `from` at share 0, `to` at share 1.
Vec3 Blend(Vec3 from, Vec3 to, float share);
// The same material, lighter (above 1) or darker (below 1), under another name.
Material Shaded(const Material& material, float factor, std::string_view suffix);

}  // namespace flair::renderer
