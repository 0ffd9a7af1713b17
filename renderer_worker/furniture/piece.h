// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "flair/v1/object_list.pb.h"
#include "flair/v1/style_sheet.pb.h"
#include "renderer_worker/furniture/materials.h"
#include "renderer_worker/furniture/modeller.h"
#include "renderer_worker/scene/furnishing.h"

namespace flair::renderer {

// What a class of furniture is made of unless its style says otherwise.
struct ClassLook {
  enum class Dominant { kHard, kSoft };
  std::string_view hard = "oak";    // frames and bodies
  std::string_view soft = "linen";  // upholstery and textiles
  std::string_view metal = "steel";
  Dominant dominant = Dominant::kHard;  // what takes the style's colour
  unsigned soft_colour = 0;             // instead of the base material's; 0 keeps it
  unsigned hard_colour = 0;
};

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
Palette PaletteOf(const ClassLook& look, const v1::Object& object, const v1::ObjectStyle* style);

// One piece of furniture in the making: [-w/2, w/2] x [-d/2, d/2] x [0, h], front at +y, metres.
struct Piece {
  float w, d, h;
  Palette is;
  std::string words;  // lower case: name, material, description
  uint32_t seed;      // of its class and name: for what varies without meaning
  Modeller make;
  std::vector<LampLight> lights;

  // Whether its words say so; `word` in lower case.
  bool Says(std::string_view word) const;
  float smaller() const { return w < d ? w : d; }
  // The size that a part has usually, unless the piece is too small for it.
  float Most(float usual, float share, float of) const { return usual < share * of ? usual : share * of; }
  // A repeatable number in [0, 1) for part `index`.
  float Chance(int index) const;
  // A light at `at`, which moves along when the piece is fitted into its box.
  void Shine(Vec3 at, float intensity_cd, float radius_m, Vec3 colour = {1, 0.78F, 0.52F});

  // Shortcuts for what many are made of.
  void LegsAt(const Material& material, float x, float y, float top, float half, float taper = 0.6F, float splay = 0);
  void RoundLegsAt(const Material& material, float x, float y, float top, float radius, float splay = 0);
  void Knob(Vec3 at, float radius);                  // sticks out to the front (+y)
  void Handle(Vec3 at, float length, bool upright);  // likewise
  // A front of a box that faces +y at `y`: a panel with a gap around it.
  void Panel(const Material& material, Vec2 low, Vec2 high, float y, float thickness = 0.018F, bool framed = false);
  // A flame above `at` and its light.
  void Flame(Vec3 at, float height, float intensity_cd);
  void Shade(Vec3 base, float bottom_radius, float top_radius, float height, const Material& material);
  void Book(Vec3 low, Vec3 high, int index);  // its back to +y
  void Pot(Vec3 base, float radius, float height, const Material& material);
  void Foliage(Vec3 centre, Vec3 radii, int leaves, float leaf, const Material& material);
};

// Materials that no style changes.
namespace stuff {
const Material& White();  // glazed ceramic, enamel
const Material& Black();  // plastic
const Material& Rubber();
const Material& Steel();
const Material& Mirror();
const Material& Glass();
const Material& Screen();  // of something switched off
const Material& Lit();     // of something switched on
const Material& Shade();   // of a lamp, shining
const Material& Bulb();
const Material& FlameStuff();
const Material& Embers();  // behind a stove's window
const Material& Water();
const Material& Leaf(int tint);
const Material& Soil();
const Material& Paper();
const Material& Cork();
const Material& Book(int tint);
const Material& Ivory();
}  // namespace stuff

}  // namespace flair::renderer
