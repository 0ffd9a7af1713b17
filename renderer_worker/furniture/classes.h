// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "flair/v1/layout_graph.pb.h"
#include "flair/v1/object_list.pb.h"
#include "flair/v1/style_sheet.pb.h"
#include "renderer_worker/furniture/furniture.pb.h"
#include "renderer_worker/scene/mesh.h"

// The classes of furniture, which plans, views, GLB files and the search for assets share: one record each in
// classes.textproto. Thread-safe; nothing here fails.

// What furniture is made of. Thread-safe; nothing here fails.
// What floors, walls and openings are made of, for plans and views alike. Thread-safe; nothing here fails.

namespace flair::renderer {

// classes.textproto and materials.textproto together, read at the first call.
const FurnitureData& Furniture();

// The record of a class; that of "box" for a name that is no class.
const FurnitureClass& ClassNamed(std::string_view class_name);

// Number of a class for pictures of classes: from 1, the same in every version; 0 for a name that is no class.
int ClassIdOf(std::string_view class_name);

// The class whose word is the head noun of a name, such as "adjustable dumbbell set" -> "weights"; empty where no class
// has it. The head noun is the last word ("desk lamp" is a lamp), with those before it where the phrase is known, of
// what comes before the first comma, bracket or small word ("wardrobe with mirror").
std::string_view ClassFromWords(std::string_view name);

// The class that `object` is shown as: by its name, else by its category and its id where they name a class that is not
// rough; "box", a plain block, where none of them does. What carries it decides between classes of the same name: a
// lamp on the ceiling is a pendant.
std::string_view ClassOf(const v1::Object& object);

// How high things lie that are put on a piece of furniture of our making, metres above its underside: on the mattress
// of a bed, the seat of a sofa, the top of a dressing table below its mirror. The piece's height, (0, inf), for all
// others.
float RestHeightOf(std::string_view class_name, float height_m);

// A material that words name.
struct BaseMaterial {
  std::string_view name;
  FurnitureMaterial::Kind kind;
  Material look;
};

// Every base material, in the order of materials.textproto.
std::span<const BaseMaterial> BaseMaterials();
// By its own name; "wood" for a name that is none.
const BaseMaterial& BaseMaterialOf(std::string_view name);
// Those that free text names, in the text's order and without repeats: "walnut and brass" -> walnut, brass.
std::vector<const BaseMaterial*> MaterialsInWords(std::string_view text);

// `material` in another colour (linear RGB), the contrast of its pattern kept. Wood in a colour that no wood has
// becomes painted wood.
Material Coloured(const BaseMaterial& material, Vec3 colour);

// A material that no style changes, by its own name: a fixture of materials.textproto or a base material. Null for a
// name that is none.
const Material* FixedMaterial(std::string_view name);
// Linear RGB of 0xRRGGBB.
Vec3 LinearHex(unsigned srgb);
// `from` at share 0, `to` at share 1.
Vec3 Blend(Vec3 from, Vec3 to, float share);
// The same material, lighter (above 1) or darker (below 1), under another name.
Material Shaded(const Material& material, float factor, std::string_view suffix);

// The materials of one piece.
struct Palette {
  Material hard;
  Material soft;
  Material metal;
  Material pale;    // of the soft colour, much lighter: pillows, mattresses
  Material accent;  // of the soft colour, deeper: throws, piping, figures
  Vec3 colour;      // what the style calls the dominant colour, or the class does
  bool styled = false;
};

// Reads the words and the colour of `style` (may be null) and the name of `object`.
Palette PaletteOf(const ClassMaterials& look, const v1::Object& object, const v1::ObjectStyle* style);

// What the shell of the room is made of.
struct ShellMaterials {
  Material floor;
  Material wall;
  Material ceiling;
  Material outside;  // of the walls, where a cut-away room shows them
  Material section;  // cut surfaces
  Material trim;     // frames, skirting, sills
  Material glass;
  Material metal;  // handles
};

// By the style sheet's words and colours; where it says nothing, white paint and oak boards, tiles in wet rooms.
ShellMaterials ShellMaterialsOf(const v1::LayoutGraph& graph);

// The material of a door's leaf or a window's frame, by its style; `fallback` when it has none.
Material OpeningMaterialOf(const v1::StyleSheet& style, const std::string& id, const Material& fallback);

// Linear RGB of an sRGB colour.
Vec3 LinearOf(const v1::Colour& colour);

}  // namespace flair::renderer
