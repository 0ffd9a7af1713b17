// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/provenance.pb.h"
#include "renderer_worker/gltf/read_asset.h"
#include "renderer_worker/scene/mesh.h"

namespace flair::renderer {

// One 3D model that a user brings along.
struct AssetEntry {
  std::string id;
  std::string file;            // relative to the folder, never leaving it
  std::string name;            // what it is, such as "rattan armchair"
  std::string tags;            // further words, spaces between
  std::string text;            // a description
  std::optional<Vec3> size_m;  // width, depth, height; nothing when not known
  AssetAxes axes;
  std::string licence;
};

struct Manifest {
  std::vector<AssetEntry> entries;          // unique ids, in the file's order (by id for annotations)
  std::vector<v1::Diagnostic> diagnostics;  // entries that cannot be used, with the reason; at most 100
};

inline constexpr size_t kMaxManifestBytes = size_t{256} << 20;

// Reads a manifest of ours, {"assets": [{"id": ..., "file": ..., ...}]}, or annotations as Objaverse and its followers
// have them, {uid: {"name": ..., "tags": [...], ...}}; docs/assets.md tells both. A bad entry is left out with a
// diagnostic. INVALID_ARGUMENT: no JSON of either form; RESOURCE_EXHAUSTED: more than kMaxManifestBytes.
absl::StatusOr<Manifest> ReadManifest(std::string_view json);

// `file` names something below a folder: relative, no "..", no back slash, no NUL.
bool StaysInFolder(std::string_view file);

}  // namespace flair::renderer
