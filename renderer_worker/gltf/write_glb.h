// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "absl/status/statusor.h"
#include "renderer_worker/scene/mesh.h"
#include "renderer_worker/scene/scene.h"

namespace flair::renderer {

// What a GLB says of where it comes from, in `asset.extras`; empty fields are left out.
struct GlbMetadata {
  std::string job_id;
  std::string brief_text;
  std::optional<int64_t> brief_seed;
  std::string layout_digest;  // hex SHA-256 of the layout's bytes
  std::string build;          // Producer.build
};

// Viewers that have no exposure show a light of 1 lx as white; lamps and daylight are written times this, so that
// rooms look right in them. Divide by it for candela and lux as they are. Also said in `asset.extras.light_scale`.
inline constexpr double kLightScale = 0.01;

// Writes the room as binary glTF 2.0 (Khronos), complete in itself: metres, y up, north is -z, every object a node with
// its id as name, its front along the node's +z and our words about it in `extras`; equal meshes are shared. Lamps and
// daylight are KHR_lights_punctual, patterns textures that tile. See docs/scene.md. The same scene and metadata give
// the same bytes. Thread-safe. INVALID_ARGUMENT: a placement that is not finite; INTERNAL: a mesh that is not sound;
// RESOURCE_EXHAUSTED: more than the 4 GiB that the format can hold.
absl::StatusOr<std::string> WriteGlb(const Scene& scene, const GlbMetadata& metadata);

// Writes one piece of furniture (object frame O) as binary glTF 2.0 as assets are: a single node without a transform,
// metres, y up, its front along +z. The same mesh gives the same bytes. Thread-safe.
// INTERNAL: a mesh that is not sound or has no triangles, a name that is no UTF-8.
absl::StatusOr<std::string> WriteMeshGlb(const Mesh& mesh, const std::string& name);

}  // namespace flair::renderer
