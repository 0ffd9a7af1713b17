// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "renderer_worker/scene/mesh.h"

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

}  // namespace flair::renderer
