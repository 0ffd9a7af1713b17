// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "flair/v1/layout_graph.pb.h"
#include "renderer_worker/scene/mesh.h"

// What floors, walls and openings are made of, for plans and views alike. Thread-safe; nothing here fails.
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

// By the style sheet's words and colours; where it says nothing, white paint and oak boards, tiles in wet rooms.
ShellMaterials ShellMaterialsOf(const v1::LayoutGraph& graph);

// The material of a door's leaf or a window's frame, by its style; `fallback` when it has none.
Material OpeningMaterialOf(const v1::StyleSheet& style, const std::string& id, const Material& fallback);

// Linear RGB of an sRGB colour.
Vec3 LinearOf(const v1::Colour& colour);

}  // namespace flair::renderer
