// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "flair/v1/object_list.pb.h"
#include "flair/v1/style_sheet.pb.h"
#include "renderer_worker/furniture/piece.h"
#include "renderer_worker/scene/furnishing.h"

namespace flair::renderer {

// Extents that a mesh is made for, metres: what is smaller, larger or no number at all is brought to the nearest.
inline constexpr float kSmallestExtent_m = 0.002F;
inline constexpr float kLargestExtent_m = 100;

// A class of furniture, how it is made and of what.
struct PieceMaker {
  std::string_view class_name;
  void (*make)(Piece& piece);
  ClassLook look;
};

// Every maker, sorted by class; as many as there are classes.
std::span<const PieceMaker> PieceMakers();

struct MadePiece {
  Mesh mesh;
  std::vector<LampLight> lights;
};

// The mesh of `object` as a piece of class `class_name` (a box when that is no class), in the look of `style`, which
// may be null. Equal input gives equal bits.
MadePiece MakePiece(std::string_view class_name, const v1::Object& object, const v1::ObjectStyle* style);

}  // namespace flair::renderer
