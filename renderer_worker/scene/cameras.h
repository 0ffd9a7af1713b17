// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "renderer_worker/scene/sight.h"

namespace flair::renderer {

// Three-quarter view from above, from the side from which most of the furniture shows its front; the room with its
// uncut walls fills a square picture up to an even margin.
SceneCamera BirdseyeCamera(const RoomShape& shape, const Sight& sight);

// From eye height, from a corner, a door, or a little behind a wall (which is cut away), where most objects are seen
// and nothing stands right before the eye.
SceneCamera PerspectiveCamera(const RoomShape& shape, const Sight& sight);

}  // namespace flair::renderer
