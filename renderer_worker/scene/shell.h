// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "flair/v1/style_sheet.pb.h"
#include "renderer_worker/scene/mesh.h"
#include "renderer_worker/scene/room_shape.h"
#include "renderer_worker/scene/scene.h"

namespace flair::renderer {

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

// By the style sheet's words and colours; oak boards, white paint where it says nothing.
ShellMaterials ShellMaterialsOf(const v1::StyleSheet& style);

// The material of a door's leaf or a window's frame, by its style; `fallback` when it has none.
Material OpeningMaterialOf(const v1::StyleSheet& style, const std::string& id, const Material& fallback);

// Linear RGB of an sRGB colour.
Vec3 LinearOf(const v1::Colour& colour);

// Floor, ceiling, then for each wall its body, skirting and openings.
std::vector<ShellPart> BuildShell(const RoomShape& shape, const v1::StyleSheet& style);

// The body of a wall up to `top_m`, openings cut, its upper surface of the section's material.
Mesh WallBody(const RoomShape& shape, const ShapedWall& wall, float top_m, const ShellMaterials& materials);

// A door with lining, architrave, leaf and handle; a window with lining, frame, bars, glass and sill.
Mesh DoorMesh(const RoomShape& shape, const ShapedWall& wall, const ShapedOpening& door,
              const ShellMaterials& materials, const Material& leaf);
// Where the leaf of a door that stands ajar is: along it from the hinge, through it, up. None for others.
std::optional<Axes> OpenLeafAxes(const RoomShape& shape, const ShapedWall& wall, const ShapedOpening& door);
Mesh WindowMesh(const RoomShape& shape, const ShapedWall& wall, const ShapedOpening& window,
                const ShellMaterials& materials, const Material& frame);

}  // namespace flair::renderer
