// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "flair/v1/object_list.pb.h"
#include "flair/v1/style_sheet.pb.h"
#include "renderer_worker/furniture/materials.h"
#include "renderer_worker/furniture/modeller.h"
#include "renderer_worker/scene/furnishing.h"

namespace flair::renderer {

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

// Makes a piece of furniture that fills its box, about: it is stretched to it in the end.
struct PieceMaker {
  std::string_view name;  // what records call it
  void (*make)(Piece& piece);
};

// The maker of that name; null when there is none.
const PieceMaker* MakerNamed(std::string_view name);

// The makers by family, each in the file of its name.
std::span<const PieceMaker> BathroomMakers();
std::span<const PieceMaker> BedMakers();
std::span<const PieceMaker> ChairMakers();
std::span<const PieceMaker> ContainerMakers();
std::span<const PieceMaker> CraftMakers();
std::span<const PieceMaker> DecorMakers();
std::span<const PieceMaker> FigureMakers();
std::span<const PieceMaker> HearthMakers();
std::span<const PieceMaker> KitchenMakers();
std::span<const PieceMaker> LampMakers();

std::span<const PieceMaker> MountedMakers();
std::span<const PieceMaker> MusicMakers();
std::span<const PieceMaker> SeatingMakers();
std::span<const PieceMaker> SportMakers();
std::span<const PieceMaker> StorageMakers();
std::span<const PieceMaker> TableMakers();
std::span<const PieceMaker> TextileMakers();

}  // namespace flair::renderer
