// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "renderer_worker/scene/mesh.h"

namespace flair::renderer {

// Writes one piece of furniture (object frame O) as binary glTF 2.0 as assets are: a single node without a transform,
// metres, y up, its front along +z. The same mesh gives the same bytes. Thread-safe.
// INTERNAL: a mesh that is not sound or has no triangles, a name that is no UTF-8.
absl::StatusOr<std::string> WriteMeshGlb(const Mesh& mesh, const std::string& name);

}  // namespace flair::renderer
