// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "renderer_worker/scene/mesh.h"
#include "renderer_worker/scene/scene.h"

namespace flair::renderer {

// Which way an asset stands in its file, as axes of glTF's frame: "+x", "-x", "+y", "-y", "+z" or "-z".
struct AssetAxes {
  std::string front = "+z";
  std::string up = "+y";
};

// OK when both are axes and not parallel; INVALID_ARGUMENT otherwise.
absl::Status CheckAxes(const AssetAxes& axes);

struct AssetMesh {
  Mesh mesh;                       // in an object's axes (x right, y front, z up), the file's own unit and origin
  std::vector<std::string> notes;  // what was left out, for people
};

// An asset larger than this is refused.
inline constexpr size_t kMaxAssetBytes = size_t{256} << 20;
inline constexpr size_t kMaxAssetVertices = size_t{4} << 20;
inline constexpr size_t kMaxAssetTriangles = size_t{2} << 20;

// Reads the triangles of a binary glTF 2.0 file that a stranger made: all meshes of its default scene, in place.
// Colours, roughness, metalness, opacity and emission come as factors; a base colour picture of at most 4096 px a side
// is handed on unread, all other pictures are left out. Nothing outside `bytes` is opened. Thread-safe.
// INVALID_ARGUMENT: no GLB, or one whose numbers contradict each other or are not finite; UNIMPLEMENTED: what it
// requires and we cannot read, such as Draco compression; RESOURCE_EXHAUSTED: more than the limits above; NOT_FOUND: no
// triangles.
absl::StatusOr<AssetMesh> ReadAsset(std::string_view bytes, const AssetAxes& axes);

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

// INVALID_ARGUMENT for an object that is nowhere.
absl::Status CheckFinite(const v1::Placement& placement);

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
