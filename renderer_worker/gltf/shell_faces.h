// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "flair/v1/room.pb.h"
#include "renderer_worker/scene/scene.h"

namespace flair::renderer::gltf {

// The faces of a part of the shell that are seen from within the room: the underside of the ceiling, walls without
// their outer faces. Nearly all viewers leave out the backs of surfaces and so show the room from outside and above
// like a doll's house, and cameras may stand behind a wall. All other parts as they are.
Mesh SeenFromWithin(const ShellPart& part, const v1::Room& room);

}  // namespace flair::renderer::gltf
