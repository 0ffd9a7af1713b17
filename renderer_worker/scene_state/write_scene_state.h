// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "renderer_worker/scene/scene.h"

namespace flair::renderer {

// The name before the dot of every `modelId`: what SceneEval's configs/assets.yaml calls `asset_id_prefix`.
inline constexpr char kSceneStateAssetPrefix[] = "flair";

// Writes the room as SceneState JSON, versions scene@1.0.2 and arch@1.0.2, as the public benchmark SceneEval
// (github.com/3dlg-hcvc/SceneEval, its template and GUIDE.md) reads it: z up, metres, the floor's polygon, walls from
// point to point with holes for doors and windows, objects as `modelId` and 4 x 4 transform, column by column, from the
// glTF frame of their mesh. Meshes: SceneStateAssets. SceneEval 1.1 turns walls by quarter turns only: rooms with
// slanted walls are written right and read wrong. The same scene gives the same bytes. Thread-safe.
// INVALID_ARGUMENT: a placement that is not finite; INTERNAL: texts that are no UTF-8.
absl::StatusOr<std::string> WriteSceneState(const Scene& scene);

// A file beside the JSON.
struct SceneStateFile {
  std::string path;  // relative, such as "desk/desk.glb"
  std::string bytes;
};

// The meshes that the JSON's `modelId`s name: ID/ID.glb and ID/data.json for each object, which SceneEval's dataset
// class `layoutvlm_objathor` reads as they are. Errors as WriteGlb.
absl::StatusOr<std::vector<SceneStateFile>> SceneStateAssets(const Scene& scene);

}  // namespace flair::renderer
