// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "flair/v1/layout_graph.pb.h"
#include "renderer_worker/furniture/materials.h"
#include "renderer_worker/scene/mesh.h"
#include "renderer_worker/scene/room_shape.h"
#include "renderer_worker/scene/scene.h"

namespace flair::renderer {

// Floor, ceiling, then for each wall its body, skirting and openings.
std::vector<ShellPart> BuildShell(const RoomShape& shape, const v1::LayoutGraph& graph);

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
