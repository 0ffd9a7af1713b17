// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "flair/v1/object_list.pb.h"
#include "renderer_worker/scene/mesh.h"

namespace flair::renderer {

// Width, depth and height of the box round a mesh's triangles; 0 for a mesh without.
Vec3 ExtentOf(const Mesh& mesh);

// An asset (x right, y front, z up, any unit and origin) as a piece of furniture in frame O: scaled to the object's
// width and depth, its height in proportion (by the mean of both scales, on walls by that of the width) but at most a
// quarter higher than the object's; what stands has its underside at 0, what hangs on a wall is centred in the object's
// height, what hangs from the ceiling reaches up to it. An extent of nothing stays nothing.
Mesh Fitted(const Mesh& asset, const v1::Object& object);

}  // namespace flair::renderer
